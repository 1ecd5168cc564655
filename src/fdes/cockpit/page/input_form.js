/** One test input: its shape, what it moves, how far and when; the words that will be sent, and what they mean. */

import { html, svg } from "./dom.js";
import { button, choice, number, refill } from "./fields.js";
import { CHANNELS, said } from "./input_channels.js";
import { historyOf, readColumns } from "./measured_csv.js";
import { figure, shown } from "./units.js";

// Shapes by the name the server knows: the words for their times, the label of each, and the time [s] offered.
const SHAPES = {
  step: [],
  pulse: [["for", "Lasting, s", 1]],
  doublet: [["for", "Lasting, s", 1]],
  "3-2-1-1": [["for", "Lasting, s", 7]],
  ramp: [["for", "Rising, s", 2]],
  sine: [["period", "Period, s", 2], ["for", "Lasting, s", 10]],
  sweep: [["for", "Lasting, s", 30], ["slowest", "First period, s", 10], ["fastest", "Last period, s", 0.5]],
  multisine: [["for", "Lasting, s", 10], ["period", "Period, s", 10]],
  "1-cosine": [["for", "Rising, s", 1]],
  "1-cosine-pulse": [["for", "Lasting, s", 1]],
  measured: [],
};
const WIDTH = 320;
const HEIGHT = 60;
const PAUSE = 150; // ms without a change before the server is asked

export class InputForm {
  /** `link` sends; `command(name, fields)` sends and shows an error. */
  constructor(link, command) {
    this.link = link;
    this.shape = choice("Shape", Object.keys(SHAPES), "doublet");
    this.channel = choice("Moves", Object.entries(CHANNELS).map(([name, { words }]) => [name, words]), "elevator");
    this.amplitude = number("Amplitude", 2);
    this.unit = choice("Unit", ["deg"]);
    this.times = html("span", { class: "field" });
    this.file = html("input", { type: "file", accept: ".csv,text/csv" });
    this.column = choice("Column", []);
    this.measured = html("span", { class: "field" }, html("label", {}, html("span", {}, "CSV file, with t"), this.file), this.column.label);
    this.plain = html("span", { class: "field" }, this.amplitude.label, this.unit.label);
    this.words = html("output", { class: "input-words", "aria-label": "Will be sent" });
    this.trouble = html("p", { class: "problem", role: "status" });
    this.curve = svg("polyline", { class: "preview-curve" });
    this.axis = svg("path", { class: "preview-axis" });
    this.span = html("span", { class: "quiet-words number" });
    const picture = svg("svg", { class: "preview", viewBox: `0 0 ${WIDTH} ${HEIGHT}`, preserveAspectRatio: "none", role: "img", "aria-label": "The input over time" }, this.axis, this.curve);
    this.element = html(
      "div",
      {},
      html("div", { class: "form-row" }, this.shape.label, this.channel.label, this.plain, this.times, this.measured),
      picture,
      html("div", { class: "form-row send-row" }, this.words, this.span),
      this.trouble,
      html("div", { class: "button-row" }, button("Put in", () => this.send()), button("End all", () => command("clear_inputs"))),
    );
    this.shape.select.addEventListener("change", () => this.offer());
    this.channel.select.addEventListener("change", () => this.offerUnits());
    this.file.addEventListener("change", () => this.read());
    this.element.addEventListener("input", () => this.changed());
    this.offer();
    this.offerUnits();
  }

  /** The times of the chosen shape. */
  offer() {
    const isMeasured = this.shape.select.value === "measured";
    this.measured.hidden = !isMeasured;
    this.plain.hidden = isMeasured;
    this.asked = SHAPES[this.shape.select.value].map(([word, label, value]) => ({ word, ...number(label, value) }));
    this.times.replaceChildren(...this.asked.map(({ label }) => label));
    this.changed();
  }

  offerUnits() {
    const { units, start } = CHANNELS[this.channel.select.value];
    refill(this.unit, Object.keys(units));
    this.amplitude.input.value = start;
    this.changed();
  }

  async read() {
    this.table = null;
    try {
      if (this.file.files.length) this.table = await readColumns(this.file.files[0]);
      const names = (this.table?.columns ?? []).map(({ name }) => name).filter((name) => name !== "t");
      const alike = names.includes(this.channel.select.value) ? this.channel.select.value : names[0];
      refill(this.column, names.map((name) => [name, name]), alike);
      this.changed();
    } catch (error) {
      this.complain(error);
    }
  }

  /** The input as one would say it: ``doublet elevator 2deg for 1s``. */
  text() {
    const shape = this.shape.select.value;
    const channel = this.channel.select.value;
    if (shape === "measured") return `measured ${channel} ${this.table?.file ?? "(choose a file)"} column ${this.column.select.value}`;
    const times = this.asked.map(({ word, input }) => `${word} ${said(input.value, "s")}`);
    return [shape, channel, said(this.amplitude.input.value, this.unit.select.value), ...times].join(" ");
  }

  /** Says the words at once, and asks the server what they mean when the typing pauses. */
  changed() {
    this.words.textContent = this.text();
    clearTimeout(this.asking);
    this.asking = setTimeout(() => this.preview(), PAUSE);
  }

  async preview() {
    const text = this.text();
    try {
      const seen = this.shape.select.value === "measured" ? this.history() : this.link.connected && (await this.link.command("preview", { text }));
      if (text !== this.text() || !seen) return;
      this.trouble.textContent = "";
      this.draw(seen.times ?? seen.values.map((_, k) => seen.start + k * seen.dt), seen.values);
    } catch (error) {
      if (text === this.text()) this.complain(error);
    }
  }

  history() {
    return this.table && historyOf(this.table, this.column.select.value, CHANNELS[this.channel.select.value].si);
  }

  async send() {
    try {
      if (this.shape.select.value !== "measured") await this.link.command("input", { text: this.text() });
      else if (!this.table) throw new Error("Choose a CSV file first: a column t, and one for each signal, t [s],elevator [deg].");
      else await this.link.upload(this.channel.select.value, this.history());
      this.trouble.textContent = "";
    } catch (error) {
      this.complain(error);
    }
  }

  complain(error) {
    this.trouble.textContent = error.message;
    this.curve.setAttribute("points", "");
    this.span.textContent = "";
  }

  draw(times, values) {
    const [first, last] = [times[0], times.at(-1)];
    const low = values.reduce((a, b) => Math.min(a, b), 0);
    const high = values.reduce((a, b) => Math.max(a, b), 0);
    const y = (value) => HEIGHT - 6 - ((value - low) / (high - low || 1)) * (HEIGHT - 12);
    const x = (t) => ((t - first) / (last - first)) * WIDTH;
    this.curve.setAttribute("points", times.map((t, k) => `${x(t).toFixed(1)},${y(values[k]).toFixed(1)}`).join(" "));
    this.axis.setAttribute("d", `M0 ${y(0)}H${WIDTH}`);
    const channel = CHANNELS[this.channel.select.value];
    const { label, factor } = channel.si === "m/s" ? { label: "m/s", factor: 1 } : shown(channel.si);
    this.span.textContent = `${figure(low * factor)} to ${figure(high * factor)} ${label === "–" ? "" : label} in ${figure(last - first)} s`.replace("  ", " ");
  }
}
