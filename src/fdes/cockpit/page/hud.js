/**
 * Head-up display over the world, in the manner of MIL-STD-1787: climb-dive ladder, flight-path marker, waterline,
 * heading, speed and altitude scales, bank scale with slip.
 *
 * Ladder, horizon and flight-path marker are conformal: they use the world's camera. Everything else is at rest on
 * the glass. Strokes are collected in a few paths and each is drawn twice, a dark halo under a green core, so that
 * the symbols stand out before sky and ground alike.
 */

import { flightPathMarker, ghostHorizon, horizonOf, ladder, waterline } from "./hud_conformal.js";
import { Lettering } from "./hud_font.js";
import { Ink } from "./hud_ink.js";
import { bank, heading, readouts, scales } from "./hud_scales.js";
import { clamp } from "./units.js";

export const HUD_MODES = ["full", "declutter", "off"];

const GREEN = "#4dff94";
const HALO = "rgba(0, 26, 12, 0.5)";
const STROKES = [
  [HALO, 4.2],
  [GREEN, 1.75],
]; // color, and width in units of k
const BACKING = "rgba(2, 14, 9, 0.5)";
const PLAQUE = "rgba(2, 14, 9, 0.78)";

export class Hud {
  constructor(canvas) {
    this.canvas = canvas;
    this.context = canvas.getContext("2d");
    this.lettering = new Lettering();
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
    this.paint(glass.ink, k, pixelRatio);
    const over = new Ink(); // words come last, on a dark ground of their own: the ladder passes behind them
    if (words.small) plaque(over, words.small, glass.cx, glass.cy + glass.R * 0.7, glass.letter);
    if (words.big) plaque(over, words.big, glass.cx, glass.cy - glass.R * 0.45, glass.letter * 2.4);
    if (words.small || words.big) this.paint(over, k, pixelRatio, PLAQUE);
  }

  /** The largest load factor since the flight began; a clock that runs back is a new flight. */
  rememberLoad(g, t) {
    if (t < this.most.t) this.most.g = g;
    else if (g > this.most.g) this.most.g = g;
    this.most.t = t;
  }

  paint(ink, k, ratio, backing = BACKING) {
    const { context } = this;
    context.fillStyle = backing;
    context.fill(ink.backing);
    context.lineCap = context.lineJoin = "round";
    const dash = [7 * k, 5 * k];
    for (const [color, width] of STROKES) {
      context.strokeStyle = color;
      context.lineWidth = width * k;
      context.stroke(ink.lines);
      context.setLineDash(dash);
      context.stroke(ink.dashes);
      context.setLineDash([]);
    }
    const fine = STROKES.map(([color, width]) => [color, width * 0.86 * k]);
    for (const line of ink.texts) this.lettering.write(context, line, fine, ratio);
  }
}

function plaque(ink, words, cx, y, size) {
  const half = words.length * size * 0.47 + size * 0.6;
  ink.backing.rect(cx - half, y - size, 2 * half, 2 * size);
  ink.text(words, cx, y, size);
}
