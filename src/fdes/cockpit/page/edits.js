/**
 * The changes made to the aircraft, as an ordered list of texts such as "Cm_q=-1.8", and their way to the server.
 *
 * One edit is under way at a time, at most 20 a second while a slider moves; of those that come meanwhile the newest wins.
 */

const PERIOD = 50; // ms

/** The name in a change: "Cm_q*=0.5" -> "Cm_q". */
export const nameOf = (change) => change.match(/^\s*(\w+)/)?.[1] ?? "";

/** `changes` with one more; it takes the place of the last when both set the same number. */
export function withChange(changes, change) {
  const same = changes.length > 0 && nameOf(changes.at(-1)) === nameOf(change);
  return [...(same ? changes.slice(0, -1) : changes), change];
}

export class Edits {
  /** `link` is the wire; `refused(sentence)` is called when an edit cannot be, with an empty text when all is well. */
  constructor(link, refused) {
    this.link = link;
    this.refused = refused;
    this.changes = [];
    this.asked = null;
    this.busy = false;
    this.sent = 0;
    this.onChange = () => {};
    link.on("stability", (stability) => {
      if (this.asked === null && !this.busy) this.changes = stability.changes;
      this.onChange(stability);
    });
  }

  /** One number changed, such as "Cm_q=-1.8"; `dragging` while its slider is still moving. */
  set(change, dragging = false) {
    return this.ask(withChange(this.changes, change), dragging);
  }

  reset(name) {
    return this.ask(this.changes.filter((change) => nameOf(change) !== name));
  }

  resetAll() {
    return this.ask([]);
  }

  undo() {
    return this.say("undo");
  }

  redo() {
    return this.say("redo");
  }

  /** The whole list at once. */
  ask(changes, dragging = false) {
    this.changes = changes;
    this.asked = { changes, dragging };
    return this.busy ? null : this.pump();
  }

  async pump() {
    this.busy = true;
    while (this.asked) {
      const wait = this.sent + PERIOD - performance.now();
      if (wait > 0 && this.asked.dragging) await new Promise((done) => setTimeout(done, wait));
      const asked = this.asked;
      this.asked = null;
      this.sent = performance.now();
      await this.say("edit", asked);
    }
    this.busy = false;
    this.changes = this.link.latest.get("stability")?.changes ?? [];
  }

  async say(name, fields) {
    try {
      await this.link.command(name, fields);
      this.refused("");
    } catch (error) {
      this.refused(error.message);
      this.onChange(this.link.latest.get("stability"));
    }
  }
}
