/**
 * The dialog that lays flights over one another. Loaded when first asked for.
 *
 * What it draws is a list of sets `{ label, channels: [{ name, unit, long_name }], read(names) }`; `read` resolves to
 * `{ t, values: { name: [...] }, stride }` in SI. A recording is one such set; a computed flight can be another.
 */

import { copyReadably, fetchJson, html } from "./dom.js";
import { OverlayChart } from "./overlay_chart.js";
import { MOST } from "./recordings.js";
import { symbol } from "./strip_chart.js";
import { minus, shown } from "./units.js";

const FIRST = ["theta", "phi", "q", "p"];
const STICK = ["stick_pitch", "stick_roll", "stick_yaw"];
const MOVED = 0.01; // of full stick, from where it began

/** A recording of the server as a set of series. */
export async function recordingSet(name, label) {
  const url = `/api/recordings/${encodeURIComponent(name)}.json`;
  const { columns } = await fetchJson(url);
  return {
    label,
    channels: columns,
    read: (names) => fetchJson(`${url}?columns=${encodeURIComponent(names.join(","))}`),
  };
}

export class Overlay {
  constructor() {
    this.canvas = html("canvas", { class: "overlay-chart", role: "img", tabindex: "0", "aria-label": "Flights laid over one another; the arrow keys move the reading line" });
    this.signals = html("span", { class: "overlay-signals" });
    this.align = this.toggle("Start at the first stick movement");
    this.difference = this.toggle("Difference from the first flight");
    this.note = html("p", { class: "overlay-note", role: "status" });
    this.readings = html("table", { class: "overlay-readings number" });
    this.dialog = html(
      "dialog",
      { id: "overlay", "aria-labelledby": "overlay-title" },
      html(
        "div",
        { class: "dialog-head" },
        html("h2", { id: "overlay-title" }, "Flights overlaid"),
        html("button", { class: "icon", "aria-label": "Close", onclick: () => this.dialog.close() }, "✕"),
      ),
      html(
        "div",
        { class: "dialog-body" },
        html("div", { class: "overlay-choices" }, this.signals, this.align.row, this.difference.row),
        this.canvas,
        this.readings,
        this.note,
        html(
          "p",
          { class: "overlay-choices" },
          html("button", { onclick: () => this.save(this.csv(), "overlay.csv") }, "Download CSV"),
          html("button", { onclick: () => this.canvas.toBlob((png) => this.save(png, "overlay.png")) }, "Download PNG"),
        ),
      ),
    );
    this.chart = new OverlayChart(this.canvas);
    this.chart.onReading = () => this.showReadings();
    const style = html("link", { rel: "stylesheet", href: "/page/overlay.css", onload: () => this.chart.draw() });
    document.head.append(style);
    document.body.append(this.dialog);
    copyReadably(this.dialog);
    new ResizeObserver(() => this.chart.draw()).observe(this.canvas);
    const themed = new MutationObserver(() => this.chart.draw());
    themed.observe(document.documentElement, { attributeFilter: ["data-theme"] });
  }

  toggle(words) {
    const box = html("input", { type: "checkbox", onchange: () => this.show() });
    return { box, row: html("label", {}, box, ` ${words}`) };
  }

  /** Opens the dialog with these sets, the others compared with the first, and with signals that `differ` first of all. */
  async open(sets, differ = []) {
    this.sets = sets.slice(0, MOST);
    const common = this.sets[0].channels.filter(({ name }) =>
      this.sets.every(({ channels }) => channels.some((channel) => channel.name === name)),
    );
    this.channels = new Map(common.map((channel) => [channel.name, channel]));
    const wanted = [...FIRST.filter((name) => differ.includes(name)), ...FIRST];
    this.names = [...new Set(wanted)].filter((name) => this.channels.has(name)).slice(0, 2);
    this.signals.replaceChildren(...[0, 1].map((place) => this.select(place)));
    if (!this.dialog.open) this.dialog.showModal();
    await this.load();
  }

  select(place) {
    const options = [...this.channels.values()].map(({ name, unit, long_name }) =>
      html("option", { value: name, selected: name === this.names[place] }, `${symbol(name)} · ${long_name}, ${shown(unit, name).label}`),
    );
    const change = ({ target }) => {
      this.names[place] = target.value;
      this.load();
    };
    return html("select", { "aria-label": `Signal ${place + 1}`, onchange: change }, options);
  }

  async load() {
    const stick = STICK.filter((name) => this.channels.has(name));
    const asked = [...new Set([...this.names, ...stick])];
    const wanted = (this.loading = Symbol("load"));
    try {
      const flights = await Promise.all(this.sets.map(({ read }) => read(asked)));
      if (this.loading !== wanted) return; // another choice was made meanwhile
      this.flights = flights;
    } catch (error) {
      this.note.textContent = `The flights could not be read. ${error.message}`;
      return;
    }
    const thinned = Math.max(...this.flights.map(({ stride }) => stride ?? 1));
    this.note.textContent = thinned > 1 ? `A flight is long: every ${thinned}th of its rows is drawn.` : "";
    this.show();
  }

  /** The chart's lanes from what was read: time from the chosen start, units as shown. */
  show() {
    const starts = this.flights.map((flight) => (this.align.box.checked ? firstMovement(flight) : (flight.t[0] ?? 0)));
    this.lanes = this.names.map((name) => {
      const { label, factor } = shown(this.channels.get(name).unit, name);
      const series = this.flights.map(({ t, values }, i) => ({
        label: this.sets[i].label,
        t: t.map((time) => time - starts[i]),
        y: values[name].map((value) => (value === null ? NaN : value * factor)),
      }));
      return { name, symbol: symbol(name), unit: label, series: this.difference.box.checked ? differences(series) : series };
    });
    this.chart.show(this.lanes);
    this.showReadings();
  }

  showReadings() {
    const at = this.chart.reading;
    const head = this.lanes.map(({ name, unit }) => html("th", { scope: "col" }, `${symbol(name)}, ${unit}`));
    const rows = this.sets.map(({ label }, i) =>
      html(
        "tr",
        {},
        html("th", { scope: "row" }, html("i", { class: `ink-${i + 1}` }), label),
        this.lanes.map(({ series }) => html("td", {}, said(valueAt(series[i], at)))),
      ),
    );
    this.readings.replaceChildren(
      html("thead", {}, html("tr", {}, html("th", { scope: "col" }, `at ${at.toFixed(2)} s`), head)),
      html("tbody", {}, rows),
    );
  }

  /** Every series with its own time, side by side: flights need not share their steps. */
  csv() {
    const series = this.lanes.flatMap(({ name, unit, series: all }) => all.map((one) => ({ name, unit, ...one })));
    const quoted = (text) => `"${text.replaceAll('"', '""')}"`;
    const head = series.flatMap(({ name, unit, label }) => [quoted(`t [s] ${label}`), quoted(`${name} [${unit}] ${label}`)]);
    const length = Math.max(...series.map(({ t }) => t.length));
    const row = (_, k) => series.flatMap(({ t, y }) => (k < t.length ? [t[k], Number.isFinite(y[k]) ? y[k] : ""] : ["", ""]));
    const rows = Array.from({ length }, row);
    return new Blob([[head, ...rows].map((cells) => cells.join(",")).join("\n") + "\n"], { type: "text/csv" });
  }

  save(blob, name) {
    const link = html("a", { href: URL.createObjectURL(blob), download: name });
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  }
}

/** Time [s] at which the stick first leaves where it began; the start of a flight whose stick rests. */
function firstMovement({ t, values }) {
  const sticks = STICK.map((name) => values[name]).filter(Boolean);
  // A recording begins with the movement: its first row may already be one, so a stick off center counts too.
  const at = t.findIndex((_, k) => sticks.some((stick) => Math.abs(stick[k]) > MOVED));
  return t[Math.max(0, at)] ?? 0;
}

/** Linear between samples [unit of y]; NaN outside the flight. */
export function valueAt({ t, y }, at) {
  if (!(at >= t[0] && at <= t.at(-1))) return NaN;
  let [low, high] = [0, t.length - 1];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (t[middle] <= at) low = middle;
    else high = middle;
  }
  const span = t[high] - t[low];
  return span > 0 ? y[low] + ((y[high] - y[low]) * (at - t[low])) / span : y[low];
}

function differences([first, ...others]) {
  const less = (one) => ({ ...one, y: one.y.map((value, k) => value - valueAt(first, one.t[k])) });
  return [first, ...others].map(less);
}

const said = (value) => (Number.isFinite(value) ? minus(value.toFixed(Math.abs(value) >= 100 ? 1 : 3)) : "–");
