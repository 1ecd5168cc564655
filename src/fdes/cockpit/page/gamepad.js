/**
 * A gamepad or joystick as a stick. What moves what is a mapping, remembered for each device under "fdes.gamepads":
 * a control is an axis ({axis, invert, center}) or a pair of buttons ({plus, minus}).
 */

import { clamp } from "./units.js";

const KEY = "fdes.gamepads";
const CONTROLS = ["pitch", "roll", "yaw", "throttle"];
const MOST = 64; // axes or buttons of any device
const FEEL = { deadZone: 0.06, curve: 1.4 }; // share of the travel; exponent, finer near the center
const axis = (number, invert = false) => ({ axis: number, invert, center: 0 });

// The standard mapping of the Gamepad API: left stick, triggers as pedals, cross up and down as throttle.
const STANDARD = { pitch: axis(1), roll: axis(0), yaw: { plus: 7, minus: 6 }, throttle: { plus: 12, minus: 13 }, ...FEEL };
// A joystick of four axes: its grip twists, and its lever is pushed forward to -1.
const JOYSTICK = { pitch: axis(1), roll: axis(0), yaw: axis(2), throttle: axis(3, true), ...FEEL };

const isNumber = (value, low, high) => Number.isFinite(value) && value >= low && value <= high;
const isIndex = (value) => Number.isInteger(value) && isNumber(value, 0, MOST - 1);

export class Gamepads {
  constructor() {
    this.pad = null;
    this.mapping = STANDARD;
    this.lastId = null;
  }

  /** The first connected device, or null. Finds its mapping when the device is another one. */
  find() {
    const pads = navigator.getGamepads?.() ?? [];
    this.pad = null;
    for (let i = 0; i < pads.length && !this.pad; i += 1) if (pads[i]?.connected) this.pad = pads[i];
    if (this.pad && this.pad.id !== this.lastId) {
      this.lastId = this.pad.id;
      this.mapping = mappingOf(this.pad);
    }
    if (!this.pad) this.lastId = null;
    return this.pad;
  }

  get name() {
    return this.pad.id.replace(/\s*\(.*/, "").slice(0, 18) || "Gamepad";
  }

  /** Where `control` stands, -1 to 1, before dead zone and curve. */
  raw(control) {
    const from = this.mapping[control];
    if (from.axis === undefined) return this.button(from.plus) - this.button(from.minus);
    const value = (this.pad.axes[from.axis] ?? from.center) - from.center;
    const span = 1 - Math.sign(value) * from.center; // of the side that the axis is on
    return clamp((from.invert ? -value : value) / span, -1, 1);
  }

  /** Where the stick is on `control`, -1 to 1; exactly 0 inside the dead zone. */
  shaped(control) {
    const { deadZone, curve } = this.mapping;
    const raw = this.raw(control);
    const size = Math.abs(raw);
    return size <= deadZone ? 0 : Math.sign(raw) * ((size - deadZone) / (1 - deadZone)) ** curve;
  }

  /** Whether the throttle is a lever, which says where it stands, rather than a pair of buttons, which move it. */
  get hasLever() {
    const from = this.mapping.throttle;
    return from.axis !== undefined && from.axis < this.pad.axes.length;
  }

  button(number) {
    return this.pad.buttons[number]?.value ?? 0;
  }
}

/** The device's usual mapping, with what is remembered for it where that makes sense. */
function mappingOf(pad) {
  const mapping = { ...(pad.mapping === "standard" ? STANDARD : JOYSTICK) };
  const kept = remembered(pad.id);
  for (const control of CONTROLS) {
    const from = kept?.[control];
    if (isIndex(from?.axis))
      mapping[control] = {
        axis: from.axis,
        invert: from.invert === true,
        center: isNumber(from.center, -0.9, 0.9) ? from.center : 0,
      };
    else if (isIndex(from?.plus) && isIndex(from?.minus)) mapping[control] = { plus: from.plus, minus: from.minus };
  }
  if (isNumber(kept?.deadZone, 0, 0.9)) mapping.deadZone = kept.deadZone;
  if (isNumber(kept?.curve, 0.5, 4)) mapping.curve = kept.curve;
  return mapping;
}

// Storage may be forbidden, or hold what another program left there: the device then has its usual mapping.
function remembered(id) {
  try {
    return JSON.parse(localStorage.getItem(KEY))?.[id];
  } catch {
    return undefined;
  }
}
