// Values of a setting's type: what a person fills in, what it means, how it is told.
// `read` gives {value}, null where it was left empty, or {wrong: a word's key}.

import { isDay } from "./dates.js";
import { element } from "./element.js";

const TIME = /^([01]\d|2[0-3]):[0-5]\d$/;
const NUMBER = /^[+-]?(\d+([.,]\d*)?|[.,]\d+)$/;

function input(kind, more) {
  const node = document.createElement("input");
  Object.assign(node, { type: kind, autocomplete: "off" }, more);
  return node;
}

// One line that is typed, saved by its button or Enter.
function typed(node, fits, meaning = (text) => text) {
  return {
    node,
    field: node,
    atOnce: false,
    put(value) { node.value = value === null || !fits(value) ? "" : String(value); },
    fits: (value) => value === null || fits(value),
    read() {
      if (node.validity.badInput) return { wrong: node.dataset.kind };
      const text = node.value.trim();
      if (text === "") return { value: null };
      const value = meaning(text);
      return value === undefined ? { wrong: node.dataset.kind } : { value };
    },
  };
}

const makers = {
  text: () => typed(input("text", { maxLength: 10000 }), (value) => typeof value === "string"),
  number() {
    // A field of the browser's type number takes other commas than people type.
    const node = input("text", { inputMode: "decimal" });
    const meaning = (text) => {
      const value = NUMBER.test(text) ? Number(text.replace(",", ".")) : NaN;
      return Number.isFinite(value) ? value : undefined;
    };
    return typed(node, (value) => typeof value === "number", meaning);
  },
  time: () => typed(input("time"), (value) => TIME.test(value), (text) => TIME.exec(text)?.[0]),
  date() {
    const node = input("date", { min: "0001-01-01", max: "9999-12-31" });
    return typed(node, (value) => typeof value === "string" && isDay(value), (text) => (isDay(text) ? text : undefined));
  },
  boolean() {
    const node = input("checkbox");
    node.setAttribute("role", "switch");
    return {
      node,
      field: node,
      atOnce: true,
      put(value) { node.checked = value === true; },
      fits: (value) => value === null || typeof value === "boolean",
      read: () => ({ value: node.checked }),
    };
  },
  choice({ choices, tag }, visit) {
    const node = document.createElement("div");
    node.className = "choices";
    node.setAttribute("role", "radiogroup");
    const radios = choices.map((choice) => {
      const label = node.appendChild(document.createElement("label"));
      const radio = label.appendChild(input("radio", { name: tag, value: choice }));
      return { radio, shown: element("span", "", label) };
    });
    return {
      node,
      field: null,
      atOnce: true,
      put(value) { for (const { radio } of radios) radio.checked = radio.value === value; },
      fits: (value) => value === null || choices.includes(value),
      read: () => ({ value: radios.find(({ radio }) => radio.checked)?.radio.value ?? null }),
      speak() { for (const { radio, shown } of radios) shown.textContent = visit.text(radio.value); },
      told: (value) => (choices.includes(value) ? visit.text(value) : told(value)),
    };
  },
};

// speak(): the visit's language is another one; told(value): the value as people read it there.
export function field(form, visit) {
  const made = { speak() {}, told, ...makers[form.type](form, visit) };
  made.node.dataset.kind = form.type;
  return made;
}

// A value as people read it.
export function told(value) {
  return typeof value === "string" ? value : JSON.stringify(value);
}
