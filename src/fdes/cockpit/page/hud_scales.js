/**
 * The symbols of the head-up display that are at rest on the glass: heading, bank with slip, speed, altitude, numbers.
 *
 * `glass` is as in hud_conformal.js; `state` the outputs in SI.
 */

import { DEG, clamp, compass, degrees, feet, feetPerMinute, fixed, halfTurn, knots } from "./units.js";

const zeros = (number, digits) => String(number).padStart(digits, "0");

const BANK_MARKS = [-60, -45, -30, -20, -10, 0, 10, 20, 30, 45, 60]; // deg
const HEADING_SPAN = 20; // deg to either side
const CLIMB_SPAN = 6000; // ft/min to either side
const FULL_SLIP = 0.15; // g of side force that puts the slip bar at its stop
// Shown to either side of the reading, and marked every so often: knots, feet.
const SPEED_SCALE = { span: 90, minor: 10, major: 50, label: (v) => zeros(v, 3) };
const ALTITUDE_SCALE = { span: 900, minor: 100, major: 500, label: (v) => (v / 1000).toFixed(1) };

/** Heading scale at the top; the diamond is the course over the ground. */
export function heading({ ink, cx, cy, k, R, letter }, { psi, chi }) {
  const y = Math.max(38 * k, cy - R * 1.04);
  const half = R * 0.72;
  const perDegree = half / HEADING_SPAN;
  const now = compass(psi);
  for (let d = Math.ceil((now - HEADING_SPAN) / 5) * 5; d <= now + HEADING_SPAN; d += 5) {
    const x = cx + (d - now) * perDegree;
    const major = d % 10 === 0;
    ink.line(x, y, x, y - (major ? 9 : 5) * k);
    if (major && Math.abs(x - cx) > 30 * k) ink.text(zeros(((d + 360) % 360) / 10, 2), x, y - 18 * k, letter * 0.9);
  }
  ink.line(cx - 6 * k, y + 9 * k, cx, y + 1.5 * k, cx + 6 * k, y + 9 * k);
  box({ ink }, cx - 21 * k, y - 29 * k, cx + 21 * k, y - 11 * k);
  ink.text(zeros(Math.round(now) % 360, 3), cx, y - 20 * k, letter);

  const drift = degrees(halfTurn(chi - psi));
  if (Math.abs(drift) < HEADING_SPAN) {
    const x = cx + drift * perDegree;
    ink.line(x, y + 2 * k, x - 4 * k, y + 7 * k, x, y + 12 * k, x + 4 * k, y + 7 * k, x, y + 2 * k);
  }
}

function box({ ink }, left, top, right, bottom) {
  ink.backing.rect(left, top, right - left, bottom - top);
  ink.line(left, top, right, top, right, bottom, left, bottom, left, top);
}

/** Bank scale below, a pointer to the ground moving along it; the bar under it goes where a ball would roll. */
export function bank({ ink, cx, cy, k, R }, { phi, n_y }) {
  const at = (angle, radius) => [cx + radius * Math.sin(angle), cy + radius * Math.cos(angle)];
  for (const mark of BANK_MARKS) ink.line(...at(mark * DEG, R), ...at(mark * DEG, R + (mark % 30 === 0 ? 12 : 7) * k));
  const turn = clamp(halfTurn(phi), -62 * DEG, 62 * DEG);
  const half = (5 * k) / R;
  ink.line(
    ...at(turn, R - 2 * k),
    ...at(turn - half, R - 11 * k),
    ...at(turn + half, R - 11 * k),
    ...at(turn, R - 2 * k),
  );
  const slip = turn + (clamp(-n_y / FULL_SLIP, -1, 1) * 16 * k) / R;
  ink.line(...at(slip - half * 1.2, R - 15 * k), ...at(slip + half * 1.2, R - 15 * k));
}

/** Speed and altitude as moving scales, climb rate as a bar beside the altitude, and the numbers under both. */
export function scales(glass, state, mostG) {
  const { ink, cx, cy, k, R, letter } = glass;
  const half = R * 0.62;
  const [left, right] = [cx - R * 1.44, cx + R * 1.44];
  const speed = knots(state.cas);
  const altitude = feet(state.h);

  scale(glass, left, -1, speed, half, SPEED_SCALE);
  scale(glass, right, 1, altitude, half, ALTITUDE_SCALE);
  readingBox(glass, left, -1, speedText(state), 4.6);
  readingBox(glass, right, 1, altitudeText(state), 6);
  ink.text("KCAS", left - 12 * k, cy - half - 14 * k, letter * 0.8, 1);
  ink.text("ALT FT", right + 12 * k, cy - half - 14 * k, letter * 0.8, -1);

  const climb = clamp(feetPerMinute(state.h_dot) / CLIMB_SPAN, -1, 1) * half;
  const bar = right - 9 * k;
  ink.line(bar, cy, bar, cy - climb);
  ink.line(bar - 7 * k, cy - climb - 5 * k, bar, cy - climb, bar - 7 * k, cy - climb + 5 * k);
  for (const mark of [-1, -0.5, 0.5, 1]) ink.line(bar - 3 * k, cy - mark * half, bar + 2 * k, cy - mark * half);

  const small = letter * 0.88;
  const row = (i) => cy + half + (15 + 17 * i) * k;
  ink.text(`M ${state.mach.toFixed(2)}`, left - 62 * k, row(0), small, -1);
  ink.text(`G ${fixed(state.n_z, 1)}`, left - 62 * k, row(1), small, -1);
  ink.text(mostG.toFixed(1), left + 22 * k, row(1), small, 1);
  ink.text(`α ${fixed(degrees(state.alpha), 1)}`, left - 62 * k, row(2), small, -1);
  ink.text(climbText(state), right + 12 * k, row(0), small, -1);
  ink.text(`R ${Math.max(0, Math.round(altitude))}`, right + 12 * k, row(1), small, -1);
}

/** The decluttered display keeps the numbers and leaves out the scales. */
export function readouts(glass, state) {
  const { ink, cx, cy, k, R, letter } = glass;
  const [left, right] = [cx - R * 1.2, cx + R * 1.2];
  ink.text(speedText(state), left, cy, letter * 1.15, 1);
  ink.text(altitudeText(state), right, cy, letter * 1.15, -1);
  ink.text(`G ${fixed(state.n_z, 1)}`, left, cy + 20 * k, letter * 0.88, 1);
  ink.text(climbText(state), right, cy + 20 * k, letter * 0.88, -1);
}

const speedText = ({ cas }) => String(Math.max(0, Math.round(knots(cas))));
const altitudeText = ({ h }) => String(Math.round(feet(h) / 10) * 10);
const climbText = ({ h_dot }) => {
  const climb = Math.round(feetPerMinute(h_dot) / 10) * 10; // the sign of what is shown: no "-0"
  return `${climb < 0 ? "-" : climb > 0 ? "+" : ""}${Math.abs(climb)}`;
};

/** A vertical moving scale at `x`, `half` its height; `side` -1 has its ticks on the left. */
function scale({ ink, cy, k, letter }, x, side, value, half, { span, minor, major, label }) {
  const perUnit = half / span;
  for (let v = Math.max(0, Math.ceil((value - span) / minor) * minor); v <= value + span; v += minor) {
    const y = cy - (v - value) * perUnit;
    const isMajor = v % major === 0;
    ink.line(x, y, x + side * (isMajor ? 11 : 6) * k, y);
    if (isMajor && Math.abs(y - cy) > 22 * k) ink.text(label(v), x + side * 17 * k, y, letter * 0.9, -side);
  }
  ink.line(x, cy - half, x, cy + half);
}

/** The boxed number in the middle of a scale, pointing at it; `letters` wide. */
function readingBox({ ink, cy, k, letter }, x, side, text, letters) {
  const far = 10 + letters * 9;
  const outline = [2.5, 0, 10, -5, 10, -11.5, far, -11.5, far, 11.5, 10, 11.5, 10, 5, 2.5, 0];
  ink.backing.rect(side < 0 ? x - far * k : x + 10 * k, cy - 11.5 * k, (far - 10) * k, 23 * k);
  ink.shape(x, cy, [side * k, k], outline);
  ink.text(text, x + (side * k * (10 + far)) / 2, cy, letter * 1.12);
}
