// A card for each application: its state, what it expects, what it says, and its debugger.

import { element } from "./element.js";

const PAUSING = "#pause"; // no event is called so
const STEPPING = "#step";

// doing: act(request, fields, words), say(text), speaks(): whether an operator's words can be said.
export class Applications {
  #cards = new Map();
  #states = {};
  #pressed = false;
  #late = null; // what came while somebody pressed

  constructor(visit, doing) {
    this.visit = visit;
    this.doing = doing;
    this.node = document.getElementById("applications");
    // Nothing moves under a finger: what changes meanwhile is shown when it has gone.
    this.node.addEventListener("pointerdown", () => { this.#pressed = true; });
    for (const end of ["pointerup", "pointercancel"]) {
      addEventListener(end, () => setTimeout(() => this.#release(), 0));
    }
  }

  begin(states) {
    this.#states = states;
    this.#cards.clear();
    this.#late = null;
    this.node.replaceChildren();
  }

  // Everything is drawn anew with the next that comes.
  forget() {
    for (const card of this.#cards.values()) card.shown = null;
  }

  disable() {
    this.forget();
    for (const one of this.node.querySelectorAll("button, select")) one.disabled = true;
  }

  show(applications, holds) {
    if (this.#pressed) {
      this.#late = [applications, holds];
      return;
    }
    for (const [name, { time, ...expectation }] of Object.entries(applications)) {
      const card = this.#cards.get(name) ?? this.#make(name);
      const shown = JSON.stringify([expectation, holds[name], this.visit.may, this.doing.speaks()]);
      if (card.shown !== shown) {
        card.shown = shown;
        this.#draw(card, name, expectation, holds[name] ?? []);
      }
      card.since.textContent = age((this.visit.board.time - time) / 1e6);
    }
  }

  #release() {
    this.#pressed = false;
    const late = this.#late;
    this.#late = null;
    if (late) this.show(...late);
  }

  #make(name) {
    const node = element("article", "card application", this.node);
    node.dataset.application = name;
    const title = element("h2", "", node);
    title.textContent = name;
    const card = { node, body: element("div", "body", node), shown: null, used: null };
    card.more = this.#more(name, node);
    this.#cards.set(name, card);
    return card;
  }

  // Where it can be sent, and where it is to stop: kept as it stands while the rest is drawn anew.
  #more(name, node) {
    const details = element("details", "more", node);
    const summary = element("summary", "", details);
    const form = element("div", "places", details);
    const choice = element("select", "", form);
    for (const { path, name: called } of this.#states[name] ?? []) {
      choice.append(new Option(called ? `${called} (${path})` : path, path));
    }
    const button = (request, word) => {
      const made = element("button", "", form);
      made.type = "button";
      made.addEventListener("click", () => {
        const fields = { application: name, state: choice.value };
        this.doing.act(request, fields, this.visit.say(word, { state: choice.selectedOptions[0].textContent }));
      });
      return made;
    };
    const go = button("goto", "went");
    const stop = button("break", "stopping");
    return { details, speak: (words, may) => {
      summary.textContent = words.more;
      choice.setAttribute("aria-label", words.state);
      go.textContent = words.go;
      stop.textContent = words.stop;
      details.hidden = !may || !choice.options.length;
      for (const one of [choice, go, stop]) one.disabled = !may;
    } };
  }

  #draw(card, name, { state, name: called, suspended, paused, events, speeches }, holds) {
    const { visit, doing } = this;
    const { words } = visit;
    const { body } = card;
    const focused = body.contains(document.activeElement) ? document.activeElement.dataset.event : card.used;
    body.replaceChildren();
    card.more.speak(words, visit.may);
    const line = element("p", "state", body);
    element("span", "", line).textContent = called ? `${called} (${state})` : state;
    card.since = element("span", "since", line);
    if (holds.length) element("p", "holds", body).textContent = `${words.holds} ${holds.join(", ")}`;
    if (suspended) element("p", "note", body).textContent = words.suspended;
    if (paused) element("p", "note", body).textContent = words.paused;
    if (!events.length) element("p", "", body).textContent = words.nothing;
    const list = element("div", "events", body);
    const buttons = [];
    const button = (className, key, parent, enabled, press) => {
      const made = element("button", className, parent);
      made.type = "button";
      made.dataset.event = key;
      made.disabled = !enabled;
      made.addEventListener("click", () => {
        // Once: a second tap would meet the next state.
        for (const one of buttons) one.disabled = true;
        card.used = key;
        card.shown = null;
        press();
      });
      buttons.push(made);
      return made;
    };
    for (const event of events) {
      const may = visit.may && !suspended && !paused && event.holds;
      const made = button(event.says.length ? "first" : "", event.name, list, may, () =>
        doing.act("publish", { event: event.name, application: name }, visit.say("raised", { name: event.name })));
      element("span", "", made).textContent = event.name;
      if (event.says.length) element("small", "", made).textContent = event.says.map((one) => `“${one}”`).join(" ");
      if (!event.holds) {
        const when = event.when.join(words.or);
        element("small", "", made).textContent = when ? visit.say("when", { when }) : words.back;
      }
    }
    if (speeches.length && visit.may) {
      element("h3", "", body).textContent = words.says;
      const said = element("div", "speeches", body);
      for (const [number, text] of speeches.entries()) {
        const made = button("", `say ${number}`, said, doing.speaks(), () => doing.say(text));
        made.textContent = visit.say("spoken", { text });
      }
    }
    if (visit.may) {
      const row = element("div", "debug", body);
      const halt = button("pause", PAUSING, row, true, () =>
        doing.act(paused ? "resume" : "pause", { application: name }, paused ? words.resume : words.paused));
      halt.textContent = paused ? words.resume : words.pause;
      if (paused) button("", STEPPING, row, true, () => doing.act("step", { application: name }, words.step)).textContent = words.step;
    }
    // What can not be used has no focus: it comes back to what stands in its place.
    if (focused && [document.body, null].includes(document.activeElement)) {
      buttons.find((one) => one.dataset.event === focused)?.focus({ preventScroll: true });
    }
    card.used = null;
  }
}

function age(seconds) {
  const whole = Math.max(0, Math.floor(seconds));
  const [unit, count] = whole < 60 ? ["second", whole] : whole < 3600 ? ["minute", Math.floor(whole / 60)] : ["hour", Math.floor(whole / 3600)];
  return new Intl.NumberFormat(document.documentElement.lang, { style: "unit", unit, unitDisplay: "short" }).format(count);
}
