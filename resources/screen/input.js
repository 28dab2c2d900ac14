// Something to type into: text, number, date or pin. Entered by Enter, by the button at its
// end, or as soon as `max` characters stand there; left without that, it is written, no more.

import { colour } from "./colours.js";
import { element } from "./element.js";

const MODES = { text: "text", number: "decimal", date: "text", pin: "numeric" };
const ALLOWED = { number: /[^0-9.,+-]/g, pin: /[^0-9]/g };

// What a person typed as the value that is sent; undefined: not (yet) one.
function valueOf(kind, typed) {
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
    const value = valueOf(shown.kind, field.value);
    const wrong = value === undefined && (field.value !== "" || how === "use");
    node.classList.toggle("wrong", wrong);
    if (wrong || value === undefined) return;
    if (how === "write" && field.value === sent) return;
    sent = field.value;
    say[how](shown.id, { value });
  };
  const full = () => shown.max !== undefined && [...field.value].length >= shown.max;
  const mark = () => {
    const empty = field.value === "";
    node.classList.toggle("empty", empty);
    node.classList.toggle("can-enter", Boolean(shown.event) && shown.max !== 1 && !empty);
  };

  field.addEventListener("input", (event) => {
    const allowed = ALLOWED[shown.kind];
    if (allowed && allowed.test(field.value)) field.value = field.value.replace(allowed, "");
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
      const type = component.kind === "date" ? "date" : "text";
      field.dataset.kind = component.kind;
      if (field.type !== type) field.type = type;
      field.inputMode = say.ownKeys() ? "none" : MODES[component.kind];
      field.setAttribute("aria-label", component.id);
      // What is being typed stays, unless the robot itself has set something new.
      if (component.value !== given) {
        given = component.value;
        if (field.value !== given) field.value = given;
        sent = field.value;
      }
      mark();
    },
    fit(component, unit) {
      const letters = component.kind === "date" ? 9 : Math.min(component.max ?? 1, 12);
      const most = Math.min(node.clientHeight * 0.62, field.clientWidth / (letters * 0.68));
      field.style.fontSize = `${Math.max(14, Math.min(most, (component.size ?? 7) * unit))}px`;
    },
    remove() {
      gone = true;
    },
  };
}
