/** The dialog that chooses which signals the strip charts draw; the choice is remembered by the browser. */

import { html } from "./dom.js";
import { DEFAULT_LANES, symbol } from "./strip_chart.js";
import { shown } from "./units.js";

const KEY = "fdes.lanes";
const PER_LANE = 3;

export class SignalChooser {
  constructor(dialog, chart) {
    this.dialog = dialog;
    this.chart = chart;
    this.body = dialog.querySelector(".dialog-body");
    chart.setLanes(remembered() ?? DEFAULT_LANES);
  }

  open() {
    this.draw();
    this.dialog.showModal();
  }

  draw() {
    const lanes = this.chart.lanes.map((names, lane) =>
      html(
        "fieldset",
        { class: "lane" },
        html("legend", {}, `Chart ${lane + 1}`),
        Array.from({ length: PER_LANE }, (_, place) => this.select(lane, place, names[place] ?? "")),
      ),
    );
    const standard = html("button", { onclick: () => this.apply(DEFAULT_LANES) }, "Default signals");
    this.body.replaceChildren(...lanes, html("p", {}, standard));
  }

  select(lane, place, chosen) {
    const options = this.chart.channels.map(({ name, long_name, unit }) =>
      html(
        "option",
        { value: name, selected: name === chosen },
        `${symbol(name)} · ${long_name}, ${shown(unit, name).label}`,
      ),
    );
    const label = `Chart ${lane + 1}, signal ${place + 1}`;
    return html(
      "select",
      { "aria-label": label, onchange: ({ target }) => this.change(lane, place, target.value) },
      html("option", { value: "" }, "none"),
      ...options,
    );
  }

  change(lane, place, name) {
    const lanes = this.chart.lanes.map((names) => Array.from({ length: PER_LANE }, (_, i) => names[i] ?? ""));
    lanes[lane][place] = name;
    this.apply(
      lanes.map((names) => names.filter((one, i) => one && names.indexOf(one) === i)),
      { redraw: false },
    );
  }

  apply(lanes, { redraw = true } = {}) {
    this.chart.setLanes(lanes);
    try {
      localStorage.setItem(KEY, JSON.stringify(lanes));
    } catch {
      return; // storage may be forbidden: the choice then lasts as long as the page
    } finally {
      if (redraw) this.draw();
    }
  }
}

function remembered() {
  try {
    const lanes = JSON.parse(localStorage.getItem(KEY));
    return Array.isArray(lanes) && lanes.length === DEFAULT_LANES.length && lanes.every(Array.isArray) ? lanes : null;
  } catch {
    return null;
  }
}
