/**
 * The head-down panel: instruments of the shelf side by side on one canvas. What does not move is drawn once for each
 * size and aircraft; each frame copies it and adds what does.
 *
 * An instrument is a module instruments/NAME.js that exports `title`, `needs` (names of Outputs), optionally
 * `face(dial, start)` and `draw(dial, outputs, start)`. `start` holds the outputs first seen of this flight; its field
 * `trimmed` tells whether they are those of trim. What an instrument must remember of a flight it may add to `start`.
 */

import { Dial, GREY } from "./dial.js";

export const SIX = ["airspeed", "attitude", "altimeter", "turn_coordinator", "heading", "vertical_speed"];

const MARGIN = 3; // CSS px around each instrument

const KEY = "fdes.instruments";

export class InstrumentPanel {
  constructor(canvas) {
    this.canvas = canvas;
    this.context = canvas.getContext("2d");
    this.names = [];
    this.instruments = [];
    this.faces = new Map();
    this.key = "";
    this.start = {};
  }

  /** The panel with the instruments `asked` for, else those remembered, else the six; a missing one is left out. */
  static async load(canvas, asked) {
    const panel = new InstrumentPanel(canvas);
    await panel.use(asked ?? remembered() ?? SIX);
    return panel;
  }

  /** Shows the instruments of the shelf with these names, in this order. With none the world has their room too. */
  async use(names) {
    const wanted = (this.wanted = [...names]);
    const found = await Promise.allSettled(wanted.map((name) => import(`../instruments/${name}.js`)));
    if (this.wanted !== wanted) return; // another choice was made meanwhile
    this.names = wanted.filter((_, i) => found[i].status === "fulfilled");
    this.instruments = found.filter(({ status }) => status === "fulfilled").map(({ value }) => value);
    this.faces.clear();
    this.canvas.setAttribute("aria-label", `Instruments: ${this.instruments.map(({ title }) => title).join(", ")}`);
    document.querySelector("main").classList.toggle("without-instruments", this.names.length === 0);
  }

  remember() {
    try {
      localStorage.setItem(KEY, JSON.stringify(this.names));
    } catch {
      return; // storage may be forbidden: the choice then lasts as long as the page
    }
  }

  /** Tells the instruments how the flight began: their scales fit that, and their bugs stand there. */
  setStart(start) {
    this.start = start;
    this.faces.clear();
  }

  draw(outputs, pixelRatio) {
    const { canvas, context, instruments } = this;
    if (!instruments.length) return;
    const wide = canvas.width / instruments.length;
    const radius = Math.floor(Math.min(wide, canvas.height) / 2 - MARGIN * pixelRatio);
    if (radius < 10) return;
    if (this.key !== `${radius} ${canvas.width}`) this.faces.clear();
    this.key = `${radius} ${canvas.width}`;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, canvas.width, canvas.height);
    const dial = new Dial(context, radius);
    instruments.forEach((instrument, i) => {
      context.setTransform(1, 0, 0, 1, Math.round((i + 0.5) * wide), Math.round(canvas.height / 2));
      const face = this.cached(instrument.title, radius, (d) => {
        d.case();
        instrument.face?.(d, this.start);
      });
      context.drawImage(face, -radius, -radius);
      const missing = instrument.needs.filter((name) => outputs[name] === undefined);
      if (missing.length) dial.text("OFF", 0, 0, 0.3, GREY);
      else instrument.draw(dial, outputs, this.start);
      context.drawImage(
        this.cached("glass", radius, (d) => d.glass()),
        -radius,
        -radius,
      );
    });
  }

  cached(name, radius, paint) {
    if (!this.faces.has(name)) {
      const canvas = document.createElement("canvas");
      canvas.width = canvas.height = 2 * radius;
      const context = canvas.getContext("2d");
      context.translate(radius, radius);
      paint(new Dial(context, radius));
      this.faces.set(name, canvas);
    }
    return this.faces.get(name);
  }
}

function remembered() {
  try {
    const names = JSON.parse(localStorage.getItem(KEY));
    return Array.isArray(names) && names.every((name) => /^\w+$/.test(name)) ? names : null;
  } catch {
    return null;
  }
}
