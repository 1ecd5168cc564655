/**
 * The head-down panel: instruments of the shelf side by side on one canvas. What does not move is drawn once for each
 * size and aircraft; each frame copies it and adds what does.
 *
 * An instrument is a module instruments/NAME.js that exports `title`, `needs` (names of Outputs), optionally
 * `face(dial, start)` and `draw(dial, outputs, start)`. `start` holds the outputs first seen of this flight; its field
 * `trimmed` tells whether they are those of trim.
 */

import { Dial, GREY } from "./dial.js";

export const SIX = ["airspeed", "attitude", "altimeter", "turn_coordinator", "heading", "vertical_speed"];

const MARGIN = 3; // CSS px around each instrument

export class InstrumentPanel {
  constructor(canvas, instruments) {
    this.canvas = canvas;
    this.context = canvas.getContext("2d");
    this.instruments = instruments;
    this.faces = new Map();
    this.key = "";
    this.start = {};
    canvas.setAttribute("aria-label", `Instruments: ${instruments.map(({ title }) => title).join(", ")}`);
  }

  /** Loads the named instruments from the shelf; one that fails is named in the error. */
  static async load(canvas, names = SIX) {
    const modules = await Promise.all(names.map((name) => import(`../instruments/${name}.js`)));
    return new InstrumentPanel(canvas, modules);
  }

  /** Tells the instruments how the flight began: their scales fit that, and their bugs stand there. */
  setStart(start) {
    this.start = start;
    this.faces.clear();
  }

  draw(outputs, pixelRatio) {
    const { canvas, context, instruments } = this;
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
