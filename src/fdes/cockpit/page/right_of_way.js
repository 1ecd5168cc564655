/**
 * Answers have the right of way. Without a GPU a browser paints in the thread that also reads messages, and frames come
 * first: while they follow one another without a gap, the poles of an edited aircraft wait for two or three of them.
 * So needles and traces rest from a command until its answer is on the screen; and where frames leave no gap, all rests.
 */

export const [EVERYTHING, VIEW, NOTHING] = ["everything", "world and head-up display", "nothing"];
const GAP = 4; // ms in which a message comes through
const PATIENCE = 150; // ms: an answer that takes longer is not waited for
const LONGEST = 3; // frames in a row that are not whole: a slider that is dragged asks all the time

export class RightOfWay {
  constructor(link) {
    this.link = link;
    this.command = { id: 0, at: 0 }; // the newest, and when it was first seen [ms]
    this.asked = false; // in the last frame
    this.rested = 0; // frames in a row
    this.crowded = false; // whether there was no gap since the command
    this.freeSince = 0; // ms: when the last frame was painted
    const { port1, port2 } = new MessageChannel();
    this.port = port1;
    port2.onmessage = () => (this.freeSince = performance.now());
  }

  /** What of the frame that begins at `now` [ms] is to be drawn. */
  next(now) {
    const { commandId: id, waiting } = this.link;
    if (id !== this.command.id) this.command = { id, at: now };
    const asking = waiting.size > 0 && now - this.command.at < PATIENCE;
    const hurried = asking || this.asked; // the frame after the answer shows it
    this.asked = asking;
    this.crowded = hurried && (this.crowded || now - this.freeSince < GAP);
    this.freeSince = Infinity;
    this.port.postMessage(null);
    this.rested = hurried && this.rested < LONGEST ? this.rested + 1 : 0;
    if (!this.rested) return EVERYTHING;
    return this.crowded ? NOTHING : VIEW;
  }
}
