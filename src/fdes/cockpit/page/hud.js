/**
 * Head-up display over the world, in the manner of MIL-STD-1787: climb-dive ladder, flight-path marker, waterline,
 * heading, speed and altitude scales, bank scale with slip.
 *
 * Ladder, horizon and flight-path marker are conformal: they use the world's camera. Everything else is at rest on
 * the glass. Strokes are collected in a few paths and each is drawn twice, a dark halo under a green core, so that
 * the symbols stand out before sky and ground alike.
 */

import { strokeText } from "./hud_font.js";
import { DEG, clamp, compass, degrees, feet, feetPerMinute, halfTurn, knots } from "./units.js";

export const HUD_MODES = ["full", "declutter", "off"];

const GREEN = "#4dff94";
const HALO = "rgba(0, 26, 12, 0.5)";
const BACKING = "rgba(2, 14, 9, 0.5)";

const RUNG_STEP = 5; // deg
const BANK_MARKS = [-60, -45, -30, -20, -10, 0, 10, 20, 30, 45, 60]; // deg
const HEADING_SPAN = 20; // deg to either side
const SPEED_SPAN = 90; // kt to either side
const ALTITUDE_SPAN = 900; // ft to either side
const CLIMB_SPAN = 6000; // ft/min to either side
const FULL_SLIP = 0.15; // g of side force that puts the slip bar at its stop

const zeros = (number, digits) => String(number).padStart(digits, "0");

/** The strokes of one picture, by how they are drawn. */
class Ink {
  constructor() {
    this.lines = new Path2D();
    this.letters = new Path2D();
    this.dashes = new Path2D();
    this.backing = new Path2D();
  }

  line(...xy) {
    trace(this.lines, xy);
  }

  dashed(...xy) {
    trace(this.dashes, xy);
  }

  circle(x, y, radius) {
    this.lines.moveTo(x + radius, y);
    this.lines.arc(x, y, radius, 0, 2 * Math.PI);
  }

  text(text, x, y, size, align = 0, angle = 0) {
    strokeText(this.letters, text, x, y, size, align, angle);
  }
}

function trace(path, xy) {
  path.moveTo(xy[0], xy[1]);
  for (let i = 2; i < xy.length; i += 2) path.lineTo(xy[i], xy[i + 1]);
}

export class Hud {
  constructor(canvas) {
    this.canvas = canvas;
    this.context = canvas.getContext("2d");
    this.mode = "full";
    this.horizon = { y: NaN, tilt: NaN };
    this.most = { t: Infinity, g: 1 };
  }

  nextMode() {
    this.mode = HUD_MODES[(HUD_MODES.indexOf(this.mode) + 1) % HUD_MODES.length];
    return this.mode;
  }

  /**
   * Draws `state` (SI) as seen by camera `cam` (CSS px) at time `t` [s]. `words` = { big, small }: a word across the
   * middle such as FREEZE, and a caution under the waterline.
   */
  draw(state, cam, t, words = {}, pixelRatio = 1) {
    const { context } = this;
    context.setTransform(pixelRatio, 0, 0, pixelRatio, 0, 0);
    context.clearRect(0, 0, cam.width, cam.height);
    const k = clamp(cam.height / 620, 0.72, 1.4);
    const glass = { ...cam, k, letter: 9.5 * k, R: Math.min(cam.width * 0.225, cam.height * 0.4), ink: new Ink() };
    this.rememberLoad(state.n_z, t);
    this.horizon = horizonOf(glass);
    if (this.mode !== "off") {
      const marker = flightPathMarker(glass, state);
      ladder(glass, marker);
      ghostHorizon(glass);
      waterline(glass);
      heading(glass, state);
      bank(glass, state);
      if (this.mode === "full") scales(glass, state, this.most.g);
      else readouts(glass, state);
    }
    if (words.small) plaque(glass, words.small, glass.cy + glass.R * 0.7, glass.letter);
    if (words.big) plaque(glass, words.big, glass.cy - glass.R * 0.45, glass.letter * 2.4);
    this.paint(glass);
  }

  /** The largest load factor since the flight began; a clock that runs back is a new flight. */
  rememberLoad(g, t) {
    if (t < this.most.t) this.most.g = g;
    else if (g > this.most.g) this.most.g = g;
    this.most.t = t;
  }

  paint({ ink, k }) {
    const { context } = this;
    context.fillStyle = BACKING;
    context.fill(ink.backing);
    context.lineCap = context.lineJoin = "round";
    const dash = [7 * k, 5 * k];
    for (const [color, width] of [[HALO, 4.2], [GREEN, 1.75]]) {
      context.strokeStyle = color;
      context.lineWidth = width * k;
      context.stroke(ink.lines);
      context.setLineDash(dash);
      context.stroke(ink.dashes);
      context.setLineDash([]);
      context.lineWidth = width * 0.86 * k;
      context.stroke(ink.letters);
    }
  }
}

/** Words on a dark ground of their own: the ladder may pass behind them. */
function plaque({ ink, cx }, words, y, size) {
  const half = words.length * size * 0.47 + size * 0.6;
  ink.backing.rect(cx - half, y - size, 2 * half, 2 * size);
  ink.text(words, cx, y, size);
}

/** y [px] of the horizon line in the middle column, and its tilt [rad], right end down positive. */
function horizonOf({ cx, cy, f, phi, theta }) {
  const down = f * Math.tan(theta); // from the waterline, at right angles to the horizon
  const [x, y] = [cx + down * Math.sin(phi), cy + down * Math.cos(phi)];
  return { y: y + (x - cx) * Math.tan(phi), tilt: halfTurn(-phi) };
}

/** Where the aircraft is going: at (beta, alpha) from the waterline. Crossed out when held at the rim. */
function flightPathMarker({ ink, cx, cy, f, k, R }, { alpha, beta }) {
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
function ladder(glass, marker) {
  const { ink, cx, cy, k, R, phi, theta, letter } = glass;
  const shift = clamp(marker.x * Math.cos(phi) - marker.y * Math.sin(phi), -0.4 * R, 0.4 * R);
  const gap = 34 * k;
  const length = 60 * k;
  const rim = R * 0.84; // rungs that would reach beyond it are left out: the bank scale lies there
  const fits = ([x, y]) => Math.hypot(x - cx, y - cy) < rim;

  for (const side of [-1, 1]) ink.line(...onLadder(glass, 0, shift + side * gap * 0.9), ...onLadder(glass, 0, side * Math.min(R * 1.3, glass.width * 0.37)));

  for (let angle = -90 + RUNG_STEP; angle < 90; angle += RUNG_STEP) {
    if (angle === 0 || Math.abs(angle * DEG - theta) > 0.42) continue;
    const tick = Math.sign(angle) * 9 * k; // points to the horizon
    const cant = angle < 0 ? Math.tan(Math.min(30, -angle / 2) * DEG) : 0; // dive bars lean to the horizon at half their angle
    const rung = [-1, 1].map((side) => {
      const at = (along, below) => onLadder(glass, angle, shift + side * along, below);
      const label = at(gap + length + 14 * k, -cant * length + tick / 2);
      return { from: at(gap, 0), to: at(gap + length, -cant * length), tip: at(gap + length, -cant * length + tick), label };
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
function ghostHorizon({ ink, cx, cy, f, k, R, phi, theta }) {
  const down = f * Math.tan(theta);
  const rim = R * 0.84;
  if (Math.abs(down) < rim) return;
  const [cos, sin, at] = [Math.cos(phi), Math.sin(phi), Math.sign(down) * rim];
  const point = (along) => [cx + along * cos + at * sin, cy - along * sin + at * cos];
  for (const side of [-1, 1]) ink.dashed(...point(side * 18 * k), ...point(side * 85 * k));
}

function waterline({ ink, cx, cy, k }) {
  ink.line(cx - 24 * k, cy, cx - 9 * k, cy, cx - 4.5 * k, cy + 8 * k, cx, cy, cx + 4.5 * k, cy + 8 * k, cx + 9 * k, cy, cx + 24 * k, cy);
}

/** Heading scale at the top; the diamond is the course over the ground. */
function heading({ ink, cx, cy, k, R, letter }, { psi, chi }) {
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
function bank({ ink, cx, cy, k, R }, { phi, n_y }) {
  const at = (angle, radius) => [cx + radius * Math.sin(angle), cy + radius * Math.cos(angle)];
  for (const mark of BANK_MARKS) ink.line(...at(mark * DEG, R), ...at(mark * DEG, R + (mark % 30 === 0 ? 12 : 7) * k));
  const turn = clamp(halfTurn(phi), -62 * DEG, 62 * DEG);
  const half = (5 * k) / R;
  ink.line(...at(turn, R - 2 * k), ...at(turn - half, R - 11 * k), ...at(turn + half, R - 11 * k), ...at(turn, R - 2 * k));
  const slip = turn + (clamp(-n_y / FULL_SLIP, -1, 1) * 16 * k) / R;
  ink.line(...at(slip - half * 1.2, R - 15 * k), ...at(slip + half * 1.2, R - 15 * k));
}

/** Speed and altitude as moving scales, climb rate as a bar beside the altitude, and the numbers under both. */
function scales(glass, state, mostG) {
  const { ink, cx, cy, k, R, letter } = glass;
  const half = R * 0.62;
  const [left, right] = [cx - R * 1.44, cx + R * 1.44];
  const speed = knots(state.cas);
  const altitude = feet(state.h);

  scale(glass, left, -1, { value: speed, span: SPEED_SPAN, minor: 10, major: 50, half, label: (v) => zeros(v, 3) });
  scale(glass, right, 1, { value: altitude, span: ALTITUDE_SPAN, minor: 100, major: 500, half, label: (v) => (v / 1000).toFixed(1) });
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
  ink.text(`G ${state.n_z.toFixed(1)}`, left - 62 * k, row(1), small, -1);
  ink.text(mostG.toFixed(1), left + 16 * k, row(1), small, 1);
  ink.text(`α ${degrees(state.alpha).toFixed(1)}`, left - 62 * k, row(2), small, -1);
  ink.text(climbText(state), right + 12 * k, row(0), small, -1);
  ink.text(`R ${Math.max(0, Math.round(altitude))}`, right + 12 * k, row(1), small, -1);
}

/** The decluttered display keeps the numbers and leaves out the scales. */
function readouts(glass, state) {
  const { ink, cx, cy, k, R, letter } = glass;
  const [left, right] = [cx - R * 1.2, cx + R * 1.2];
  ink.text(speedText(state), left, cy, letter * 1.15, 1);
  ink.text(altitudeText(state), right, cy, letter * 1.15, -1);
  ink.text(`G ${state.n_z.toFixed(1)}`, left, cy + 20 * k, letter * 0.88, 1);
  ink.text(climbText(state), right, cy + 20 * k, letter * 0.88, -1);
}

const speedText = ({ cas }) => String(Math.max(0, Math.round(knots(cas))));
const altitudeText = ({ h }) => String(Math.round(feet(h) / 10) * 10);
const climbText = ({ h_dot }) => `${h_dot < 0 ? "-" : "+"}${Math.abs(Math.round(feetPerMinute(h_dot) / 10) * 10)}`;

/** A vertical moving scale at `x`; `side` -1 has its ticks on the left. */
function scale({ ink, cy, k, letter }, x, side, { value, span, minor, major, half, label }) {
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
  const [near, far] = [x + side * 10 * k, x + side * (10 + letters * 9) * k];
  const [tip, half, notch] = [x + side * 2.5 * k, 11.5 * k, 5 * k];
  ink.backing.rect(Math.min(near, far), cy - half, Math.abs(far - near), 2 * half);
  ink.line(tip, cy, near, cy - notch, near, cy - half, far, cy - half, far, cy + half, near, cy + half, near, cy + notch, tip, cy);
  ink.text(text, (near + far) / 2, cy, letter * 1.12);
}
