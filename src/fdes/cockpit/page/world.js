/** Chooses how the outside world is drawn: WebGL with a graphics processor, else a 2-D canvas. */

import { CanvasWorld } from "./world_canvas.js";
import { WebglWorld, isSoftwareRendered } from "./world_webgl.js";

/**
 * A world on `canvas`, or on a copy that takes its place. `kind` is "webgl", "canvas2d" or "auto". `onLoss(canvas)` is
 * called with a fresh canvas when the graphics processor takes the picture away.
 */
export function makeWorld(canvas, kind, onLoss) {
  if (kind === "webgl" || (kind === "auto" && !isSoftwareRendered())) {
    try {
      const world = new WebglWorld(canvas);
      canvas.addEventListener("webglcontextlost", () => onLoss(renewed(canvas)), { once: true });
      return world;
    } catch (error) {
      console.warn(`The world is drawn without WebGL: ${error.message}`);
      return new CanvasWorld(renewed(canvas));
    }
  }
  return new CanvasWorld(canvas);
}

// A canvas that has given out one kind of context never gives another.
function renewed(canvas) {
  const fresh = canvas.cloneNode();
  canvas.replaceWith(fresh);
  return fresh;
}
