/**
 * The animation loop: sample the stick and send it, carry the last state forward to now, draw world, head-up display,
 * instruments and charts. It knows no buttons; app.js connects those.
 */

import { camera } from "./camera.js";
import { Hud } from "./hud.js";
import { FLAG } from "./link.js";
import { FrameClock, carryForward } from "./motion.js";
import { Resolution } from "./resolution.js";
import { EVERYTHING, NOTHING, RightOfWay } from "./right_of_way.js";
import { makeWorld } from "./world.js";

export const VIEWS = ["cockpit", "chase", "tower"];

const KEPT = 3000; // latencies remembered

export class Cockpit {
  /** `parts`: canvases world, hud, instruments, chart; the element figures; and the link, stick, panel, chart, theme. */
  constructor(parts, { worldKind = "auto", look = null } = {}) {
    Object.assign(this, parts);
    this.worldKind = worldKind;
    this.fixedLook = look;
    this.flying = false; // whether the stick is sent: not by an observer, nor before the lever stands where it belongs
    this.clock = new FrameClock();
    this.hud = new Hud(parts.hudCanvas);
    this.world = null;
    this.view = VIEWS[0];
    this.outside = null; // an OutsideView, when one has been asked for
    this.beside = null; // the state of a ghost
    this.drawn = {};
    this.stats = { frames: 0, firstFrameAt: null, latencies: [], world: "", scale: 1 };
    this.lastEcho = 0;
    this.lastAt = 0;
    this.resized = true;
    this.trimWanted = true;
    this.way = new RightOfWay(parts.link);
    this.panelsTurn = false;
    const watch = new ResizeObserver(() => (this.resized = true));
    for (const canvas of [this.hudCanvas, this.instrumentCanvas, this.chartCanvas]) watch.observe(canvas);
    this.link.on("frame", (link) => this.receive(link));
    this.link.on("aircraft", (aircraft) => {
      this.aircraft = aircraft;
      this.outside?.setAircraft(aircraft);
    });
    this.onFrame = () => {};
    this.useWorld(worldKind);
  }

  async useWorld(kind) {
    const world = await makeWorld(this.worldCanvas, kind, () => this.useWorld("canvas2d"));
    this.world = world;
    this.worldCanvas = world.canvas;
    this.stats.world = this.world.constructor.kind;
    this.resolution = new Resolution(this.world.constructor.leastScale);
    this.resized = true;
  }

  /** From where one looks: "cockpit", "chase" (from behind) or "tower" (from beside the runway). */
  async setView(view) {
    this.viewWanted = view;
    if (view !== "cockpit") await this.needOutside();
    if (this.viewWanted !== view) return; // another one was asked for meanwhile
    this.view = view;
    this.figures.hidden = view === "cockpit";
  }

  /** A translucent aircraft flies beside the own one in `state` (north, east, h, phi, theta, psi, surfaces; SI), or none. */
  async ghost(state) {
    if (state) await this.needOutside();
    this.beside = state;
  }

  async needOutside() {
    const { OutsideView } = await import("./outside_view.js");
    if (this.outside) return;
    this.outside = new OutsideView(this.hudCanvas, this.chart, this.figures);
    this.outside.setAircraft(this.aircraft);
  }

  start() {
    const loop = () => {
      requestAnimationFrame(loop); // first, so that an exception below cannot end the loop
      this.frame(performance.now());
    };
    requestAnimationFrame(loop);
  }

  /** The bugs of the instruments stand at the state in which the next flight begins. */
  expectTrim() {
    this.trimWanted = true;
  }

  receive(link) {
    this.clock.receive(link.t, link.receivedAt);
    this.chart.record(link.t, link.values);
    if (link.t < this.lastT) this.trimWanted = true;
    this.lastT = link.t;
    if (this.trimWanted) {
      this.trimWanted = false;
      this.panel.setStart({ ...link.copyTo({}), trimmed: link.t < 0.5 && !link.has(FLAG.replay) });
    }
  }

  frame(now) {
    this.held = this.stick.read(now);
    if (this.flying) this.link.sendStick(this.held, now);
    if (!this.link.frames || !this.world) return;
    if (this.resized) this.resize();
    const share = this.way.next(now);
    if (share === NOTHING) return;
    this.draw(now, share);
    this.count(now);
  }

  draw(now, share) {
    const { link, drawn } = this;
    link.copyTo(drawn);
    const resting = link.has(FLAG.frozen | FLAG.ended | FLAG.replay) || !link.alive;
    if (!resting) carryForward(drawn, this.clock.age(link.t, now));
    drawn.t = link.t;

    const ratio = devicePixelRatio;
    this.world.look = this.fixedLook ?? "day";
    const size = [this.hudCanvas.width / ratio, this.hudCanvas.height / ratio];
    const { outside, view } = this;
    const cam = view === "cockpit" ? camera(...size, drawn) : outside.camera(view, ...size, drawn, now);
    this.world.draw(cam);
    if (view === "cockpit") {
      this.hud.draw(drawn, cam, link.t, this.words(), ratio);
      if (this.beside) outside.drawGhost(this.beside, cam, ratio);
    } else {
      this.hud.rememberLoad(drawn.n_z, link.t);
      outside.draw(view, drawn, cam, this.beside, now, ratio, this.words());
    }
    if (share === EVERYTHING) {
      this.panelsTurn = !this.panelsTurn; // needles and traces look the same at half the rate
      if (this.panelsTurn) this.panel.draw(drawn, ratio);
      else this.chart.draw(this.theme.colors, ratio);
    }
    drawn.hudHorizon = this.hud.horizon;
    drawn.worldHorizon = this.world.horizon;
    this.onFrame(drawn);
  }

  words() {
    const { link } = this;
    const big = !link.alive ? "NO DATA" : link.has(FLAG.replay) ? "REPLAY" : link.has(FLAG.frozen) ? "FREEZE" : "";
    return {
      big: link.has(FLAG.ended) && link.alive ? "" : big,
      small: caution(link),
    };
  }

  count(now) {
    const { stats, link } = this;
    stats.frames += 1;
    stats.firstFrameAt ??= performance.now();
    if (this.flying && link.echo.stamp && link.echo.sequence !== this.lastEcho) {
      this.lastEcho = link.echo.sequence;
      stats.latencies.push(performance.now() - link.echo.stamp);
      if (stats.latencies.length > KEPT) stats.latencies.splice(0, KEPT / 2);
    }
    if (this.lastAt && this.resolution.adapt(now - this.lastAt)) this.resized = true;
    this.lastAt = now;
    stats.scale = this.resolution.scale;
    if (this.worldKind === "auto" && stats.world === "webgl" && this.resolution.exhausted) this.useWorld("canvas2d");
  }

  resize() {
    this.resized = false;
    fit(this.worldCanvas, devicePixelRatio * this.resolution.scale);
    for (const canvas of [this.hudCanvas, this.instrumentCanvas, this.chartCanvas]) fit(canvas, devicePixelRatio);
  }
}

/** What stands under the waterline: where the data of the aircraft end. */
function caution(link) {
  if (link.has(FLAG.beyondLinear)) return "LINEAR MODEL BEYOND 15 DEG - N NONLINEAR";
  return link.has(FLAG.stalled) ? "STALL - LARGEST LIFT ASSUMED" : "";
}

function fit(canvas, ratio) {
  const { width, height } = canvas.getBoundingClientRect();
  const size = [Math.max(2, Math.round(width * ratio)), Math.max(2, Math.round(height * ratio))];
  if (canvas.width !== size[0] || canvas.height !== size[1]) [canvas.width, canvas.height] = size;
}
