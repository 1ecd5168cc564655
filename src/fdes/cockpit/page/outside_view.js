/**
 * The aircraft seen from outside: behind it, or from beside the runway; the path it has flown; a ghost flying beside it.
 * Fetched when first asked for. It paints over whichever world is drawn.
 */

import { AircraftPainter, DRAWN_TIMES } from "./aircraft_painter.js";
import { bodyAxes, camera, toBody } from "./camera.js";
import { Path } from "./flown_path.js";
import { RUNWAY } from "./scenery.js";
import { DEG, clamp, compass, degrees, feet, feetPerMinute, fixed, halfTurn, knots, minus } from "./units.js";

const LAG = 0.45; // s: how fast the chase camera takes over a change of direction
const BEHIND = 2.1; // sizes of the aircraft
const ABOVE = 8 * DEG; // of the chase camera over the path behind the aircraft
const GLANCE = 4 * DEG; // by which it looks over the aircraft
const STEEPEST = 60 * DEG;
const LONGEST = 0.1; // s: after a pause the camera goes on, it does not jump
const FAR_OFF = 300; // m from one picture to the next: another flight
const TOWER = { north: RUNWAY.south + RUNWAY.length / 2 + 115, east: -312, h: 56 };
const ZOOM = { wide: 0.7, narrow: 0.006, share: 0.17 }; // rad, rad; of the picture's width that the span fills
const WORDS_EVERY = 150; // ms

export class OutsideView {
  /** `canvas` to paint on, the strip `chart` that keeps the past, and the element for the figures. */
  constructor(canvas, chart, strip) {
    Object.assign(this, { canvas, chart, strip });
    this.context = canvas.getContext("2d");
    this.painter = new AircraftPainter(this.context);
    this.path = new Path(this.context, chart);
    this.eye = { north: NaN, east: NaN, h: 0, phi: 0, theta: 0, psi: 0 };
    this.last = { north: NaN, east: NaN, at: 0 };
    this.saidAt = 0;
    this.course = this.climb = 0;
  }

  setAircraft({ id, size, mach }) {
    this.painter.setAircraft(id, { ...size, mach });
  }

  /** The camera for `view` ("chase" or "tower") at `now` [ms]. */
  camera(view, width, height, state, now) {
    const { last } = this;
    const step = Math.min(LONGEST, (now - last.at) / 1000);
    const jumped = !(Math.hypot(state.north - last.north, state.east - last.east) < FAR_OFF);
    const share = jumped ? 1 : 1 - Math.exp(-step / LAG);
    const steep = clamp(Math.atan2(state.h_dot, state.ground_speed), -STEEPEST, STEEPEST);
    this.course += share * halfTurn(state.chi - this.course);
    this.climb += share * (steep - this.climb);
    [last.north, last.east, last.at] = [state.north, state.east, now];
    return view === "tower" ? this.fromTower(width, height, state) : this.fromBehind(width, height, state);
  }

  fromBehind(width, height, state) {
    const { eye, painter } = this;
    const away = BEHIND * Math.max(painter.span, 0.8 * painter.length);
    const down = this.climb - ABOVE; // direction from the eye to the aircraft
    eye.north = state.north - away * Math.cos(down) * Math.cos(this.course);
    eye.east = state.east - away * Math.cos(down) * Math.sin(this.course);
    eye.h = Math.max(2.5, state.h - away * Math.sin(down));
    eye.psi = this.course;
    eye.theta = Math.atan2(state.h - eye.h, away * Math.cos(down)) + GLANCE;
    return camera(width, height, eye);
  }

  fromTower(width, height, state) {
    const { eye, painter } = this;
    Object.assign(eye, TOWER);
    const [n, e] = [state.north - eye.north, state.east - eye.east];
    const level = Math.hypot(n, e);
    eye.psi = Math.atan2(e, n);
    eye.theta = Math.atan2(state.h - eye.h, level);
    this.distance = Math.hypot(level, state.h - eye.h);
    const wanted = (painter.span / ZOOM.share / Math.max(this.distance, 1)) * (height / width);
    return camera(width, height, eye, clamp(wanted, ZOOM.narrow, ZOOM.wide));
  }

  /** Paints path and aircraft, and `ghost` where there is one, over a clear canvas. */
  draw(view, state, cam, ghost, now, pixelRatio, words) {
    const { context, painter } = this;
    context.setTransform(pixelRatio, 0, 0, pixelRatio, 0, 0);
    context.clearRect(0, 0, cam.width, cam.height);
    const axes = bodyAxes(state);
    this.path.draw(state, axes, cam, painter.span);
    const own = [state, axes, cam];
    if (!ghost) painter.draw(...own);
    else {
      const beyond = far(ghost, cam) > far(state, cam);
      if (beyond) this.drawGhost(ghost, cam, pixelRatio);
      painter.draw(...own);
      if (!beyond) this.drawGhost(ghost, cam, pixelRatio);
      painter.place(state, axes, cam);
      painter.deflect(state);
    }
    if (now - this.saidAt > WORDS_EVERY) this.say(view, state, words, now);
  }

  /** A translucent aircraft; also seen from the cockpit, unless it flies where the eye is. */
  drawGhost(ghost, cam, pixelRatio) {
    const { context, painter } = this;
    context.setTransform(pixelRatio, 0, 0, pixelRatio, 0, 0);
    const place = toBody(cam.axes, ghost.north - cam.north, ghost.east - cam.east, cam.eye - ghost.h);
    if (Math.hypot(...place) > painter.length) painter.draw(ghost, bodyAxes(ghost), cam, true);
  }

  say(view, state, { big, small }, now) {
    this.saidAt = now;
    const climb = Math.round(feetPerMinute(state.h_dot) / 10) * 10;
    const figures = [
      `${Math.max(0, Math.round(knots(state.cas)))} KCAS`,
      `M ${state.mach.toFixed(2)}`,
      `${Math.round(feet(state.h) / 10) * 10} ft`,
      `${climb > 0 ? "+" : ""}${climb} ft/min`,
      `hdg ${String(Math.round(compass(state.psi)) % 360).padStart(3, "0")}°`,
      `θ ${angle(state.theta)}`,
      `φ ${angle(halfTurn(state.phi))}`,
      `α ${angle(state.alpha)}`,
      `β ${angle(state.beta)}`,
      `${state.n_z.toFixed(1)} g`,
    ];
    const seen = view === "tower" ? [`${(this.distance / 1852).toFixed(1)} NM from the tower`] : [];
    const [head, line, foot] = this.strip.children;
    head.textContent = [big, small].filter(Boolean).join(" · ");
    line.textContent = figures.join("  ");
    foot.textContent = [...seen, `surfaces drawn ${DRAWN_TIMES}×`].join(" · ");
  }
}

const far = (state, cam) => Math.hypot(state.north - cam.north, state.east - cam.east, state.h - cam.eye);
const angle = (radians) => `${minus(fixed(degrees(radians), 1))}°`;
