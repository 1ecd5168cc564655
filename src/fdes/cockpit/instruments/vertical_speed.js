/** Vertical speed in thousands of feet per minute, wide near zero where it is read most. */

import { GREY } from "../page/dial.js";
import { DEG, clamp, feetPerMinute } from "../page/units.js";

export const title = "vertical speed";
export const needs = ["h_dot"];

const STOPS = [
  [0, 0],
  [1, 42],
  [2, 82],
  [4, 130],
  [6, 172],
]; // thousand ft/min -> degrees from level

/** Clockwise from the top; level flight points left. */
function angle(thousands) {
  const size = clamp(Math.abs(thousands), 0, 6);
  const i = Math.max(
    1,
    STOPS.findIndex(([value]) => value >= size),
  );
  const [[v0, a0], [v1, a1]] = [STOPS[i - 1], STOPS[i]];
  return (-90 + Math.sign(thousands) * (a0 + ((size - v0) / (v1 - v0)) * (a1 - a0))) * DEG;
}

export function face(dial) {
  for (const sign of [-1, 1]) {
    for (let v = 0; v <= 6; v += v < 2 ? 0.2 : 0.5) {
      const mark = Math.round(v * 10) / 10;
      dial.tick(angle(sign * mark), mark % 1 ? 0.81 : 0.74, 0.87, mark % 1 ? 0.012 : 0.024);
    }
    for (const v of [1, 2, 4]) dial.label(String(v), angle(sign * v), 0.58, 0.14);
  }
  dial.label("6", 90 * DEG, 0.6, 0.14);
  dial.label("0", -90 * DEG, 0.6, 0.14);
  dial.text("VERTICAL SPEED", 0.1, -0.24, 0.08, GREY);
  dial.text("1000 FT/MIN", 0.1, 0.24, 0.08, GREY);
}

export function draw(dial, { h_dot }) {
  dial.needle(angle(feetPerMinute(h_dot) / 1000), 0.8, 0.03);
  dial.cap();
}
