/** Listening to a gamepad that is being set up: which axis or button somebody moves, and how far each axis travels. */

import { isTravel } from "./gamepad_mapping.js";

const CLEAR = 0.5; // change from rest that is meant
const SETTLE = 300; // ms from there until the movement has shown which change is the largest

/** Waits for the axis or button that is moved furthest from where it rests when the waiting begins. */
export class Capture {
  /** `axes`: whether an axis will do as well as a button; `except`: a button that will not. */
  constructor(pad, { axes = true, except = null } = {}) {
    Object.assign(this, { axes, except });
    this.restingAxes = [...pad.axes];
    this.restingButtons = pad.buttons.map(({ value }) => value);
    this.largest = { change: 0 };
    this.since = null;
  }

  /** To be called in every frame, `now` in ms: {axis, change} or {button, change} when it has been found, else null. */
  follow(pad, now) {
    if (this.axes) pad.axes.forEach((value, axis) => this.weigh({ axis, change: value - this.restingAxes[axis] }));
    pad.buttons.forEach(({ value }, button) => {
      if (button !== this.except) this.weigh({ button, change: Math.max(0, value - this.restingButtons[button]) });
      this.restingButtons[button] = Math.min(value, this.restingButtons[button]); // one that was held may be let go
    });
    if (Math.abs(this.largest.change) < CLEAR) return null;
    this.since ??= now;
    return now - this.since >= SETTLE ? this.largest : null;
  }

  weigh(moved) {
    if (Math.abs(moved.change) > Math.abs(this.largest.change)) this.largest = moved;
  }
}

/** Measures the travel of every axis of a device, from where all of them rest. */
export class Calibration {
  constructor(pad) {
    this.axes = pad.axes.map((center) => ({ center, low: center, high: center }));
  }

  follow(pad) {
    this.axes.forEach((axis, i) => {
      const value = Math.max(-1, Math.min(1, pad.axes[i] ?? axis.center));
      axis.low = Math.min(axis.low, value);
      axis.high = Math.max(axis.high, value);
    });
  }

  /**
   * The travel of an axis {center, low, high}, or null where it was not moved far enough to tell. One that has no
   * center, a lever or a trigger that rests at its stop, has it in the middle of its travel.
   */
  travel(number, isLever = false) {
    const axis = this.axes[number];
    if (!axis) return null;
    if (!isLever && isTravel(axis)) return axis;
    const atStop = axis.high - axis.center < 0.1 || axis.center - axis.low < 0.1;
    const middle = { ...axis, center: (axis.low + axis.high) / 2 };
    return (isLever || (atStop && axis.high - axis.low > 1)) && isTravel(middle) ? middle : null;
  }
}
