// Data that an operator sets: each known tag by its type, and any other as JSON or text.

import { element } from "./element.js";
import { field, told } from "./fields.js";

const node = (name) => document.getElementById(name);

// act(request, fields, words): whether it was done.
export class Data {
  #rows = new Map();

  constructor(visit, act, tell) {
    this.visit = visit;
    this.act = act;
    this.tell = tell;
    node("data-tag").addEventListener("focus", () => this.#suggest());
    node("data-tag").addEventListener("input", () => this.#look());
    node("other-data").addEventListener("submit", (event) => {
      event.preventDefault();
      this.#set();
    });
  }

  // The tags to watch.
  begin(data) {
    this.#rows.clear();
    for (const one of data) this.#rows.set(one.tag, this.#row(one));
    node("known-data").replaceChildren(...[...this.#rows.values()].map((row) => row.node));
    return [...this.#rows.keys()];
  }

  entry(tag, entry) {
    this.#rows.get(tag)?.entry(entry.value);
  }

  speak() {
    const { words } = this.visit;
    node("data-title").textContent = words.data;
    document.querySelector('label[for="data-tag"]').textContent = words.other;
    document.querySelector('label[for="data-value"]').textContent = words.value;
    document.querySelector("#other-data button").textContent = words.set;
    for (const row of this.#rows.values()) row.speak();
  }

  #row(datum) {
    const { visit } = this;
    const made = field({ ...datum, tag: `data ${datum.tag}` }, visit);
    const form = element("form", `datum ${datum.type}`);
    form.noValidate = true;
    form.dataset.tag = datum.tag;
    const title = element(made.field ? "label" : "p", "label", form);
    title.id = `name-of-${datum.tag}`;
    if (made.field) {
      made.field.id = `value-of-${datum.tag}`;
      title.htmlFor = made.field.id;
    } else {
      made.node.setAttribute("aria-labelledby", title.id);
    }
    const row = element("div", "row", form);
    let speak = () => {};
    if (datum.type === "number") speak = stepper(made, row, visit, () => put());
    else row.append(made.node);
    const set = made.atOnce ? null : element("button", "", row);
    if (set) set.type = "submit";
    const note = element("p", "note", form);
    let value = null;
    let dirty = false;

    const says = () => { note.textContent = value === null ? visit.words.unset : visit.say("now", { value: made.told(value) }); };
    const put = async () => {
      const { value: filled, wrong } = made.read();
      if (wrong) {
        this.tell("wrong", visit.words[wrong]);
        return;
      }
      dirty = false;
      if (!(await this.act("set", { tags: { [datum.tag]: filled } }, visit.say("wrote", { tag: datum.tag })))) made.put(value);
    };
    form.addEventListener("input", () => { dirty = !made.atOnce; });
    form.addEventListener("change", () => { if (made.atOnce) put(); });
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      put();
    });
    return {
      node: form,
      entry(now) {
        value = now;
        if (!dirty) made.put(value);
        says();
      },
      speak() {
        title.textContent = (datum.label ? visit.text(datum.label) : datum.tag) + (datum.unit ? ` (${datum.unit})` : "");
        made.speak();
        if (set) set.textContent = visit.words.set;
        speak();
        says();
      },
    };
  }

  async #set() {
    const tag = node("data-tag").value.trim();
    if (!tag) {
      this.tell("wrong", this.visit.words.tagless);
      return;
    }
    const done = await this.act("set", { tags: { [tag]: read(node("data-value").value) } }, this.visit.say("wrote", { tag }));
    if (done) node("data-value").value = "";
    this.#look();
  }

  async #look() {
    const tag = node("data-tag").value.trim();
    node("data-now").textContent = "";
    if (!tag || !this.visit.connected) return;
    try {
      const { entries } = await this.visit.board.ask("get", { names: [tag] });
      const value = entries[tag]?.value ?? null;
      if (tag !== node("data-tag").value.trim()) return;
      node("data-now").textContent = value === null ? this.visit.words.unset : this.visit.say("now", { value: told(value) });
    } catch { /* no tag yet: it is being typed */ }
  }

  // What the script looks at and modules should provide, and what stands there already.
  async #suggest() {
    try {
      const { wanted } = await this.visit.board.ask("modules");
      const { entries } = await this.visit.board.ask("get", { names: ["**"] });
      const tags = new Set([...wanted.map((one) => one.data), ...Object.keys(entries)]);
      const plain = [...tags].filter((tag) => tag && !tag.includes("/") && !tag.startsWith("clock.")).sort();
      node("data-tags").replaceChildren(...plain.map((tag) => new Option(tag, tag)));
    } catch { /* away */ }
  }
}

// JSON where it is some, else the text as it stands; nothing deletes.
function read(text) {
  if (text.trim() === "") return null;
  try {
    return JSON.parse(text);
  } catch {
    return text;
  }
}

// A number with one less and one more beside it, each set at once. Gives what speaks its words.
function stepper(made, row, visit, put) {
  const box = element("div", "stepper", row);
  const step = (sign, by) => {
    const button = element("button", "", box);
    button.type = "button";
    button.textContent = sign;
    button.addEventListener("click", () => {
      const { value } = made.read();
      // In the last place that is written: 0.5 goes on by tenths.
      const places = (String(value ?? 0).split(".")[1] ?? "").length;
      made.put(Number(((value ?? 0) + by / 10 ** places).toFixed(places)));
      put();
    });
    return button;
  };
  const less = step("−", -1);
  box.append(made.node);
  const more = step("+", 1);
  return () => {
    const name = row.parentElement.querySelector(".label").textContent;
    less.setAttribute("aria-label", `${visit.words.less}: ${name}`);
    more.setAttribute("aria-label", `${visit.words.moreOf}: ${name}`);
  };
}
