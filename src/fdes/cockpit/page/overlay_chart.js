/** The overlay's chart: one lane for each signal, one line for each flight, and a line that reads them at a time. */

import { clamp, minus, roundStep } from "./units.js";

const LEFT = 58; // px for the numbers of the axis
const RIGHT = 12;
const TITLE = 20;
const FOOT = 24;
const NUDGE = 0.005; // of the width, for one press of an arrow key
const DASHES = [[], [7, 4], [2, 3], [9, 3, 2, 3]]; // colors alone would not tell flights apart for everyone

export class OverlayChart {
  constructor(canvas) {
    this.canvas = canvas;
    this.lanes = [];
    this.reading = 0; // s
    this.onReading = null;
    canvas.addEventListener("pointermove", ({ offsetX }) => this.readAt(this.timeAt(offsetX)));
    canvas.addEventListener("keydown", (event) => {
      const way = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
      if (!way) return;
      event.preventDefault();
      this.readAt(this.reading + way * NUDGE * (this.to - this.from));
    });
  }

  /** `lanes`: [{ symbol, unit, series: [{ label, t, y }] }], times in s, y in `unit`. */
  show(lanes) {
    this.lanes = lanes;
    const times = lanes.flatMap(({ series }) => series.filter(({ t }) => t.length));
    this.from = Math.min(0, ...times.map(({ t }) => t[0]));
    this.to = Math.max(this.from + 1, ...times.map(({ t }) => t.at(-1)));
    this.reading = clamp(this.reading, this.from, this.to);
    this.draw();
  }

  readAt(t) {
    this.reading = clamp(t, this.from, this.to);
    this.draw();
    this.onReading?.();
  }

  timeAt(x) {
    return this.from + ((x - LEFT) / (this.canvas.clientWidth - LEFT - RIGHT)) * (this.to - this.from);
  }

  draw() {
    const { canvas } = this;
    const [width, height, ratio] = [canvas.clientWidth, canvas.clientHeight, devicePixelRatio];
    if (!width || !this.lanes.length) return;
    [canvas.width, canvas.height] = [Math.round(width * ratio), Math.round(height * ratio)];
    const context = canvas.getContext("2d");
    context.scale(ratio, ratio);
    const style = getComputedStyle(canvas);
    const ink = (name) => style.getPropertyValue(`--${name}`).trim();
    context.fillStyle = ink("card");
    context.fillRect(0, 0, width, height);
    context.font = '12px system-ui, "Segoe UI", Roboto, "DejaVu Sans", sans-serif';
    context.textBaseline = "middle";
    const tall = (height - FOOT) / this.lanes.length;
    const x = (t) => LEFT + ((t - this.from) / (this.to - this.from)) * (width - LEFT - RIGHT);
    this.lanes.forEach((lane, i) =>
      drawLane(context, lane, { ink, x, right: width - RIGHT, top: i * tall + TITLE, bottom: (i + 1) * tall - 6 }),
    );
    context.fillStyle = ink("quiet");
    context.textAlign = "center";
    const step = roundStep((this.to - this.from) / 8);
    for (let n = Math.ceil(this.from / step); n * step <= this.to; n++)
      context.fillText(`${Number((n * step).toFixed(3))} s`, clamp(x(n * step), LEFT, width - 20), height - 10);
    context.fillStyle = ink("ink");
    context.fillRect(Math.round(x(this.reading)), TITLE, 1, height - FOOT - TITLE);
  }
}

function drawLane(context, { symbol, unit, series }, { ink, x, right, top, bottom }) {
  context.fillStyle = ink("plot");
  context.fillRect(LEFT, top, right - LEFT, bottom - top);
  let [low, high] = [Infinity, -Infinity];
  for (const { y } of series)
    for (const value of y) {
      if (value < low) low = value;
      if (value > high) high = value;
    }
  if (!(low <= high)) [low, high] = [0, 0];
  if (high - low < 1e-6) [low, high] = [low - 1, high + 1];
  const step = roundStep((high - low) / 4);
  [low, high] = [Math.floor(low / step) * step, Math.ceil(high / step) * step];
  const at = (value) => bottom - ((value - low) / (high - low)) * (bottom - top);
  for (let n = 0; n * step <= high - low + step / 2; n++) {
    const value = low + n * step;
    context.fillStyle = ink("grid");
    context.fillRect(LEFT, Math.round(at(value)), right - LEFT, 1);
    context.fillStyle = ink("quiet");
    context.textAlign = "right";
    context.fillText(minus(Number(value.toPrecision(6))), LEFT - 6, at(value));
  }
  context.fillStyle = ink("ink");
  context.textAlign = "left";
  context.fillText(`${symbol}, ${unit}`, LEFT + 4, top - 9);
  context.lineWidth = 1.7;
  series.forEach(({ t, y }, i) => {
    context.strokeStyle = ink(`series-${i + 1}`);
    context.setLineDash(DASHES[i]);
    context.beginPath();
    let drawing = false;
    t.forEach((time, k) => {
      if (!Number.isFinite(y[k])) drawing = false;
      else if (drawing && !(unit === "deg" && Math.abs(y[k] - y[k - 1]) > 180)) context.lineTo(x(time), at(y[k]));
      else {
        context.moveTo(x(time), at(y[k]));
        drawing = true;
      }
    });
    context.stroke();
  });
  context.setLineDash([]);
}
