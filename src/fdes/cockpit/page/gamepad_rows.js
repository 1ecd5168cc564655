/** Rows of the gamepad's set-up: one for each control, with its live bar, and one for each action that a button may have. */

import { html } from "./dom.js";

/** Each control with its two senses, and what is asked of whoever assigns it: the first way, and the other for buttons. */
export const SENSES = {
  pitch: {
    name: "Pitch",
    ends: ["push", "pull"],
    ask: "Pull the stick fully back, or press the button that is to pull.",
    other: "Now the button that is to push.",
  },
  roll: {
    name: "Roll",
    ends: ["left", "right"],
    ask: "Move the stick fully right, or press the button that is to bank right.",
    other: "Now the button that is to bank left.",
  },
  yaw: {
    name: "Yaw",
    ends: ["left", "right"],
    ask: "Press the right pedal fully, twist the grip right, or press the button that is the right pedal.",
    other: "Now the button that is the left pedal.",
  },
  throttle: {
    name: "Throttle",
    ends: ["idle", "full"],
    ask: "Push the lever fully forward, or press the button that is to add thrust.",
    other: "Now the button that is to take thrust away.",
  },
};

const signed = (reading) => reading.toFixed(2).replace("-", "−");
const percent = (share) => `${Math.round(100 * share)} %`;

/** A label that is only written when it changes. */
function write(element, text) {
  if (element.textContent !== text) element.textContent = text;
}

export class ControlRow {
  /** `assign` and `invert(on)` are called when somebody asks for it. */
  constructor(control, assign, invert) {
    Object.assign(this, { control, sense: SENSES[control] });
    const { name, ends } = this.sense;
    this.from = html("small", {});
    this.raw = html("i", { class: "raw" });
    this.fill = html("i", { class: "shaped" });
    this.figures = html("span", { class: "figures number" });
    this.invert = html("input", { type: "checkbox", "aria-label": `Invert ${name.toLowerCase()}`, onchange: () => invert(this.invert.checked) });
    this.button = html("button", { type: "button", onclick: assign }, "Assign");
    this.element = html(
      "div",
      { class: "control-row", role: "group", "aria-label": name, "data-control": control },
      html("div", { class: "control-name" }, html("b", {}, name), this.from),
      html("div", { class: "live-bar", "aria-hidden": "true" }, html("span", {}, ends[0]), html("div", { class: "track" }, this.fill, this.raw), html("span", {}, ends[1])),
      this.figures,
      html("label", {}, this.invert, " Invert"),
      this.button,
    );
  }

  /** What the control is mapped to. `others`: names of controls on the same axis. */
  describe(from, pad, others) {
    write(this.from, wordsOf(from, pad) + (others.length ? `; also ${others.join(", ")}` : ""));
    this.from.classList.toggle("doubtful", others.length > 0 || !exists(from, pad));
    this.invert.checked = from.invert;
  }

  /** Where the control stands, raw and shaped; a lever from 0 to 1, everything else -1..1. */
  show(raw, shaped, isLever) {
    this.raw.style.left = `${50 + 50 * raw}%`;
    const [from, to] = isLever ? [-1, shaped] : [Math.min(0, shaped), Math.max(0, shaped)];
    this.fill.style.left = `${50 + 50 * from}%`;
    this.fill.style.width = `${50 * (to - from)}%`;
    write(this.figures, this.wordsFor(raw, shaped, isLever));
  }

  wordsFor(raw, shaped, isLever) {
    if (isLever) return percent((1 + raw) / 2);
    const sense = this.sense.ends[raw > 0 ? 1 : 0];
    if (this.control === "throttle") return raw === 0 ? "as it stands" : `towards ${sense}`;
    return raw === 0 ? "0 %" : `${sense} ${percent(Math.abs(raw))} → ${percent(Math.abs(shaped))}`;
  }

  /** How far the axis of this control has been moved so far, as the device reads it. */
  showTravel({ low, high }) {
    write(this.figures, `${signed(low)} to ${signed(high)}`);
  }

  /** Whether this row waits for a movement. */
  wait(waits) {
    this.element.classList.toggle("waits", waits);
    write(this.button, waits ? "Cancel" : "Assign");
    this.button.setAttribute("aria-label", `${waits ? "Cancel assigning" : "Assign"} ${this.sense.name.toLowerCase()}`);
  }
}

const exists = (from, pad) =>
  from.axis === undefined ? Math.max(from.plus, from.minus) < pad.buttons.length : from.axis < pad.axes.length;

/** "Axis 1, inverted" or "Buttons 7 − 6". */
function wordsOf(from, pad) {
  const name = from.axis === undefined ? `Buttons ${from.plus} − ${from.minus}` : `Axis ${from.axis}`;
  if (!exists(from, pad)) return `${name}: this device has none`;
  return name + (from.invert ? ", inverted" : "");
}

export class ActionRow {
  /** `entry` is one of keys.js; `assign` and `clear` are called when somebody asks for it. */
  constructor(entry, assign, clear) {
    Object.assign(this, { action: entry.action, does: entry.does });
    this.button = html("button", { type: "button", onclick: assign });
    this.clear = html("button", { type: "button", class: "quiet", "aria-label": `No button for: ${entry.does}`, title: "No button", onclick: clear }, "✕");
    this.element = html("div", { class: "action-row", "data-action-row": entry.action }, html("span", {}, entry.does), this.button, this.clear);
  }

  /** `number` of its button, or none; whether it waits for one; whether that button moves a control too. */
  describe(number, waits, moves) {
    const is = number === undefined ? "Assign" : `Button ${number}`;
    write(this.button, waits ? "Press it…" : is);
    const also = moves ? `; it also moves ${moves}` : "";
    this.button.setAttribute("aria-label", `${waits ? "Cancel assigning" : is}: ${this.does}${also}`);
    this.button.title = also && is + also;
    this.button.classList.toggle("doubtful", Boolean(moves));
    this.button.classList.toggle("is-set", number !== undefined);
    this.element.classList.toggle("waits", waits);
    this.clear.style.visibility = number === undefined ? "hidden" : "visible";
  }
}
