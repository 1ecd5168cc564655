/** The answer to one question, asked again whenever it may have changed, while somebody looks; never two at a time. */

import { html } from "./dom.js";

export class FreshAnswer {
  /** Asks `command` over `link` and hands the reply to `draw`; a refusal is written into the element `place`. */
  constructor(link, command, place, draw) {
    Object.assign(this, { link, command, place, draw, shown: false, asking: false, again: false });
  }

  /** Somebody looks, or nobody any more. */
  watch(shown) {
    this.shown = shown;
    this.stale();
  }

  /** What was asked about has changed. */
  async stale() {
    this.again = true;
    if (!this.shown || this.asking) return;
    this.asking = true;
    try {
      while (this.again) {
        this.again = false;
        this.draw(await this.link.command(this.command));
      }
    } catch (error) {
      this.place.replaceChildren(html("p", { class: "problem" }, error.message));
    }
    this.asking = false;
  }
}
