/** The Modes tab: the s-plane, always in sight, under it the table of the natural modes and a line of static figures. */

import { html } from "./dom.js";
import { drawSPlane, modeName } from "./s_plane.js";
import { figure } from "./units.js";

const COLUMNS = [
  ["Mode", "The natural motions of the aircraft, stick fixed"],
  ["ωn, rad/s", "Undamped natural frequency; of a real root its size"],
  ["ζ", "Damping ratio; none for a real root"],
  ["τ, s", "Time constant"],
  ["T½, s", "Time to half amplitude; ×2: to double it"],
  ["T, s", "Period: time of one oscillation"],
  ["Cycles", "Periods until half the amplitude is left; ×2: until it has doubled"],
];
const NEUTRAL = 1e6; // s: a slower motion is none
const LONGEST_TRAIL = 1200; // modes as they were: some 240 edits
const AIRLESS = "Dimensional derivatives: no static margin, n/α, roll rate.";

export class ModesPanel {
  constructor(plane, table, figures) {
    this.plane = plane;
    this.table = table;
    this.figures = figures;
    this.modes = [];
    this.bare = [];
    new ResizeObserver(() => this.drawPlane()).observe(plane.parentElement);
    table.addEventListener("pointerover", ({ target }) => this.highlight(target.closest("tr")?.dataset.mode));
    table.addEventListener("pointerleave", () => this.highlight(null));
    table.addEventListener("focusin", ({ target }) => this.highlight(target.closest("tr")?.dataset.mode));
    table.addEventListener("focusout", () => this.highlight(null));
    this.static = null;
    this.whose = "";
    this.trail = [];
    this.clear = html("button", { type: "button", class: "quiet clear-trail", hidden: true, title: "Clear the trail of the poles", "aria-label": "Clear the trail of the poles", onclick: () => this.clearTrail() }, "✕");
    document.querySelector(".levels-line").append(this.clear);
  }

  /** Static margin and its relatives: numbers in SI, or null where the aircraft has none. */
  showStatic(figures, plant) {
    this.static = figures;
    this.whose = plant === "nonlinear" ? " · all of the linearized aircraft" : "";
    this.describe(null);
  }

  /** The line under the table: the approximation to the mode pointed at, else the static figures. */
  describe(mode) {
    this.figures.textContent = mode ? approximation(mode) : `${staticFigures(this.static)}${this.whose}`;
  }

  /** Forgets where the poles have been: with another aircraft, or when asked. */
  clearTrail() {
    this.trail = [];
    this.clear.hidden = true;
    this.drawPlane();
  }

  /** `bare`: the roots [re, im] without control law and actuators, where there are any. */
  show(modes, bare = []) {
    this.leaveTrail(modes);
    this.modes = modes;
    this.bare = bare;
    this.drawPlane();
    const head = html(
      "thead",
      {},
      html(
        "tr",
        {},
        COLUMNS.map(([label, title]) => html("th", { scope: "col", title }, label)),
      ),
    );
    this.table.replaceChildren(
      html("caption", { class: "unseen" }, "Natural modes"),
      head,
      html("tbody", {}, modes.map(row)),
    );
  }

  /** Keeps the present modes as a trail when `next` have other roots. */
  leaveTrail(next) {
    const roots = (modes) => JSON.stringify(modes.map(({ eigenvalue }) => eigenvalue));
    if (!this.modes.length || roots(this.modes) === roots(next)) return;
    this.trail = [...this.trail, ...this.modes].slice(-LONGEST_TRAIL);
    this.clear.hidden = false;
  }

  drawPlane() {
    const { width, height } = this.plane.parentElement.getBoundingClientRect();
    if (width > 0) drawSPlane(this.plane, this.modes, width, height, this.trail, this.bare);
  }

  highlight(name) {
    for (const element of [
      ...this.plane.querySelectorAll("[data-mode]"),
      ...this.table.querySelectorAll("[data-mode]"),
    ])
      element.classList.toggle("is-pointed", element.dataset.mode === name);
    this.describe(this.modes.find((mode) => mode.name === name));
  }
}

function staticFigures(figures) {
  if (!figures) return AIRLESS;
  const { static_margin, n_alpha, roll_rate } = figures;
  const rolls = roll_rate === null ? "" : ` · roll ${figure(roll_rate)} °/s per °`;
  return `Static margin ${figure(100 * static_margin)} % · n/α ${figure(n_alpha)} g/rad${rolls}`;
}

/** Nelson's approximation to a mode, and how far it is off. */
function approximation({ name, approximation: nelson }) {
  if (!nelson) return `${modeName(name)}: there is no approximation to it.`;
  const [re, im] = nelson.eigenvalue;
  const value = `${figure(re)}${im ? ` ± ${figure(im)} i` : ""} rad/s`;
  const off = [
    ["ωn", nelson.omega_n_error],
    ["ζ", nelson.zeta_error],
  ]
    .filter(([, error]) => error !== null)
    .map(([what, error]) => `${what} ${error < 0 ? "−" : "+"}${Math.abs(100 * error).toFixed(Math.abs(error) < 0.1 ? 1 : 0)} %`);
  return `Nelson: ${value}, off by ${off.join(", ")}`;
}

/** A short time is told in two digits: its column is no wider than the others. */
const brief = (time) => figure(time, Math.abs(time) < 0.1 ? 2 : 3);

/** A time of a mode; that of a root which is zero but for rounding is infinite. */
const lasting = (time) => (time > NEUTRAL ? "∞" : brief(time));

function row(mode) {
  const { name, axis, omega_n, zeta, time_constant, time_to_half, time_to_double, period } = mode;
  const { cycles_to_half, cycles_to_double } = mode;
  const growing = time_to_double !== null && time_to_double < NEUTRAL;
  const who = Object.entries(mode.participation ?? {})
    .map(([state, share]) => `${state} ${Math.round(100 * share)} %`)
    .join(", ");
  return html(
    "tr",
    { "data-mode": name, tabindex: 0, title: who && `Who takes part: ${who}` },
    html("th", { scope: "row" }, html("i", { class: `swatch ${axis}` }), modeName(name)),
    html("td", {}, omega_n < 1 / NEUTRAL ? "0" : figure(omega_n)),
    html("td", {}, period === null ? "–" : figure(zeta)),
    html("td", {}, lasting(time_constant)),
    html("td", { class: growing ? "growing" : "" }, growing ? `×2 ${brief(time_to_double)}` : lasting(time_to_half ?? time_to_double)),
    html("td", {}, brief(period)),
    html("td", { class: growing ? "growing" : "" }, cycles_to_double ? `×2 ${brief(cycles_to_double)}` : brief(cycles_to_half)),
  );
}
