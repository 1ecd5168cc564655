/**
 * Strip charts: lanes of signals over the last 20 seconds. Every channel is kept, so that a signal chosen later shows
 * its past. Point at the chart to read values at an earlier time; while time stands still a slider goes further back.
 */

import { clamp, fixed, minus, roundStep, shown } from "./units.js";

const SECONDS = 20;
const KEPT = 120; // s
const STILL = 400; // ms without a new row: time stands still
const RATE = 60; // frames a second that are kept
const LEFT = 44; // px for the numbers of the axis
const RIGHT = 10;
const TITLE = 17; // px above each lane for its legend
const FOOT = 20; // px below all lanes for the time axis
const NUMBER = 16; // px from number to number up an axis, at least: those at its ends are moved in
const ROW = 20; // px between the lines of an axis, at least
const LATE_START = 12; // s of flight before the chart stops explaining its empty part
const HALF_TURN = Math.PI; // rad: no angle goes so far from row to row, but for one that begins a new turn

export const DEFAULT_LANES = [
  ["theta", "alpha"],
  ["p", "q", "r"],
  ["phi", "beta"],
  ["elevator", "aileron", "rudder"],
];

const SYMBOLS = {
  theta: "θ",
  alpha: "α",
  phi: "φ",
  beta: "β",
  psi: "ψ",
  gamma: "γ",
  chi: "χ",
  elevator: "δe",
  aileron: "δa",
  rudder: "δr",
  throttle: "δT",
  psi_dot: "ψ̇",
  p_dot: "ṗ",
  q_dot: "q̇",
  r_dot: "ṙ",
  h_dot: "ḣ",
  mach: "M",
  n_x: "nx",
  n_y: "ny",
  n_z: "nz",
};

export const symbol = (name) => SYMBOLS[name] ?? name.replaceAll("_", " ");

export class StripChart {
  /** `slider`: the input that goes back; shown when there is something to go back to. */
  constructor(canvas, slider) {
    this.canvas = canvas;
    this.slider = slider;
    this.context = canvas.getContext("2d");
    this.lanes = DEFAULT_LANES;
    this.limits = [];
    this.pointer = null;
    this.setChannels([]);
    slider.addEventListener("input", () => (this.past = -Number(slider.value)));
    canvas.addEventListener("pointermove", ({ offsetX }) => (this.pointer = offsetX));
    canvas.addEventListener("pointerleave", () => (this.pointer = null));
  }

  setChannels(channels) {
    this.channels = channels;
    this.index = Object.fromEntries(channels.map(({ name }, i) => [name, i]));
    this.rows = KEPT * RATE;
    this.times = new Float64Array(this.rows);
    this.values = new Float32Array(this.rows * channels.length);
    this.clear();
  }

  setLanes(lanes) {
    this.lanes = lanes;
    this.limits = [];
  }

  clear() {
    this.count = 0;
    this.next = 0;
    this.past = 0; // s before the last row at which the chart ends
    this.recordedAt = 0;
  }

  /** Keeps the channel `values` of time `t` [s]. Time that runs back, or leaps, starts a new chart. */
  record(t, values) {
    if (this.count) {
      const last = this.times[this.row(-1)];
      if (t < last || t > last + SECONDS) this.clear();
      else if (t - last < 0.5 / RATE) return;
    }
    this.times[this.next] = t;
    this.values.set(values.subarray(0, this.channels.length), this.next * this.channels.length);
    this.next = (this.next + 1) % this.rows;
    this.count = Math.min(this.rows, this.count + 1);
    this.recordedAt = performance.now();
    this.past = 0;
  }

  /** Index of the row `back` rows before the next one (-1: the last). */
  row(back) {
    return (this.next + back + this.rows) % this.rows;
  }

  /** The first of the kept rows at `t` [s] or later, counted back from the next one; 0 when there is none. */
  since(t) {
    let [low, high] = [-this.count, 0];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.times[this.row(middle)] < t) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  /** The slider is there while time stands still and more is kept than is shown. */
  offerPast() {
    const { slider } = this;
    const kept = this.count ? this.times[this.row(-1)] - this.times[this.row(-this.count)] : 0;
    const offered = kept > SECONDS && performance.now() - this.recordedAt > STILL;
    if (slider.hidden !== offered) return;
    slider.hidden = !offered;
    slider.min = SECONDS - kept;
    slider.value = 0;
  }

  draw(colors, pixelRatio) {
    this.offerPast();
    const { canvas, context } = this;
    const [width, height] = [canvas.width / pixelRatio, canvas.height / pixelRatio];
    context.setTransform(pixelRatio, 0, 0, pixelRatio, 0, 0);
    context.clearRect(0, 0, width, height);
    context.font = '11px system-ui, "Segoe UI", Roboto, "DejaVu Sans", sans-serif';
    context.textBaseline = "middle";
    const now = this.count ? this.times[this.row(-1)] - this.past : 0;
    const frame = { colors, left: LEFT, right: width - RIGHT, from: now - SECONDS, now, pixelRatio };
    frame.first = Math.max(-this.count, this.since(frame.from) - 1);
    frame.end = this.past > 0 ? Math.min(0, this.since(now) + 1) : 0;
    frame.perSecond = (frame.right - frame.left) / SECONDS;
    frame.reading = this.pointed(frame);
    const laneHeight = (height - FOOT) / this.lanes.length;
    this.lanes.forEach((names, i) =>
      this.drawLane(i, names, { ...frame, top: i * laneHeight + TITLE, bottom: (i + 1) * laneHeight - 5 }),
    );
    this.drawTimes(frame, height);
  }

  /** The row under the pointer, else the last one, else null. */
  pointed(frame) {
    if (!this.count) return null;
    if (this.pointer === null) return this.row(frame.end - 1);
    const t = frame.from + (clamp(this.pointer, frame.left, frame.right) - frame.left) / frame.perSecond;
    return this.row(Math.max(-this.count, this.since(t + 1e-9) - 1));
  }

  drawLane(i, names, frame) {
    const { context } = this;
    const { colors, left, right, top, bottom } = frame;
    const series = names
      .filter((name) => name in this.index)
      .map((name) => {
        const column = this.index[name];
        return { name, column, ...shown(this.channels[column].unit, name) };
      });
    context.fillStyle = colors.plot;
    context.fillRect(left, top, right - left, bottom - top);
    const axis = (this.limits[i] = limits(
      this.extremes(series, frame),
      series[0]?.span ?? 1,
      this.limits[i],
      (bottom - top) / ROW,
    ));
    const y = (value) => bottom - ((value - axis.low) / (axis.high - axis.low)) * (bottom - top);
    this.drawGrid(axis, y, frame);
    this.drawLegend(series, frame);
    if (i === 0) this.drawEmpty(frame);

    context.save();
    context.beginPath();
    context.rect(left, top - 1, right - left, bottom - top + 2);
    context.clip();
    series.forEach((one, k) => this.drawSeries(one, colors.series[k % colors.series.length], y, frame));
    context.restore();
    if (this.pointer !== null && frame.reading !== null) this.drawCursor(frame);
  }

  extremes(series, { first, end }) {
    let [low, high] = [Infinity, -Infinity];
    for (let back = first; back < end; back++) {
      const row = this.row(back);
      for (const { column, factor } of series) {
        const value = this.values[row * this.channels.length + column] * factor;
        if (value < low) low = value;
        if (value > high) high = value;
      }
    }
    return low <= high ? [low, high] : [0, 0];
  }

  drawGrid(axis, y, { colors, left, right, top, bottom, from, now, perSecond }) {
    const { context } = this;
    context.strokeStyle = colors.grid;
    context.lineWidth = 1;
    context.beginPath();
    context.fillStyle = colors.quiet;
    context.textAlign = "right";
    const every = Math.ceil(NUMBER / (y(axis.low) - y(axis.low + axis.step)));
    for (let n = 0; n * axis.step <= axis.high - axis.low + 1e-9; n++) {
      const value = axis.low + n * axis.step;
      const at = Math.round(y(value)) + 0.5;
      context.moveTo(left, at);
      context.lineTo(right, at);
      if (n % every === 0) context.fillText(minus(Number(value.toFixed(3))), left - 6, clamp(at, top + 4, bottom - 3));
    }
    for (let t = Math.ceil(from / 5) * 5; t <= now; t += 5) {
      const x = Math.round(left + (t - from) * perSecond) + 0.5;
      context.moveTo(x, top);
      context.lineTo(x, bottom);
    }
    context.stroke();
  }

  drawLegend(series, { colors, left, right, top, reading }) {
    const { context } = this;
    let x = left;
    series.forEach(({ name, column, factor, label }, k) => {
      context.fillStyle = colors.series[k % colors.series.length];
      context.fillRect(x, top - 10, 10, 3);
      const value = reading === null ? NaN : this.values[reading * this.channels.length + column] * factor;
      const digits = Math.abs(value) >= 100 ? 0 : label === "–" || Math.abs(value) < 10 ? 2 : 1;
      context.textAlign = "left";
      context.fillStyle = colors.ink;
      context.fillText(
        `${symbol(name)} ${Number.isFinite(value) ? minus(fixed(value, digits)) : "–"}`,
        x + 14,
        top - 8,
      );
      x += 14 + Math.max(62, context.measureText(symbol(name)).width + 50);
    });
    context.textAlign = "right";
    context.fillStyle = colors.quiet;
    context.fillText([...new Set(series.map(({ label }) => label))].join(", "), right, top - 8);
  }

  /** Says why the chart is still empty. */
  drawEmpty({ colors, left, top, bottom, from, perSecond }) {
    const first = this.count ? this.times[this.row(-this.count)] : from + SECONDS;
    if (SECONDS - (first - from) > LATE_START) return;
    const { context } = this;
    const [words, room] = ["The last 20 s of flight fill in from the right", (first - from) * perSecond];
    const wide = context.measureText(words).width;
    if (wide + 12 > room) return;
    const [x, y] = [left + room / 2, (top + bottom) / 2];
    context.fillStyle = colors.plot;
    context.fillRect(x - wide / 2 - 5, y - 8, wide + 10, 16);
    context.fillStyle = colors.quiet;
    context.textAlign = "center";
    context.fillText(words, x, y);
  }

  /**
   * One polyline, broken where an angle begins a new turn. Where several samples share a pixel column, their smallest
   * and largest are joined.
   */
  drawSeries({ column, factor }, color, y, { left, from, first, end, perSecond, pixelRatio }) {
    const { context } = this;
    const wide = this.channels.length;
    const angle = this.channels[column].unit === "rad";
    let [pixel, low, high, started, last] = [-1, 0, 0, false, NaN];
    context.beginPath();
    for (let back = first; back < end; back++) {
      const row = this.row(back);
      const x = Math.round((left + (this.times[row] - from) * perSecond) * pixelRatio) / pixelRatio;
      const value = this.values[row * wide + column];
      const at = y(value * factor);
      const broken = angle && Math.abs(value - last) > HALF_TURN;
      last = value;
      if (x === pixel && !broken) {
        low = Math.min(low, at);
        high = Math.max(high, at);
        continue;
      }
      if (started && low !== high) {
        context.lineTo(pixel, low);
        context.lineTo(pixel, high);
      }
      if (started && !broken) context.lineTo(x, at);
      else context.moveTo(x, at);
      [pixel, low, high, started] = [x, at, at, true];
    }
    context.strokeStyle = color;
    context.lineWidth = 1.7;
    context.lineJoin = "round";
    context.stroke();
  }

  drawCursor({ colors, left, from, perSecond, top, bottom, reading }) {
    const { context } = this;
    const x = Math.round(left + (this.times[reading] - from) * perSecond) + 0.5;
    context.strokeStyle = colors.ink;
    context.lineWidth = 1;
    context.beginPath();
    context.moveTo(x, top);
    context.lineTo(x, bottom);
    context.stroke();
  }

  drawTimes({ colors, left, right, from, now, perSecond }, height) {
    const { context } = this;
    context.fillStyle = colors.quiet;
    for (let t = Math.max(0, Math.ceil(from / 5) * 5); t <= now; t += 5) {
      const x = left + (t - from) * perSecond;
      if (x > right - 62) continue; // the newest time stands there
      context.textAlign = "center";
      context.fillText(`${t} s`, Math.max(left + 8, x), height - 9);
    }
    context.textAlign = "right";
    context.fillText(`${now.toFixed(1)} s`, right, height - 9);
  }
}

/**
 * Round limits around [low, high] with at least `span` between them and about `lines` steps. The old limits stay while
 * they still fit well, so that the axis does not twitch.
 */
function limits([low, high], span, old, lines) {
  if (
    old?.lines === lines &&
    low >= old.low &&
    high <= old.high &&
    Math.max(high - low, span) > 0.4 * (old.high - old.low)
  )
    return old;
  const spare = Math.max(0, span - (high - low)) / 2;
  let step = roundStep((high - low + 2 * spare) / clamp(lines, 2, 5));
  const first = () => Math.floor((low - spare) / step);
  const last = () => Math.ceil((high + spare) / step);
  while (last() - first() > Math.max(2, lines)) step = roundStep(1.01 * step); // numbers that touch cannot be read
  return { step, lines, low: first() * step, high: last() * step };
}
