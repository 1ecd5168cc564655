/** A small picture of where stick, pedals and throttle are, over the corner of the world. */

import { svg } from "./dom.js";

const SIZE = 52; // px of the stick's square
const HALF = SIZE / 2;

export class StickIndicator {
  constructor(picture) {
    this.dot = svg("circle", { r: 4.5, class: "stick-dot" });
    this.pedal = svg("rect", { x: -3, y: 0, width: 6, height: 8, rx: 2, class: "stick-dot" });
    this.lever = svg("rect", { x: 0, y: -3, width: 10, height: 6, rx: 2, class: "stick-dot" });
    this.trim = svg("path", { class: "stick-trim" });
    picture.setAttribute("viewBox", "0 0 76 72");
    picture.append(
      svg(
        "g",
        { class: "stick-frame" },
        svg("rect", { x: 4, y: 4, width: SIZE, height: SIZE, rx: 5 }),
        svg("path", { d: `M${4 + HALF} 4v${SIZE}M4 ${4 + HALF}h${SIZE}` }),
        svg("rect", { x: 4, y: 61, width: SIZE, height: 8, rx: 3 }),
        svg("path", { d: `M${4 + HALF} 61v8` }),
        svg("rect", { x: 62, y: 4, width: 10, height: SIZE, rx: 3 }),
      ),
      this.trim,
      this.dot,
      this.pedal,
      this.lever,
    );
    this.seen = "";
  }

  setTrim(throttle) {
    this.trim.setAttribute("d", `M59.5 ${4 + SIZE * (1 - throttle)}h4`);
  }

  /** Pulling moves the dot down, as it moves the hand towards the pilot. */
  draw({ pitch, roll, yaw, throttle }) {
    const key = [pitch, roll, yaw, throttle].map((value) => value.toFixed(2)).join();
    if (key === this.seen) return;
    this.seen = key;
    place(this.dot, 4 + HALF + roll * (HALF - 4), 4 + HALF + pitch * (HALF - 4));
    place(this.pedal, 4 + HALF + yaw * (HALF - 4), 61);
    place(this.lever, 62, 4 + SIZE * (1 - throttle));
  }
}

const place = (element, x, y) => element.setAttribute("transform", `translate(${x.toFixed(1)} ${y.toFixed(1)})`);
