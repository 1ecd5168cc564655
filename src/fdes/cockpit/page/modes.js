/** The Modes tab: the s-plane, always in sight, and the table of the natural modes under it. */

import { html } from "./dom.js";
import { drawSPlane, modeName } from "./s_plane.js";
import { figure } from "./units.js";

const COLUMNS = [
  ["Mode", "The natural motions of the aircraft, stick fixed"],
  ["ωn, rad/s", "Undamped natural frequency; of a real root its size"],
  ["ζ", "Damping ratio; none for a real root"],
  ["τ, s", "Time constant"],
  ["T½, s", "Time to half amplitude; T2: to double it"],
  ["Period", "Time of one oscillation, s"],
];

export class ModesPanel {
  constructor(plane, table) {
    this.plane = plane;
    this.table = table;
    this.modes = [];
    new ResizeObserver(() => this.drawPlane()).observe(plane.parentElement);
    table.addEventListener("pointerover", ({ target }) => this.highlight(target.closest("tr")?.dataset.mode));
    table.addEventListener("pointerleave", () => this.highlight(null));
  }

  show(modes) {
    this.modes = modes;
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

  drawPlane() {
    const { width, height } = this.plane.parentElement.getBoundingClientRect();
    if (width > 0) drawSPlane(this.plane, this.modes, width, height);
  }

  highlight(name) {
    for (const element of [
      ...this.plane.querySelectorAll("[data-mode]"),
      ...this.table.querySelectorAll("[data-mode]"),
    ])
      element.classList.toggle("is-pointed", element.dataset.mode === name);
  }
}

function row(mode) {
  const { name, axis, omega_n, zeta, time_constant, time_to_half, time_to_double, period } = mode;
  const growing = time_to_double !== null;
  const who = Object.entries(mode.participation ?? {})
    .map(([state, share]) => `${state} ${Math.round(100 * share)} %`)
    .join(", ");
  return html(
    "tr",
    { "data-mode": name, title: who && `Who takes part: ${who}` },
    html("th", { scope: "row" }, html("i", { class: `swatch ${axis}` }), modeName(name)),
    html("td", {}, figure(omega_n)),
    html("td", {}, period === null ? "–" : figure(zeta)),
    html("td", {}, figure(time_constant)),
    html("td", { class: growing ? "growing" : "" }, growing ? `T2 ${figure(time_to_double)}` : figure(time_to_half)),
    html("td", {}, figure(period)),
  );
}
