/** Angle of attack in degrees; the bug marks that of trim. */

import { GREY } from "../page/dial.js";
import { DEG, clamp, degrees, minus } from "../page/units.js";

export const title = "angle of attack";
export const needs = ["alpha"];

const SCALE = { low: -10, high: 30 };
const PER_DEGREE = 7 * DEG;

/** Clockwise from the top; zero points left. */
const angle = (alpha) => -90 * DEG + clamp(alpha, SCALE.low, SCALE.high) * PER_DEGREE;

export function face(dial, start) {
  for (let alpha = SCALE.low; alpha <= SCALE.high; alpha++) {
    const major = alpha % 5 === 0;
    dial.tick(angle(alpha), major ? 0.74 : 0.81, 0.87, major ? 0.022 : 0.011);
    if (alpha % 10 === 0) dial.label(minus(alpha), angle(alpha), 0.56, 0.14);
  }
  dial.text("ALPHA", 0.1, -0.24, 0.1, GREY);
  dial.text("DEGREES", 0.1, 0.26, 0.085, GREY);
  if (start.trimmed) dial.bug(angle(degrees(start.alpha)));
}

export function draw(dial, { alpha }) {
  dial.needle(angle(degrees(alpha)), 0.8, 0.03);
  dial.cap();
}
