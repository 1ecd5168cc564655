/** How far each loop of the laws in use is from growing, broken at its surface, and what each part on the way takes of it. */

import { html } from "./dom.js";
import { FreshAnswer } from "./fresh_answer.js";
import { figure } from "./units.js";

const NOTHING = "Nothing is fed back: engage a law, and its margins stand here.";
const LEGEND = "Where the loop begins to grow: with less or more gain, with the phase it has left (negative: of lead), with more delay.";
const COLUMNS = [
  ["with", ""],
  ["less", "gain, dB"],
  ["more", "gain, dB"],
  ["at", "rad/s"],
  ["phase", "deg"],
  ["at", "rad/s"],
  ["delay", "ms"],
];

export class MarginsView {
  /** `link` is the wire. */
  constructor(panel, link) {
    this.panel = panel;
    this.answer = new FreshAnswer(link, "margins", panel, ({ margins }) => this.draw(margins));
    for (const change of ["control", "stability", "aircraft"]) link.on(change, () => this.answer.stale());
  }

  watch(shown) {
    this.answer.watch(shown);
  }

  draw(margins) {
    const surfaces = [...new Set(margins.map(({ surface }) => surface))];
    this.panel.replaceChildren(
      ...surfaces.map((surface) => table(surface, margins.filter((one) => one.surface === surface))),
      html("p", { class: "quiet-words" }, surfaces.length ? LEGEND : NOTHING),
    );
  }
}

function table(surface, rows) {
  return html(
    "table",
    { class: "margins number" },
    html("caption", {}, `Loop broken at the ${surface}`),
    html("thead", {}, html("tr", {}, COLUMNS.map(([name, unit]) => html("th", { scope: "col" }, name, unit && html("small", {}, unit))))),
    html("tbody", {}, rows.map(row)),
  );
}

function row({ step, stable, ...margin }) {
  const { gain_reduction_db, gain_margin_db, phase_crossover, phase_margin_deg, gain_crossover, delay_margin_s } = margin;
  const cells = [
    end(gain_reduction_db),
    end(gain_margin_db),
    gain_margin_db === null ? "" : figure(phase_crossover),
    end(phase_margin_deg),
    gain_crossover === null ? "" : figure(gain_crossover),
    end(delay_margin_s && 1e3 * delay_margin_s),
  ];
  const name = html("th", { scope: "row" }, stable ? step : `${step}, grows`);
  return html("tr", { class: stable ? "" : "is-growing" }, name, cells.map((text) => html("td", {}, text)));
}

/** A margin; there may be no end to it. */
const end = (value) => (value === null ? "no end" : figure(value));
