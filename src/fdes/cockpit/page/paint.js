/** Colors and the turned horizon, for the 2-D world's painters. */

import { clamp } from "./units.js";

/** A color [r, g, b] in 0..1 under a `light`, as CSS. */
export function css(color, light = [1, 1, 1], alpha = 1) {
  const channels = color.map((value, i) => Math.round(255 * clamp(value * light[i], 0, 1)));
  return `rgba(${channels.join()},${alpha})`;
}

export const mix = (a, b, share) => a.map((value, i) => value + (b[i] - value) * share);

/** Calls `paint(reach)` with the x axis along the horizon and y down into the ground. */
export function onHorizon(context, cam, paint) {
  context.save();
  context.translate(cam.cx, cam.cy);
  context.rotate(-cam.phi);
  const away = cam.f * Math.tan(clamp(cam.theta, -1.4, 1.4)); // far out of the picture for an eye that zooms
  context.translate(0, away);
  paint(cam.width + cam.height + Math.abs(away));
  context.restore();
}
