/** The Inputs tab: test inputs on the surfaces, perturbations of the state, and how the equations are solved. */

import { html } from "./dom.js";
import { figure } from "./units.js";

// Shapes by the name the server knows, and what may be said of their time.
const SHAPES = {
  doublet: "for",
  step: null,
  pulse: "for",
  "3-2-1-1": "for",
  ramp: "for",
  sine: "period",
  sweep: "for",
  multisine: "for",
};
const CHANNELS = { elevator: "deg", aileron: "deg", rudder: "deg", throttle: "" };
const READY = [
  ["Elevator doublet", "doublet elevator 2deg for 1s"],
  ["Aileron pulse", "pulse aileron 5deg for 1s"],
  ["Rudder doublet", "doublet rudder 5deg for 1.5s"],
  ["Elevator 3-2-1-1", "3-2-1-1 elevator 2deg for 7s"],
];
const DISTURBANCES = [
  ["β + 5°", "beta=5deg"],
  ["φ + 20°", "phi=20deg"],
  ["θ + 5°", "theta=5deg"],
  ["u + 10 kt", "u=+10kt"],
];
const FORMS = ["full", "nelson", "paper"];
const INTEGRATORS = ["rk4", "exact", "dopri5", "kutta_merson", "heun", "euler"];
const STEPS = [1 / 120, 0.02, 0.04, 0.1, 0.2, 0.3, 0.5];

export class InputsPanel {
  /** `command(name, fields)` sends a command, shows its error, and says whether it was obeyed. */
  constructor(panel, command) {
    this.command = command;
    this.shape = choice("Shape", Object.keys(SHAPES), "doublet");
    this.channel = choice("On", Object.keys(CHANNELS), "elevator");
    this.amplitude = number("Amplitude", 2, 0.5);
    this.time = number("Time", 1, 0.1);
    this.form = choice("Equations", FORMS, "full");
    this.integrator = choice("Integrator", INTEGRATORS, "rk4");
    this.step = choice("Step", STEPS.map(stepName), stepName(STEPS[0]));
    this.limit = html("p", { class: "step-limit", role: "status" });
    this.unit = html("span", { class: "unit" });
    this.timeWord = html("span", { class: "unit" });
    for (const { select } of [this.shape, this.channel]) select.addEventListener("change", () => this.label());
    panel.replaceChildren(
      html("h3", {}, "Put in a test input"),
      row(READY.map(([name, text]) => button(name, () => this.command("input", { text })))),
      html(
        "div",
        { class: "form-row" },
        this.shape.label,
        this.channel.label,
        html("span", { class: "field" }, this.amplitude.label, this.unit),
        html("span", { class: "field", id: "input-time" }, this.time.label, this.timeWord),
        button("Put in", () => this.command("input", { text: this.text() })),
        button("End all", () => this.command("clear_inputs")),
      ),
      html("h3", {}, "Disturb the state"),
      row(DISTURBANCES.map(([name, text]) => button(name, () => this.command("disturb", { text })))),
      html("h3", {}, "Solve the equations"),
      html(
        "div",
        { class: "form-row" },
        this.form.label,
        this.integrator.label,
        this.step.label,
        button("Fly from trim with these", () => this.solve()),
      ),
      this.limit,
    );
    this.label();
  }

  /** The input as one would say it: ``doublet elevator 2deg for 1s``. */
  text() {
    const channel = this.channel.select.value;
    const word = SHAPES[this.shape.select.value];
    const said = [this.shape.select.value, channel, `${this.amplitude.input.value || "nothing"}${CHANNELS[channel]}`];
    if (word) said.push(word, `${this.time.input.value || "nothing"}s`);
    return said.join(" ");
  }

  label() {
    const word = SHAPES[this.shape.select.value];
    this.unit.textContent = CHANNELS[this.channel.select.value] || "of 1";
    this.timeWord.textContent = word === "period" ? "s period" : "s";
    this.time.label.parentElement.hidden = word === null;
  }

  solve() {
    return this.command("equations", {
      form: this.form.select.value,
      integrator: this.integrator.select.value,
      step: STEPS[this.step.select.selectedIndex],
    });
  }

  /** What is flown: `aircraft` as in the server's message. */
  show(aircraft) {
    this.form.select.value = aircraft.form;
    this.integrator.select.value = aircraft.integrator;
    const nearest = STEPS.reduce((a, b) => (Math.abs(b - aircraft.dt) < Math.abs(a - aircraft.dt) ? b : a));
    this.step.select.selectedIndex = STEPS.indexOf(nearest);
    const limit = aircraft.step_limit;
    const beyond = limit !== null && limit !== undefined && aircraft.dt > limit.step;
    this.limit.classList.toggle("is-beyond", beyond);
    this.limit.textContent = limit
      ? `${aircraft.integrator} is stable up to ${figure(limit.step, 3)} s here (${limit.mode.replaceAll("_", " ")}).` +
        (beyond ? " This step is beyond it: what grows is the integrator's doing." : "")
      : `${aircraft.integrator} is stable at every step here.`;
  }
}

function stepName(step) {
  return step < 0.01 ? `1/${Math.round(1 / step)} s` : `${step} s`;
}

function button(name, action) {
  return html("button", { type: "button", onclick: action }, name);
}

function row(children) {
  return html("div", { class: "button-row" }, children);
}

function choice(name, options, chosen) {
  const select = html(
    "select",
    {},
    options.map((option) => html("option", { value: option, selected: option === chosen }, option.replaceAll("_", "-"))),
  );
  return { select, label: html("label", {}, html("span", {}, name), select) };
}

function number(name, value, step) {
  const input = html("input", { type: "number", value, step });
  return { input, label: html("label", {}, html("span", {}, name), input) };
}
