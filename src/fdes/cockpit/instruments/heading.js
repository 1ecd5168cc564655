/** Heading indicator: the card turns under a fixed aircraft; the small diamond is the course over the ground. */

import { AMBER, CYAN, WHITE } from "../page/dial.js";
import { DEG } from "../page/units.js";

export const title = "heading";
export const needs = ["psi", "chi"];

const CARDINAL = { 0: "N", 90: "E", 180: "S", 270: "W" };
const AIRCRAFT = [
  [0, -0.36],
  [0.04, -0.3],
  [0.045, -0.12],
  [0.34, 0.04],
  [0.34, 0.1],
  [0.045, 0.04],
  [0.035, 0.22],
  [0.13, 0.29],
  [0.13, 0.34],
  [0, 0.3],
];

export function draw(dial, { psi, chi }) {
  dial.turned(-psi, () => card(dial));
  dial.turned(chi - psi, () =>
    dial.polygon(
      [
        [0, -0.88],
        [0.035, -0.82],
        [0, -0.76],
        [-0.035, -0.82],
      ],
      CYAN,
    ),
  );
  const left = AIRCRAFT.map(([x, y]) => [-x, y]).reverse();
  dial.polygon([...AIRCRAFT, ...left], AMBER);
  dial.polygon(
    [
      [0, -0.74],
      [-0.055, -0.885],
      [0.055, -0.885],
    ],
    AMBER,
  );
}

function card(dial) {
  for (let d = 0; d < 360; d += 5) dial.tick(d * DEG, d % 10 ? 0.81 : 0.76, 0.87, d % 10 ? 0.012 : 0.02);
  for (let d = 0; d < 360; d += 30) {
    dial.turned(d * DEG, () =>
      dial.text(CARDINAL[d] ?? String(d / 10), 0, -0.62, d % 90 ? 0.13 : 0.175, d % 90 ? WHITE : "#ffd166"),
    );
  }
}
