/** Chooses how the outside world is drawn: WebGL with a graphics processor, else a 2-D canvas. */

import { CanvasWorld } from "./world_canvas.js";

/** Whether WebGL is drawn by the processor: software looks available, but manages a few pictures a second. */
function isSoftwareRendered() {
  const gl = document.createElement("canvas").getContext("webgl2");
  if (!gl) return true;
  const info = gl.getExtension("WEBGL_debug_renderer_info");
  const renderer = String(gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
  gl.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(renderer);
}

/**
 * A world in the place of `canvas`. `kind` is "webgl", "canvas2d" or "auto". `onLoss()` is called when the graphics
 * processor takes the picture away. WebGL is fetched only where it will be used.
 */
export async function makeWorld(canvas, kind, onLoss) {
  if (kind === "canvas2d") return new CanvasWorld(renewed(canvas));
  const software = isSoftwareRendered();
  if (kind !== "webgl" && software) return new CanvasWorld(renewed(canvas));
  const fresh = renewed(canvas);
  try {
    const { WebglWorld } = await import("./world_webgl.js");
    const world = new WebglWorld(fresh, software);
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
