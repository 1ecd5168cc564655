/** Load factor in g. The thin hands stay at the most and the least of this flight. */

import { AMBER, GREY } from "../page/dial.js";
import { DEG, clamp, minus } from "../page/units.js";

export const title = "load factor";
export const needs = ["n_z"];

const SCALE = { low: -4, high: 10 };
const PER_G = 22 * DEG;

/** Clockwise from the top; 1 g points left. */
const angle = (g) => -90 * DEG + (clamp(g, SCALE.low, SCALE.high) - 1) * PER_G;

export function face(dial) {
  for (let half = 2 * SCALE.low; half <= 2 * SCALE.high; half++) {
    const g = half / 2;
    const whole = Number.isInteger(g);
    dial.tick(angle(g), whole ? 0.75 : 0.8, 0.87, whole ? 0.022 : 0.012);
    if (whole && g % 2 === 0) dial.label(minus(g), angle(g), 0.58, 0.14);
  }
  dial.text("LOAD FACTOR", 0.08, -0.24, 0.085, GREY);
  dial.text("G", 0.08, 0.26, 0.1, GREY);
}

export function draw(dial, { n_z }, start) {
  start.mostG = Math.max(start.mostG ?? n_z, n_z);
  start.leastG = Math.min(start.leastG ?? n_z, n_z);
  dial.needle(angle(start.mostG), 0.72, 0.014, { color: AMBER, tail: 0.1 });
  dial.needle(angle(start.leastG), 0.72, 0.014, { color: AMBER, tail: 0.1 });
  dial.needle(angle(n_z), 0.8, 0.03);
  dial.cap();
}
