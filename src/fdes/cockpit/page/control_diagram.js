/**
 * The block diagram of the flight control system in use, with live values on its arrows: one lane for each surface, from
 * the stick through sum, stop and actuator to the aircraft; below, what is fed back.
 */

import { html, svg } from "./dom.js";
import { FLAG } from "./link.js";
import { Sensed } from "./sensed.js";
import { DEG, clamp, degrees, figure, minus } from "./units.js";

const PERIOD = 90; // ms from one writing of the values to the next
const MARK_STAYS = 700; // ms that a surface at a limit is marked
const NEAR = 0.98; // of the rate limit counts as at it
const WIDTH = 362;
const X = { source: 2, shape: 38, error: 97, gain: 110, sum: 170, stop: 190, actuator: 222, aircraft: 298 };
const FORWARD = 33; // px from the top of a lane to its forward path
const ROW = 28; // px from one path to the next
const SENSOR = { room: 66, width: 52, row: 40 }; // px that sensors add to the width, their own, and from path to path
const MEASURED = ["p", "q", "r", "phi"];
const LANES = [
  { surface: "elevator", stick: "stick_pitch", word: "Stick ↕", symbol: "δe" },
  { surface: "aileron", stick: "stick_roll", word: "Stick ↔", symbol: "δa" },
  { surface: "rudder", stick: "stick_yaw", word: "Pedals", symbol: "δr" },
];
// The loops: what is measured, the blocks on its way (the last its gain), what it brings to the sum [rad], the sign there.
const LOOPS = {
  pitch_rate_damper: { surface: "elevator", signal: "q", sign: "+", brings: ({ gain }, v) => gain * v.q },
  roll_rate_damper: { surface: "aileron", signal: "p", sign: "−", brings: ({ gain }, v) => gain * v.p },
  spiral_stabilization: { surface: "aileron", signal: "r", sign: "−", brings: ({ gain }, v) => gain * v.r },
  yaw_damper: { surface: "rudder", signal: "r", sign: "+", before: ({ washout }) => ["s", `s + ${figure(1 / washout, 2)}`] },
};

const signed = ({ sign, brings }, settings, v) => (sign === "−" ? -1 : 1) * brings(settings, v);

export class ControlDiagram {
  /** `host` holds the drawing; `link` is the wire. */
  constructor(host, link) {
    Object.assign(this, { host, link, aircraft: null, control: null, values: [], written: 0, before: null, marks: new Map(), sensed: null });
    this.state = html("p", { class: "diagram-state number", role: "status" });
    link.on("frame", () => this.update());
  }

  setAircraft(aircraft) {
    this.aircraft = aircraft;
    this.draw();
  }

  show(control) {
    this.control = control;
    this.draw();
  }

  draw() {
    if (!this.aircraft || !this.control) return;
    this.values = [];
    this.marks.clear();
    const { sensors } = this.control.gains;
    this.right = X.aircraft + (sensors ? SENSOR.room : 0);
    if (!sensors) this.sensed = null;
    else if (this.sensed?.lag !== sensors.lag || this.sensed.delay !== sensors.delay) this.sensed = new Sensed(MEASURED, sensors);
    const wide = WIDTH + this.right - X.aircraft;
    const drawing = svg("svg", { class: "diagram", role: "img", "aria-label": "Block diagram of the flight control system in use" });
    let top = 0;
    for (const lane of LANES) top = this.lane(drawing, lane, top);
    drawing.setAttribute("viewBox", `0 0 ${wide} ${top + 2}`);
    drawing.append(
      text(this.right + (wide - this.right) / 2 - 1, 14, "Aircraft", "d-middle"),
    );
    drawing.prepend(svg("rect", { class: "d-block", x: this.right, y: 2, width: wide - this.right - 1, height: top - 4, rx: 5 }));
    this.host.replaceChildren(drawing, this.state);
    this.update();
  }

  /** One surface; returns where the next lane begins. */
  lane(drawing, lane, top) {
    const { gains } = this.control;
    const y = top + FORWARD;
    const full = this.aircraft.full_stick[lane.surface];
    const loops = Object.entries(LOOPS).filter(([name, { surface }]) => surface === lane.surface && gains[name]);
    const commands = lane.surface === "elevator" ? gains.pitch_rate_pi : lane.surface === "aileron" ? gains.roll_angle : null;
    const stick = (v) => v[lane.stick];
    drawing.append(text(X.source, y - 15, lane.word), wire([[X.source, y], [X.shape, y]], true));
    this.value(drawing, X.source, y - 4, (v) => `${Math.round(100 * stick(v))} %`);
    if (commands) this.command(drawing, lane, commands, y);
    else {
      drawing.append(block(X.shape, y, 42, `${figure(degrees(full))}°`), wire([[X.shape + 42, y], [X.sum - 8, y]], true));
      this.value(drawing, X.shape + 48, y - 4, (v) => angle(full * stick(v)));
    }
    this.value(drawing, X.sum - 3, y - 17, (v) => (v[`excitation_${lane.surface}`] ? angle(v[`excitation_${lane.surface}`]) : ""), "d-quiet d-end");
    drawing.append(wire([[X.sum, y - 16], [X.sum, y - 8]], true));
    this.actuation(drawing, lane, y);
    const apart = this.sensed ? SENSOR.row : ROW;
    let row = y + apart;
    const rows = loops.map(([name, loop]) => ({ ...loop, settings: gains[name], name }));
    if (commands?.rate_gain) rows.push({ signal: "p", sign: "−", name: "rate", settings: { gain: commands.rate_gain }, brings: (s, v) => s.gain * v.p });
    rows.forEach((loop, i) => {
      this.feedback(drawing, lane, loop, row, i === rows.length - 1);
      if (i === rows.length - 1) drawing.append(wire([[X.sum, row], [X.sum, y + 8]], true));
      row += apart;
    });
    if (commands) {
      const signal = lane.surface === "elevator" ? "q" : "phi";
      drawing.append(wire([[this.sensor(drawing, signal, row), row], [X.error, row], [X.error, y + 8]], true), text(X.error + 5, y + 18, lane.surface === "elevator" ? "+" : "−"));
      this.value(drawing, this.right + 4, row + 3.5, (v) => measured(signal, v));
      row += apart;
    }
    drawing.append(sum(X.sum, y));
    return row - apart + 16;
  }

  /** Lag and delay of one signal, and what comes out of them; returns where the path goes on to the left. */
  sensor(drawing, signal, y) {
    if (!this.sensed) return this.right;
    const { lag, delay } = this.sensed;
    const left = this.right - SENSOR.width - 7;
    const words = [lag ? `lag ${milliseconds(lag)}` : "", delay ? `delay ${milliseconds(delay)}` : ""].filter(Boolean);
    const sensor = block(left, y, SENSOR.width);
    words.forEach((line, i) => sensor.append(text(left + SENSOR.width / 2, y + (words.length === 1 ? 3 : i ? 8.5 : -1.5), line, "d-middle d-small")));
    drawing.append(wire([[this.right, y], [left + SENSOR.width, y]], true), sensor);
    this.value(drawing, left + SENSOR.width / 2, y - 15, (v, seen) => measured(signal, seen), "d-middle");
    return left;
  }

  /** The stick in its new role: what it commands, the error, and the controller. */
  command(drawing, lane, settings, y) {
    const ofRate = lane.surface === "elevator";
    const full = ofRate ? settings.full_rate : settings.full_bank;
    const words = ofRate ? [figure(settings.gain), `+ ${figure(settings.integral_gain)}/s`] : [figure(settings.gain)];
    drawing.append(
      block(X.shape, y, 40, ofRate ? `${figure(degrees(full), 2)}°/s` : `${figure(degrees(full), 2)}°`),
      wire([[X.shape + 40, y], [X.error - 8, y]], true),
      sum(X.error, y),
      text(X.error - 14, y + 13, ofRate ? "−" : "+"),
      block(X.gain, y, 44, ...words),
      wire([[X.error + 8, y], [X.gain, y]], true),
      wire([[X.gain + 44, y], [X.sum - 8, y]], true),
    );
    this.value(drawing, X.shape, y - 15, (v) => `${ofRate ? "q" : "φ"} wanted ${angle(full * v[lane.stick])}${ofRate ? "/s" : ""}`);
  }

  /** From the sum to the surface: stop, actuator, and marks where one of them is at its limit. */
  actuation(drawing, lane, y) {
    const { actuators } = this.control;
    const stop = block(X.stop, y, 22);
    stop.append(svg("path", { class: "d-curve", d: `M${X.stop + 3} ${y + 6}h4l8 -12h4` }));
    drawing.append(wire([[X.sum + 8, y], [X.stop, y]], true), stop);
    this.value(drawing, X.stop + 13, y - 15, (v) => angle(v[`command_${lane.surface}`]), "d-middle");
    const { lower, upper } = this.aircraft.limits;
    this.marks.set(`${lane.surface} at its stop`, {
      element: stop,
      until: 0,
      is: (v) => v[`command_${lane.surface}`] > upper[lane.surface] + 1e-6 || v[`command_${lane.surface}`] < lower[lane.surface] - 1e-6,
    });
    if (actuators.on) {
      const b = figure(actuators.bandwidth, 2);
      const actuator = block(X.actuator, y, 40, b, `s + ${b}`);
      drawing.append(wire([[X.stop + 22, y], [X.actuator, y]], true), actuator, wire([[X.actuator + 40, y], [this.right, y]], true));
      this.marks.set(`${lane.surface} at its rate limit`, {
        element: actuator,
        until: 0,
        is: (v, rate) => Math.abs(rate(lane.surface)) >= NEAR * actuators.rate_limit,
      });
    } else drawing.append(wire([[X.stop + 22, y], [this.right, y]], true));
    this.value(drawing, this.right + 4, y + 3.5, (v) => `${lane.symbol} ${angle(v[lane.surface])}`);
  }

  /** One path back to the sum; the last one turns up to it, the others join it on the way. */
  feedback(drawing, lane, { signal, sign, before, settings, brings }, y, last) {
    const words = before?.(settings);
    const gain = X.sum + 20;
    drawing.append(wire([[this.sensor(drawing, signal, y), y], [words ? gain + 96 : gain + 42, y]], true), block(gain, y, 42, figure(settings.gain)), wire([[gain, y], [X.sum + (last ? 0 : 4), y]], !last));
    if (words) drawing.append(block(gain + 54, y, 42, ...words), wire([[gain + 54, y], [gain + 42, y]], true));
    if (!last) drawing.append(svg("circle", { class: "d-sum", cx: X.sum, cy: y, r: 3.5 }));
    drawing.append(text(X.sum + 6, y - 5, sign));
    this.value(drawing, this.right + 4, y + 3.5, (v) => measured(signal, v));
    const others = Object.entries(LOOPS).filter(([, loop]) => loop.surface === lane.surface && loop.brings);
    const full = this.aircraft.full_stick[lane.surface];
    // What has a memory is what remains of the command when all else is taken off.
    const rest = (v, seen) =>
      v[`command_${lane.surface}`] -
      v[`excitation_${lane.surface}`] -
      full * v[lane.stick] -
      others.reduce((total, [name, loop]) => total + (this.control.gains[name] ? signed(loop, this.control.gains[name], seen) : 0), 0);
    this.value(drawing, X.sum - 6, y - 4, (v, seen) => angle(brings ? brings(settings, seen) : rest(v, seen)), "d-end");
  }

  value(drawing, x, y, words, kind = "") {
    const element = text(x, y, "", `d-value ${kind}`);
    drawing.append(element);
    this.values.push({ element, words });
  }

  /** Writes the values on the arrows, while they can be seen. */
  update() {
    const now = performance.now();
    if (!this.values.length || !this.link.frames || this.host.hidden || !this.host.offsetParent) return;
    const v = this.link.copyTo({});
    v.t = this.link.t;
    const seen = this.sensed?.of(v) ?? v;
    this.mark(v, now);
    if (now - this.written < PERIOD) return;
    this.written = now;
    for (const { element, words } of this.values) {
      const said = words(v, seen);
      if (element.textContent !== said) element.textContent = said;
    }
  }

  mark(v, now) {
    const dt = v.t - (this.before?.t ?? v.t);
    const rate = (surface) => (dt > 0 && dt < 0.2 ? (v[surface] - this.before[surface]) / dt : 0);
    const moving = !this.link.has(FLAG.frozen);
    const said = [];
    for (const [words, mark] of this.marks) {
      if (moving && mark.is(v, rate)) mark.until = now + MARK_STAYS;
      const on = now < mark.until;
      mark.element.classList.toggle("is-limited", on);
      if (on) said.push(words);
    }
    this.before = v;
    const sentence = said.length ? `At a limit: ${said.join(", ")}.` : "No surface is at a limit.";
    if (this.state.textContent !== sentence) this.state.textContent = sentence;
    this.state.classList.toggle("is-limited", said.length > 0);
  }
}

const angle = (radians) => {
  const value = clamp(degrees(radians), -999, 999);
  return `${Math.abs(value) < 0.005 ? "0.00" : minus(value.toFixed(Math.abs(value) < 10 ? 2 : 1))}°`;
};
const milliseconds = (seconds) => `${figure(1000 * seconds, 2)} ms`;
const measured = (signal, v) => (signal === "phi" ? `φ ${angle(v.phi)}` : `${signal} ${angle(v[signal])}/s`);

function text(x, y, words, kind = "") {
  return svg("text", { class: kind, x, y }, words);
}

/** A box with one line of words, or a fraction of two. */
function block(x, y, width, top, bottom) {
  const group = svg("g", { class: "d-box" }, svg("rect", { class: "d-block", x, y: y - 12, width, height: 24, rx: 3 }));
  if (bottom) {
    const fraction = !bottom.startsWith("+");
    group.append(text(x + width / 2, y - 2.5, top, "d-middle d-small"), text(x + width / 2, y + 9, bottom, "d-middle d-small"));
    if (fraction) group.append(svg("path", { class: "d-wire", d: `M${x + 5} ${y}h${width - 10}` }));
  } else if (top) group.append(text(x + width / 2, y + 3.5, top, "d-middle"));
  return group;
}

const sum = (x, y) => svg("circle", { class: "d-sum", cx: x, cy: y, r: 7.5 });

/** A line through `points`, with an arrow at its end. */
function wire(points, arrow) {
  const d = points.map(([x, y], i) => `${i ? "L" : "M"}${x} ${y}`).join("");
  const group = svg("g", {}, svg("path", { class: "d-wire", d }));
  if (arrow) {
    const [[x0, y0], [x1, y1]] = points.slice(-2);
    const turn = Math.atan2(y1 - y0, x1 - x0) / DEG;
    group.append(svg("path", { class: "d-arrow", d: "M0 0l-6 -3v6z", transform: `translate(${x1} ${y1}) rotate(${turn})` }));
  }
  return group;
}
