// A keyboard on the screen, for robots that have none. It comes with the first touch of an
// input; phones bring their own. `keyboard=on` or `off` in the address decides it for good.

import { element } from "./element.js";
import { PAD, changed, decimalMark, isChange, pages } from "./layouts.js";

const asked = new URLSearchParams(location.search).get("keyboard");
const phone = /Android|iPhone|iPad/.test(navigator.userAgent);
let touched = matchMedia("(pointer: coarse)").matches && !matchMedia("(any-pointer: fine)").matches;

export const ownKeys = () => asked === "on" || (asked !== "off" && touched && !phone);

const language = () => document.documentElement.lang.slice(0, 2);

export function keyboard(panel, resized) {
  let field = null;
  let upper = true;
  let page = null;

  // A date is written from its beginning: its marks are not there to be erased.
  const focus = () => {
    field.focus();
    if (field.dataset.kind === "date") field.setSelectionRange(field.value.length, field.value.length);
  };
  const type = (text) => {
    focus();
    // As if typed, so that the field's own rules hold; replaces what is marked.
    field.setRangeText(text, field.selectionStart, field.selectionEnd, "end");
    field.dispatchEvent(new InputEvent("input", { bubbles: true, data: text, inputType: "insertText" }));
    if (field.dataset.kind !== "text") return;
    if (upper) shift(false);
    if (page.once) build("text", pages(language())[0]);
  };
  const change = (mark) => {
    focus();
    const at = field.selectionEnd;
    if (at === 0) return;
    const letter = changed(field.value[at - 1], mark);
    field.setRangeText(letter, at - 1, at, "end");
    field.dispatchEvent(new InputEvent("input", { bubbles: true, data: letter, inputType: "insertReplacementText" }));
  };
  const erase = () => {
    focus();
    const [start, end] = [field.selectionStart, field.selectionEnd];
    field.setRangeText("", start === end ? Math.max(0, start - 1) : start, end, "end");
    field.dispatchEvent(new InputEvent("input", { bubbles: true, inputType: "deleteContentBackward" }));
    if (field.value === "") shift(true);
  };
  const enter = () => {
    const target = field;
    target.dispatchEvent(new KeyboardEvent("keydown", { key: "Enter", bubbles: true, cancelable: true }));
    target.blur();
  };
  const shift = (on) => {
    upper = on;
    panel.classList.toggle("upper", on);
  };

  const key = (row, label, act, className = "", name = label) => {
    const node = element("button", className, row);
    node.type = "button";
    node.tabIndex = -1;
    node.textContent = label;
    node.setAttribute("aria-label", name);
    node.addEventListener("click", act);
  };
  const letterKey = (row, letter) => {
    const big = letter.toUpperCase();
    if (isChange(letter)) key(row, letter, () => change(letter), "soft");
    else if (letter >= "0" && letter <= "9") key(row, letter, () => type(letter), "soft");
    // Of ß there is no single capital.
    else if (big.length === 1) key(row, letter, () => type(upper ? big : letter), "letter");
    else key(row, letter, () => type(letter));
  };

  const build = (kind, shown) => {
    page = shown;
    const rows = [];
    const begin = () => rows[rows.push(element("div", "row")) - 1];
    if (kind === "text") {
      for (const letters of shown.rows) {
        const row = begin();
        const isLast = shown.shift && letters === shown.rows.at(-1);
        if (isLast) key(row, "⇧", () => shift(!upper), "wide shift", "Shift");
        for (const letter of letters) letterKey(row, letter);
        if (isLast) key(row, "⌫", erase, "wide", "Backspace");
      }
      const last = begin();
      const other = pages(language()).find((one) => one.name !== shown.name);
      key(last, other.label, () => build("text", other), "wide", other.name);
      key(last, "␣", () => type(" "), "space", "Space");
      if (!shown.shift) key(last, "⌫", erase, "wide", "Backspace");
      key(last, "OK", enter, "wide enter-key");
    } else {
      for (const numbers of PAD) {
        const row = begin();
        for (const number of numbers) key(row, number, () => type(number));
      }
      const last = begin();
      key(last, "⌫", erase, "", "Backspace");
      key(last, "0", () => type("0"));
      const mark = decimalMark(language());
      if (kind === "number") key(last, mark, () => type(mark));
      key(last, "OK", enter, "enter-key");
    }
    panel.dataset.kind = kind;
    panel.dataset.page = shown.name;
    panel.dataset.language = language();
    panel.replaceChildren(...rows);
  };

  panel.addEventListener("pointerdown", (event) => event.preventDefault());
  addEventListener("pointerdown", (event) => {
    if (event.pointerType === "touch") touched = true;
  }, { capture: true });

  const show = (target) => {
    const kind = target?.dataset.kind;
    const before = field;
    field = target && ownKeys() ? target : null;
    if (field) {
      const { kind: built, language: spoken } = panel.dataset;
      if (panel.hidden || built !== kind || spoken !== language() || field !== before) {
        build(kind, pages(language())[0]);
      }
      shift(field.value === "");
    }
    if (panel.hidden !== (field === null)) {
      panel.hidden = field === null;
      resized();
    }
  };
  // While a finger is down nothing may move: what it aims at would slip away from under it.
  let down = false;
  let following = 0;
  const follow = (delay) => {
    clearTimeout(following);
    following = setTimeout(() => {
      const active = document.activeElement;
      if (down) follow(delay);
      else show(active instanceof HTMLInputElement ? active : null);
    }, delay);
  };
  addEventListener("pointerdown", () => { down = true; }, { capture: true });
  for (const over of ["pointerup", "pointercancel"]) {
    addEventListener(over, () => { down = false; }, { capture: true });
  }
  addEventListener("focusin", () => follow(20));
  addEventListener("focusout", () => follow(200));
  return { hide: () => show(null) };
}
