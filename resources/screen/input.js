// Something to type into: text, number, date or pin. Entered by Enter, by the button at its
// end, or as soon as `max` characters stand there; left without that, it is written, no more.

import { colour } from "./colours.js";
import { datePattern, dateRead, dateShown, dateTyped } from "./dates.js";
import { element } from "./element.js";
import { measure } from "./measures.js";

const MODES = { text: "text", number: "decimal", date: "text", pin: "numeric" };
const ALLOWED = { number: /[^0-9.,+-]/g, pin: /[^0-9]/g };

// What a person typed as the value that is sent; undefined: not (yet) one.
function valueOf(kind, field) {
  const typed = field.value;
  // The browser's own date field gives a date or nothing.
  if (kind === "date" && field.type === "text") return typed === "" ? "" : dateRead(typed);
  if (kind !== "number") return typed;
  const text = typed.trim().replace(",", ".");
  return text !== "" && Number.isFinite(Number(text)) ? Number(text) : undefined;
}

export function input(say) {
  const node = element("label", "input");
  const field = element("input", "", node);
  const enter = element("button", "enter", node);
  enter.type = "button";
  enter.setAttribute("aria-label", "OK");
  field.autocomplete = "off";
  field.spellcheck = false;
  field.setAttribute("autocapitalize", "off");
  field.enterKeyHint = "done";
  let shown = null;
  let given = null;
  let sent = "";
  let gone = false;

  const send = (how) => {
    if (gone) return;
    const value = valueOf(shown.kind, field);
    const wrong = value === undefined && (field.value !== "" || how === "use");
    node.classList.toggle("wrong", wrong);
    if (wrong || value === undefined) return;
    if (how === "write" && field.value === sent) return;
    sent = field.value;
    say[how](shown.id, { value });
  };
  // With our own keys a date is typed by digits: the browser's calendar is for fine pointers.
  const adapt = () => {
    const type = shown.kind === "date" && !say.ownKeys() ? "date" : "text";
    if (field.type !== type) {
      field.type = type;
      write(given ?? "");
    }
    field.placeholder = shown.kind === "date" && type === "text" ? datePattern() : "";
    field.inputMode = say.ownKeys() ? "none" : MODES[shown.kind];
  };
  const write = (value) => {
    const text = field.type === "text" && shown.kind === "date" ? dateShown(value) : value;
    if (field.value !== text) field.value = text;
    sent = field.value;
  };
  const full = () => shown.max !== undefined && [...field.value].length >= shown.max;
  const mark = () => {
    const empty = field.value === "";
    node.classList.toggle("empty", empty);
    node.classList.toggle("can-enter", Boolean(shown.event) && shown.max !== 1 && !empty);
  };

  // Whether fingers are used is known from the first touch on, which may be of this field.
  node.addEventListener("pointerdown", () => adapt());
  field.addEventListener("input", (event) => {
    const allowed = ALLOWED[shown.kind];
    if (allowed && allowed.test(field.value)) field.value = field.value.replace(allowed, "");
    if (shown.kind === "date" && field.type === "text") {
      field.value = dateTyped(field.value);
      if (dateRead(field.value) !== undefined) send("write");
    }
    if (shown.max !== undefined && !event.isComposing) {
      const typed = [...field.value];
      // A single letter is replaced by the next one, so that nobody has to find Backspace.
      if (shown.max === 1 && typed.length > 1) field.value = [...(event.data ?? typed.at(-1))].at(-1);
      else if (typed.length > shown.max) field.value = typed.slice(0, shown.max).join("");
    }
    node.classList.remove("wrong");
    mark();
    if (!event.isComposing && full() && field.value !== sent) send("use");
  });
  field.addEventListener("compositionend", () => {
    if (full() && field.value !== sent) send("use");
  });
  field.addEventListener("keydown", (event) => {
    if (event.key === "Enter" && !event.isComposing) {
      event.preventDefault();
      send("use");
    }
  });
  field.addEventListener("blur", () => send("write"));
  field.addEventListener("change", () => send("write"));
  enter.addEventListener("pointerdown", (event) => event.preventDefault());
  enter.addEventListener("click", () => send("use"));

  return {
    node,
    field,
    update(component) {
      shown = component;
      node.style.color = colour(component.color);
      field.dataset.kind = component.kind;
      adapt();
      field.setAttribute("aria-label", component.id);
      // What is being typed stays, unless the robot itself has set something new.
      if (component.value !== given) {
        given = component.value;
        write(given);
      }
      mark();
    },
    fit(component, unit) {
      node.classList.toggle("narrow", node.clientWidth < measure("input-slim"));
      const seen = measure("input-letters");
      const letters = component.kind === "date" ? seen : Math.min(component.max ?? 1, seen);
      const most = Math.min(node.clientHeight * measure("input-share"), field.clientWidth / (letters * measure("input-letter")));
      const wanted = (component.size ?? measure("input-size")) * unit;
      field.style.fontSize = `${Math.max(measure("least"), Math.min(most, wanted))}px`;
    },
    remove() {
      gone = true;
    },
  };
}
