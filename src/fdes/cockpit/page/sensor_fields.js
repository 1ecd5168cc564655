/** Sensor lag and pure delay in the Flight control tab: what all laws measure comes through both. */

import { choice } from "./fields.js";
import { html } from "./dom.js";

const HELP = {
  lag: "What the laws measure comes through 1 / (lag s + 1)",
  delay: "What the laws measure comes this much later, after the lag: computer and bus",
};

export class SensorFields {
  /** `changed()` is called when the pilot has entered another number. */
  constructor(changed) {
    this.frame = 1 / 120; // s
    this.settings = { lag: 0, delay: 0 };
    this.lag = entry("Sensor lag", HELP.lag, changed);
    this.delay = entry("Sensor delay", HELP.delay, changed);
    this.unit = choice("", [["s", "s"], ["frames", "frames"]], "s");
    this.unit.select.setAttribute("aria-label", "Unit of the sensor delay");
    this.unit.select.addEventListener("change", () => {
      this.delay.blur();
      this.show(this.settings, this.frame);
    });
    this.element = html(
      "span",
      { class: "law-sensors law-row" },
      html("span", {}, "Sensors"),
      html("label", { title: HELP.lag }, html("span", {}, "lag"), this.lag, html("small", {}, "s")),
      html("label", { title: HELP.delay }, html("span", {}, "delay"), this.delay),
      this.unit.select,
    );
  }

  /** The part of a law's text that says them; null where there is neither lag nor delay. */
  text({ lag, delay } = this.settings) {
    return [lag, delay].every((value) => Number(value) === 0) ? null : `sensors lag=${lag}s delay=${delay}s`;
  }

  /** The same of what was entered, number or not: the server says what is wrong with it. */
  entered() {
    const [lag, late] = [said(this.lag), said(this.delay)];
    const inFrames = this.unit.select.value === "frames" && Number.isFinite(Number(late));
    return this.text({ lag, delay: inFrames ? String(Number(late) * this.frame) : late });
  }

  /** `settings` { lag, delay } and `frame`, all in s. */
  show(settings, frame) {
    Object.assign(this, { settings, frame });
    const shown = this.unit.select.value === "frames" ? settings.delay / frame : settings.delay;
    write(this.lag, settings.lag);
    write(this.delay, shown);
  }

  /** Keeps what was entered for the first law that is engaged. */
  keep() {
    const late = Number(said(this.delay));
    const [lag, delay] = [Number(said(this.lag)), this.unit.select.value === "frames" ? late * this.frame : late];
    if (Number.isFinite(lag) && Number.isFinite(delay)) this.settings = { lag, delay };
  }
}

function entry(words, title, changed) {
  return html("input", { type: "text", inputmode: "decimal", autocomplete: "off", value: "0", title, "aria-label": words, onchange: changed });
}

const said = (input) => input.value.trim() || "0";

function write(input, value) {
  if (input !== document.activeElement) input.value = String(Number(value.toPrecision(4)));
}
