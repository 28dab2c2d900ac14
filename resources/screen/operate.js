// An operator plays what the robot can not hear or see: the events that applications expect now,
// words that a person said, data, and touches of the screen; and says what it is to say.

import { Applications } from "./applications.js";
import { Data } from "./data.js";
import { element } from "./element.js";
import { WORDS } from "./operate_words.js";
import { Speaking } from "./speaking.js";
import { Visit } from "./visit.js";

const PAUSE = 500;
const SHOWN = 4000;
const SHOWN_REFUSAL = 9000;

const node = (name) => document.getElementById(name);
let asking = 0;
let acts = 0;
let fading = 0;
let breakpoints = [];

const visit = new Visit({
  words: WORDS,
  user: "operate",
  begin({ data: known, states }) {
    node("acts").hidden = true;
    node("robot-now").hidden = true;
    breakpoints = [];
    applications.begin(states);
    speaking.situation = null;
    return [...data.begin(known), "application/*", "situation", "speech.rate", "debugger.breakpoints"];
  },
  entry(tag, { value }) {
    data.entry(tag, { value });
    if (tag === "situation") speaking.situation = value;
    else if (tag === "speech.rate") speaking.rate = typeof value === "number" ? value : 100;
    else if (tag === "debugger.breakpoints") stops(value ?? []);
    if (tag === "situation" || tag.startsWith("application/")) ask();
  },
  speak() {
    const { words } = visit;
    document.querySelector("#say label").textContent = words.saying;
    document.querySelector("#say .row button").textContent = words.say;
    node("say-why").textContent = words.unspoken;
    node("hush").textContent = words.hush;
    document.querySelector("#heard label").textContent = words.heard;
    document.querySelector("#heard button").textContent = words.send;
    node("touch").textContent = words.touch;
    data.speak();
    stops(breakpoints);
    applications.forget();
    ask();
  },
  show() {
    node("acts").hidden = !visit.may;
    if (!visit.connected) speaking.lost();
    stops(breakpoints);
    applications.forget();
    ask();
  },
  empty: () => null,
});
const speaking = new Speaking(visit, tell, (on) => { node("hush").hidden = !on; });
const data = new Data(visit, act, tell);
const applications = new Applications(visit, { act, say: (text) => spoken(text), speaks: () => speaking.may });

// -- what is so now ----------------------------------------------------------------------

// Asked again and again: a guard may come to hold by data or by time.
async function ask() {
  clearTimeout(asking);
  asking = setTimeout(ask, PAUSE);
  if (!visit.connected || document.hidden) {
    applications.disable();
    return;
  }
  try {
    const before = acts;
    const [{ applications: told }, { modules }] = await Promise.all([visit.board.ask("expected"), visit.board.ask("modules")]);
    // What was so before something was done says nothing about what may be done next.
    if (before !== acts) return;
    const holds = Object.fromEntries(modules.map((one) => [one.name, one.holds]));
    applications.show(told, holds);
    now(holds, told);
  } catch { /* a new connection asks again */ }
}

// The situation, and the modules beside the applications that have something.
function now(holds, told) {
  const lines = [];
  if (speaking.situation) lines.push([visit.words.situation, speaking.situation.name]);
  for (const [name, has] of Object.entries(holds)) {
    if (has.length && !(name in told)) lines.push([name, has.join(", ")]);
  }
  const shown = JSON.stringify(lines);
  if (node("robot-now").dataset.shown !== shown) {
    node("robot-now").dataset.shown = shown;
    node("robot-now").replaceChildren(...lines.map(([name, what]) => {
      const line = element("div");
      element("dt", "", line).textContent = name;
      element("dd", "", line).textContent = what;
      return line;
    }));
  }
  node("robot-now").hidden = !lines.length;
  const may = speaking.may;
  node("say-why").hidden = may;
  for (const one of document.querySelectorAll("#say .row > *")) one.disabled = !may;
}

function stops(found) {
  breakpoints = found;
  node("breakpoints").hidden = !found.length;
  node("breakpoints").replaceChildren(...found.map(({ id, ...where }) => {
    const line = element("li", "card");
    const { application, state, from, to, situation, when } = where;
    const places = [application, state ?? situation, from && `${from} →`, to && `→ ${to}`, when];
    element("span", "", line).textContent = visit.say("stops", { place: places.filter(Boolean).join(" ") });
    const gone = element("button", "", line);
    gone.type = "button";
    gone.textContent = visit.words.unstop;
    gone.hidden = !visit.may;
    gone.addEventListener("click", () => act("unbreak", { breakpoint: id }, visit.words.unstopped));
    return line;
  }));
}

// -- what is done ----------------------------------------------------------------------

// Whether it was done; what came of it is told.
async function act(request, fields, done) {
  acts += 1;
  try {
    await visit.board.ask(request, fields);
    tell("", done);
    return true;
  } catch (refusal) {
    tell("wrong", refusal.code ? refusal.message : visit.words.away);
    return false;
  } finally {
    acts += 1;
    ask();
  }
}

async function spoken(text) {
  acts += 1;
  try {
    return await speaking.say(text);
  } finally {
    acts += 1;
    ask();
  }
}

function tell(is, text) {
  clearTimeout(fading);
  node("told").dataset.is = is;
  node("told").textContent = text;
  fading = setTimeout(() => { node("told").textContent = ""; }, is ? SHOWN_REFUSAL : SHOWN);
}

node("say").addEventListener("submit", async (event) => {
  event.preventDefault();
  const text = node("say-text").value.trim();
  if (!text) tell("wrong", visit.words.wordlessSay);
  else if (await spoken(text)) node("say-text").value = "";
});
node("hush").addEventListener("click", () => speaking.hush());

node("heard").addEventListener("submit", async (event) => {
  event.preventDefault();
  const text = node("heard-text").value.trim();
  if (!text) {
    tell("wrong", visit.words.wordless);
    return;
  }
  // As a recogniser that is certain would tell it.
  const heard = { text, confidence: 1 };
  if (await act("set", { tags: { heard } }, visit.say("said", { text }))) node("heard-text").value = "";
});

node("touch").addEventListener("click", () => act("touch", {}, visit.words.touched));

visit.start();
