/**
 * The outside world on a 2-D canvas: for machines, and test browsers, without a graphics processor. Painter's order:
 * sky, sun, clouds above, skyline, land, haze, runway, things that stand on the ground.
 */

import { toBody, worldHorizon } from "./camera.js";
import { Projector } from "./projector.js";
import { drawClouds, drawSky, drawSkyline } from "./canvas_sky.js";
import {
  APRONS,
  BUILDINGS,
  COUNTRY,
  FIELD,
  LAKELAND,
  LOOKS,
  RIVER_WIDTH,
  ROAD_SPACING,
  ROAD_WIDTH,
  RUNWAY,
  RUNWAY_PAINT,
  countryside,
  crop,
  fieldSplit,
  hash,
  lakeIn,
  riverEast,
  shore,
  woodIn,
} from "./scenery.js";
import { css, mix, onHorizon } from "./paint.js";
import { clamp } from "./units.js";

const FIELDS_AHEAD = { low: 13, high: 26 }; // cells of farmland to each side
const FADES = 64; // steps from clear to full
const HAZES = 24; // steps from near to far
const TREES_WITHIN = 9000; // m
const SMALLEST = 0.8; // px: what is lower is not worth a fill
const FACE_LIGHT = { roof: 1.06, south: 0.82, north: 0.62, east: 0.94, west: 0.7 };

export class CanvasWorld {
  static kind = "canvas2d";
  static leastScale = 0.7;

  constructor(canvas) {
    this.canvas = canvas;
    this.context = canvas.getContext("2d", { alpha: false });
    this.look = "day";
    this.horizon = { y: NaN, tilt: NaN };
  }

  /** Draws what camera `cam` (CSS px) sees; the canvas may have fewer or more pixels. */
  draw(cam) {
    const { canvas, context } = this;
    this.horizon = worldHorizon(cam);
    context.setTransform(canvas.width / cam.width, 0, 0, canvas.height / cam.height, 0, 0);
    const scene = { context, cam, look: LOOKS[this.look] ?? LOOKS.day, lens: new Projector(context, cam) };
    drawSky(scene);
    drawClouds(scene, "above");
    drawSkyline(scene);
    drawLand(scene);
    drawFields(scene);
    drawWater(scene);
    drawRoads(scene);
    drawHaze(scene);
    drawAirfield(scene);
    drawStanding(scene);
    drawClouds(scene, "below");
  }
}

/** Bare ground from the horizon down, turned with the bank. */
function drawLand({ context, cam, look }) {
  onHorizon(context, cam, (reach) => {
    const ground = context.createLinearGradient(0, 0, 0, cam.height);
    ground.addColorStop(0, css(look.haze));
    ground.addColorStop(0.05, css(mix(look.haze, look.crops[1], 0.6), mix([1, 1, 1], look.light, 0.6)));
    ground.addColorStop(0.3, css(look.crops[5], look.light));
    ground.addColorStop(1, css(look.crops[3], look.light));
    context.fillStyle = ground;
    context.fillRect(-reach, 0, 2 * reach, 2 * reach);
  });
}

/** Distance dissolves in haze: a band under the horizon over everything flat. */
function drawHaze({ context, cam, look }) {
  onHorizon(context, cam, (reach) => {
    const deep = cam.height * 0.16;
    const haze = context.createLinearGradient(0, 0, 0, deep);
    for (const [at, alpha] of [
      [0, 0.8],
      [0.1, 0.5],
      [0.35, 0.18],
      [1, 0],
    ])
      haze.addColorStop(at, css(look.haze, undefined, alpha));
    context.fillStyle = haze;
    context.fillRect(-reach, 0, 2 * reach, deep);
  });
}

/** Farmland around the aircraft. Higher up one sees further: there are more cells, and larger ones. */
function drawFields(scene) {
  const { cam } = scene;
  const level = Math.max(0, 0.72 * Math.log2(cam.eye / 900));
  const ahead = Math.round(Math.min(FIELDS_AHEAD.high, FIELDS_AHEAD.low + 5 * level));
  const [coarse, fine] = [Math.ceil(level), Math.floor(level)];
  fieldsOfSize(scene, ahead, FIELD * 2 ** coarse, coarse, 0.8);
  if (coarse !== fine) fieldsOfSize(scene, ahead, FIELD * 2 ** fine, fine, 0.8 * (coarse - level));
}

function fieldsOfSize({ cam, look, lens }, ahead, size, salt, strength) {
  const [ci, cj] = [Math.floor(cam.north / size), Math.floor(cam.east / size)];
  for (let i = ci - ahead; i <= ci + ahead; i++) {
    for (let j = cj - ahead; j <= cj + ahead; j++) {
      const fade = 1 - Math.hypot(i - ci, j - cj) / (ahead + 0.5);
      if (fade <= 0.03) continue;
      const [n, e] = [i * size, j * size];
      if (lens.outside(n + size / 2, e + size / 2, 0.75 * size)) continue;
      const split = fieldSplit(hash(i, j, 1 + salt * 7));
      const alpha = strength * Math.min(1, 2 * fade);
      const color = (half) => cropColor(look, crop(i, j, half, look.crops.length), alpha);
      const middle = 0.3 + 0.4 * hash(i, j, 5);
      if (split === "whole") lens.rectangle(n, n + size, e, e + size, color(0));
      else if (split === "north") {
        lens.rectangle(n, n + size * middle, e, e + size, color(0));
        lens.rectangle(n + size * middle, n + size, e, e + size, color(1));
      } else {
        lens.rectangle(n, n + size, e, e + size * middle, color(0));
        lens.rectangle(n, n + size, e + size * middle, e + size, color(1));
      }
    }
  }
}

const cropColors = new Map();

/** The color of a crop, remembered: to make its text anew for every field costs as much as to draw it. */
function cropColor(look, number, alpha) {
  if (!cropColors.has(look)) cropColors.set(look, look.crops.map(() => []));
  const step = Math.round(alpha * FADES);
  return (cropColors.get(look)[number][step] ??= css(look.crops[number], look.light, step / FADES));
}

/** Lakes, the river, and the dark ground of woods. */
function drawWater({ cam, look, lens }) {
  const water = css(mix(look.water, look.horizon, 0.25), mix([1, 1, 1], look.light, 0.5));
  lens.ofOne(water, () => {
    const [li, lj] = [Math.floor(cam.north / LAKELAND), Math.floor(cam.east / LAKELAND)];
    for (let i = li - 3; i <= li + 3; i++) {
      for (let j = lj - 3; j <= lj + 3; j++) {
        const lake = lakeIn(i, j);
        if (lake) lens.polygon(ring(lake.north, lake.east, 26, (angle) => shore(lake, angle)));
      }
    }
    const bends = Array.from({ length: 41 }, (_, k) => (Math.floor(cam.north / 800) + k - 14) * 800);
    const bank = (side) => bends.map((north) => [north, riverEast(north) + (side * RIVER_WIDTH) / 2]);
    lens.band(bank(-1), bank(1));
  });

  const [wi, wj] = [Math.floor(cam.north / COUNTRY), Math.floor(cam.east / COUNTRY)];
  const reach = clamp(Math.ceil(cam.eye / 700), 4, 8);
  lens.ofOne(css(look.wood, look.light, 0.85), () => {
    for (let i = wi - reach; i <= wi + reach; i++) {
      for (let j = wj - reach; j <= wj + reach; j++) {
        const wood = woodIn(i, j);
        if (wood && !lens.outside(wood.north, wood.east, wood.radius))
          lens.polygon(ring(wood.north, wood.east, 14, (angle) => wood.radius * (0.92 + 0.14 * Math.sin(3 * angle + i))));
      }
    }
  });
}

function ring(north, east, corners, radius) {
  return Array.from({ length: corners }, (_, k) => {
    const angle = (2 * Math.PI * k) / corners;
    return [north + radius(angle) * Math.cos(angle), east + radius(angle) * Math.sin(angle)];
  });
}

function drawRoads({ cam, look, lens }) {
  const reach = 5;
  const [i0, j0] = [Math.round(cam.north / ROAD_SPACING), Math.round(cam.east / ROAD_SPACING)];
  const [south, north] = [(i0 - reach) * ROAD_SPACING, (i0 + reach) * ROAD_SPACING];
  const [west, east] = [(j0 - reach) * ROAD_SPACING, (j0 + reach) * ROAD_SPACING];
  const roads = [];
  for (let k = -reach; k <= reach; k++) {
    const e = (j0 + k + 0.5) * ROAD_SPACING;
    const n = (i0 + k + 0.5) * ROAD_SPACING;
    roads.push([south, e, north, e], [n, west, n, east]);
  }
  lens.strips(roads, ROAD_WIDTH, css(look.road, look.light, 0.9));
}

function drawAirfield({ cam, look, lens, context }) {
  const { south, length, width } = RUNWAY;
  if (Math.hypot(cam.north - south - length / 2, cam.east) > 40000) return;
  lens.rectangle(south - 120, south + length + 120, -95, 95, css(look.grass, look.light));
  for (const [n0, n1, e0, e1] of APRONS) lens.rectangle(n0, n1, e0, e1, css(look.apron, look.light));
  lens.rectangle(south, south + length, -width / 2, width / 2, css(look.runway, look.light));
  lens.ofOne(css(look.paint, look.light), () => RUNWAY_PAINT.forEach((mark) => lens.rectangle(...mark)));
  if (look.lamps) {
    for (let n = 0; n <= length; n += 60)
      for (const side of [-1, 1]) lens.lamp(south + n, side * (width / 2 + 2), "#ffe9a8");
    for (let n = 30; n <= 600; n += 30) for (let e = -9; e <= 9; e += 4.5) lens.lamp(south - n, e, "#fff4dd");
    for (let e = -28; e <= 28; e += 4) lens.lamp(south - 3, e, "#7dff9c");
  }
  context.globalAlpha = 1;
}

/** Trees and buildings, far ones first. Trees of one shade are filled together: a fill for each would cost too much. */
function drawStanding({ cam, look, lens }) {
  const reach = Math.ceil(TREES_WITHIN / COUNTRY);
  const [ci, cj] = [Math.floor(cam.north / COUNTRY), Math.floor(cam.east / COUNTRY)];
  const shades = Array.from({ length: 6 }, () => new Path2D());
  const boxes = [];
  for (let i = ci - reach; i <= ci + reach; i++) {
    for (let j = cj - reach; j <= cj + reach; j++) {
      if (lens.outside((i + 0.5) * COUNTRY, (j + 0.5) * COUNTRY, COUNTRY)) continue;
      const cell = countryside(i, j);
      const near = Math.max(Math.abs(i - ci), Math.abs(j - cj)) < 2;
      const every = near ? 1 : 4; // far off every fourth tree is enough
      for (let k = 0; k < cell.trees.length; k += every) addTree(shades, cell.trees[k], cam, lens);
      boxes.push(...cell.boxes);
    }
  }
  shades.forEach((path, k) => {
    const far = k >= 3;
    const color = mix(look.wood, [0.3, 0.4, 0.18], (k % 3) / 3);
    lens.context.fillStyle = css(far ? mix(color, look.haze, 0.25) : color, look.light);
    lens.context.fill(path);
  });
  const distance = (b) => (b.north - cam.north) ** 2 + (b.east - cam.east) ** 2;
  boxes.push(...BUILDINGS);
  boxes
    .map((b) => [distance(b), b])
    .sort((a, b) => b[0] - a[0])
    .forEach(([square, b]) => drawBox(b, Math.sqrt(square), look, cam, lens));
}

/** A round crown on the ground's vertical, into the path of its shade; the three last paths are for far trees. */
function addTree(shades, { north, east, height, shade }, cam, lens) {
  const foot = toBody(cam.axes, north - cam.north, east - cam.east, cam.eye);
  if (foot[0] < 30) return;
  const scale = cam.f / foot[0];
  const tall = height * scale;
  if (tall < SMALLEST) return;
  const [x, y] = [cam.cx + foot[1] * scale, cam.cy + foot[2] * scale];
  const [ux, uy] = [-Math.sin(cam.phi), -Math.cos(cam.phi)]; // up, on the turned screen
  const path = shades[Math.floor(shade * 2.99) + (foot[0] > 4000 ? 3 : 0)];
  const half = tall * (0.3 + 0.16 * shade);
  path.moveTo(x - uy * half, y + ux * half);
  path.quadraticCurveTo(
    x + ux * tall * 1.6 - uy * half * 0.6,
    y + uy * tall * 1.6 + ux * half * 0.6,
    x + uy * half,
    y - ux * half,
  );
}

function drawBox(box, distance, look, cam, lens) {
  const { north, east, deep, wide, height } = box;
  if (distance > 30000 || (height * cam.f) / Math.max(distance, 1) < SMALLEST) return;
  const [n0, n1, e0, e1] = [north - deep / 2, north + deep / 2, east - wide / 2, east + wide / 2];
  const haze = Math.round(clamp(distance / 26000, 0, 0.7) * HAZES);
  const upright = (na, ea, nb, eb, face) => {
    lens.corner(na, ea);
    lens.corner(nb, eb);
    lens.corner(nb, eb, height);
    lens.corner(na, ea, height);
    lens.close(tint(box, face, look, haze));
  };
  if (cam.north < n0) upright(n0, e0, n0, e1, "south");
  else if (cam.north > n1) upright(n1, e0, n1, e1, "north");
  if (cam.east < e0) upright(n0, e0, n1, e0, "west");
  else if (cam.east > e1) upright(n0, e1, n1, e1, "east");
  if (cam.eye <= height) return;
  lens.corner(n0, e0, height);
  lens.corner(n1, e0, height);
  lens.corner(n1, e1, height);
  lens.corner(n0, e1, height);
  lens.close(tint(box, "roof", look, haze));
}

const tints = new WeakMap();

/** The color of a building's face so far off, remembered for as long as look and haze stay. */
function tint(box, face, look, haze) {
  let known = tints.get(box);
  if (known?.look !== look || known.haze !== haze) tints.set(box, (known = { look, haze }));
  const base = face === "roof" ? box.roof : box.wall;
  return (known[face] ??= css(
    mix(
      base.map((c, i) => c * FACE_LIGHT[face] * look.light[i]),
      look.haze,
      haze / HAZES,
    ),
  ));
}
