/** One control law in the Flight control tab: on or off, what is wanted of it, its gains, and what came of them. */

import { html } from "./dom.js";
import { button } from "./fields.js";
import { DEG, figure } from "./units.js";

const DETENTS = 200; // of a slider
const WORDS = { zeta: "ζ", omega: "ωn", time_constant: "τ", gain: "K", integral_gain: "Ki", rate_gain: "Kp" };
const HELP = {
  zeta: "damping ratio",
  omega: "natural frequency",
  time_constant: "time constant",
  washout: "What lasts longer than this is forgotten, so that the damper does not fight a steady turn",
  full_bank: "The bank that full stick commands",
  full_rate: "The pitch rate that full stick commands",
};
const OF_THE_STOPS = new Set(["lower", "upper"]); // where the elevator stops: they go along unseen
const DEGREES = { rad: "deg", "rad/s": "deg/s" };

export class LawCard {
  /** `law` as in the server's message LAWS, `words` { title, does }; `ask(text)` flies this law, or none for null. */
  constructor(law, words, ask) {
    Object.assign(this, { law, words, ask });
    this.part = null; // what the server says of it, while it is engaged
    this.last = null; // what it said when it was engaged last
    this.box = html("input", { type: "checkbox", onchange: () => ask(this.box.checked ? (this.last ?? law.name) : null) });
    this.wishes = new Map(Object.entries(law.wishes).map(([name, unit]) => [name, this.entry(name, unit, () => this.design())]));
    this.gains = new Map(Object.entries(law.gains).map(([name, unit]) => [name, this.slider(name, unit)]));
    this.settings = new Map(
      Object.entries(law.settings)
        .filter(([name]) => !OF_THE_STOPS.has(name))
        .map(([name, unit]) => [name, this.entry(name, unit, () => this.change())]),
    );
    this.figures = html("dl", { class: "law-figures number" });
    const rows = [...this.gains.values()].map(({ row }) => row);
    const fields = (entries) => [...entries.values()].map(({ label }) => label);
    this.body = html(
      "div",
      { class: "law-body", hidden: true },
      html("div", { class: "law-row" }, html("span", {}, "Wanted"), fields(this.wishes), button("Design", () => this.design())),
      rows,
      this.settings.size ? html("div", { class: "law-row" }, fields(this.settings)) : null,
      this.figures,
    );
    this.element = html(
      "section",
      { class: "law", "data-law": law.name, "aria-label": words.title },
      html("label", { class: "law-head" }, this.box, html("b", {}, words.title), html("small", {}, words.does)),
      this.body,
    );
  }

  /** A number with its unit; angles are said in degrees, natural frequencies are not. */
  entry(name, unit, changed) {
    const shown = name === "omega" ? unit : (DEGREES[unit] ?? unit);
    const input = html("input", { type: "text", inputmode: "decimal", autocomplete: "off", "aria-label": `${this.words.title}: ${HELP[name] ?? name}`, onchange: changed });
    const label = html(
      "label",
      { title: HELP[name] },
      html("span", {}, WORDS[name] ?? name.replaceAll("_", " ")),
      input,
      shown === "1" ? null : html("small", {}, shown),
    );
    return { input, label, unit, shown };
  }

  slider(name, unit) {
    const words = `${this.words.title}: ${name.replaceAll("_", " ")}`;
    const range = html("input", { type: "range", min: 0, max: 1, step: 1 / DETENTS, "aria-label": `${words}, slider`, oninput: () => this.slide(name) });
    const input = html("input", { type: "text", inputmode: "decimal", autocomplete: "off", "aria-label": `${words}, ${unit}`, onchange: () => this.change() });
    return { range, input, row: html("div", { class: "law-gain" }, html("span", {}, WORDS[name]), range, input, html("small", {}, unit)) };
  }

  slide(name) {
    const { range, input } = this.gains.get(name);
    input.value = tidy(Number(range.value));
    this.change();
  }

  /** Designed for what is wanted; what is left empty is left to the server. */
  design() {
    const wishes = [...this.wishes].filter(([, { input }]) => input.value.trim()).map(([name, { input }]) => `${name}=${input.value.trim()}`);
    return this.ask([this.law.name, ...wishes, ...this.said(this.settings, false)].join(" "));
  }

  /** By hand: the gains as they stand. */
  change() {
    for (const { input } of this.wishes.values()) input.value = "";
    return this.ask([this.law.name, ...this.said(this.gains, true), ...this.said(this.settings, true)].join(" "));
  }

  /** What must be sent to have it designed once more, in another domain; as it is where its gains are given. */
  again() {
    return [...this.wishes.values()].some(({ input }) => input.value) ? this.designed() : this.part;
  }

  designed() {
    const wishes = [...this.wishes].filter(([, { input }]) => input.value).map(([name, { input }]) => `${name}=${input.value}`);
    return [this.law.name, ...wishes, ...this.said(this.settings, false)].join(" ");
  }

  /** Fields as the server reads them. Settings that stand as they are may be left out of a design: it knows them. */
  said(fields, all) {
    return [...fields]
      .filter(([, { input, was }]) => input.value.trim() && (all || input.value !== was || this.part === null))
      .map(([name, { input, shown }]) => `${name}=${input.value.trim()}${shown && shown !== "1" ? shown : ""}`);
  }

  /** `gains` by name, `achieved` and `part`, the text, as in CONTROL; null where the law is off. */
  show(now) {
    this.part = now?.part ?? null;
    this.last = this.part ?? this.last;
    this.box.checked = now !== null;
    this.element.classList.toggle("is-on", now !== null);
    const opens = this.body.hidden && now !== null;
    this.body.hidden = now === null;
    if (!now) return;
    for (const [name, { range, input }] of this.gains) {
      const value = now.gains[name];
      if (!range.matches(":active")) {
        const least = Math.max(1e-3, 2.5 * Math.abs(value));
        if (value > range.max || least > range.max || range.max > 8 * least) range.max = roundUp(least);
        range.step = range.max / DETENTS;
        range.value = value;
      }
      write(input, tidy(value));
    }
    for (const [name, field] of this.settings) {
      field.was = tidy(now.gains[name] / (DEGREES[field.unit] ? DEG : 1));
      write(field.input, field.was);
    }
    const { quantity, wanted } = now.achieved;
    const wish = this.wishes.get(quantity);
    if (wanted !== null) write(wish.input, tidy(wanted));
    else for (const { input } of this.wishes.values()) write(input, "");
    this.figures.replaceChildren(...figures(now));
    if (opens && document.activeElement === this.box) this.element.scrollIntoView({ block: "nearest" });
  }

  /** Forgets the gains of another aircraft. */
  forget() {
    this.last = null;
  }
}

/** What is wanted, designed and flown side by side, and what half a frame of delay does. */
function figures({ achieved, sampled, frame }) {
  const { mode, quantity, unit, wanted, before, designed, alone, continuous, flown, reached } = achieved;
  const name = `${WORDS[quantity]} of the ${mode.replaceAll("_", " ")}`;
  const cost = flown - continuous;
  const suffix = unit === "1" ? "" : ` ${unit}`;
  const late = Math.abs(alone - continuous) > 5e-4 * Math.abs(continuous);
  const cells = [
    ["without", before, `${name} without this loop`],
    ["wanted", wanted, wanted === null ? "The gains are given by hand" : `${name} that was asked for`],
    ["design", designed, `${name} where it was designed: ${sampled ? "sampled, in z" : "continuous, in s"}`],
    ...(late ? [["law alone", alone, `${name} by the law alone, continuous, without sensors and actuators`]] : []),
    ["flown", flown, `${name} as it is flown, with sensors and actuators: ln z / dt at ${Math.round(1 / frame)} frames a second`],
    ["½ frame", cost, `What the ${(500 * frame).toFixed(1)} ms do by which a held command comes late: flown less continuous`],
  ];
  return cells.map(([label, value, title]) => {
    const missed = label === "wanted" && value !== null && !reached;
    const sign = label === "½ frame" && value > 0 ? "+" : "";
    const small = label === "½ frame" && Math.abs(value) < 5e-4 * Math.abs(flown);
    return html("div", { title, class: missed ? "is-missed" : "" }, html("dt", {}, label), html("dd", {}, value === null ? "–" : small ? "±0" : `${sign}${figure(value, label === "½ frame" ? 1 : 3)}${suffix}`));
  });
}

/** What is being typed is left alone. */
function write(input, text) {
  if (input !== document.activeElement) input.value = text;
}

const tidy = (value) => String(Number(value.toPrecision(4)));

function roundUp(value) {
  const power = 10 ** Math.floor(Math.log10(value));
  return [1, 2, 5, 10].find((lead) => lead * power >= value * 0.9999) * power;
}
