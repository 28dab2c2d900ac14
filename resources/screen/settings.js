// Settings that end users change: a form for each, with what stands at its tag now.

import { element } from "./element.js";
import { field } from "./fields.js";
import { Visit } from "./visit.js";

const WORDS = {
  en: {
    title: "Settings", save: "Save", cancel: "Cancel",
    none: "This robot has no settings.",
    saving: "Saving …", saved: "Saved at {at}", refused: "Not saved: {why}", away: "Not saved: the robot is away. Try again.",
    changed: "Meanwhile changed to {value} by {who}. Save to put yours in its place.", cleared: "Meanwhile cleared by {who}. Save to put yours in its place.",
    by: "Changed by {who} at {at}", unset: "Not set", unfit: "Now {value}, which does not fit here",
    number: "Type a number, such as 12 or 0.5", time: "Type a time, such as 08:30", date: "Type a day of the calendar",
  },
  ja: {
    title: "設定", save: "保存", cancel: "取消",
    none: "このロボットには設定がありません。",
    saving: "保存しています…", saved: "{at}に保存しました", refused: "保存できません：{why}", away: "保存できません。ロボットに接続できません。もう一度お試しください。",
    changed: "{who}が{value}に変更しました。保存すると入力した値になります。", cleared: "{who}が値を消しました。保存すると入力した値になります。",
    by: "{at}に{who}が変更しました", unset: "未設定", unfit: "現在の値{value}はここに合いません",
    number: "数字を入力してください（例：12、0.5）", time: "時刻を入力してください（例：08:30）", date: "日付を入力してください",
  },
  de: {
    title: "Einstellungen", save: "Speichern", cancel: "Abbrechen",
    none: "Dieser Roboter hat keine Einstellungen.",
    saving: "Wird gespeichert …", saved: "Gespeichert um {at}", refused: "Nicht gespeichert: {why}", away: "Nicht gespeichert: Der Roboter ist nicht erreichbar. Bitte noch einmal versuchen.",
    changed: "Inzwischen von {who} auf {value} geändert. Speichern setzt Ihren Wert ein.", cleared: "Inzwischen von {who} gelöscht. Speichern setzt Ihren Wert ein.",
    by: "Von {who} um {at} geändert", unset: "Nicht gesetzt", unfit: "Jetzt {value}: das passt hier nicht",
    number: "Bitte eine Zahl eingeben, etwa 12 oder 0,5", time: "Bitte eine Uhrzeit eingeben, etwa 08:30", date: "Bitte einen Tag des Kalenders eingeben",
  },
};

const cards = new Map(); // tag -> card
const visit = new Visit({
  words: WORDS,
  user: "settings",
  begin({ settings }) {
    cards.clear();
    for (const [number, form] of settings.entries()) cards.set(form.tag, card(form, number));
    document.getElementById("settings").replaceChildren(...[...cards.values()].map((one) => one.node));
    return cards.keys();
  },
  entry(tag, entry) { cards.get(tag)?.entry(entry); },
  speak() { for (const one of cards.values()) one.speak(); },
  show() { for (const one of cards.values()) one.allow(visit.may); },
  empty: () => (cards.size === 0 ? visit.words.none : null),
});

function now() {
  return new Intl.DateTimeFormat(document.documentElement.lang, { timeStyle: "short" }).format(new Date());
}

// Who wrote, as people call him.
function who(writer) {
  return (writer ?? "").replace(/^\w+:/, "");
}

function card(form, number) {
  const made = field(form, visit);
  const node = element("form", `card setting ${form.type}`);
  node.noValidate = true;
  node.dataset.tag = form.tag;
  const title = element(made.field ? "label" : "p", made.field ? "" : "label", node);
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
    const text = () => (!made.fits(value) ? visit.say("unfit", { value: made.told(value) }) : value === null ? visit.words.unset : "");
    tell(made.fits(value) ? "" : "wrong", text);
  };
  const touch = (now) => {
    dirty = now;
    buttons.hidden = !dirty;
  };
  const settle = () => {
    made.put(value);
    seen = visit.board?.version(form.tag) ?? 0;
    touch(false);
  };

  async function keep() {
    const { value: filled, wrong } = made.read();
    if (wrong) {
      tell("wrong", () => visit.words[wrong]);
      made.field?.focus();
      return;
    }
    tell("saving", () => visit.words.saving);
    try {
      // Nobody's change is overwritten that was not seen.
      const { versions } = await visit.board.ask("set", { tags: { [form.tag]: filled }, versions: { [form.tag]: seen } });
      const at = now();
      const version = versions[form.tag] ?? seen;
      if (visit.board.version(form.tag) <= version) value = filled;
      settle();
      seen = Math.max(seen, version);
      tell("saved", () => visit.say("saved", { at }));
    } catch (refusal) {
      // What stands there instead is told by its notice.
      if (refusal.code === "conflict" && !made.atOnce) return;
      const { message } = refusal;
      tell("wrong", () => (refusal.code ? visit.say("refused", { why: message }) : visit.words.away));
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
      title.textContent = form.label ? visit.text(form.label) : form.tag;
      made.speak();
      save.textContent = visit.words.save;
      cancel.textContent = visit.words.cancel;
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
        seen = visit.board.version(form.tag);
        return;
      }
      value = entry.value;
      if (note.dataset.is === "saving" && !dirty) return;
      if (dirty) {
        const mine = made.read();
        seen = visit.board.version(form.tag);
        if (!mine.wrong && JSON.stringify(mine.value) === JSON.stringify(value)) return;
        const { value: theirs, writer } = entry;
        tell("changed", () => visit.say(theirs === null ? "cleared" : "changed", { value: made.told(theirs), who: who(writer) }));
        return;
      }
      settle();
      plain();
      if (first || !made.fits(value)) return;
      const at = now();
      tell("", () => visit.say("by", { who: who(entry.writer), at }));
    },
  };
}

visit.start();
