/** Chooses how the outside world is drawn: WebGL with a graphics processor, else a 2-D canvas. */

import { CanvasWorld } from "./world_canvas.js";
import { WebglWorld, isSoftwareRendered } from "./world_webgl.js";

/**
 * A world in the place of `canvas`. `kind` is "webgl", "canvas2d" or "auto". `onLoss()` is called when the graphics
 * processor takes the picture away.
 */
export function makeWorld(canvas, kind, onLoss) {
  const fresh = renewed(canvas);
  if (kind !== "webgl" && (kind !== "auto" || isSoftwareRendered())) return new CanvasWorld(fresh);
  try {
    const world = new WebglWorld(fresh);
    fresh.addEventListener("webglcontextlost", onLoss, { once: true });
    return world;
  } catch (error) {
    console.warn(`The world is drawn without WebGL: ${error.message}`);
    return new CanvasWorld(renewed(fresh));
  }
}

// A canvas that has given out one kind of context never gives another.
function renewed(canvas) {
  const fresh = canvas.cloneNode();
  canvas.replaceWith(fresh);
  return fresh;
}
