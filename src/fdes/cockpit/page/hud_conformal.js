/**
 * The symbols of the head-up display that lie on the world: horizon, climb-dive ladder, flight-path marker, waterline.
 *
 * `glass` is the world's camera together with ink, scale `k`, radius `R` of the display, height `letter` of its text.
 */

import { DEG, clamp, halfTurn } from "./units.js";

const RUNG_STEP = 5; // deg

/** y [px] of the horizon line in the middle column, and its tilt [rad], right end down positive. */
export function horizonOf({ cx, cy, f, phi, theta }) {
  const down = f * Math.tan(theta); // from the waterline, at right angles to the horizon
  const [x, y] = [cx + down * Math.sin(phi), cy + down * Math.cos(phi)];
  return { y: y + (x - cx) * Math.tan(phi), tilt: halfTurn(-phi) };
}

/** Where the aircraft is going: at (beta, alpha) from the waterline. Crossed out when held at the rim. */
export function flightPathMarker({ ink, cx, cy, f, k, R }, { alpha, beta }) {
  let x = (f * Math.tan(beta)) / Math.cos(alpha);
  let y = f * Math.tan(alpha);
  const far = Math.hypot(x, y);
  const rim = R * 0.82;
  const caged = far > rim;
  if (caged) [x, y] = [(x * rim) / far, (y * rim) / far];
  const [px, py, r] = [cx + x, cy + y, 7.5 * k];
  ink.circle(px, py, r);
  ink.line(px - r, py, px - 2.9 * r, py);
  ink.line(px + r, py, px + 2.9 * r, py);
  ink.line(px, py - r, px, py - 2.1 * r);
  if (caged) {
    ink.line(px - r, py - r, px + r, py + r);
    ink.line(px + r, py - r, px - r, py + r);
  }
  return { x, y };
}

/** A point at elevation `angle` [deg], `along` the horizon and `below` that line [px], on the turned glass. */
function onLadder({ cx, cy, f, phi, theta }, angle, along, below = 0) {
  const down = below - f * Math.tan(angle * DEG - theta);
  const [cos, sin] = [Math.cos(phi), Math.sin(phi)];
  return [cx + along * cos + down * sin, cy - along * sin + down * cos];
}

/** Rungs every 5 degrees, and the horizon. The ladder stands over the flight-path marker, across the horizon. */
export function ladder(glass, marker) {
  const { ink, cx, cy, k, R, phi, theta, letter } = glass;
  const shift = clamp(marker.x * Math.cos(phi) - marker.y * Math.sin(phi), -0.3 * R, 0.3 * R);
  const gap = 34 * k;
  const length = 60 * k;
  // Rungs that would reach beyond are left out: the bank scale lies below on a circle, the heading above on a line.
  const fits = ([x, y]) => (y > cy ? Math.hypot(x - cx, y - cy) < R * 0.84 : cy - y < R * 0.72 && Math.abs(x - cx) < R);

  const end = Math.min(R * 1.3, glass.width * 0.37);
  for (const side of [-1, 1]) {
    ink.line(...onLadder(glass, 0, shift + side * gap * 0.9), ...onLadder(glass, 0, side * end));
  }

  for (let angle = -90 + RUNG_STEP; angle < 90; angle += RUNG_STEP) {
    if (angle === 0 || Math.abs(angle * DEG - theta) > 0.42) continue;
    const tick = Math.sign(angle) * 9 * k; // points to the horizon
    const cant = angle < 0 ? Math.tan(Math.min(30, -angle / 2) * DEG) : 0; // dive bars lean, by half their angle
    const rung = [-1, 1].map((side) => {
      const at = (along, below) => onLadder(glass, angle, shift + side * along, below);
      const label = at(gap + length + 14 * k, -cant * length + tick / 2);
      return {
        from: at(gap, 0),
        to: at(gap + length, -cant * length),
        tip: at(gap + length, -cant * length + tick),
        label,
      };
    });
    if (!rung.every(({ label, from }) => fits(label) && fits(from))) continue;
    for (const { from, to, tip, label } of rung) {
      if (angle > 0) ink.line(...from, ...to);
      else ink.dashed(...from, ...to);
      ink.line(...to, ...tip);
      ink.text(String(Math.abs(angle)), ...label, letter * 0.92, 0, -phi);
    }
  }
  for (const pole of [90, -90]) if (Math.abs(pole * DEG - theta) < 0.45) poleMark(glass, pole, shift);
}

/** Straight up: a star. Straight down: a circle filled with bars. */
function poleMark(glass, pole, shift) {
  const { ink, k } = glass;
  const [x, y] = onLadder(glass, pole, shift);
  const r = 13 * k;
  ink.circle(x, y, r);
  for (let i = 0; i < 8; i++) {
    const [c, s] = [Math.cos((i * Math.PI) / 4), Math.sin((i * Math.PI) / 4)];
    if (pole > 0) ink.line(x + c * r, y + s * r, x + c * r * 1.7, y + s * r * 1.7);
    else if (i < 5) ink.line(x - r * 0.8, y + (i - 2) * 0.36 * r, x + r * 0.8, y + (i - 2) * 0.36 * r);
  }
}

/** With the horizon out of sight, a dashed line at the rim says where it is. */
export function ghostHorizon({ ink, cx, cy, f, k, R, phi, theta }) {
  const down = f * Math.tan(theta);
  const rim = R * 0.84;
  if (Math.abs(down) < rim) return;
  const [cos, sin, at] = [Math.cos(phi), Math.sin(phi), Math.sign(down) * rim];
  const point = (along) => [cx + along * cos + at * sin, cy - along * sin + at * cos];
  for (const side of [-1, 1]) ink.dashed(...point(side * 18 * k), ...point(side * 85 * k));
}

/** Where the nose points: the body x axis. */
export function waterline({ ink, cx, cy, k }) {
  ink.shape(cx, cy, k, [-24, 0, -9, 0, -4.5, 8, 0, 0, 4.5, 8, 9, 0, 24, 0]);
}
