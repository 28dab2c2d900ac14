// An operator's words, said by the robot: as the module `operator`, which asks for the voice like
// any other, and has it where the script gives it a priority.

const MODULE = "operator";
const RESOURCE = "speech";
const WORD = 0.35; // seconds, as the robot reckons speech that nobody hears
const LETTER = 0.2; // of Chinese, Japanese and Thai
const DIGIT = 0.45; // said one by one at the slowest
const SLOW = 1.6; // a voice may be slower than that
const LETTERS = /[\u0e00-\u0e7f\u3040-\u30ff\u3400-\u9fff]/gu;

export class Speaking {
  rate = 100; // percent, the tag speech.rate
  situation = null;
  #end = 0;

  // begun(on): whether something is being said.
  constructor(visit, tell, begun) {
    this.visit = visit;
    this.tell = tell;
    this.begun = begun;
  }

  // Whether the script lets the module speak in this situation.
  get may() {
    return this.visit.may && this.situation?.priorities?.[MODULE] !== undefined;
  }

  async say(text) {
    const { visit } = this;
    try {
      const { holds } = await visit.board.ask("acquire", { module: MODULE, resources: [RESOURCE] });
      if (!holds.includes(RESOURCE)) {
        await visit.board.ask("abandon", { module: MODULE });
        this.tell("wrong", await this.#who());
        return false;
      }
      const seconds = this.#length(text);
      await visit.board.ask("command", { module: MODULE, resource: RESOURCE, value: { text }, for: seconds });
      clearTimeout(this.#end);
      this.#end = setTimeout(() => this.#give(), seconds * 1000);
      this.begun(true);
      this.tell("", visit.say("spoken", { text }));
      return true;
    } catch (refusal) {
      this.tell("wrong", refusal.code ? refusal.message : visit.words.away);
      return false;
    }
  }

  // The voice goes back to whoever is next.
  async hush() {
    clearTimeout(this.#end);
    await this.#give();
    this.tell("", this.visit.words.hushed);
  }

  lost() {
    clearTimeout(this.#end);
    this.begun(false);
  }

  async #give() {
    this.begun(false);
    await this.visit.board.ask("abandon", { module: MODULE }).catch(() => {});
  }

  async #who() {
    const { modules } = await this.visit.board.ask("modules");
    const who = modules.find((one) => one.holds.includes(RESOURCE))?.name;
    return who ? this.visit.say("busy", { who }) : this.visit.words.nobody;
  }

  #length(text) {
    const letters = text.match(LETTERS)?.length ?? 0;
    const words = text.replace(LETTERS, " ").split(/\s+/).filter(Boolean).length;
    const digits = text.match(/\d/g)?.length ?? 0;
    return ((0.5 + LETTER * letters + WORD * words + DIGIT * digits) * SLOW * 100) / Math.min(Math.max(this.rate, 25), 250);
  }
}
