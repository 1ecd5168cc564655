/**
 * The outside world in plain WebGL 2: a ray for each pixel paints sky and land, then trees and buildings as solids.
 */

import { worldHorizon } from "./camera.js";
import { APRONS, BUILDINGS, COUNTRY, LOOKS, RUNWAY_PAINT, countryside, hash, skyline } from "./scenery.js";
import { LAND_FRAGMENT, SCREEN_VERTEX, SOLID_FRAGMENT, SOLID_VERTEX } from "./world_shaders.js";

const SKYLINE_SAMPLES = 2048;
const HIGHEST_HILL = 0.04; // rad: the texture's 255
const CELLS_AROUND = 4;
const NOISE = 256; // texels along each side

export class WebglWorld {
  static kind = "webgl";
  static leastScale = 0.35;

  /** Throws where there is no WebGL 2. A `frugal` one has rough edges and few trees: so it moves without a GPU. */
  constructor(canvas, frugal) {
    const gl = canvas.getContext("webgl2", { antialias: !frugal, alpha: false, powerPreference: "high-performance" });
    if (!gl) throw new Error("This browser has no WebGL 2.");
    Object.assign(this, { canvas, gl, frugal, look: "day", horizon: { y: NaN, tilt: NaN }, cell: null });
    this.land = program(gl, SCREEN_VERTEX, LAND_FRAGMENT);
    this.solid = program(gl, SOLID_VERTEX, SOLID_FRAGMENT);
    this.screen = gl.createVertexArray();
    this.boxes = new Solids(gl, boxCorners());
    this.trees = new Solids(gl, treeCorners());
    this.textures = { uSkyline: skylineTexture(gl), uNoise: noiseTexture(gl) };
    gl.useProgram(this.land.program);
    gl.uniform4fv(this.land.at["uMarks[0]"], RUNWAY_PAINT.flat());
    gl.uniform4fv(this.land.at["uAprons[0]"], APRONS.flat());
    Object.entries(this.textures).forEach(([name, texture], unit) => {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, texture);
      gl.uniform1i(this.land.at[name], unit);
    });
    gl.enable(gl.DEPTH_TEST);
  }

  /** Draws what camera `cam` (CSS px) sees; the canvas may have fewer or more pixels. */
  draw(cam) {
    const { gl, canvas } = this;
    this.horizon = worldHorizon(cam);
    this.gather(cam);
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.clear(gl.DEPTH_BUFFER_BIT);

    gl.useProgram(this.land.program);
    this.setEye(this.land.at, cam);
    gl.bindVertexArray(this.screen);
    gl.depthMask(false); // the land is flat and lies under everything that stands on it
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    gl.depthMask(true);

    gl.useProgram(this.solid.program);
    this.setEye(this.solid.at, cam);
    for (const [solids, round] of [
      [this.boxes, 0],
      [this.trees, 1],
    ]) {
      gl.uniform1f(this.solid.at.uRound, round);
      solids.draw();
    }
  }

  setEye(at, cam) {
    const { gl, canvas } = this;
    const look = LOOKS[this.look] ?? LOOKS.day;
    const sun = Math.hypot(...look.sun);
    gl.uniformMatrix3fv(at.uAxes, false, cam.axes);
    gl.uniform2f(at.uPlace, cam.north, cam.east);
    gl.uniform2f(at.uSize, cam.width, cam.height);
    gl.uniform2f(at.uCenter, cam.cx, cam.cy);
    gl.uniform1f(at.uF, cam.f);
    gl.uniform1f(at.uEye, cam.eye);
    gl.uniform3fv(at.uHaze, look.haze);
    gl.uniform3fv(at.uLight, look.light);
    gl.uniform3fv(
      at.uSun,
      look.sun.map((value) => value / sun),
    );
    if (!at.uZenith) return;
    gl.uniform2f(at.uPixel, cam.width / canvas.width, cam.height / canvas.height);
    gl.uniform1f(at.uLamps, look.lamps);
    gl.uniform3fv(at["uCrops[0]"], look.crops.flat());
    const named = {
      uSunColor: look.sunColor,
      uZenith: look.zenith,
      uSky: look.sky,
      uHorizon: look.horizon,
      uCloud: look.cloud,
      uCloudShade: look.cloudShade,
    };
    const ground = {
      uRange0: look.ranges[0],
      uRange1: look.ranges[1],
      uWood: look.wood,
      uWater: look.water,
      uRoad: look.road,
      uApron: look.apron,
      uRunway: look.runway,
      uPaint: look.paint,
      uGrass: look.grass,
    };
    for (const [name, color] of Object.entries({ ...named, ...ground })) gl.uniform3fv(at[name] ?? null, color);
  }

  /** Collects what stands around the aircraft, anew when it enters another cell. */
  gather(cam) {
    const [ci, cj] = [Math.floor(cam.north / COUNTRY), Math.floor(cam.east / COUNTRY)];
    const cell = `${ci},${cj}`;
    if (cell === this.cell) return;
    this.cell = cell;
    const [boxes, trees] = [[...BUILDINGS], []];
    for (let i = ci - CELLS_AROUND; i <= ci + CELLS_AROUND; i++) {
      for (let j = cj - CELLS_AROUND; j <= cj + CELLS_AROUND; j++) {
        const found = countryside(i, j);
        boxes.push(...found.boxes);
        const near = Math.max(Math.abs(i - ci), Math.abs(j - cj)) < 2;
        const thin = (near ? 1 : 3) * (this.frugal ? 4 : 1); // far off every third tree is enough
        trees.push(...found.trees.filter((_, k) => k % thin === 0));
      }
    }
    this.boxes.fill(boxes.map((b) => [b.north, b.east, b.deep, b.wide, b.height, 0, ...b.wall, ...b.roof]));
    this.trees.fill(
      trees.map((tree) => {
        const wide = tree.height * (0.6 + 0.32 * tree.shade);
        const leaf = [0.15 + 0.12 * tree.shade, 0.27 + 0.1 * tree.shade, 0.13 + 0.04 * tree.shade];
        return [tree.north, tree.east, wide, wide, tree.height, 1, ...leaf, ...leaf];
      }),
    );
  }
}

const FLOATS = 12; // of one instance: footing 4, shape 2, wall 3, roof 3

/** Many copies of one shape. */
class Solids {
  constructor(gl, corners) {
    Object.assign(this, {
      gl,
      corners: corners.length / 6,
      count: 0,
      array: gl.createVertexArray(),
      instances: gl.createBuffer(),
    });
    gl.bindVertexArray(this.array);
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(corners), gl.STATIC_DRAW);
    for (const [location, offset] of [
      [0, 0],
      [1, 3],
    ]) {
      gl.enableVertexAttribArray(location);
      gl.vertexAttribPointer(location, 3, gl.FLOAT, false, 24, offset * 4);
    }
    gl.bindBuffer(gl.ARRAY_BUFFER, this.instances);
    for (const [location, size, offset] of [
      [2, 4, 0],
      [3, 2, 4],
      [4, 3, 6],
      [5, 3, 9],
    ]) {
      gl.enableVertexAttribArray(location);
      gl.vertexAttribPointer(location, size, gl.FLOAT, false, FLOATS * 4, offset * 4);
      gl.vertexAttribDivisor(location, 1);
    }
  }

  fill(instances) {
    const { gl } = this;
    this.count = instances.length;
    gl.bindBuffer(gl.ARRAY_BUFFER, this.instances);
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(instances.flat()), gl.DYNAMIC_DRAW);
  }

  draw() {
    this.gl.bindVertexArray(this.array);
    this.gl.drawArraysInstanced(this.gl.TRIANGLES, 0, this.corners, this.count);
  }
}

const triangle = (a, b, c, normal) => [a, b, c].flatMap((corner) => [...corner, ...normal]);
const face = (a, b, c, d, normal) => [...triangle(a, b, c, normal), ...triangle(a, c, d, normal)];

/** A unit box without its floor; corners 0..1 north, east, up; normals north-east-down. */
function boxCorners() {
  return [
    ...face([0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1], [0, 0, -1]),
    ...face([0, 0, 0], [1, 0, 0], [1, 0, 1], [0, 0, 1], [0, -1, 0]),
    ...face([0, 1, 0], [1, 1, 0], [1, 1, 1], [0, 1, 1], [0, 1, 0]),
    ...face([0, 0, 0], [0, 1, 0], [0, 1, 1], [0, 0, 1], [-1, 0, 0]),
    ...face([1, 0, 0], [1, 1, 0], [1, 1, 1], [1, 0, 1], [1, 0, 0]),
  ];
}

/** A crown of five sides: narrow foot, wide middle, pointed top. */
function treeCorners() {
  const side = (2 * Math.PI) / 5;
  const around = (k, radius, up) => [0.5 + radius * Math.cos(k * side), 0.5 + radius * Math.sin(k * side), up];
  const corners = [];
  for (let k = 0; k < 5; k++) {
    const normal = [Math.cos((k + 0.5) * side), Math.sin((k + 0.5) * side), 0];
    corners.push(
      ...face(around(k, 0.26, 0), around(k + 1, 0.26, 0), around(k + 1, 0.5, 0.38), around(k, 0.5, 0.38), normal),
    );
    corners.push(...triangle(around(k, 0.5, 0.38), around(k + 1, 0.5, 0.38), [0.5, 0.5, 1], normal));
  }
  return corners;
}

/** Elevation of both ranges around the compass, far range in red, near hills in green. */
function skylineTexture(gl) {
  const pixels = new Uint8Array(SKYLINE_SAMPLES * 4);
  for (let i = 0; i < SKYLINE_SAMPLES; i++) {
    const direction = (2 * Math.PI * i) / SKYLINE_SAMPLES;
    for (const layer of [0, 1]) pixels[4 * i + layer] = Math.round((255 * skyline(direction, layer)) / HIGHEST_HILL);
  }
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, SKYLINE_SAMPLES, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.LINEAR);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.REPEAT);
  return texture;
}

/** See noise() and heap() in world_shaders.js. */
function noiseTexture(gl) {
  const random = (x, y, salt, period) => hash(((x % period) + period) % period, ((y % period) + period) % period, salt);
  const smooth = (x, y, salt, period) => {
    const [i, j] = [Math.floor(x), Math.floor(y)];
    const [u, v] = [x - i, y - j].map((f) => f * f * (3 - 2 * f));
    const row = (jj) => random(i, jj, salt, period) * (1 - u) + random(i + 1, jj, salt, period) * u;
    return row(j) * (1 - v) + row(j + 1) * v;
  };
  const octaves = [
    [1, 0.5],
    [2, 0.27],
    [4, 0.15],
    [8, 0.08],
  ];
  const pixels = new Uint8Array(NOISE * NOISE * 4);
  for (let y = 0; y < NOISE; y++) {
    for (let x = 0; x < NOISE; x++) {
      const heaped = octaves.reduce(
        (sum, [times, weight]) =>
          sum + weight * smooth((x * times) / 16, (y * times) / 16, 90 + times, (NOISE / 16) * times),
        0,
      );
      pixels.set([255 * hash(x, y, 90), 255 * heaped], 4 * (y * NOISE + x));
    }
  }
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, NOISE, NOISE, 0, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR);
  gl.generateMipmap(gl.TEXTURE_2D);
  return texture;
}

function program(gl, vertex, fragment) {
  const program = gl.createProgram();
  for (const [type, source] of [
    [gl.VERTEX_SHADER, vertex],
    [gl.FRAGMENT_SHADER, fragment],
  ]) {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS))
      throw new Error(`A shader did not compile: ${gl.getShaderInfoLog(shader)}`);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS))
    throw new Error(`Shaders did not link: ${gl.getProgramInfoLog(program)}`);
  const at = {};
  for (let i = 0; i < gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS); i++) {
    const { name } = gl.getActiveUniform(program, i);
    at[name] = gl.getUniformLocation(program, name);
  }
  return { program, at };
}
