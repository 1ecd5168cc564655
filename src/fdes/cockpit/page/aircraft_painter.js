/**
 * Paints an aircraft seen from outside, its surfaces moving, onto a 2-D canvas over whichever world is drawn. Far facets
 * first (back_to_front.js); a frame allocates nothing.
 */

import { CONTROLS, aircraftShape, normalOf } from "./aircraft_shape.js";
import { partition, walk } from "./back_to_front.js";
import { DEG, clamp } from "./units.js";

export const DRAWN_TIMES = 2; // surfaces are drawn deflected so many times as far: a few degrees would not be seen
const FURTHEST = 60 * DEG; // drawn deflection
const NEAR = 1; // m ahead of the eye
const SMALL = 26; // px of span below which a bracket shows where the aircraft is
const SHADES = 24;
const PAINTS = {
  body: [222, 228, 234],
  wing: [198, 207, 216],
  metal: [150, 160, 170],
  glass: [52, 84, 112],
  control: [255, 122, 26],
};
const GHOST = { body: [120, 220, 255], wing: [100, 200, 245], metal: [90, 170, 215], glass: [50, 110, 150], control: [255, 190, 120] };
const SUN = [-0.35, 0.45, -0.82]; // towards it, north-east-down: high, so that upper sides are light

export class AircraftPainter {
  constructor(context) {
    this.context = context;
    this.key = "";
    this.turn = new Float64Array(9); // body axes to the camera's
    this.shift = new Float64Array(3);
    this.point = new Float64Array(3);
    this.sines = new Float64Array(CONTROLS.length);
    this.cosines = new Float64Array(CONTROLS.length);
    this.screen = new Float64Array(64);
    this.shades = { own: shadesOf(PAINTS), ghost: shadesOf(GHOST) };
    this.paintOne = (facet) => this.facet(facet);
  }

  /** The aircraft to draw: its id and { span, area, chord, mach }. */
  setAircraft(id, size) {
    const key = `${id} ${size.span} ${size.area} ${size.chord}`;
    if (key === this.key) return;
    this.key = key;
    const { facets, span, length, tips } = aircraftShape(id, size);
    Object.assign(this, { span, length, tips });
    for (const one of facets) one.normal = normalOf(one.corners);
    this.tree = partition(facets);
    this.edges = Object.fromEntries(CONTROLS.map((name, i) => [name, facets.find(({ hinge }) => hinge?.control === i)]));
  }

  /** Paints it in `state` (SI) for camera `cam`; `ghost` makes it translucent. */
  draw(state, axes, cam, ghost = false) {
    const { context } = this;
    this.cam = cam;
    this.place(state, axes, cam);
    this.deflect(state);
    if (this.shift[0] < NEAR) return;
    const wide = (this.span * cam.f) / this.shift[0];
    if (wide < SMALL && !ghost) this.bracket();
    this.colors = ghost ? this.shades.ghost : this.shades.own;
    this.sun(axes);
    context.globalAlpha = ghost ? 0.5 : 1;
    context.lineWidth = 0.7; // of the facet's own color: closes the seams between facets
    context.lineJoin = "round";
    const { shift, turn } = this; // the eye, in body axes
    const eye = (i) => -(turn[i] * shift[0] + turn[3 + i] * shift[1] + turn[6 + i] * shift[2]);
    walk(this.tree, eye(0), eye(1), eye(2), this.paintOne);
    context.globalAlpha = 1;
  }

  /** camera = turn body + shift; both rotations have their axes as rows. */
  place(state, axes, cam) {
    const [n, e, d] = [state.north - cam.north, state.east - cam.east, cam.eye - state.h];
    for (let i = 0; i < 3; i++) {
      const [a, b, c] = [cam.axes[3 * i], cam.axes[3 * i + 1], cam.axes[3 * i + 2]];
      this.shift[i] = a * n + b * e + c * d;
      for (let j = 0; j < 3; j++) this.turn[3 * i + j] = a * axes[3 * j] + b * axes[3 * j + 1] + c * axes[3 * j + 2];
    }
  }

  /** Signs: docs/symbols.md. Positive aileron has the right one up, the left one down. */
  deflect({ elevator = 0, aileron = 0, rudder = 0 }) {
    this.angle(0, elevator);
    this.angle(1, -aileron);
    this.angle(2, aileron);
    this.angle(3, rudder);
  }

  angle(control, value) {
    const drawn = clamp(DRAWN_TIMES * value, -FURTHEST, FURTHEST);
    this.sines[control] = Math.sin(drawn);
    this.cosines[control] = Math.cos(drawn);
  }

  sun(axes) {
    for (let i = 0; i < 3; i++) this.point[i] = axes[3 * i] * SUN[0] + axes[3 * i + 1] * SUN[1] + axes[3 * i + 2] * SUN[2];
    [this.sunX, this.sunY, this.sunZ] = this.point;
  }

  facet({ corners, paint, hinge, normal }) {
    const { context, screen } = this;
    let area = 0;
    for (let k = 0; k < corners.length; k++) {
      if (!this.project(corners[k], hinge)) return;
      screen[2 * k] = this.point[0];
      screen[2 * k + 1] = this.point[1];
    }
    const last = corners.length - 1;
    for (let k = 0, before = last; k <= last; before = k++)
      area += screen[2 * before] * screen[2 * k + 1] - screen[2 * k] * screen[2 * before + 1];
    if (area >= 0) return; // seen from behind
    context.beginPath();
    context.moveTo(screen[0], screen[1]);
    for (let k = 1; k <= last; k++) context.lineTo(screen[2 * k], screen[2 * k + 1]);
    context.closePath();
    const light = normal[0] * this.sunX + normal[1] * this.sunY + normal[2] * this.sunZ;
    const shade = this.colors[paint][Math.round(((light + 1) / 2) * (SHADES - 1))];
    context.fillStyle = context.strokeStyle = shade;
    context.fill();
    context.stroke();
  }

  /** A point of the body on the screen, into this.point; turned about its hinge. False when it is behind the eye. */
  project(corner, hinge) {
    let [x, y, z] = corner;
    if (hinge) {
      const [px, py, pz] = hinge.at;
      const [ax, ay, az] = hinge.axis;
      const [s, c] = [this.sines[hinge.control], this.cosines[hinge.control]];
      const [rx, ry, rz] = [x - px, y - py, z - pz];
      const along = (ax * rx + ay * ry + az * rz) * (1 - c);
      x = px + rx * c + (ay * rz - az * ry) * s + ax * along;
      y = py + ry * c + (az * rx - ax * rz) * s + ay * along;
      z = pz + rz * c + (ax * ry - ay * rx) * s + az * along;
    }
    const { turn, shift, cam, point } = this;
    const far = turn[0] * x + turn[1] * y + turn[2] * z + shift[0];
    if (far < NEAR) return false;
    point[0] = cam.cx + (cam.f * (turn[3] * x + turn[4] * y + turn[5] * z + shift[1])) / far;
    point[1] = cam.cy + (cam.f * (turn[6] * x + turn[7] * y + turn[8] * z + shift[2])) / far;
    return true;
  }

  bracket() {
    const { context, shift, cam } = this;
    const [x, y] = [cam.cx + (cam.f * shift[1]) / shift[0], cam.cy + (cam.f * shift[2]) / shift[0]];
    context.strokeStyle = "#ffffff";
    context.lineWidth = 1.5;
    context.strokeRect(x - SMALL, y - SMALL * 0.7, 2 * SMALL, 1.4 * SMALL);
  }

  /** Where wing tips and trailing edges are on the screen [px], as last drawn: for tests. */
  landmarks() {
    const at = (corner, hinge = null) => (this.project(corner, hinge) ? [this.point[0], this.point[1]] : null);
    const [x, y, z] = this.tips;
    const found = { "right tip": at([x, y, z]), "left tip": at([x, -y, z]), middle: at([0, 0, 0]) };
    for (const [name, { corners, hinge }] of Object.entries(this.edges)) {
      const rear = corners.reduce((a, b) => (b[0] < a[0] ? b : a));
      found[name] = at(rear, hinge);
      found[`${name} at rest`] = at(rear);
    }
    return found;
  }
}

/** Each paint in shades from the dark underside to full light. */
function shadesOf(paints) {
  const shade = (color, k) => {
    const light = 0.5 + 0.52 * (k / (SHADES - 1));
    return `rgb(${color.map((value) => Math.min(255, Math.round(value * light))).join()})`;
  };
  return Object.fromEntries(
    Object.entries(paints).map(([name, color]) => [name, Array.from({ length: SHADES }, (_, k) => shade(color, k))]),
  );
}
