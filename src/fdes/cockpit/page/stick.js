/**
 * Who moves the stick: keyboard, mouse, gamepad or fingers, as pitch (aft +), roll (right +), yaw (right
 * pedal +), throttle (0..1).
 *
 * A key does not throw the stick against its stop: the stick travels at a hand's rate while the key is down and
 * centers when it is let go. Shift holds it to a third of its travel, for small corrections.
 */

import { Gamepads } from "./gamepad.js";
import { MouseStick } from "./mouse_stick.js";
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
const CHOICE = "fdes.control"; // one of CONTROLS, where one was chosen
const CONTROLS = ["keyboard", "mouse", "touch", "gamepad"];
const FINGERS = "(pointer: coarse)"; // the first pointer of this device
const MOUSE_FLIES = "Mouse stick: the pointer over the world flies. M or Escape ends it.";
const TOUCH_FLIES = "Fingers fly: stick at the right, throttle and rudder at the left.";

const TYPING = "input:not([type=checkbox], [type=range]), select, textarea, [contenteditable], dialog";
const MOVES = { "[role=tab]": /^(Arrow|Home|End)/, "input[type=range]": /^(Arrow|Home|End|Page)/ }; // keys they take

/** Whether a key event belongs to the element that has the focus, or to the browser, rather than to the cockpit. */
export function isTaken(event) {
  const within = (what) => Boolean(event.target.closest?.(what));
  const moved = Object.entries(MOVES).some(([what, keys]) => keys.test(event.code) && within(what));
  return event.ctrlKey || event.altKey || event.metaKey || moved || within(TYPING);
}

/** A slider that was dragged has done its work: the keys fly again. One that was reached by keys keeps them. */
function giveBackKeys(target) {
  if (target.matches?.("input[type=range]") && !target.closest("dialog")) target.blur();
}

export class StickInput {
  constructor() {
    this.held = new Set();
    this.gentle = false;
    this.stick = { pitch: 0, roll: 0, yaw: 0, throttle: 0 };
    this.moved = { ...this.stick }; // what read() answers; one object, so that no frame leaves garbage
    this.gamepads = new Gamepads();
    this.mouse = new MouseStick(document.querySelector(".view"));
    this.touch = null; // a TouchStick, once fingers fly
    this.wantsTouch = this.isChosen = false;
    this.padName = null;
    this.usesPad = true; // one that is plugged in flies, unless another control was chosen
    this.trimThrottle = 0;
    this.source = "Keyboard";
    this.touched = false;
    this.onFirstInput = () => {};
    this.onNotice = () => {}; // told in a sentence when another device takes or leaves the stick
    this.onAction = () => {}; // told which action a button of the gamepad asks for
    this.gamepads.onAction = (action) => this.usesPad && !document.querySelector("dialog[open]") && this.onAction(action);
    this.recallChoice();
    this.last = performance.now();
    addEventListener("keydown", (event) => this.press(event));
    addEventListener("keyup", (event) => {
      this.held.delete(event.code);
      this.gentle = event.shiftKey;
    });
    addEventListener("blur", () => this.release());
    addEventListener("pointerup", ({ target }) => setTimeout(() => giveBackKeys(target)));
    this.mouse.view.addEventListener("pointerdown", (event) => this.meetFinger(event));
  }

  press(event) {
    this.gentle = event.shiftKey;
    if (this.switchesMouse(event)) return;
    if (!KEYS[event.code] || isTaken(event)) return;
    event.preventDefault();
    this.held.add(event.code);
    this.notice();
  }

  switchesMouse(event) {
    const leaves = event.code === "Escape" && this.mouse.active;
    if ((event.code !== "KeyM" && !leaves) || event.repeat || isTaken(event)) return false;
    this.mouse.toggle();
    this.rememberChoice(this.mouse.active ? "mouse" : this.usesPad ? null : this.choice);
    this.onNotice(this.mouse.active ? MOUSE_FLIES : `${this.padFlies ? this.gamepads.name : "The keyboard"} flies. The stick is centered.`);
    return true;
  }

  /** What was chosen before the page was loaded again. Nothing, where storage is forbidden or holds something else. */
  recallChoice() {
    try {
      const name = CONTROLS.find((each) => each === localStorage.getItem(CHOICE));
      this.isChosen = Boolean(name);
      this.mouse.toggle(name === "mouse");
      this.usesPad = !name || name === "gamepad";
      this.useTouch(name === "touch" || (!name && matchMedia(FINGERS).matches));
    } catch {
      this.usesPad = true;
      this.useTouch(matchMedia(FINGERS).matches);
    }
  }

  /** Shows the stick for fingers, or takes it away. */
  async useTouch(wanted) {
    this.wantsTouch = wanted;
    try {
      if (wanted && !this.touch) {
        const { TouchStick } = await import("./touch_stick.js");
        this.touch ??= new TouchStick(this.mouse.view);
      }
      this.touch?.toggle(this.wantsTouch);
    } catch (error) {
      this.onNotice(`The stick for fingers could not be fetched. ${error.message}`);
    }
  }

  /** A finger on a screen that also has a mouse: it flies, unless another control was chosen. */
  meetFinger({ pointerType }) {
    if (pointerType === "touch" && !this.isChosen && !this.wantsTouch) this.useTouch(true);
  }

  rememberChoice(name) {
    try {
      if (name) localStorage.setItem(CHOICE, name);
      else localStorage.removeItem(CHOICE);
    } catch {
      return; // storage may be forbidden: the choice then lasts until the page is closed
    }
  }

  get padFlies() {
    return this.usesPad && Boolean(this.gamepads.pad) && !this.gamepads.isBeingSetUp;
  }

  /** What flies now, as the chooser names it. */
  get choice() {
    if (this.mouse.active) return "mouse";
    if (this.usesPad && this.gamepads.pad) return "gamepad";
    return this.wantsTouch ? "touch" : "keyboard";
  }

  /** Hands the stick to "keyboard", "mouse", "touch" or "gamepad"; answers what that means in a sentence. */
  choose(name) {
    this.mouse.toggle(name === "mouse");
    this.usesPad = name === "gamepad";
    this.useTouch(name === "touch");
    this.isChosen = true;
    this.rememberChoice(name);
    if (name === "touch") return TOUCH_FLIES;
    if (name === "mouse") return MOUSE_FLIES;
    if (name === "keyboard") return "The keyboard flies. The stick is centered.";
    if (this.gamepads.pad) return `${this.gamepads.name} flies.`;
    return "No gamepad is seen. Plug one in and press one of its buttons; until then the keyboard flies.";
  }

  release() {
    this.held.clear();
    this.touch?.center();
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
    Object.assign(this.moved, this.stick);
    this.source = this.mouse.active ? "Mouse stick" : this.wantsTouch ? "Touch" : "Keyboard";
    if (this.mouse.active) this.addMouse();
    if (this.touch?.active) this.addTouch();
    this.noticeGamepad(this.gamepads.find());
    if (this.gamepads.pad) this.gamepads.followButtons();
    if (this.padFlies) this.addGamepad(dt);
    this.moved.throttle = this.stick.throttle;
    if (this.touch?.active) this.touch.show(this.moved);
    return this.moved;
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

  addMouse() {
    const { pitch, roll } = this.mouse;
    if (pitch !== 0) this.moved.pitch = pitch;
    if (roll !== 0) this.moved.roll = roll;
    if (pitch !== 0 || roll !== 0) this.notice();
  }

  /** Fingers win on every axis that they move; keys keep the others. */
  addTouch() {
    const { touch } = this;
    for (const axis of AXES) if (touch[axis] !== 0) this.moved[axis] = touch[axis];
    if (touch.lever !== null) this.stick.throttle = touch.lever;
    if (touch.lever !== null || AXES.some((axis) => touch[axis] !== 0)) this.notice();
  }

  /** Says it when a device comes or goes; one that has gone holds nothing: the stick is then centered. */
  noticeGamepad(pad) {
    const name = pad ? this.gamepads.name : null;
    if (name === this.padName) return;
    if (!name) this.onNotice(`${this.padName} is unplugged.${this.usesPad ? " The stick is centered; the keyboard flies." : ""}`);
    else if (this.usesPad) this.onNotice(`${name} flies.`);
    else this.onNotice(`${name} is plugged in. To fly with it, choose Gamepad in the menu of the top bar.`);
    this.padName = name;
  }

  /** The pad wins on every axis where it is off center; keys and mouse keep the others. */
  addGamepad(dt) {
    if (!this.mouse.active) this.source = this.padName;
    for (const axis of AXES) {
      const value = this.gamepads.shaped(axis);
      if (value === 0) continue;
      this.moved[axis] = value;
      this.notice();
    }
    const throttle = this.gamepads.raw("throttle");
    if (this.gamepads.hasLever) this.stick.throttle = (1 + throttle) / 2;
    else this.stick.throttle = clamp(this.stick.throttle + throttle * THROTTLE_RATE * dt, 0, 1);
  }
}
