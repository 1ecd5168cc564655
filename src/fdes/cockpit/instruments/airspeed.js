/** Airspeed indicator: calibrated airspeed in knots. The scale fits the aircraft; the bug marks the trim speed. */

import { AMBER, GREY } from "../page/dial.js";
import { DEG, clamp, knots } from "../page/units.js";

export const title = "airspeed";
export const needs = ["cas"];

const SCALES = [
  { top: 200, minor: 5, major: 20, letter: 0.115 },
  { top: 400, minor: 10, major: 50, letter: 0.13 },
  { top: 700, minor: 20, major: 100, letter: 0.14 },
  { top: 1400, minor: 50, major: 200, letter: 0.125 },
];
const SWEEP = 325 * DEG;

const scaleFor = ({ cas = 0 }) => SCALES.find(({ top }) => top >= 1.7 * knots(cas)) ?? SCALES.at(-1);
const angle = (speed, { top }) => (clamp(speed, 0, top) / top) * SWEEP;

export function face(dial, start) {
  const scale = scaleFor(start);
  for (let v = 0; v <= scale.top; v += scale.minor) {
    const major = v % scale.major === 0;
    dial.tick(angle(v, scale), major ? 0.73 : 0.79, 0.86, major ? 0.022 : 0.012);
    if (major && v) dial.label(String(v), angle(v, scale), 0.56, scale.letter);
  }
  dial.text("AIRSPEED", 0, -0.26, 0.095, GREY);
  dial.text("KNOTS", 0, 0.3, 0.095, GREY);
  if (start.trimmed) dial.bug(angle(knots(start.cas), scale));
}

export function draw(dial, { cas }, start) {
  dial.needle(angle(knots(cas), scaleFor(start)), 0.8, 0.03, { color: cas < 0 ? AMBER : undefined });
  dial.cap();
}
