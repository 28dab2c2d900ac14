// The blackboard from a page (docs/protocol.md, The WebSocket door): a session that comes back
// by itself, what stands at its tags, and what is asked.

const BEAT = 250;
const FIRST_WAIT = 300;
const LONGEST_WAIT = 3000;
const ANSWERED = 5000;

// The token is kept on this device until its user leaves; what came in the address is taken out of it.
const PLACE = "situ-token";

export function token() {
  const address = new URL(location.href);
  const given = address.searchParams.get("token");
  if (given !== null) {
    localStorage.setItem(PLACE, given);
    address.searchParams.delete("token");
    history.replaceState(null, "", address);
  }
  return localStorage.getItem(PLACE) ?? "";
}

export function keepToken(given) {
  if (given) localStorage.setItem(PLACE, given);
  else localStorage.removeItem(PLACE);
}

// A part of the page's data beside the blackboard; null: the token does not open it.
export async function load(path) {
  const answer = await fetch(path, { cache: "no-store", headers: { Authorization: `Bearer ${token()}` } });
  if (answer.status === 403) return null;
  if (!answer.ok) throw new Error(`${path}: ${answer.status}`);
  return answer.json();
}

export class Refused extends Error {
  constructor({ code, message }) {
    super(message);
    this.code = code;
  }
}

// One session after the other until `close`. patterns: whole tags, or patterns that end in .* or
// .**, no two of which fit the same tag.
// on.entry(tag, entry): what stands there now, on.open({writes, project}): in; on.away(): out.
// time: the robot's, in µs, as last heard.
export class Board {
  time = 0;
  #socket = null;
  #ids = 0;
  #waiting = new Map();
  #versions = new Map();
  #heard = 0;
  #before = null;
  #beat = 0;
  #delay = FIRST_WAIT;
  #again = 0;
  #echo = null;
  #masked = ""; // begins the topics where private values are hidden from us

  constructor(user, patterns, on) {
    this.user = user;
    this.patterns = patterns;
    this.on = on;
    this.#open();
  }

  close() {
    clearTimeout(this.#again);
    this.on = { entry() {}, open() {}, away() {} };
    this.#again = -1;
    this.#socket.close();
  }

  // The reply; throws Refused, or an Error where nothing came back.
  ask(request, fields = {}) {
    if (this.#socket.readyState !== WebSocket.OPEN) return Promise.reject(new Error("away"));
    const id = ++this.#ids;
    const socket = this.#socket;
    socket.send(JSON.stringify({ do: request, id, ...fields }));
    return new Promise((resolve, reject) => {
      // Who does not answer for so long is not there: only a new connection tells.
      const late = setTimeout(() => socket.close(), ANSWERED);
      this.#waiting.set(id, { resolve, reject, late });
    });
  }

  version(tag) {
    return this.#versions.get(tag) ?? 0;
  }

  #open() {
    const query = token() ? `?token=${encodeURIComponent(token())}` : "";
    const scheme = location.protocol === "https:" ? "wss" : "ws";
    const socket = new WebSocket(`${scheme}://${location.host}/board${query}`);
    this.#socket = socket;
    socket.onopen = () => this.#enter().catch(() => socket.close());
    socket.onmessage = ({ data }) => this.#hear(data);
    socket.onclose = () => this.#lost();
  }

  #lost() {
    clearInterval(this.#beat);
    for (const { reject, late } of this.#waiting.values()) {
      clearTimeout(late);
      reject(new Error("away"));
    }
    this.#waiting.clear();
    this.#versions.clear();
    this.on.away();
    if (this.#again === -1) return;
    this.#again = setTimeout(() => this.#open(), this.#delay);
    this.#delay = Math.min(this.#delay * 1.6, LONGEST_WAIT);
  }

  async #enter() {
    let writes = true;
    const hello = { version: 1, role: "operator" };
    let welcome;
    try {
      welcome = await this.ask("hello", this.user ? { ...hello, user: this.user } : hello);
    } catch (refusal) {
      if (refusal.code !== "denied") throw refusal;
      writes = false;
      welcome = await this.ask("hello", { version: 1, role: "viewer" });
    }
    // From here on requests keep the lease.
    this.#beat = setInterval(() => this.#live(), BEAT);
    this.#masked = welcome.masked ? "masked:" : "";
    for (const pattern of this.patterns) {
      this.#socket.send(`+${this.#masked}t:${pattern.includes("*") ? pattern.replace(/\.?\*.*$/, "") : `${pattern}\n`}`);
    }
    // The first echo says that the connection stands, the second that all is heard.
    await this.#hears();
    await this.#hears();
    await this.#watch();
    this.#delay = FIRST_WAIT;
    this.on.open({ writes, project: welcome.project });
  }

  #hears() {
    const topic = `echo:${crypto.getRandomValues(new Uint32Array(2)).join("-")}`;
    return new Promise((resolve) => {
      this.#echo = { topic, resolve };
      this.#socket.send(`+${topic}\n`);
    });
  }

  async #watch() {
    const { entries, changes } = await this.ask("watch", { patterns: this.patterns });
    this.#heard = sum(changes);
    this.#before = null;
    for (const tag of this.patterns) {
      if (!tag.includes("*") && !(tag in entries)) this.on.entry(tag, { value: null, writer: null });
    }
    for (const [tag, entry] of Object.entries(entries)) this.#enters(tag, entry);
  }

  // Whether it was new.
  #enters(tag, entry) {
    if (entry.version <= this.version(tag)) return false;
    this.#versions.set(tag, entry.version);
    this.on.entry(tag, entry);
    return true;
  }

  async #live() {
    try {
      const { changes, time } = await this.ask("heartbeat");
      this.time = time;
      const lost = this.#before !== null && this.#heard < this.#before;
      this.#before = sum(changes);
      if (lost) await this.#watch();
    } catch {
      // A phone that slept has lost its session: a new connection gets another.
      this.#socket.close();
    }
  }

  #hear(data) {
    if (data.startsWith("{")) {
      const reply = JSON.parse(data);
      const waiting = this.#waiting.get(reply.id);
      this.#waiting.delete(reply.id);
      clearTimeout(waiting?.late);
      if (reply.re === "refused") waiting?.reject(new Refused(reply));
      else waiting?.resolve(reply);
      return;
    }
    const at = data.indexOf("\n");
    const topic = data.slice(0, at);
    if (topic === this.#echo?.topic) {
      this.#socket.send(`-${topic}\n`);
      this.#echo.resolve();
      this.#echo = null;
    } else if (topic.startsWith(`${this.#masked}t:`)) {
      const change = JSON.parse(data.slice(at + 1));
      if (this.#enters(change.tag, change)) this.#heard += 1;
    }
  }
}

function sum(counts) {
  return Object.values(counts).reduce((all, one) => all + one, 0);
}
