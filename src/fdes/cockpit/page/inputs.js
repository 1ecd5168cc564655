/** The Inputs tab: test inputs on the surfaces, perturbations of the state, and how the equations are solved. */

import { html } from "./dom.js";
import { button, choice, row } from "./fields.js";
import { HoldForm } from "./hold_form.js";
import { InputForm } from "./input_form.js";
import { Tabs } from "./tabs.js";
import { figure } from "./units.js";

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
export const INTEGRATORS = ["rk4", "exact", "dopri5", "kutta_merson", "heun", "euler"];
const STEPS = [1 / 120, 0.02, 0.04, 0.1, 0.2, 0.3, 0.5];

export class InputsPanel {
  /** `command(name, fields)` sends a command, shows its error, and says whether it was obeyed; `link` is the wire. */
  constructor(panel, command, link) {
    this.command = command;
    this.plant = choice("Plant", [["linear", "Linear, small perturbations"], ["nonlinear", "Nonlinear, six degrees of freedom"]], "linear");
    this.plant.select.addEventListener("change", () => this.command("plant", { plant: this.plant.select.value }).then((done) => done || this.show(this.aircraft)));
    this.form = choice("Equations", FORMS, "full");
    this.integrator = choice("Integrator", INTEGRATORS, "rk4");
    this.step = choice("Step", STEPS.map(stepName), stepName(STEPS[0]));
    this.limit = html("p", { class: "step-limit", role: "status" });
    this.input = new InputForm(link, command);
    this.hold = new HoldForm(command);
    const ready = row(READY.map(([name, text]) => button(name, () => this.command("input", { text }))));
    const disturb = row(DISTURBANCES.map(([name, text]) => button(name, () => this.command("disturb", { text }))));
    const solve = html(
      "div",
      { class: "form-row" },
      this.plant.label,
      this.form.label,
      this.integrator.label,
      this.step.label,
      button("Fly from trim with these", () => this.solve()),
    );
    const pages = {
      "Ready-made": [html("h3", {}, "Put in a test input"), ready, html("h3", {}, "Disturb the state"), disturb],
      "Test input": [this.input.element],
      Hold: [this.hold.element],
      Equations: [solve, this.limit],
    };
    const list = html("div", { role: "tablist", class: "sub", "aria-label": "Kinds of inputs" });
    panel.replaceChildren(list);
    for (const [name, children] of Object.entries(pages)) {
      const id = `inputs-${name.toLowerCase().replace(" ", "-")}`;
      list.append(html("button", { role: "tab", id: `tab-${id}`, "data-tab": id, "aria-controls": id }, name));
      panel.append(html("div", { role: "tabpanel", id, "aria-labelledby": `tab-${id}` }, children));
    }
    this.tabs = new Tabs(list);
    link.on("aircraft", (aircraft) => this.show(aircraft));
    link.on("status", ({ held }) => this.hold.show(held));
    link.on("hello", () => this.input.changed());
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
    this.aircraft = aircraft;
    this.plant.select.value = aircraft.plant;
    this.form.select.value = aircraft.form;
    this.integrator.select.value = aircraft.integrator;
    const nearest = STEPS.reduce((a, b) => (Math.abs(b - aircraft.dt) < Math.abs(a - aircraft.dt) ? b : a));
    this.step.select.selectedIndex = STEPS.indexOf(nearest);
    const limit = aircraft.step_limit;
    const whose = aircraft.plant === "linear" ? "" : ", of the linearized aircraft";
    const beyond = limit !== null && limit !== undefined && aircraft.dt > limit.step;
    this.limit.classList.toggle("is-beyond", beyond);
    this.limit.textContent = limit
      ? `${aircraft.integrator} is stable up to ${figure(limit.step, 3)} s here (${limit.mode.replaceAll("_", " ")}${whose}).` +
        (beyond ? " This step is beyond it: what grows is the integrator's doing." : "")
      : `${aircraft.integrator} is stable at every step here.`;
  }
}

function stepName(step) {
  return step < 0.01 ? `1/${Math.round(1 / step)} s` : `${step} s`;
}
