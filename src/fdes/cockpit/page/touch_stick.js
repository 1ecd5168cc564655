/**
 * Stick, throttle lever and rudder for fingers, over the lower corners of the outside view. Each follows a finger of its
 * own; stick and rudder center when they are let go, the lever stays. Fetched where a touch screen flies.
 */

import { fetchStyle, html } from "./dom.js";
import { clamp } from "./units.js";

const DEAD_ZONE = 0.06;

export class TouchStick {
  constructor(view) {
    fetchStyle("/page/touch_stick.css");
    Object.assign(this, { active: false, pitch: 0, roll: 0, yaw: 0, lever: null });
    this.at = 0; // where the throttle is
    this.stick = control("touch-pad", "");
    this.rudder = control("touch-rudder", "rudder");
    this.throttle = control("touch-throttle", "throttle");
    this.box = html("div", { class: "touch", "aria-hidden": "true", hidden: true }, this.throttle, this.rudder, this.stick);
    view.append(this.box);
    this.controls = [this.stick, this.rudder, this.throttle];
    this.follow(this.stick, (x, y) => ([this.roll, this.pitch] = [beyondDeadZone(x), beyondDeadZone(y)]), 0);
    this.follow(this.rudder, (x) => (this.yaw = beyondDeadZone(x)), 0);
    // The lever moves as far as the finger does: a touch by itself must not jump the throttle.
    this.follow(this.throttle, (_, y, from) => (this.lever = clamp(from.lever - (y - from.y) / 2, 0, 1)), null);
    addEventListener("blur", () => this.center());
  }

  /** Calls `move(x, y, from)`, -1 to 1 right and down, while a finger is on `element`; without one, with `rest`. */
  follow(element, move, rest) {
    let finger = null;
    let from = null;
    const place = ({ clientX, clientY }) => {
      const { left, top, width, height } = element.getBoundingClientRect();
      const knob = element.firstChild.offsetWidth;
      const reach = (offset, size) => (2 * offset) / Math.max(size - knob, 1);
      return [reach(clientX - left - width / 2, width), reach(clientY - top - height / 2, height)];
    };
    const go = (event) => {
      const [x, y] = place(event);
      from ??= { y, lever: this.at };
      move(rest === null ? x : clamp(x, -1, 1), rest === null ? y : clamp(y, -1, 1), from);
    };
    const letGo = () => {
      finger = from = null;
      if (rest === null) this.lever = null;
      else move(rest, rest);
    };
    element.addEventListener("pointerdown", (event) => {
      if (finger !== null) return;
      finger = event.pointerId;
      element.setPointerCapture(finger);
      go(event);
    });
    element.addEventListener("pointermove", (event) => event.pointerId === finger && go(event));
    for (const end of ["pointerup", "pointercancel", "lostpointercapture"])
      element.addEventListener(end, (event) => event.pointerId === finger && letGo());
    element.letGo = letGo;
  }

  /** Shows or hides the controls; `active` says which. */
  toggle(active) {
    this.active = active;
    this.box.hidden = !active;
    document.documentElement.classList.toggle("by-touch", active);
    this.center();
  }

  center() {
    for (const element of this.controls) element.letGo();
  }

  /** The knobs stand where `moved` has stick, pedals and lever, whoever moves them. */
  show({ pitch, roll, yaw, throttle }) {
    this.at = throttle;
    const key = [pitch, roll, yaw, throttle].map((value) => value.toFixed(2)).join();
    if (key === this.shown) return;
    this.shown = key;
    put(this.stick, roll, pitch);
    put(this.rudder, yaw, 0);
    put(this.throttle, 0, 1 - 2 * throttle);
  }
}

const control = (name, words) => html("div", { class: `touch-control ${name}` }, html("i"), words && html("span", {}, words));

/** In CSS, so that nothing is measured each frame: see touch_stick.css. */
function put(element, x, y) {
  element.style.setProperty("--x", x.toFixed(2));
  element.style.setProperty("--y", y.toFixed(2));
}

function beyondDeadZone(value) {
  const size = Math.abs(value);
  return size <= DEAD_ZONE ? 0 : (Math.sign(value) * (size - DEAD_ZONE)) / (1 - DEAD_ZONE);
}
