/** A gamepad or joystick as a stick: which device flies, where its controls stand, and which of its buttons go down. */

import { mappingOf, remember, usualMapping } from "./gamepad_mapping.js";
import { clamp } from "./units.js";

const KEY = "fdes.gamepad"; // the id of the device that flies, where there are several
const DOWN = 0.5; // of a button's travel

export class Gamepads {
  constructor() {
    this.pad = null;
    this.mapping = null; // of the pad
    this.wanted = { id: recall(), index: null };
    this.seen = { id: null, index: null };
    this.down = null; // which buttons are; null until they have been looked at
    this.isBeingSetUp = false; // it then flies nothing, and its buttons do nothing
    this.onAction = () => {};
  }

  /** The device that flies, or null: the one that was chosen where it is connected, else the first. */
  find() {
    const pads = navigator.getGamepads?.() ?? [];
    let found = null;
    let best = -1;
    for (let i = 0; i < pads.length; i += 1) {
      if (!pads[i]?.connected) continue;
      const fit = pads[i].id !== this.wanted.id ? 0 : pads[i].index === this.wanted.index ? 2 : 1;
      if (fit > best) [found, best] = [pads[i], fit];
    }
    this.pad = found;
    if (found?.id !== this.seen.id || found?.index !== this.seen.index) this.meet(found);
    return found;
  }

  meet(pad) {
    this.seen = { id: pad?.id, index: pad?.index };
    this.down = null;
    this.mapping = pad && mappingOf(pad);
  }

  /** Every connected device. */
  get all() {
    return [...(navigator.getGamepads?.() ?? [])].filter((pad) => pad?.connected);
  }

  /** From now on `pad` flies whenever it is connected. */
  choose({ id, index }) {
    this.wanted = { id, index };
    keep(id);
    this.find();
  }

  /** Another mapping, remembered for this device: these parts of it, or (null) the usual one. */
  change(parts) {
    this.mapping = parts ? { ...this.mapping, ...parts } : usualMapping(this.pad);
    remember(this.pad.id, parts && this.mapping);
  }

  get name() {
    return nameOf(this.pad).slice(0, 18);
  }

  /** Where `control` stands, -1 to 1, before dead zone and curve. */
  raw(control) {
    const from = this.mapping[control];
    const value = from.axis === undefined ? this.button(from.plus) - this.button(from.minus) : this.travelled(from);
    return from.invert ? -value : value;
  }

  /** How far an axis is from its center, as a share of the travel to that side. */
  travelled({ axis, center, low, high }) {
    const value = (this.pad.axes[axis] ?? center) - center;
    return clamp(value / (value > 0 ? high - center : center - low), -1, 1);
  }

  /** Where the stick is on `control`, -1 to 1; exactly 0 inside the dead zone. */
  shaped(control) {
    return shape(this.raw(control), this.mapping);
  }

  /** Whether the throttle is a lever, which says where it stands, rather than a pair of buttons, which move it. */
  get hasLever() {
    const from = this.mapping.throttle;
    return from.axis !== undefined && from.axis < this.pad.axes.length;
  }

  button(number) {
    return this.pad.buttons[number]?.value ?? 0;
  }

  /** Tells the actions of buttons that have gone down since the last call; not of those that already were. */
  followButtons() {
    const first = this.down === null;
    this.down ??= [];
    for (let i = 0; i < this.pad.buttons.length; i += 1) {
      const isDown = this.button(i) > DOWN;
      if (isDown && !this.down[i] && !first) this.press(i);
      this.down[i] = isDown;
    }
  }

  press(number) {
    const { actions } = this.mapping;
    for (const action in actions) if (actions[action] === number) this.onAction(action);
  }
}

/** What a device calls itself, without its numbers. */
export const nameOf = ({ id }) => id.replace(/\s*\(.*/, "") || "Gamepad";

/** A deflection -1..1 after the dead zone and the curve. */
export function shape(raw, { deadZone, curve }) {
  const size = Math.abs(raw);
  return size <= deadZone ? 0 : Math.sign(raw) * ((size - deadZone) / (1 - deadZone)) ** curve;
}

// Storage may be forbidden: the first device then flies after every reload.
function recall() {
  try {
    return localStorage.getItem(KEY);
  } catch {
    return null;
  }
}

function keep(id) {
  try {
    localStorage.setItem(KEY, id);
  } catch {
    return;
  }
}
