/** One number of the aircraft in the Variable stability tab: slider, entry, printed value, reset. */

import { html } from "./dom.js";
import { DEG, FOOT, KNOT, clamp } from "./units.js";

const DETENTS = 400; // of a slider
const DIGITS = 5;
// What pilots and data sheets use instead of the SI unit: label for the eye, label on the wire, factor to SI.
const SHOWN = {
  V: { unit: "kt", factor: KNOT },
  h: { unit: "ft", factor: FOOT },
  alpha: { unit: "deg", factor: DEG },
};
const DIMENSIONLESS = new Set(["1", "1/rad"]);

export class KnobRow {
  /** `knob` as in the server's message KNOBS; `edits` takes the changes. */
  constructor(knob, edits) {
    this.knob = knob;
    this.edits = edits;
    const { name, meaning, low, high, value, unit } = knob;
    const shown = SHOWN[name];
    this.unit = shown?.unit ?? unit;
    this.factor = shown?.factor ?? 1;
    const id = `knob-${name}`;
    this.slider = html("input", {
      type: "range",
      min: low,
      max: high,
      step: (high - low) / DETENTS,
      value,
      "aria-label": `${name}, ${meaning}`,
      oninput: () => this.slide(true),
      onchange: () => this.slide(false),
    });
    this.entry = html("input", {
      id,
      type: "text",
      inputmode: "decimal",
      autocomplete: "off",
      spellcheck: "false",
      "aria-label": `${name}, exact value${DIMENSIONLESS.has(unit) ? "" : ` in ${this.unit}`}`,
      title: "Enter sets it. Other units may be written after the number.",
      onchange: () => this.enter(),
      onblur: () => this.show(this.value),
    });
    this.back = html(
      "button",
      { type: "button", class: "icon-small", title: `Reset ${name}`, "aria-label": `Reset ${name}`, onclick: () => edits.reset(name) },
      "↺",
    );
    const printed = clamp((value - low) / (high - low), 0, 1);
    this.element = html(
      "div",
      { class: "knob", "data-knob": name, role: "group", "aria-label": name },
      html("label", { for: id, title: meaning }, name),
      html("span", { class: "knob-slider", style: `--printed:${printed}` }, this.slider),
      this.entry,
      html("span", { class: "knob-unit" }, unit === "1" ? "" : this.unit),
      this.back,
      html("small", {}, `${meaning} · ${origin(knob)}`),
    );
    this.show(value);
  }

  /** The present value, SI; `changed` says whether it is another than in the file. */
  show(value, changed = this.element.classList.contains("is-changed")) {
    this.value = value;
    this.element.classList.toggle("is-changed", changed);
    this.back.disabled = !changed;
    if (!this.slider.matches(":active")) this.slider.value = value;
    if (document.activeElement !== this.entry || !this.typed()) this.entry.value = this.words(value);
  }

  words(value) {
    return tidy(value / this.factor);
  }

  typed() {
    return this.entry.value !== this.words(this.value);
  }

  slide(dragging) {
    const { low, high } = this.knob;
    const fine = 10 ** Math.floor(Math.log10((high - low) / DETENTS));
    const value = Number((Math.round(Number(this.slider.value) / fine) * fine).toPrecision(12));
    this.send(`${value}${this.suffix(this.knob.unit)}`, value, dragging);
  }

  enter() {
    const text = this.entry.value.trim();
    if (!text || !this.typed()) return;
    const bare = Number.isFinite(Number(text));
    this.entry.blur();
    this.send(bare ? `${text}${this.suffix(this.unit)}` : text, bare ? Number(text) * this.factor : null, false);
  }

  /** A center of gravity that the source does not give can only be shifted. */
  send(text, value, dragging) {
    const asInFile = value !== null && this.words(value) === this.words(this.knob.value);
    if (asInFile && !dragging && !this.knob.shifts) this.edits.reset(this.knob.name);
    else this.edits.set(`${this.knob.name}${this.knob.shifts ? "+=" : "="}${text}`, dragging);
    if (value !== null) this.entry.value = this.words(value);
  }

  suffix(unit) {
    return DIMENSIONLESS.has(unit) ? "" : ` ${unit}`;
  }

  /** Whether it is meant by `text`, in its name or in its meaning. */
  fits(text) {
    return `${this.knob.name} ${this.knob.meaning}`.toLowerCase().includes(text);
  }
}

function origin({ printed, confidence, assumed, tabulated }) {
  if (assumed) return "assumed";
  if (printed === null) return "not in the source";
  if (tabulated) return `${printed.replace("-", "−")} from the tables`;
  return `printed ${printed.replace("-", "−")}${confidence ? `, ${confidence} confidence` : ""}`;
}

const tidy = (value) => String(Number(value.toPrecision(DIGITS)));
