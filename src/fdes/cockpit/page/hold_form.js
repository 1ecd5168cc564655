/** Values held by hand: a number and a slider for each channel, added until they are let go. */

import { html } from "./dom.js";
import { button } from "./fields.js";
import { CHANNELS, said } from "./input_channels.js";
import { degrees } from "./units.js";

const BETWEEN = 60; // ms from command to command while a slider moves

export class HoldForm {
  constructor(command) {
    this.command = command;
    this.rows = new Map(Object.entries(CHANNELS).map(([name, channel]) => [name, this.makeRow(name, channel)]));
    this.element = html(
      "div",
      { class: "hold" },
      html(
        "p",
        { class: "quiet-words hold-head" },
        "Added to the stick until let go, or reset.",
        button("Let go of all", () => command("clear_inputs")),
      ),
      [...this.rows.values()].map(({ element }) => element),
    );
  }

  makeRow(name, { words, units, reach }) {
    const unit = Object.keys(units)[0];
    const step = reach / 100;
    const slider = html("input", { type: "range", min: -reach, max: reach, step, value: 0, "aria-label": `Hold ${words}, slider, ${unit}` });
    const entry = html("input", { type: "number", step: "any", value: 0, "aria-label": `Hold ${words}, ${unit}` });
    slider.addEventListener("input", () => this.ask(name, (entry.value = slider.value), unit));
    entry.addEventListener("change", () => this.ask(name, (slider.value = entry.value) && entry.value, unit));
    const element = html("div", { class: "hold-row" }, html("span", {}, words), slider, entry, html("span", { class: "unit" }, unit));
    return { element, slider, entry, unit, waiting: null };
  }

  /** Sends the newest value, not more often than `BETWEEN`. */
  ask(name, value, unit) {
    const row = this.rows.get(name);
    if (value === "") return;
    const first = row.waiting === null;
    row.waiting = `${name} ${said(value, unit)}`;
    if (!first) return;
    setTimeout(async () => {
      const text = row.waiting;
      row.waiting = null;
      await this.command("hold", { text });
    }, BETWEEN);
  }

  /** What is held, as the server's status says it, in SI. What is being typed or dragged is left alone. */
  show(held) {
    for (const [name, { slider, entry, unit, element, waiting }] of this.rows) {
      const value = held[name] ?? 0;
      element.classList.toggle("is-held", value !== 0);
      if (waiting !== null || entry === document.activeElement) continue;
      slider.value = entry.value = Number((unit === "deg" ? degrees(value) : value).toPrecision(6));
    }
  }
}
