/**
 * Units at the instruments' edge. Everything arrives in SI and radians; pilots read knots, feet and degrees.
 * The factors are exact by definition: international foot (1959), nautical mile (1929).
 */

export const DEG = Math.PI / 180;
export const FOOT = 0.3048;
export const KNOT = 1852 / 3600;
export const FOOT_PER_MINUTE = FOOT / 60;
export const POUND = 0.45359237;

export const degrees = (radians) => radians / DEG;
export const knots = (speed) => speed / KNOT;
export const feet = (length) => length / FOOT;
export const feetPerMinute = (speed) => speed / FOOT_PER_MINUTE;

/** A heading or course [rad] as degrees from 0 up to 360. */
export const compass = (radians) => ((degrees(radians) % 360) + 360) % 360;

/** An angle [rad] brought to -pi..pi. */
export const halfTurn = (radians) => radians - 2 * Math.PI * Math.round(radians / (2 * Math.PI));

/** The least of 1, 2, 5, 10, ... that is not below `value`: what an axis counts by. */
export function roundStep(value) {
  const power = 10 ** Math.floor(Math.log10(value || 1));
  return ([1, 2, 5].find((lead) => value / power <= lead * 1.0001) ?? 10) * power;
}

export const clamp = (value, low, high) => Math.max(low, Math.min(high, value));

/** SI unit -> what a chart shows: label, factor to multiply by, and the smallest span worth an axis. */
const SHOWN = {
  rad: { label: "deg", factor: 1 / DEG, span: 4 },
  "rad/s": { label: "deg/s", factor: 1 / DEG, span: 4 },
  "rad/s^2": { label: "deg/s²", factor: 1 / DEG, span: 10 },
  m: { label: "ft", factor: 1 / FOOT, span: 100 },
  "m/s": { label: "kt", factor: 1 / KNOT, span: 10 },
  Pa: { label: "kPa", factor: 1e-3, span: 1 },
  1: { label: "–", factor: 1, span: 1 },
};

/** How a channel of unit `unit` is shown. Load factors are counted in g. Climb rates are speeds too, but pilots want them in feet per minute. */
export function shown(unit, name = "") {
  if (/^n_[xyz]$/.test(name)) return { label: "g", factor: 1, span: 1 };
  if (name === "h_dot") return { label: "ft/min", factor: 1 / FOOT_PER_MINUTE, span: 1000 };
  return SHOWN[unit] ?? { label: unit, factor: 1, span: 1 };
}

/** Seconds as minutes and seconds: 75 -> "1:15". */
export function minutes(seconds) {
  const whole = Math.max(0, Math.floor(seconds));
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, "0")}`;
}

/** `value` with so many decimals; what rounds to zero has no sign. */
export const fixed = (value, digits) => value.toFixed(digits).replace(/^-(0\.?0*)$/, "$1");

/** A number as it is read, with a true minus sign for the hyphen that JavaScript writes. */
export const minus = (number) => String(number).replaceAll("-", "−");

/** A number with three significant digits, a true minus sign and no exponent; an en dash for null. */
export function figure(value, digits = 3) {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const decimals = clamp(digits - 1 - Math.floor(Math.log10(Math.abs(value))), 0, 9);
  return minus(value.toFixed(decimals));
}
