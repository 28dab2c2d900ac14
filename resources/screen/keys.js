// A keyboard on the screen, for robots that have none. It comes with the first touch of an
// input; phones bring their own. `keyboard=on` or `off` in the address decides it for good.

import { element } from "./element.js";

const LETTERS = ["qwertyuiop", "asdfghjkl", "zxcvbnm'-"];
const NUMBERS = ["123", "456", "789"];

const asked = new URLSearchParams(location.search).get("keyboard");
const phone = /Android|iPhone|iPad/.test(navigator.userAgent);
let touched = matchMedia("(pointer: coarse)").matches && !matchMedia("(any-pointer: fine)").matches;

export const ownKeys = () => asked === "on" || (asked !== "off" && touched && !phone);

export function keyboard(panel, resized) {
  let field = null;
  let upper = true;

  const type = (text) => {
    field.focus();
    // As if typed, so that the field's own rules hold; replaces what is marked.
    field.setRangeText(text, field.selectionStart, field.selectionEnd, "end");
    field.dispatchEvent(new InputEvent("input", { bubbles: true, data: text, inputType: "insertText" }));
    if (upper && field.dataset.kind === "text") shift(false);
  };
  const erase = () => {
    field.focus();
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

  const build = (kind) => {
    const rows = [];
    const begin = () => rows[rows.push(element("div", "row")) - 1];
    if (kind === "text") {
      for (const letters of LETTERS) {
        const row = begin();
        if (letters === LETTERS[2]) key(row, "⇧", () => shift(!upper), "wide shift", "Shift");
        for (const letter of letters) {
          key(row, letter, () => type(upper ? letter.toUpperCase() : letter), "letter");
        }
        if (letters === LETTERS[2]) key(row, "⌫", erase, "wide", "Backspace");
      }
      const last = begin();
      key(last, "␣", () => type(" "), "space", "Space");
      key(last, "OK", enter, "wide enter-key");
    } else {
      for (const numbers of NUMBERS) {
        const row = begin();
        for (const number of numbers) key(row, number, () => type(number));
      }
      const last = begin();
      key(last, "⌫", erase, "", "Backspace");
      key(last, "0", () => type("0"));
      if (kind === "number") key(last, ".", () => type("."));
      key(last, "OK", enter, "enter-key");
    }
    panel.dataset.kind = kind;
    panel.replaceChildren(...rows);
  };

  panel.addEventListener("pointerdown", (event) => event.preventDefault());
  addEventListener("pointerdown", (event) => {
    if (event.pointerType === "touch") touched = true;
  }, { capture: true });

  const show = (target) => {
    const kind = target?.dataset.kind;
    field = target && ownKeys() && kind !== "date" ? target : null;
    if (field) {
      if (panel.hidden || panel.dataset.kind !== kind) build(kind);
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
