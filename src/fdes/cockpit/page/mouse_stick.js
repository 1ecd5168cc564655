/** The mouse as a stick: while it is on, the pointer's place over the world is pitch and roll. M or Escape ends it. */

import { html } from "./dom.js";
import { clamp } from "./units.js";

const TRAVEL = 0.4; // of the view's shorter side, from the center to the stop
const DEAD_ZONE = 0.05;

export class MouseStick {
  constructor(view) {
    Object.assign(this, { view, active: false, pitch: 0, roll: 0 });
    this.reticle = html("div", { class: "mouse-stick", "aria-hidden": "true", hidden: true }, html("i"));
    view.append(this.reticle);
    view.addEventListener("pointermove", (event) => this.active && this.follow(event));
    view.addEventListener("pointerleave", () => this.center());
    addEventListener("blur", () => this.center());
  }

  toggle(active = !this.active) {
    this.active = active;
    this.reticle.hidden = !active;
    this.center();
  }

  center() {
    this.place(0, 0, 0);
  }

  /** Towards the pilot is aft, as with the stick. */
  follow({ clientX, clientY }) {
    const box = this.view.getBoundingClientRect();
    const travel = TRAVEL * Math.min(box.width, box.height);
    const x = clamp((clientX - box.left - box.width / 2) / travel, -1, 1);
    const y = clamp((clientY - box.top - box.height / 2) / travel, -1, 1);
    this.place(x, y, travel);
  }

  place(x, y, travel) {
    this.roll = beyondDeadZone(x);
    this.pitch = beyondDeadZone(y);
    this.reticle.firstChild.style.transform = `translate(${x * travel}px, ${y * travel}px)`;
  }
}

function beyondDeadZone(value) {
  const size = Math.abs(value);
  return size <= DEAD_ZONE ? 0 : (Math.sign(value) * (size - DEAD_ZONE)) / (1 - DEAD_ZONE);
}
