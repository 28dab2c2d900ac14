// An operator plays what the robot can not hear or see: the events that applications expect now,
// words that a person said, data, and touches of the screen.

import { element } from "./element.js";
import { told } from "./fields.js";
import { Visit } from "./visit.js";

const WORDS = {
  en: {
    title: "Operate", suspended: "Suspended: it waits for its resources", paused: "Paused", pause: "Pause", resume: "Go on",
    nothing: "It expects no event.", when: "Only where {when}", back: "Nowhere to go back to", or: " or ",
    heard: "What a person said", send: "Send", data: "Set data", tag: "Tag", value: "Value", set: "Set", now: "Now {value}", unset: "Now not set",
    touch: "Touch the screen", raised: "{name} raised", said: "“{text}” sent", wrote: "{tag} set", touched: "Screen touched",
    away: "The robot is away. Try again.", tagless: "Type a tag first", wordless: "Type what was said first",
  },
  ja: {
    title: "操作", suspended: "中断中：資源を待っています", paused: "一時停止中", pause: "一時停止", resume: "再開",
    nothing: "待っているイベントはありません。", when: "条件：{when}", back: "戻り先がありません", or: " または ",
    heard: "人が言ったこと", send: "送る", data: "データを設定", tag: "タグ", value: "値", set: "設定", now: "現在：{value}", unset: "現在：未設定",
    touch: "画面にタッチ", raised: "{name}を送りました", said: "「{text}」を送りました", wrote: "{tag}を設定しました", touched: "画面にタッチしました",
    away: "ロボットに接続できません。もう一度お試しください。", tagless: "タグを入力してください", wordless: "言ったことを入力してください",
  },
  de: {
    title: "Bedienen", suspended: "Unterbrochen: wartet auf ihre Ressourcen", paused: "Angehalten", pause: "Anhalten", resume: "Weiter",
    nothing: "Erwartet kein Ereignis.", when: "Nur wenn {when}", back: "Kein Zustand, zu dem es zurückgeht", or: " oder ",
    heard: "Was jemand gesagt hat", send: "Senden", data: "Daten setzen", tag: "Tag", value: "Wert", set: "Setzen", now: "Jetzt {value}", unset: "Jetzt nicht gesetzt",
    touch: "Bildschirm berühren", raised: "{name} ausgelöst", said: "„{text}“ gesendet", wrote: "{tag} gesetzt", touched: "Bildschirm berührt",
    away: "Der Roboter ist nicht erreichbar. Bitte noch einmal versuchen.", tagless: "Bitte erst einen Tag eingeben", wordless: "Bitte erst eingeben, was gesagt wurde",
  },
};
const PAUSE = 500;
const PAUSING = "#pause"; // no event is called so
const SHOWN = 4000;
const SHOWN_REFUSAL = 9000;

const node = (name) => document.getElementById(name);
const cards = new Map(); // application -> {node, since, shown, time}
let asking = 0;
let acts = 0;
let fading = 0;

const visit = new Visit({
  words: WORDS,
  user: "operate",
  begin() {
    node("acts").hidden = true;
    cards.clear();
    node("applications").replaceChildren();
    return ["application/*"];
  },
  entry(tag) {
    if (tag.startsWith("application/")) ask();
  },
  speak() {
    const { words } = visit;
    document.querySelector("#heard label").textContent = words.heard;
    document.querySelector("#heard button").textContent = words.send;
    node("data-title").textContent = words.data;
    document.querySelector('label[for="data-tag"]').textContent = words.tag;
    document.querySelector('label[for="data-value"]').textContent = words.value;
    document.querySelector("#data button").textContent = words.set;
    node("touch").textContent = words.touch;
    for (const card of cards.values()) card.shown = null;
    ask();
  },
  show() {
    node("acts").hidden = !visit.may;
    for (const card of cards.values()) card.shown = null;
    ask();
  },
  empty: () => null,
});

// -- applications ----------------------------------------------------------------------

// Asked again and again: a guard may come to hold by data or by time.
async function ask() {
  clearTimeout(asking);
  asking = setTimeout(ask, PAUSE);
  if (!visit.connected || document.hidden) {
    for (const card of cards.values()) {
      card.shown = null;
      for (const one of card.node.querySelectorAll("button")) one.disabled = true;
    }
    return;
  }
  try {
    const before = acts;
    const { applications } = await visit.board.ask("expected");
    // What was so before something was done says nothing about what may be done next.
    if (before !== acts) return;
    for (const [name, expectation] of Object.entries(applications)) show(name, expectation);
  } catch { /* a new connection asks again */ }
}

function show(name, { time, ...expectation }) {
  let card = cards.get(name);
  if (!card) {
    card = { node: element("article", "card application", node("applications")), shown: null };
    card.node.dataset.application = name;
    cards.set(name, card);
  }
  const shown = JSON.stringify(expectation);
  if (card.shown !== shown) {
    card.shown = shown;
    draw(card, name, expectation);
  }
  card.since.textContent = age((visit.board.time - time) / 1e6);
}

function draw(card, name, { state, name: called, suspended, paused, events }) {
  const focused = card.node.contains(document.activeElement) ? document.activeElement.dataset.event : card.used;
  card.node.replaceChildren();
  element("h2", "", card.node).textContent = name;
  const line = element("p", "state", card.node);
  element("span", "", line).textContent = called ? `${called} (${state})` : state;
  card.since = element("span", "since", line);
  if (suspended) element("p", "note", card.node).textContent = visit.words.suspended;
  if (paused) element("p", "note", card.node).textContent = visit.words.paused;
  if (!events.length) element("p", "", card.node).textContent = visit.words.nothing;
  const list = element("div", "events", card.node);
  for (const event of events) {
    const button = element("button", event.says.length ? "first" : "", list);
    button.type = "button";
    button.dataset.event = event.name;
    button.disabled = !visit.may || suspended || paused || !event.holds;
    element("span", "", button).textContent = event.name;
    if (event.says.length) element("small", "", button).textContent = event.says.map((one) => `“${one}”`).join(" ");
    if (!event.holds) {
      const when = event.when.join(visit.words.or);
      element("small", "", button).textContent = when ? visit.say("when", { when }) : visit.words.back;
    }
    button.addEventListener("click", () => {
      // Once: a second tap would meet the next state.
      for (const one of list.children) one.disabled = true;
      card.shown = null;
      act("publish", { event: event.name, application: name }, visit.say("raised", { name: event.name }));
    });
    if (event.name === focused) button.focus();
  }
  if (!visit.may) return;
  const halt = element("button", "pause", card.node);
  halt.type = "button";
  halt.dataset.event = PAUSING;
  halt.textContent = paused ? visit.words.resume : visit.words.pause;
  halt.addEventListener("click", () => {
    // What can not be used has no focus: it comes back to what stands in its place.
    card.used = PAUSING;
    halt.disabled = true;
    card.shown = null;
    act(paused ? "resume" : "pause", { application: name }, halt.textContent);
  });
  if (focused === PAUSING && document.activeElement === document.body) halt.focus();
  card.used = null;
}

function age(seconds) {
  const whole = Math.max(0, Math.floor(seconds));
  const [unit, count] = whole < 60 ? ["second", whole] : whole < 3600 ? ["minute", Math.floor(whole / 60)] : ["hour", Math.floor(whole / 3600)];
  return new Intl.NumberFormat(document.documentElement.lang, { style: "unit", unit, unitDisplay: "short" }).format(count);
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

function tell(is, text) {
  clearTimeout(fading);
  node("told").dataset.is = is;
  node("told").textContent = text;
  fading = setTimeout(() => { node("told").textContent = ""; }, is ? SHOWN_REFUSAL : SHOWN);
}

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

// JSON where it is some, else the text as it stands; nothing deletes.
function read(text) {
  if (text.trim() === "") return null;
  try {
    return JSON.parse(text);
  } catch {
    return text;
  }
}

async function look() {
  const tag = node("data-tag").value.trim();
  node("data-now").textContent = "";
  if (!tag || !visit.connected) return;
  try {
    const { entries } = await visit.board.ask("get", { names: [tag] });
    const value = entries[tag]?.value ?? null;
    if (tag !== node("data-tag").value.trim()) return;
    node("data-now").textContent = value === null ? visit.words.unset : visit.say("now", { value: told(value) });
  } catch { /* no tag yet: it is being typed */ }
}

// What the script looks at and modules should provide, and what stands there already.
async function suggest() {
  try {
    const { wanted } = await visit.board.ask("modules");
    const { entries } = await visit.board.ask("get", { names: ["**"] });
    const tags = new Set([...wanted.map((one) => one.data), ...Object.keys(entries)]);
    const plain = [...tags].filter((tag) => tag && !tag.includes("/") && !tag.startsWith("clock.")).sort();
    node("data-tags").replaceChildren(...plain.map((tag) => new Option(tag, tag)));
  } catch { /* away */ }
}

node("data-tag").addEventListener("focus", suggest);
node("data-tag").addEventListener("input", look);
node("data").addEventListener("submit", async (event) => {
  event.preventDefault();
  const tag = node("data-tag").value.trim();
  if (!tag) {
    tell("wrong", visit.words.tagless);
    return;
  }
  const done = await act("set", { tags: { [tag]: read(node("data-value").value) } }, visit.say("wrote", { tag }));
  if (done) node("data-value").value = "";
  look();
});

visit.start();
