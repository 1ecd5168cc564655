/**
 * One verdict on flying qualities, beside the flight: Level, margin, requirement and its source, the chart with the
 * aircraft's point and its path while edited, and which number to change to reach the next Level.
 */

import { fetchStyle, html, svg } from "./dom.js";
import { choice } from "./fields.js";
import { formula, plainFormula } from "./formula.js";
import { levelSentence, levelWord } from "./levels.js";
import { modeName } from "./s_plane.js";
import { clamp, figure, minus, roundStep } from "./units.js";

const CLASSES = ["I", "II-L", "II-C", "III", "IV"];
const CATEGORIES = ["A", "B", "C"];
const SIZE = { width: 330, height: 210, left: 40, right: 10, top: 8, bottom: 32 };
let clips = 0;

export class QualityCard {
  constructor(view, link) {
    fetchStyle("/page/quality_card.css");
    this.link = link;
    this.criterion = null;
    this.class = choice("Class", CLASSES, "IV");
    this.category = choice("Category", CATEGORIES, "A");
    for (const { select } of [this.class, this.category]) select.addEventListener("change", () => this.judge());
    this.title = html("h2", { id: "quality-title" });
    this.body = html("div", { class: "quality-body" });
    this.advice = html("div", { class: "advice" });
    const ask = html("button", { type: "button", onclick: () => this.improve() }, "What to change");
    const close = html("button", { class: "icon", type: "button", "aria-label": "Close the verdict", onclick: () => this.close() }, "✕");
    this.problem = html("p", { class: "problem", role: "alert" });
    this.element = html(
      "section",
      { class: "quality-card", "aria-labelledby": "quality-title", tabindex: -1 },
      html("div", { class: "quality-head" }, this.title, close),
      html("div", { class: "form-row" }, this.class.label, this.category.label, ask),
      this.problem,
      this.advice,
      this.body,
    );
    this.element.addEventListener("keydown", ({ key }) => key === "Escape" && this.close());
    view.append(this.element);
  }

  open(criterion) {
    if (criterion !== this.criterion) this.advice.replaceChildren();
    this.criterion = criterion;
    this.element.hidden = false;
    this.element.focus({ preventScroll: true });
  }

  close() {
    this.element.hidden = true;
    document.querySelector(`.level[data-criterion="${this.criterion}"]`)?.focus();
  }

  async judge() {
    const fields = { airplane_class: this.class.select.value, category: this.category.select.value };
    await this.say(() => this.link.command("judge", fields));
  }

  async improve() {
    this.advice.replaceChildren(html("p", { class: "quiet-words" }, "Trying changes…"));
    const found = await this.say(() => this.link.command("improve", { criterion: this.criterion }));
    const lines = found?.improvements.map(({ says }) => html("li", {}, formula(says))) ?? [];
    this.advice.replaceChildren(
      lines.length ? html("ul", {}, lines) : html("p", {}, found?.reason ?? "No single number reaches a better Level."),
    );
  }

  async say(ask) {
    try {
      this.problem.textContent = "";
      return await ask();
    } catch (error) {
      this.problem.textContent = error.message;
      return null;
    }
  }

  show({ role, verdicts, charts }, paths) {
    const verdict = verdicts.find(({ criterion }) => criterion === this.criterion);
    if (!verdict || this.element.hidden) return;
    const { mode, level, margin, reason, requirement, reference } = verdict;
    this.class.select.value = role.airplane_class;
    this.category.select.value = role.category;
    this.title.replaceChildren(`${modeName(mode)} `, html("b", { class: `level level-${level}` }, level === null ? "–" : levelWord(level)));
    const drawn = charts.filter(({ criterion }) => criterion === this.criterion).map((chart) => draw(chart, paths.get(chart.title) ?? []));
    this.body.replaceChildren(
      html("p", {}, `${levelSentence(level)}${margin === null ? "" : `, margin ${minus((100 * margin).toFixed(0))} %`}. `, formula(reason)),
      ...drawn,
      html("p", { class: "quiet-words" }, formula(requirement)),
      html("p", { class: "quiet-words" }, reference),
      html("p", { class: "quiet-words" }, `${role.says}: ${role.reason}.`),
    );
  }
}

/** A chart of the server, as SVG, with the aircraft's point and where it has been. */
function draw({ title, reference, x, y, boundaries, point, level }, path) {
  const { width, height, left, right, top, bottom } = SIZE;
  const scale = ({ low, high, log }, from, to) => {
    const [a, b] = log ? [Math.log(low), Math.log(high)] : [low, high];
    return (value) => from + ((to - from) * ((log ? Math.log(Math.max(value, 1e-12)) : value) - a)) / (b - a);
  };
  const across = scale(x, left, width - right);
  const up = scale(y, height - bottom, top);
  const line = (points) => points.map(([px, py], i) => `${i ? "L" : "M"}${across(px).toFixed(1)} ${up(py).toFixed(1)}`).join("");
  const id = `chart-clip-${++clips}`;
  const plane = svg("svg", { class: "quality-chart", viewBox: `0 0 ${width} ${height}`, role: "img", "aria-label": `${title}, ${reference}` });
  const frame = { x: left, y: top, width: width - left - right, height: height - top - bottom };
  plane.append(svg("clipPath", { id }, svg("rect", frame)), svg("rect", { class: "s-pane", ...frame }));
  for (const tick of ticks(x))
    plane.append(svg("text", { class: "s-number s-middle", x: across(tick), y: height - bottom + 12 }, minus(tick)));
  for (const tick of ticks(y)) plane.append(svg("text", { class: "s-number s-end", x: left - 4, y: up(tick) + 3 }, minus(tick)));
  const inside = svg("g", { "clip-path": `url(#${id})` });
  for (const { level: edge, x: xs, y: ys } of boundaries)
    inside.append(svg("path", { class: `bound bound-${edge}`, d: line(xs.map((value, i) => [value, ys[i]])) }));
  if (path.length > 1) inside.append(svg("path", { class: "quality-path", d: line(path) }));
  if (point) {
    const [px, py] = [clamp(across(point[0]), left, width - right), clamp(up(point[1]), top, height - bottom)];
    inside.append(svg("circle", { class: `quality-point level-${level}`, cx: px, cy: py, r: 5 }));
  }
  plane.append(inside, svg("text", { class: "s-number s-middle", x: (left + width - right) / 2, y: height - 6 }, titled(x)));
  const word = svg("text", { class: "s-number s-middle", transform: `rotate(-90) translate(${-(top + height - bottom) / 2} 10)` }, titled(y));
  plane.append(word);
  return html("figure", {}, html("figcaption", {}, formula(title)), plane, key(boundaries));
}

/** Which line bounds which Level. */
function key(boundaries) {
  const levels = [...new Set(boundaries.map(({ level }) => level))].sort();
  const lines = levels.map((level) =>
    html("span", {}, svg("svg", { viewBox: "0 0 24 4", width: 24, height: 4, "aria-hidden": "true" }, svg("path", { class: `bound bound-${level}`, d: "M0 2H24" })), ` Level ${level}`),
  );
  return html("p", { class: "bound-key" }, "Bounds of ", lines);
}

const titled = ({ label, unit }) => plainFormula(unit === "1" ? label : `${label}, ${unit}`);

function ticks({ low, high, log }) {
  if (!log) {
    const step = roundStep((high - low) / 5);
    const first = Math.ceil(low / step - 1e-9);
    return Array.from({ length: Math.floor(high / step + 1e-9) - first + 1 }, (_, k) => Number(((first + k) * step).toPrecision(3)));
  }
  const found = [];
  for (let power = Math.floor(Math.log10(low)); 10 ** power <= high; power++)
    for (const lead of high / low > 50 ? [1] : [1, 2, 5]) {
      const value = Number((lead * 10 ** power).toPrecision(3));
      if (value >= low && value <= high) found.push(value);
    }
  return found;
}
