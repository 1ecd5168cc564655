/** A small drawing of what dead zone and curve make of a deflection, with the point where a control stands now. */

import { svg } from "./dom.js";
import { shape } from "./gamepad.js";

const SIDE = 100; // user units from the center to the full deflection
const POINTS = 80;

export class ShapingCurve {
  constructor() {
    this.zone = svg("rect", { class: "zone", y: -SIDE, height: 2 * SIDE });
    this.line = svg("polyline", {});
    this.point = svg("circle", { r: 6, class: "live" });
    this.element = svg(
      "svg",
      { class: "shaping", viewBox: "-108 -108 216 216", role: "img", "aria-label": "Deflection of the stick over that of the device" },
      svg("rect", { class: "room", x: -SIDE, y: -SIDE, width: 2 * SIDE, height: 2 * SIDE }),
      this.zone,
      svg("path", { class: "axes", d: `M${-SIDE} 0H${SIDE}M0 ${-SIDE}V${SIDE}` }),
      svg("path", { class: "diagonal", d: `M${-SIDE} ${SIDE}L${SIDE} ${-SIDE}` }),
      this.line,
      this.point,
    );
  }

  draw(mapping) {
    const place = (_, i) => {
      const raw = (2 * i) / POINTS - 1;
      return `${(raw * SIDE).toFixed(1)},${(-SIDE * shape(raw, mapping)).toFixed(1)}`;
    };
    this.line.setAttribute("points", Array.from({ length: POINTS + 1 }, place).join(" "));
    this.zone.setAttribute("x", -SIDE * mapping.deadZone);
    this.zone.setAttribute("width", 2 * SIDE * mapping.deadZone);
  }

  /** Puts the live point at a raw deflection and what it becomes, both -1..1. */
  show(raw, shaped) {
    this.point.setAttribute("cx", (raw * SIDE).toFixed(1));
    this.point.setAttribute("cy", (-shaped * SIDE).toFixed(1));
  }
}
