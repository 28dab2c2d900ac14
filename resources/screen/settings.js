// Settings that end users change: a form for each, with what stands at its tag now.

import { Board, keepToken, load, token } from "./board.js";
import { element } from "./element.js";
import { field, told } from "./fields.js";

const WORDS = {
  en: {
    title: "Settings", on: "Connected", off: "Robot is away", save: "Save", cancel: "Cancel", token: "Token",
    why: "This robot lets in only whom it knows. Type the token that you were given.",
    wrongToken: "The robot does not know this token.", enter: "Open", leave: "Forget the token on this device",
    looking: "You can look only: your token is not an operator’s.", none: "This robot has no settings.",
    saving: "Saving …", saved: "Saved at {at}", refused: "Not saved: {why}", away: "Not saved: the robot is away. Try again.",
    changed: "Meanwhile changed to {value} by {who}. Save to put yours in its place.", cleared: "Meanwhile cleared by {who}. Save to put yours in its place.",
    by: "Changed by {who} at {at}", unset: "Not set", unfit: "Now {value}, which does not fit here",
    number: "Type a number, such as 12 or 0.5", time: "Type a time, such as 08:30", date: "Type a day of the calendar",
  },
  ja: {
    title: "設定", on: "接続中", off: "ロボットに接続できません", save: "保存", cancel: "取消", token: "トークン",
    why: "このロボットは登録された人だけが使えます。受け取ったトークンを入力してください。",
    wrongToken: "このトークンは登録されていません。", enter: "開く", leave: "この端末のトークンを消す",
    looking: "閲覧のみです。このトークンでは変更できません。", none: "このロボットには設定がありません。",
    saving: "保存しています…", saved: "{at}に保存しました", refused: "保存できません：{why}", away: "保存できません。ロボットに接続できません。もう一度お試しください。",
    changed: "{who}が{value}に変更しました。保存すると入力した値になります。", cleared: "{who}が値を消しました。保存すると入力した値になります。",
    by: "{at}に{who}が変更しました", unset: "未設定", unfit: "現在の値{value}はここに合いません",
    number: "数字を入力してください（例：12、0.5）", time: "時刻を入力してください（例：08:30）", date: "日付を入力してください",
  },
  de: {
    title: "Einstellungen", on: "Verbunden", off: "Roboter nicht erreichbar", save: "Speichern", cancel: "Abbrechen", token: "Zugangscode",
    why: "Dieser Roboter lässt nur ein, wen er kennt. Bitte geben Sie Ihren Zugangscode ein.",
    wrongToken: "Der Roboter kennt diesen Zugangscode nicht.", enter: "Öffnen", leave: "Zugangscode auf diesem Gerät vergessen",
    looking: "Sie können nur lesen: Ihr Zugangscode erlaubt keine Änderungen.", none: "Dieser Roboter hat keine Einstellungen.",
    saving: "Wird gespeichert …", saved: "Gespeichert um {at}", refused: "Nicht gespeichert: {why}", away: "Nicht gespeichert: Der Roboter ist nicht erreichbar. Bitte noch einmal versuchen.",
    changed: "Inzwischen von {who} auf {value} geändert. Speichern setzt Ihren Wert ein.", cleared: "Inzwischen von {who} gelöscht. Speichern setzt Ihren Wert ein.",
    by: "Von {who} um {at} geändert", unset: "Nicht gesetzt", unfit: "Jetzt {value}: das passt hier nicht",
    number: "Bitte eine Zahl eingeben, etwa 12 oder 0,5", time: "Bitte eine Uhrzeit eingeben, etwa 08:30", date: "Bitte einen Tag des Kalenders eingeben",
  },
};
const LANGUAGE = "language";

const page = (name) => document.getElementById(name);
const cards = new Map(); // tag -> card
let language = navigator.language;
let words = WORDS.en;
let board = null;
let writes = false;
let connected = null; // null: not tried yet
let known = true; // whether the robot knows the token

function say(name, parts = {}) {
  return words[name].replace(/\{(\w+)\}/g, (_, part) => parts[part]);
}

function now() {
  return new Intl.DateTimeFormat(document.documentElement.lang, { timeStyle: "short" }).format(new Date());
}

// Who wrote, as people call him.
function who(writer) {
  return (writer ?? "").replace(/^\w+:/, "");
}

function speak(next) {
  const found = String(next).slice(0, 2).toLowerCase();
  language = found in WORDS ? found : "en";
  words = WORDS[language];
  document.documentElement.lang = language;
  document.title = words.title;
  document.querySelector("h1").textContent = words.title;
  document.querySelector("#enter label").textContent = words.token;
  document.querySelector("#enter button").textContent = words.enter;
  page("leave").textContent = words.leave;
  for (const card of cards.values()) card.speak();
  show();
}

function show() {
  page("enter-why").textContent = token() && !known ? words.wrongToken : words.why;
  const link = page("link");
  link.dataset.is = connected === null ? "" : connected ? "on" : "off";
  link.textContent = connected === null ? "" : connected ? words.on : words.off;
  const banner = page("banner");
  banner.hidden = !(connected && (!writes || cards.size === 0));
  banner.textContent = cards.size === 0 ? words.none : words.looking;
  for (const card of cards.values()) card.allow(Boolean(connected) && writes);
}

// -- one setting ---------------------------------------------------------------------

function card(form, number) {
  const made = field(form);
  const node = element("form", `card setting ${form.type}`);
  node.noValidate = true;
  node.dataset.tag = form.tag;
  const title = element(made.field ? "label" : "p", made.field ? "" : "label", node);
  title.textContent = form.label || form.tag;
  title.id = `title-${number}`;
  if (made.field) {
    made.field.id = `field-${number}`;
    title.htmlFor = made.field.id;
  } else {
    made.node.setAttribute("aria-labelledby", title.id);
  }
  if (made.atOnce) node.append(made.node);
  else element("div", "row", node).append(made.node);
  const buttons = element("div", "buttons", made.atOnce ? null : made.node.parentElement);
  const save = element("button", "first", buttons);
  save.type = "submit";
  const cancel = element("button", "", buttons);
  cancel.type = "button";
  const note = element("p", "note", node);
  note.id = `note-${number}`;
  note.setAttribute("role", "status");
  (made.field ?? made.node).setAttribute("aria-describedby", note.id);

  let value = null; // what stands there now
  let seen = 0; // the version on which what is filled in rests
  let dirty = false;
  let saying = () => "";

  const tell = (is, words) => {
    note.dataset.is = is;
    saying = words;
    note.textContent = saying();
    made.field?.setAttribute("aria-invalid", String(is === "wrong"));
  };
  const plain = () => {
    const text = () => (!made.fits(value) ? say("unfit", { value: told(value) }) : value === null ? words.unset : "");
    tell(made.fits(value) ? "" : "wrong", text);
  };
  const touch = (now) => {
    dirty = now;
    buttons.hidden = !dirty;
  };
  const settle = () => {
    made.put(value);
    seen = board?.version(form.tag) ?? 0;
    touch(false);
  };

  async function keep() {
    const { value: filled, wrong } = made.read();
    if (wrong) {
      tell("wrong", () => words[wrong]);
      made.field?.focus();
      return;
    }
    tell("saving", () => words.saving);
    try {
      // Nobody's change is overwritten that was not seen.
      const { versions } = await board.ask("set", { tags: { [form.tag]: filled }, versions: { [form.tag]: seen } });
      const at = now();
      const version = versions[form.tag] ?? seen;
      if (board.version(form.tag) <= version) value = filled;
      settle();
      seen = Math.max(seen, version);
      tell("saved", () => say("saved", { at }));
    } catch (refusal) {
      // What stands there instead is told by its notice.
      if (refusal.code === "conflict" && !made.atOnce) return;
      const { message } = refusal;
      tell("wrong", () => (refusal.code ? say("refused", { why: message }) : words.away));
      if (made.atOnce) settle();
    }
  }

  node.addEventListener("submit", (event) => {
    event.preventDefault();
    if (dirty) keep();
  });
  node.addEventListener("input", () => {
    if (made.atOnce) return;
    touch(true);
    if (note.dataset.is !== "changed") tell("", () => "");
  });
  node.addEventListener("change", () => {
    if (made.atOnce) keep();
  });
  cancel.addEventListener("click", () => {
    settle();
    plain();
    made.field?.focus();
  });
  node.addEventListener("keydown", (event) => {
    if (event.key === "Escape" && dirty) cancel.click();
  });
  touch(false);

  let fresh = true;
  return {
    node,
    speak() {
      save.textContent = words.save;
      cancel.textContent = words.cancel;
      note.textContent = saying();
    },
    allow(may) {
      for (const one of node.querySelectorAll("input, button")) one.disabled = !may;
    },
    // What stands at the tag; `own`: it was written from here.
    entry(entry) {
      const first = fresh;
      fresh = false;
      if (JSON.stringify(entry.value) === JSON.stringify(value) && !first) {
        seen = board.version(form.tag);
        return;
      }
      value = entry.value;
      if (note.dataset.is === "saving" && !dirty) return;
      if (dirty) {
        const mine = made.read();
        seen = board.version(form.tag);
        if (!mine.wrong && JSON.stringify(mine.value) === JSON.stringify(value)) return;
        const by = { value: told(value), who: who(entry.writer) };
        tell("changed", () => say(entry.value === null ? "cleared" : "changed", by));
        return;
      }
      settle();
      plain();
      if (first || !made.fits(value)) return;
      const at = now();
      tell("", () => say("by", { who: who(entry.writer), at }));
    },
  };
}

// -- life ----------------------------------------------------------------------------

async function start() {
  board?.close();
  board = null;
  let told = null;
  for (let wait = 300; ; wait = Math.min(wait * 1.6, 3000)) {
    try {
      told = await load("/settings.json");
      break;
    } catch {
      connected = false;
      show();
      await new Promise((resolve) => setTimeout(resolve, wait));
    }
  }
  known = told !== null;
  page("enter").hidden = known;
  page("leave").hidden = !known || !token();
  cards.clear();
  for (const [number, form] of (told?.settings ?? []).entries()) cards.set(form.tag, card(form, number));
  page("settings").replaceChildren(...[...cards.values()].map((one) => one.node));
  connected = null;
  speak(language);
  if (!known) {
    page("token").focus();
    return;
  }
  board = new Board(told.keyed ? null : "settings", [...new Set([...cards.keys(), LANGUAGE])], {
    entry(tag, entry) {
      cards.get(tag)?.entry(entry);
      if (tag === LANGUAGE) speak(entry.value ?? "en");
    },
    open(welcome) {
      connected = true;
      writes = welcome.writes;
      page("robot").textContent = welcome.project;
      show();
    },
    async away() {
      if (connected === null) return;
      connected = false;
      show();
      // A token that is no longer right has to be said: waiting would be for nothing.
      const still = await load("/settings.json").catch(() => undefined);
      if (still === null) start();
    },
  });
}

page("enter").addEventListener("submit", (event) => {
  event.preventDefault();
  keepToken(page("token").value.trim());
  page("token").value = "";
  start();
});
page("leave").addEventListener("click", () => {
  keepToken("");
  start();
});

speak(language);
start();
