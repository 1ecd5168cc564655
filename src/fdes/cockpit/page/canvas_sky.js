/** The sky of the 2-D world: air, sun, clouds and the skyline. */

import { toBody } from "./camera.js";
import { CLOUD_BASE, CLOUD_CELL, cloudIn, hash, skyline } from "./scenery.js";
import { DEG, clamp } from "./units.js";
import { css, mix, onHorizon } from "./paint.js";

const CLOUDS_WITHIN = 34000; // m
const SKYLINE_STEP = 1.5; // deg
const SPRITE = { width: 320, height: 160 };

export function drawSky({ context, cam, look }) {
  onHorizon(context, cam, (reach) => {
    const sky = context.createLinearGradient(0, -cam.height * 1.1, 0, 0);
    sky.addColorStop(0, css(look.zenith));
    sky.addColorStop(0.55, css(look.sky));
    sky.addColorStop(0.86, css(mix(look.sky, look.horizon, 0.7)));
    sky.addColorStop(1, css(look.horizon));
    context.fillStyle = sky;
    context.fillRect(-reach, -2 * reach, 2 * reach, 2 * reach + 1);
  });
  drawSun({ context, cam, look });
}

function drawSun({ context, cam, look }) {
  const [x, y, z] = toBody(cam.axes, ...look.sun);
  if (x < 0.2) return;
  const [sx, sy] = [cam.cx + (cam.f * y) / x, cam.cy + (cam.f * z) / x];
  const glow = cam.height * (look.lamps ? 0.75 : 0.5);
  const light = context.createRadialGradient(sx, sy, 0, sx, sy, glow);
  for (const [at, alpha, white] of [
    [0, 1, 0.95],
    [0.045, 1, 0.8],
    [0.062, 0.7, 0.3],
    [0.12, 0.42, 0],
    [0.35, 0.16, 0],
    [1, 0, 0],
  ])
    light.addColorStop(at, css(mix(look.sunColor, [1, 1, 1], white), undefined, alpha));
  context.fillStyle = light;
  context.fillRect(sx - glow, sy - glow, 2 * glow, 2 * glow);
}

/** Two ranges at the edge of the world: infinitely far, so they only turn. */
export function drawSkyline({ context, cam, look }) {
  const middle = Math.round(cam.psi / DEG / SKYLINE_STEP);
  const half = Math.ceil(60 / SKYLINE_STEP);
  look.ranges.forEach((color, layer) => {
    const [top, bottom] = [[], []];
    for (let k = middle - half; k <= middle + half; k++) {
      const direction = k * SKYLINE_STEP * DEG;
      top.push(project(cam, direction, skyline(direction, layer)));
      bottom.unshift(project(cam, direction, -0.002)); // a little below, so that no seam shows
    }
    const outline = [...top, ...bottom].filter(Boolean);
    if (outline.length < 3) return;
    context.beginPath();
    outline.forEach((point, i) => context[i ? "lineTo" : "moveTo"](...point));
    context.fillStyle = css(color);
    context.fill();
  });
}

function project(cam, direction, elevation) {
  const level = Math.cos(elevation);
  const [x, y, z] = toBody(cam.axes, level * Math.cos(direction), level * Math.sin(direction), -Math.sin(elevation));
  return x > 0.08 ? [cam.cx + (cam.f * y) / x, cam.cy + (cam.f * z) / x] : null;
}

const sprites = new Map();

/** Clouds "above" the eye lie behind the land, those "below" in front of it. */
export function drawClouds({ context, cam, look }, where) {
  if (cam.eye < CLOUD_BASE !== (where === "above")) return;
  const reach = Math.ceil(CLOUDS_WITHIN / CLOUD_CELL);
  const [ci, cj] = [Math.floor(cam.north / CLOUD_CELL), Math.floor(cam.east / CLOUD_CELL)];
  const seen = [];
  for (let i = ci - reach; i <= ci + reach; i++) {
    for (let j = cj - reach; j <= cj + reach; j++) {
      const cloud = cloudIn(i, j);
      if (!cloud) continue;
      const body = toBody(cam.axes, cloud.north - cam.north, cloud.east - cam.east, cam.eye - cloud.height);
      if (body[0] > 1200 && Math.abs(body[1]) < body[0] * 1.4) seen.push({ cloud, body });
    }
  }
  seen.sort((a, b) => b.body[0] - a.body[0]);
  for (const { cloud, body } of seen) {
    const scale = cam.f / body[0];
    const wide = 2.6 * cloud.radius * scale;
    context.save();
    context.translate(cam.cx + body[1] * scale, cam.cy + body[2] * scale);
    context.rotate(-cam.phi);
    context.globalAlpha = clamp(1.15 - body[0] / CLOUDS_WITHIN, 0, 0.92) * clamp((body[0] - 1200) / 1500, 0, 1);
    context.drawImage(sprite(cloud.kind, look), -wide / 2, -wide / 4, wide, wide / 2);
    context.restore();
  }
}

/** A heap of soft balls, lit from above, drawn once for each kind and look. */
function sprite(kind, look) {
  const key = `${kind} ${look.lamps}`;
  if (sprites.has(key)) return sprites.get(key);
  const canvas = document.createElement("canvas");
  Object.assign(canvas, SPRITE);
  const context = canvas.getContext("2d");
  for (let n = 0; n < 46; n++) {
    const across = hash(kind, n, 61) * 2 - 1;
    const up = hash(kind, n, 62) * (1 - across * across);
    const radius = 16 + 30 * hash(kind, n, 63) * (1 - 0.6 * Math.abs(across));
    const [x, y] = [SPRITE.width * (0.5 + 0.36 * across), SPRITE.height * (0.7 - 0.42 * up)];
    const color = mix(look.cloudShade, look.cloud, clamp(0.25 + up * 1.2, 0, 1));
    const ball = context.createRadialGradient(x, y, 0, x, y, radius);
    ball.addColorStop(0, css(color, undefined, 0.62));
    ball.addColorStop(1, css(color, undefined, 0));
    context.fillStyle = ball;
    context.fillRect(x - radius, y - radius, 2 * radius, 2 * radius);
  }
  sprites.set(key, canvas);
  return canvas;
}
