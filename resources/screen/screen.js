// The robot's screen: shows what the robot sends, tells it what people do.

import { makers } from "./components.js";
import { colour } from "./colours.js";
import { element } from "./element.js";
import { even, fit, fontsCame, unit } from "./fit.js";
import { keyboard, ownKeys } from "./keys.js";
import { connect } from "./link.js";

const WORDS = {
  en: { robot: "One moment, please …", key: "This page is out of date. Please open it anew at the robot." },
  ja: { robot: "少々お待ちください…", key: "このページは古くなりました。ロボットからもう一度開いてください。" },
  de: { robot: "Einen Moment bitte …", key: "Diese Seite ist veraltet. Bitte am Roboter neu öffnen." },
};
const PATIENCE = 700; // a short break is not worth a word
const DOUBLE_TAP = 450;

const page = (name) => document.getElementById(name);
const stage = page("stage");
const layer = page("components");
const background = page("background");
const caption = page("caption");
const veil = page("veil");
const parts = new Map(); // key -> {node, update, fit, component}
let state = { revision: 0, since: 0 };
let words = WORDS.en;
let said = []; // the parts of what the caption says
let tap = { at: -Infinity, since: 0, x: 0, y: 0 };

// The key in the address was for the door; it need not stay where people can read it.
const address = new URL(location.href);
if (address.searchParams.has("token")) {
  address.searchParams.delete("token");
  history.replaceState(null, "", address);
}

const tell = connect(show, wait);
const say = {
  use: (component, more) => tell({ revision: state.revision, use: { component, ...more } }),
  write: (component, more) => tell({ revision: state.revision, write: { component, ...more } }),
  ended: (action, error) => tell({ revision: state.revision, ended: { action, error } }),
  isSecondTap: (event) => event.detail > 1 && state.since > tap.since,
  ownKeys,
};
const keys = keyboard(page("keys"), layout);

// -- showing -------------------------------------------------------------------

function show(next) {
  state = next;
  words = WORDS[next.lang.slice(0, 2)] ?? WORDS.en;
  document.documentElement.lang = next.lang;
  const screen = next.screen;
  stage.classList.toggle("idle", screen === null);
  page("idle").hidden = screen !== null;
  showBackground(screen?.background ?? null);
  showComponents(screen?.components ?? []);
  showCaption(next.captions, next.caption);
  layout();
}

// One that can not be had is left out: a broken picture behind everything tells nobody anything.
background.addEventListener("error", () => { background.hidden = true; });

function showBackground(src) {
  if ((background.getAttribute("src") ?? null) === src) return;
  background.hidden = src === null;
  if (src === null) background.removeAttribute("src");
  else background.setAttribute("src", src);
}

// A component stays the same node while its key does: no flicker, no lost caret, no restart.
const keyOf = ({ id, type, kind, tag }) => JSON.stringify([id, type, kind, tag]);

function showComponents(components) {
  const plain = components.filter((one) => one.type === "button" && !one.fill && !one.color);
  const alike = (one) => one.width === plain[0].width && one.height === plain[0].height;
  const equals = plain.length > 2 && plain.every(alike);
  const wanted = new Set(components.map(keyOf));
  for (const [key, part] of parts) {
    if (wanted.has(key)) continue;
    part.remove?.();
    if (part.node.contains(document.activeElement)) keys.hide();
    part.node.remove();
    parts.delete(key);
  }
  let before = null;
  for (const component of components) {
    const key = keyOf(component);
    let part = parts.get(key);
    if (!part) {
      part = makers[component.type](say);
      part.node.classList.add("component");
      part.node.dataset.id = component.id;
      parts.set(key, part);
    }
    // Of two or three answers the first is the one most people want; three of one size, as in a quiz,
    // and more are equals.
    component.first = plain.length <= 3 && !equals && component === plain[0];
    part.component = component;
    place(part.node, component);
    part.update(component);
    const behind = before === null ? layer.firstChild : before.nextSibling;
    // Moving a node would take its focus: only what stands in the wrong place is moved.
    if (part.node !== behind) layer.insertBefore(part.node, behind);
    before = part.node;
  }
  focusOnly(components.filter((one) => one.type === "input"));
}

function place({ style, dataset }, { x, y, width, height, align, fill }) {
  style.left = `${x}%`;
  style.top = `${y}%`;
  style.width = `${width}%`;
  style.height = `${height}%`;
  style.backgroundColor = colour(fill);
  dataset.align = align ?? "";
  dataset.filled = String(Boolean(fill));
}

// Where there is one thing to type, typing begins at once.
let focused = null;
function focusOnly(inputs) {
  const only = inputs.length === 1 ? parts.get(keyOf(inputs[0])) : null;
  if (only && only !== focused) only.field.focus({ preventScroll: true });
  focused = only;
}

function showCaption(on, spoken) {
  caption.hidden = !on;
  const line = caption.firstElementChild;
  caption.classList.toggle("speaking", spoken !== null);
  if (spoken !== null) {
    said = spoken.parts;
    line.lang = spoken.lang;
  }
}

function layout() {
  const size = unit(layer);
  stage.style.setProperty("--unit", `${size}px`);
  for (const part of parts.values()) part.fit?.(part.component, size);
  even(parts.values());
  for (const part of parts.values()) part.balance?.();
  if (!caption.hidden) fit(caption, caption.firstElementChild, caption.clientHeight * 0.4, said);
}

new ResizeObserver(layout).observe(stage);
document.fonts.addEventListener("loadingdone", () => {
  fontsCame();
  layout();
});

// -- what people do --------------------------------------------------------------

// Texts and pictures do nothing by themselves: a touch of them is a touch of the screen.
stage.addEventListener("pointerdown", (event) => {
  if (event.timeStamp - tap.at > DOUBLE_TAP) tap.since = state.since;
  tap.at = event.timeStamp;
});
stage.addEventListener("click", (event) => {
  if (event.target.closest("button, .input, .list")) return;
  ripple(event.clientX, event.clientY);
  if (!say.isSecondTap(event)) tell({ revision: state.revision, touch: true });
});

function ripple(x, y) {
  const { left, top } = stage.getBoundingClientRect();
  const ring = element("i", "ripple", stage);
  ring.style.left = `${x - left}px`;
  ring.style.top = `${y - top}px`;
  ring.addEventListener("animationend", () => ring.remove());
}

addEventListener("contextmenu", (event) => event.preventDefault());
addEventListener("dragstart", (event) => event.preventDefault());

// -- waiting -----------------------------------------------------------------------

let patience = 0;
function wait(why) {
  if (why === null) {
    clearTimeout(patience);
    patience = 0;
    veil.hidden = true;
    return;
  }
  const lift = () => {
    veil.dataset.why = why;
    veil.lastElementChild.textContent = words[why];
    veil.hidden = false;
  };
  if (why === "key" || !veil.hidden) lift();
  else if (!patience) patience = setTimeout(lift, PATIENCE);
}
