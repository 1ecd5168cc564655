/**
 * What moves what on a gamepad: the usual mappings, and those remembered for each device under "fdes.gamepads".
 *
 * A control is an axis, {axis, invert, center, low, high}, or a pair of buttons, {plus, minus, invert}; `low`, `center` and
 * `high` are the readings at one stop, at rest and at the other stop. `actions` says which button does what.
 */

const KEY = "fdes.gamepads";
const MOST = 64; // axes or buttons of any device
const LEAST_TRAVEL = 0.1; // of an axis, to either side of its center
const FEEL = { deadZone: 0.06, curve: 1.4 }; // share of the travel; exponent, finer near the center

export const CONTROLS = ["pitch", "roll", "yaw", "throttle"];
export const DEAD_ZONES = [0, 0.5];
export const CURVES = [0.5, 4];

export const axis = (number, invert = false) => ({ axis: number, invert, center: 0, low: -1, high: 1 });
export const pair = (plus, minus) => ({ plus, minus, invert: false });

// The standard mapping of the Gamepad API: left stick, triggers as pedals, cross up and down as throttle; upper face
// button, Back and Start.
const STANDARD = {
  pitch: axis(1),
  roll: axis(0),
  yaw: pair(7, 6),
  throttle: pair(12, 13),
  actions: { view: 3, reset: 8, freeze: 9 },
  ...FEEL,
};
// A joystick of four axes: its grip twists, and its lever is pushed forward to -1.
const JOYSTICK = { pitch: axis(1), roll: axis(0), yaw: axis(2), throttle: axis(3, true), actions: {}, ...FEEL };

const isNumber = (value, [low, high]) => Number.isFinite(value) && value >= low && value <= high;
const isIndex = (value) => Number.isInteger(value) && isNumber(value, [0, MOST - 1]);

export const usualMapping = (pad) => ({ ...(pad.mapping === "standard" ? STANDARD : JOYSTICK) });

/** The device's usual mapping, with what is remembered for it where that makes sense. */
export function mappingOf(pad) {
  const mapping = usualMapping(pad);
  const kept = allRemembered()[pad.id];
  for (const control of CONTROLS) mapping[control] = checked(kept?.[control]) ?? mapping[control];
  if (isNumber(kept?.deadZone, DEAD_ZONES)) mapping.deadZone = kept.deadZone;
  if (isNumber(kept?.curve, CURVES)) mapping.curve = kept.curve;
  if (kept?.actions && typeof kept.actions === "object")
    mapping.actions = Object.fromEntries(Object.entries(kept.actions).filter(([, button]) => isIndex(button)));
  return mapping;
}

/** An axis or a pair of buttons as it was kept, or undefined where it is neither. */
function checked(from) {
  const invert = from?.invert === true;
  if (isIndex(from?.axis)) {
    const whole = axis(from.axis, invert);
    const travel = travelOf({ ...whole, ...from });
    return isTravel(travel) ? { ...whole, ...travel } : whole;
  }
  if (isIndex(from?.plus) && isIndex(from?.minus)) return { ...pair(from.plus, from.minus), invert };
  return undefined;
}

export const travelOf = ({ center, low, high }) => ({ center, low, high });

/** Whether an axis can have this travel: every reading within -1..1, and enough of it to both sides of the center. */
export function isTravel({ center, low, high }) {
  return Number.isFinite(center) && isNumber(low, [-1, center - LEAST_TRAVEL]) && isNumber(high, [center + LEAST_TRAVEL, 1]);
}

/** Keeps the mapping of the device with this id; none: its usual one again. */
export function remember(id, mapping) {
  const { [id]: _, ...others } = allRemembered();
  try {
    localStorage.setItem(KEY, JSON.stringify(mapping ? { ...others, [id]: mapping } : others));
  } catch {
    return; // storage may be forbidden: the mapping then lasts until the page is closed
  }
}

// Storage may be forbidden, or hold what another program left there: every device then has its usual mapping.
function allRemembered() {
  try {
    return { ...JSON.parse(localStorage.getItem(KEY)) };
  } catch {
    return {};
  }
}
