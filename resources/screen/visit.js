// A visit to a page beside the robot's screen: in by a token, connected, in the robot's language.

import { Board, keepToken, load, token } from "./board.js";

const WORDS = {
  en: {
    on: "Connected", off: "Robot is away", token: "Token", enter: "Open", leave: "Forget the token on this device",
    why: "This robot lets in only whom it knows. Type the token that you were given.",
    wrongToken: "The robot does not know this token.", looking: "You can look only: your token is not an operator’s.",
  },
  ja: {
    on: "接続中", off: "ロボットに接続できません", token: "トークン", enter: "開く", leave: "この端末のトークンを消す",
    why: "このロボットは登録された人だけが使えます。受け取ったトークンを入力してください。",
    wrongToken: "このトークンは登録されていません。", looking: "閲覧のみです。このトークンでは変更できません。",
  },
  de: {
    on: "Verbunden", off: "Roboter nicht erreichbar", token: "Zugangscode", enter: "Öffnen", leave: "Zugangscode auf diesem Gerät vergessen",
    why: "Dieser Roboter lässt nur ein, wen er kennt. Bitte geben Sie Ihren Zugangscode ein.",
    wrongToken: "Der Roboter kennt diesen Zugangscode nicht.", looking: "Sie können nur lesen: Ihr Zugangscode erlaubt keine Änderungen.",
  },
};
const LANGUAGE = "language";

const node = (name) => document.getElementById(name);

// words: the page's own, by language, with its title. user: who writes, where there are no keys.
// begin({settings, data, states}) gives the patterns to watch; entry(tag, entry): what stands there now;
// speak(): the language is another one; show(): so is what may be done; empty(): a word for a
// page with nothing on it, or null.
export class Visit {
  board = null;
  connected = null; // null: not tried yet
  writes = false;
  #language = navigator.language;
  #known = true; // whether the robot knows the token
  #texts = {}; // by language, what is written in the project's settings to its translation
  #asked = null; // the language in which the robot's screen shows texts; null: as they are written

  constructor(page) {
    this.page = page;
    node("enter").addEventListener("submit", (event) => {
      event.preventDefault();
      keepToken(node("token").value.trim());
      node("token").value = "";
      this.start();
    });
    node("leave").addEventListener("click", () => {
      keepToken("");
      this.start();
    });
  }

  get may() {
    return Boolean(this.connected) && this.writes;
  }

  say(name, parts = {}) {
    return this.words[name].replace(/\{(\w+)\}/g, (_, part) => parts[part]);
  }

  // What is written in the project's settings, as the robot's screen would show it.
  text(written) {
    return this.#texts[this.#asked]?.[written] ?? written;
  }

  async start() {
    this.board?.close();
    this.board = null;
    let told = null;
    for (let wait = 300; ; wait = Math.min(wait * 1.6, 3000)) {
      try {
        told = await load("/settings.json");
        break;
      } catch {
        this.connected = false;
        this.#speak(this.#language);
        await new Promise((resolve) => setTimeout(resolve, wait));
      }
    }
    this.#known = told !== null;
    this.#texts = told?.texts ?? {};
    node("enter").hidden = this.#known;
    node("leave").hidden = !this.#known || !token();
    this.connected = null;
    const patterns = this.page.begin(told ?? { settings: [], data: [], states: {} });
    this.#speak(this.#language);
    if (!this.#known) {
      node("token").focus();
      return;
    }
    this.board = new Board(told.keyed ? null : this.page.user, [...new Set([...patterns, LANGUAGE])], {
      entry: (tag, entry) => {
        this.page.entry(tag, entry);
        if (tag !== LANGUAGE) return;
        this.#asked = entry.value;
        this.#speak(entry.value ?? "en");
      },
      open: (welcome) => {
        this.connected = true;
        this.writes = welcome.writes;
        node("robot").textContent = welcome.project;
        this.#show();
      },
      away: () => this.#away(),
    });
  }

  async #away() {
    if (this.connected === null) return;
    this.connected = false;
    this.#show();
    // A token that is no longer right has to be said: waiting would be for nothing.
    if ((await load("/settings.json").catch(() => undefined)) === null) this.start();
  }

  #speak(next) {
    const found = String(next).slice(0, 2).toLowerCase();
    this.#language = found in WORDS ? found : "en";
    this.words = { ...WORDS[this.#language], ...this.page.words[this.#language] };
    document.documentElement.lang = this.#language;
    document.title = this.words.title;
    document.querySelector("h1").textContent = this.words.title;
    document.querySelector("#enter label").textContent = this.words.token;
    document.querySelector("#enter button").textContent = this.words.enter;
    node("leave").textContent = this.words.leave;
    this.page.speak();
    this.#show();
  }

  #show() {
    node("enter-why").textContent = token() && !this.#known ? this.words.wrongToken : this.words.why;
    const link = node("link");
    link.dataset.is = this.connected === null ? "" : this.connected ? "on" : "off";
    link.textContent = this.connected === null ? "" : this.connected ? this.words.on : this.words.off;
    const none = this.page.empty();
    node("banner").hidden = !(this.connected && (!this.writes || none !== null));
    node("banner").textContent = none ?? this.words.looking;
    this.page.show();
  }
}
