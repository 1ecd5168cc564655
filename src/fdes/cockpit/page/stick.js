/**
 * Who moves the stick: keyboard or gamepad, as pitch (aft +), roll (right +), yaw (right pedal +), throttle (0..1).
 *
 * A key does not throw the stick against its stop: the stick travels at a hand's rate while the key is down and
 * centers when it is let go. Shift holds it to a third of its travel, for small corrections.
 */

import { clamp } from "./units.js";

const KEYS = {
  ArrowUp: ["pitch", -1],
  ArrowDown: ["pitch", 1],
  ArrowLeft: ["roll", -1],
  ArrowRight: ["roll", 1],
  KeyW: ["pitch", -1],
  KeyS: ["pitch", 1],
  KeyA: ["roll", -1],
  KeyD: ["roll", 1],
  KeyZ: ["yaw", -1],
  KeyX: ["yaw", 1],
  PageUp: ["throttle", 1],
  PageDown: ["throttle", -1],
};
const AXES = ["pitch", "roll", "yaw"];
const OUT_RATE = 1.2; // full travel per second, away from the center
const BACK_RATE = 3.5; // full travel per second, towards the center
const THROTTLE_RATE = 0.4; // full travel per second
const GENTLE = 1 / 3;
const LONGEST_STEP = 0.1; // s: a stalled page must not make the stick jump
const DEAD_ZONE = 0.06;
const PAD_CURVE = 1.4; // exponent: finer near the center
// Axes and buttons in the standard mapping of the Gamepad API; the lever is that of a joystick.
const PAD = { pitch: 1, roll: 0, yaw: 2, lever: 3, throttleUp: 7, throttleDown: 6 };

const TYPING = "input, select, textarea, [contenteditable], dialog";
const USES_ARROWS = "[role=tab]";

/** Whether a key event belongs to the element that has the focus, or to the browser, rather than to the cockpit. */
export function isTaken(event) {
  return event.ctrlKey || event.altKey || event.metaKey || Boolean(event.target.closest?.(TYPING));
}

export class StickInput {
  constructor() {
    this.held = new Set();
    this.gentle = false;
    this.stick = { pitch: 0, roll: 0, yaw: 0, throttle: 0 };
    this.trimThrottle = 0;
    this.source = "Keyboard";
    this.touched = false;
    this.onFirstInput = () => {};
    this.last = performance.now();
    addEventListener("keydown", (event) => this.press(event));
    addEventListener("keyup", (event) => {
      this.held.delete(event.code);
      this.gentle = event.shiftKey;
    });
    addEventListener("blur", () => this.release());
  }

  press(event) {
    this.gentle = event.shiftKey;
    if (!KEYS[event.code] || isTaken(event)) return;
    if (event.code.startsWith("Arrow") && event.target.closest?.(USES_ARROWS)) return;
    event.preventDefault();
    this.held.add(event.code);
    this.notice();
  }

  release() {
    this.held.clear();
    this.gentle = false;
  }

  notice() {
    if (this.touched) return;
    this.touched = true;
    this.onFirstInput();
  }

  /** Puts the throttle lever where the aircraft is in trim. */
  toTrim(throttle = this.trimThrottle) {
    this.trimThrottle = throttle;
    Object.assign(this.stick, { pitch: 0, roll: 0, yaw: 0, throttle });
  }

  /** Where the stick is at `now` [ms]. */
  read(now) {
    const dt = Math.min(LONGEST_STEP, (now - this.last) / 1000);
    this.last = now;
    this.followKeys(dt);
    const pad = firstGamepad();
    this.source = pad ? gamepadName(pad) : "Keyboard";
    return pad ? this.withGamepad(pad, dt) : { ...this.stick };
  }

  followKeys(dt) {
    const want = { pitch: 0, roll: 0, yaw: 0, throttle: 0 };
    for (const code of this.held) {
      const [axis, direction] = KEYS[code];
      want[axis] += direction;
    }
    const travel = this.gentle ? GENTLE : 1;
    for (const axis of AXES) {
      const goal = clamp(want[axis], -1, 1) * travel;
      const reach = (goal !== 0 ? OUT_RATE : BACK_RATE) * dt;
      this.stick[axis] += clamp(goal - this.stick[axis], -reach, reach);
    }
    this.stick.throttle = clamp(this.stick.throttle + want.throttle * THROTTLE_RATE * dt, 0, 1);
  }

  /** The pad wins on every axis where it is off center; the keys keep the others. */
  withGamepad(pad, dt) {
    const stick = { ...this.stick };
    for (const axis of AXES) {
      const value = curve(pad.axes[PAD[axis]] ?? 0);
      if (value !== 0) stick[axis] = value;
    }
    if (AXES.some((axis) => stick[axis] !== 0)) this.notice();
    if (pad.mapping === "standard") {
      const lever = (pad.buttons[PAD.throttleUp]?.value ?? 0) - (pad.buttons[PAD.throttleDown]?.value ?? 0);
      this.stick.throttle = clamp(this.stick.throttle + lever * THROTTLE_RATE * dt, 0, 1);
    } else if (pad.axes.length > PAD.lever) {
      this.stick.throttle = (1 - pad.axes[PAD.lever]) / 2; // a joystick's lever is pushed forward to -1
    }
    stick.throttle = this.stick.throttle;
    return stick;
  }
}

function firstGamepad() {
  return [...(navigator.getGamepads?.() ?? [])].find((pad) => pad?.connected);
}

function gamepadName(pad) {
  return pad.id.replace(/\s*\(.*/, "").slice(0, 18) || "Gamepad";
}

function curve(value) {
  const size = Math.abs(value);
  return size < DEAD_ZONE ? 0 : Math.sign(value) * ((size - DEAD_ZONE) / (1 - DEAD_ZONE)) ** PAD_CURVE;
}
