/**
 * The dialog that sets a gamepad up: what moves what, how far it travels, how it feels, which button does what. Fetched
 * when it is opened. Every change holds at once and is remembered for the device; while the dialog is open nothing flies it.
 */

import { fetchStyle, html, svg } from "./dom.js";
import { button, choice, refill } from "./fields.js";
import { nameOf } from "./gamepad.js";
import { Calibration, Capture } from "./gamepad_capture.js";
import { CONTROLS, CURVES, DEAD_ZONES, axis, pair, travelOf } from "./gamepad_mapping.js";
import { ActionRow, ControlRow, SENSES } from "./gamepad_rows.js";
import { KEYS } from "./keys.js";
import { ShapingCurve } from "./shaping_curve.js";

const RESTING = "The pad moves its bars here, not the aircraft. Changes hold at once and are remembered for this device.";
const LET_GO = "Let go of the stick and the pedals, so that they rest in their centers. Then press Next.";
const MOVE_ALL = "Move every stick, pedal and lever from stop to stop, a few times. Then press Done.";
const PAD = "M30 18h40c14 0 20 8 23 24s3 26-5 28-14-12-22-14H34c-8 2-14 16-22 14s-8-12-5-28 9-24 23-24zM31 30v16M23 38h16M64 34h.1M72 40h.1M64 46h.1M56 40h.1";

export class GamepadDialog {
  constructor(stick) {
    this.stick = stick;
    this.gamepads = stick.gamepads;
    this.waiting = null; // {control or action, capture, plus}: what is being assigned
    this.calibration = null;
    this.devices = "";
    this.shown = null; // the mapping that the words tell of
    fetchStyle("/page/gamepad.css");
    this.build();
    document.body.append(this.element);
  }

  build() {
    this.device = choice("Device", []);
    this.device.select.addEventListener("change", () => this.chooseDevice(Number(this.device.select.value)));
    this.facts = html("small", {});
    this.rows = CONTROLS.map((control) => new ControlRow(control, () => this.assign({ control }), (invert) => this.alter(control, { invert })));
    this.actions = KEYS.map((entry) => new ActionRow(entry, () => this.assign({ action: entry.action }), () => this.setAction(entry.action, null)));
    this.says = html("p", { role: "status" });
    this.escape = html("small", { hidden: true }, html("kbd", {}, "Esc"), " cancels");
    this.next = button("Calibrate", () => this.calibrate());
    this.stop = button("Cancel", () => this.cancel());
    this.reset = button("Reset to usual mapping", () => this.toUsual());
    this.curve = new ShapingCurve();
    this.live = html("small", { class: "number" });
    this.feel = [
      this.slider("deadZone", "Dead zone", DEAD_ZONES, 0.01, (value) => `${Math.round(100 * value)} %`),
      this.slider("curve", "Curve", CURVES, 0.1, (value) => `${value.toFixed(1)}${value === 1 ? " (straight)" : ""}`),
    ];
    const close = html("button", { class: "icon", "aria-label": "Close", onclick: () => this.element.close() }, "✕");
    this.whole = html(
      "div",
      { class: "pad-whole" },
      html(
        "section",
        { "aria-label": "What moves what" },
        html("div", { class: "pad-device" }, this.device.label, this.facts),
        this.rows.map(({ element }) => element),
        html("div", { class: "pad-says" }, this.says, this.escape),
        html("div", { class: "button-row" }, this.next, this.stop, this.reset),
      ),
      html("section", { class: "pad-feel", "aria-label": "Dead zone and curve" }, this.curve.element, this.live, this.feel.map(({ element }) => element)),
      html("section", { class: "pad-actions", "aria-labelledby": "pad-actions-title" }, html("h3", { id: "pad-actions-title" }, "Buttons"), html("div", {}, this.actions.map(({ element }) => element))),
    );
    this.teaches = html("p", {});
    this.empty = html(
      "div",
      { class: "pad-empty" },
      svg("svg", { viewBox: "0 0 100 84", "aria-hidden": "true" }, svg("path", { d: PAD })),
      html("h3", {}, "No gamepad is seen"),
      this.teaches,
      html("p", { class: "quietly" }, "A browser shows a device to a page only after one of its buttons has been pressed there. The keyboard flies until then."),
    );
    this.element = html(
      "dialog",
      { id: "gamepad", "aria-labelledby": "gamepad-title" },
      html("div", { class: "dialog-head" }, html("h2", { id: "gamepad-title" }, "Set up the gamepad"), close),
      html("div", { class: "dialog-body" }, this.whole, this.empty),
    );
    this.element.addEventListener("click", ({ target }) => target === this.element && this.element.close()); // beside it
    this.element.addEventListener("close", () => this.leave());
    this.element.addEventListener("keydown", (event) => this.key(event));
  }

  slider(part, words, [min, max], step, say) {
    const input = html("input", { type: "range", min, max, step, "aria-label": words });
    const output = html("output", { class: "number" });
    const show = (value) => {
      if (input.value !== String(value)) input.value = value;
      output.textContent = say(value);
      input.setAttribute("aria-valuetext", say(value));
    };
    input.addEventListener("input", () => this.gamepads.pad && this.gamepads.change({ [part]: Number(input.value) }));
    return { part, show, element: html("div", {}, html("span", {}, words, output), input) };
  }

  open() {
    this.gamepads.isBeingSetUp = true;
    this.stick.mouse.center();
    this.says.textContent = RESTING;
    this.lost = null;
    this.tick(performance.now());
    this.element.showModal();
  }

  leave() {
    this.cancel();
    this.gamepads.isBeingSetUp = false;
    cancelAnimationFrame(this.frame);
  }

  /** Escape ends what is under way, and only then the dialog. */
  key(event) {
    if (event.key !== "Escape" || !(this.waiting || this.calibration)) return;
    event.preventDefault();
    this.cancel();
  }

  tick(now) {
    this.frame = requestAnimationFrame((time) => this.tick(time));
    const pad = this.gamepads.find();
    this.whole.hidden = !pad;
    this.empty.hidden = Boolean(pad);
    if (!pad) return this.beWithout();
    this.lost = this.gamepads.name;
    this.listDevices();
    if (this.waiting) this.listen(pad, now);
    this.calibration?.measure?.follow(pad);
    if (this.gamepads.mapping !== this.shown) this.describe(pad);
    this.showLive();
    return undefined;
  }

  beWithout() {
    if (this.waiting || this.calibration) this.cancel();
    const words = this.lost ? `${this.lost} is unplugged. Plug it in again and press one of its buttons.` : "Plug one in and press one of its buttons.";
    if (this.teaches.textContent !== words) this.teaches.textContent = words;
    if (document.activeElement === document.body) this.element.querySelector(".icon").focus(); // what had the focus is hidden
  }

  listDevices() {
    const { all, pad } = this.gamepads;
    const now = all.map(({ index, id }) => `${index} ${id}`).join("\n") + pad.index;
    if (now === this.devices) return;
    this.devices = now;
    this.cancel();
    refill(this.device, all.map((each) => [String(each.index), `${all.length > 1 ? `${each.index}: ` : ""}${nameOf(each)}`]), String(pad.index));
    this.device.select.title = pad.id;
    this.device.select.disabled = all.length < 2;
    const layout = pad.mapping === "standard" ? "standard layout" : "its own layout";
    this.facts.textContent = `${pad.axes.length} axes, ${pad.buttons.length} buttons, ${layout}${all.length > 1 ? "; the chosen one flies" : ""}`;
  }

  chooseDevice(index) {
    const pad = this.gamepads.all.find((each) => each.index === index);
    if (pad) this.gamepads.choose(pad);
  }

  /** Words, switches and sliders, when the mapping has become another one. */
  describe(pad) {
    const { mapping } = this.gamepads;
    this.shown = mapping;
    for (const row of this.rows) {
      const from = mapping[row.control];
      const same = CONTROLS.filter((other) => other !== row.control && from.axis !== undefined && mapping[other].axis === from.axis);
      row.describe(from, pad, same.map((other) => SENSES[other].name));
    }
    this.describeActions();
    for (const { part, show } of this.feel) show(mapping[part]);
    this.curve.draw(mapping);
  }

  describeActions() {
    const { mapping } = this.gamepads;
    for (const row of this.actions) {
      const number = mapping.actions[row.action];
      row.describe(number, this.waiting?.action === row.action, number === undefined ? "" : this.movedBy(number));
    }
  }

  /** Which controls a button moves, in words. */
  movedBy(number) {
    const { mapping } = this.gamepads;
    return CONTROLS.filter((control) => mapping[control].plus === number || mapping[control].minus === number).join(" and ");
  }

  alsoMoves(number) {
    const moves = this.movedBy(number);
    return moves && ` It also moves ${moves}.`;
  }

  showLive() {
    let furthest = this.rows[0].control;
    for (const { control } of this.rows.slice(1, 3)) if (Math.abs(this.gamepads.raw(control)) > Math.abs(this.gamepads.raw(furthest))) furthest = control;
    for (const row of this.rows) {
      const raw = this.gamepads.raw(row.control);
      const isThrottle = row.control === "throttle"; // which is not shaped
      row.show(raw, isThrottle ? raw : this.gamepads.shaped(row.control), isThrottle && this.gamepads.hasLever);
      const measured = this.calibration?.measure?.axes[this.gamepads.mapping[row.control].axis];
      if (measured) row.showTravel(measured);
    }
    this.curve.show(this.gamepads.raw(furthest), this.gamepads.shaped(furthest));
    const words = `Point: ${SENSES[furthest].name.toLowerCase()}`;
    if (this.live.textContent !== words) this.live.textContent = words;
  }

  /** Waits for what is to move `control` or to do `action`; asked a second time for the same, it gives up. */
  assign({ control = null, action = null }) {
    const again = this.waiting && this.waiting.control === control && this.waiting.action === action;
    this.cancel();
    if (again) return;
    this.waiting = { control, action, plus: null, capture: new Capture(this.gamepads.pad, { axes: control !== null }) };
    this.tell(control ? SENSES[control].ask : `Press the button for: ${doesOf(action)}.`);
  }

  listen(pad, now) {
    const { control, action, plus, capture } = this.waiting;
    const found = capture.follow(pad, now);
    if (!found) return;
    if (action) this.finish(() => this.setAction(action, found.button), `Button ${found.button}: ${doesOf(action)}.${this.alsoMoves(found.button)}`);
    else if (found.axis !== undefined) this.finish(() => this.setAxis(control, found), `Axis ${found.axis} moves ${control}.`);
    else if (plus !== null) this.finish(() => this.set(control, pair(plus, found.button)), `Buttons ${plus} and ${found.button} move ${control}.`);
    else {
      Object.assign(this.waiting, { plus: found.button, capture: new Capture(pad, { axes: false, except: found.button }) });
      this.tell(`Button ${found.button}. ${SENSES[control].other}`);
    }
  }

  finish(assign, words) {
    this.waiting = null;
    assign();
    this.tell(words, false);
  }

  set(control, from) {
    this.gamepads.change({ [control]: from });
  }

  alter(control, parts) {
    this.set(control, { ...this.gamepads.mapping[control], ...parts });
  }

  /** An axis keeps the travel that was measured for it. */
  setAxis(control, { axis: number, change }) {
    const known = CONTROLS.map((each) => this.gamepads.mapping[each]).find((from) => from.axis === number);
    this.set(control, { ...axis(number, change < 0), ...(known && travelOf(known)) });
  }

  /** A button does one thing: what it did before, it does no longer. */
  setAction(action, number) {
    const others = Object.entries(this.gamepads.mapping.actions).filter(([name, button]) => name !== action && button !== number);
    this.gamepads.change({ actions: Object.fromEntries(number === null ? others : [...others, [action, number]]) });
  }

  /** The button's three turns: begin, centers are taken, travels are taken. */
  calibrate() {
    if (!this.calibration) {
      this.cancel();
      this.calibration = { measure: null };
      this.tell(LET_GO);
    } else if (!this.calibration.measure) {
      this.calibration.measure = new Calibration(this.gamepads.pad);
      this.tell(MOVE_ALL);
    } else this.takeTravels();
  }

  takeTravels() {
    const { measure } = this.calibration;
    const parts = {};
    const unmoved = [];
    for (const control of CONTROLS) {
      const from = this.gamepads.mapping[control];
      if (from.axis === undefined) continue;
      const travel = measure.travel(from.axis, control === "throttle");
      if (travel) parts[control] = { ...from, ...travel };
      else unmoved.push(control);
    }
    this.calibration = null;
    this.gamepads.change(parts);
    const measured = Object.keys(parts);
    const done = measured.length ? `Measured: ${measured.join(", ")}.` : "Nothing was measured.";
    this.tell(done + (unmoved.length ? ` Not moved far enough, and left as before: ${unmoved.join(", ")}.` : ""), false);
  }

  toUsual() {
    this.cancel();
    this.gamepads.change(null);
    this.tell("The usual mapping of such a device.", false);
  }

  /** Gives up what is under way. */
  cancel() {
    this.waiting = null;
    this.calibration = null;
    this.tell(RESTING, false);
  }

  tell(words, asks = true) {
    this.says.textContent = words;
    this.says.classList.toggle("asks", asks);
    this.escape.hidden = !asks;
    for (const row of this.rows) row.wait(this.waiting !== null && this.waiting.control === row.control);
    if (this.gamepads.mapping) this.describeActions();
    this.next.textContent = !this.calibration ? "Calibrate" : this.calibration.measure ? "Done" : "Next";
    this.stop.hidden = !this.calibration;
    this.reset.hidden = Boolean(this.calibration);
  }
}

const doesOf = (action) => KEYS.find((each) => each.action === action).does;
