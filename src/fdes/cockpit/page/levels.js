/** Flying-qualities Levels: a badge for each mode, following each edit; pressed, it opens the verdict. */

import { html } from "./dom.js";
import { modeName } from "./s_plane.js";

const WORSE = 4; // than Level 3
const LONGEST = 400; // points of a path

/** A Level as a badge says it. */
export const levelWord = (level) => (level === WORSE ? "> 3" : String(level));

export const levelSentence = (level) =>
  level === null ? "not applicable" : level === WORSE ? "worse than Level 3" : `Level ${level}`;

export class Levels {
  constructor(line, link) {
    this.line = line;
    this.link = link;
    this.paths = new Map(); // where the aircraft has been in each chart
    this.card = null;
    link.on("knobs", () => this.paths.clear());
    link.on("qualities", (qualities) => this.show(qualities));
  }

  show({ role, verdicts, charts }) {
    for (const { title, point } of charts) this.extend(title, point);
    const focused = this.line.contains(document.activeElement) ? document.activeElement.dataset.criterion : null;
    const judged = verdicts.filter(({ level }) => level !== null);
    this.line.replaceChildren(
      ...judged.map(({ criterion, mode, level, reason }) =>
        html(
          "button",
          {
            type: "button",
            class: `level level-${level}`,
            "data-criterion": criterion,
            "data-mode": mode,
            "data-level": level,
            title: `${levelSentence(level)}, ${role.says}. ${reason}`,
            "aria-label": `${modeName(mode)}: ${levelSentence(level)}`,
            onclick: () => this.open(criterion),
          },
          `${modeName(mode)} `,
          html("b", {}, levelWord(level)),
        ),
      ),
    );
    if (focused) this.line.querySelector(`[data-criterion="${focused}"]`)?.focus();
    this.card?.show({ role, verdicts, charts }, this.paths);
  }

  extend(title, point) {
    const path = this.paths.get(title) ?? [];
    const last = path.at(-1);
    if (point && (!last || last[0] !== point[0] || last[1] !== point[1])) path.push(point);
    this.paths.set(title, path.slice(-LONGEST));
  }

  async open(criterion) {
    const { QualityCard } = await import("./quality_card.js");
    this.card ??= new QualityCard(document.querySelector(".view"), this.link);
    this.card.open(criterion);
    this.card.show(this.link.latest.get("qualities"), this.paths);
  }
}
