/**
 * The steps of the first-flight tour. Each is done by flying: `does` says what, `notice` what is to be seen meanwhile,
 * `isDone` looks at what the pilot has done since the step began (a Watch). A step in two parts has `first`: what is
 * done before it does not count. `after` says what came of it, and `points` at what is to be pressed.
 */

import { html } from "./dom.js";
import { KEYS } from "./keys.js";
import { DEG, figure, halfTurn } from "./units.js";

const BANKED = 15 * DEG;
const LEVEL = 10 * DEG;
const STEADY = 6 * DEG; // a second
const GRAVITY = 9.80665; // m/s^2
const SHOWN_FOR = 1.5; // s: nobody rolls out on purpose sooner
const SETTLES = 2; // s in which the eye follows a motion that has been excited
const SAMPLE = "Cm_q";

const kbd = (name) => html("kbd", {}, name);
const keyOf = (action) => kbd(KEYS.find((entry) => entry.action === action).keys[0]);

/** What a pilot who flies by `control` moves and presses: keys, or the words for it. */
export function handles(control) {
  const byKeys = control === "keyboard";
  const byTouch = control === "touch";
  return {
    right: byKeys ? kbd("→") : "the stick right",
    level: byKeys ? [kbd("←"), " and ", kbd("→")] : ["the stick"],
    aft: byKeys ? kbd("↓") : "the stick aft",
    pedal: byTouch ? "the right pedal" : kbd("X"),
    freeze: byTouch ? "Freeze" : keyOf("freeze"),
    again: byTouch ? "Resume" : keyOf("freeze"),
    reset: byTouch ? "Reset" : keyOf("reset"),
    law: byTouch ? "Engage in the tab Control" : keyOf("law"),
  };
}

/** Steps for an aircraft with these `knobs`: one whose derivatives are dimensional has no Cm_q to change. */
export function stepsFor(knobs) {
  return STEPS.filter(({ knob }) => !knob || knobs.some(({ name }) => name === knob));
}

const mode = (modes, name) => modes.find((each) => each.name === name);

/** The `figures` of a mode as ", symbol value unit", or nothing where the aircraft has no such mode. */
function figuresOf(modes, name, ...figures) {
  const found = mode(modes, name);
  return found ? figures.map(([symbol, of, unit]) => `, ${symbol} ${figure(found[of], 2)}${unit}`).join("") : "";
}

/** How the damping ratio of mode `name` has changed; nothing where it has become two real roots. */
function damping(watch, name, says, hint) {
  const [before, now] = [mode(watch.modesBefore, name), mode(watch.modes, name)];
  if (!before || !now) return null;
  return `${says}: its ζ was ${figure(before.zeta, 2)} and is ${figure(now.zeta, 2)}. ${hint}`;
}

const STEPS = [
  {
    does: ({ right }) => ["Bank: hold ", right, " until the bank angle φ passes 15°, then let go."],
    notice: ({ modes }) =>
      `The stick commands a roll rate p, reached as the roll mode says${figuresOf(modes, "roll", ["τ", "time_constant", " s"])}; φ then stays.`,
    isDone: ({ state }) => halfTurn(state.phi) > BANKED,
  },
  {
    does: ({ level }) => ["Watch the heading increase; then level the wings with taps of ", ...level, "."],
    notice: ({ state }) =>
      `A bank is a turn: the rate of heading is g/V · tan φ, here ${figure((GRAVITY / state.V) * Math.tan(BANKED) / DEG, 2)}°/s at φ = 15°.`,
    isDone: ({ state, seconds }) => seconds > SHOWN_FOR && Math.abs(halfTurn(state.phi)) < LEVEL && Math.abs(state.p) < STEADY,
  },
  {
    does: ({ aft }) => ["Pull: tap ", aft, " and let go. Look at the strip charts while it settles."],
    notice: ({ modes }) =>
      `α and q swing and die out at once: the short period${figuresOf(modes, "short_period", ["ωn", "omega_n", " rad/s"], ["ζ", "zeta", ""])}.`,
    isDone: ({ sincePull }) => sincePull > SETTLES,
  },
  {
    does: ({ freeze, again }) => ["Freeze with ", freeze, ", look back at your pull, and fly on with ", again, "."],
    notice: () => "Frozen, the slider beside “Strip charts” goes back through the last two minutes.",
    points: ["#freeze"],
    first: ({ frozen }) => frozen,
    isDone: ({ frozen }) => !frozen,
  },
  {
    knob: SAMPLE,
    does: ({ aft }) => ["In the tab Stability drag ", html("b", {}, SAMPLE), " to 0; then tap ", aft, " again."],
    notice: () => "Less pitch damping: the short period swings longer, in the charts and under your hand.",
    after: (watch) => damping(watch, "short_period", "You have changed the short period", "Reset all takes that back."),
    points: [`#panel-stability:not([hidden]) [data-knob=${SAMPLE}]`, "#tab-stability"],
    first: ({ changes }) => changes.some((change) => change.startsWith(SAMPLE)),
    isDone: ({ sincePull }) => sincePull > SETTLES,
  },
  {
    does: ({ reset, pedal }) => ["Back to trim with ", reset, "; then hold ", pedal, ", the right rudder, for a second and let go."],
    notice: ({ modes }) =>
      `The nose swings and the wings rock: the Dutch roll${figuresOf(modes, "dutch_roll", ["period", "period", " s"], ["ζ", "zeta", ""])}. Compare φ with β.`,
    points: ["[data-action=reset]"],
    first: ({ wasReset }) => wasReset,
    isDone: ({ sinceKick }) => sinceKick > SETTLES,
  },
  {
    does: ({ law, pedal }) => ["Engage the yaw damper with ", law, ", and kick ", pedal, " again."],
    notice: () => "The law moves the rudder against the yaw rate r: δr in the charts is no longer yours alone.",
    after: (watch) => damping(watch, "dutch_roll", "The damper at work on the Dutch roll", "The tab Modes shows its crosses."),
    points: ["#panel-control:not([hidden]) .law-tools button", "#tab-control"],
    first: ({ laws }) => laws,
    isDone: ({ sinceKick }) => sinceKick > SETTLES,
  },
];

export const FAREWELL = {
  does: () => ["That was the tour: you have met the roll mode, the short period and the Dutch roll."],
  notice: () => "V looks from outside, N flies the nonlinear aircraft, ? has all keys. “Reset all” undoes your changes.",
};
