/** The Flight control tab: control laws engaged in flight, their gains, actuators, and the diagram of what is in use. */

import { ControlDiagram } from "./control_diagram.js";
import { fetchStyle, html } from "./dom.js";
import { button, choice } from "./fields.js";
import { LawCard } from "./law_card.js";
import { MarginsView } from "./margins_view.js";
import { SensorFields } from "./sensor_fields.js";
import { Tabs } from "./tabs.js";
import { degrees, figure } from "./units.js";

const NONE = "direct";
const SENSORS = "sensors"; // said last: they are before all laws
const PERIOD = 60; // ms from law to law while a slider moves
const FIRST = "yaw_damper"; // what the key engages before anything was chosen
// In the order in which loops are closed, the innermost first.
const WORDS = {
  yaw_damper: { title: "Yaw damper", does: "yaw rate, washed out, to the rudder" },
  roll_rate_damper: { title: "Roll-rate damper", does: "roll rate to the ailerons" },
  spiral_stabilization: { title: "Spiral stabilization", does: "yaw rate to the ailerons" },
  roll_angle: { title: "Roll-angle control", does: "the stick commands a bank" },
  pitch_rate_damper: { title: "Pitch-rate damper", does: "pitch rate to the elevator" },
  pitch_rate_pi: { title: "Pitch-rate PI", does: "the stick commands a pitch rate" },
};

export class FlightControl {
  /** `link` is the wire. */
  constructor(panel, link) {
    fetchStyle("/page/flight_control.css");
    this.link = link;
    this.cards = new Map();
    this.last = FIRST;
    this.waiting = null;
    this.busy = false;
    this.sent = 0;
    this.control = null;
    this.others = [];
    this.problem = html("p", { class: "problem", role: "alert" });
    this.notes = html("div", { class: "law-notes", role: "status" });
    this.switch = button("Engage", () => this.toggle());
    this.switch.id = "engage";
    this.switch.title = "All laws on, or off (L)";
    this.domain = choice("Design in", [["s", "s"], ["z", "z"]], "s");
    this.domain.label.title = "s: continuous. z: sampled, at the step of the flight";
    this.domain.select.addEventListener("change", () => this.again());
    this.actuators = html("input", { type: "checkbox", id: "actuators", onchange: () => this.say("actuators", { on: this.actuators.checked }) });
    this.actuatorWords = html("label", { for: "actuators", class: "number" }, "Actuators");
    this.sensors = new SensorFields(() => this.sense());
    this.settings = html(
      "div",
      { class: "law-tools" },
      this.domain.label,
      html("span", { class: "law-actuators" }, this.actuators, this.actuatorWords),
      this.sensors.element,
    );
    this.list = html("div", { role: "tabpanel", id: "laws-list", "aria-labelledby": "tab-laws-list", tabindex: 0 });
    const margins = html("div", { role: "tabpanel", id: "laws-margins", "aria-labelledby": "tab-laws-margins", tabindex: 0 });
    this.drawing = html("div", { role: "tabpanel", id: "laws-diagram", "aria-labelledby": "tab-laws-diagram", tabindex: 0 });
    const tabs = html(
      "div",
      { role: "tablist", class: "sub", "aria-label": "Views of the flight control system" },
      html("button", { role: "tab", id: "tab-laws-list", "data-tab": "list", "aria-controls": "laws-list" }, "Laws"),
      html("button", { role: "tab", id: "tab-laws-diagram", "data-tab": "diagram", "aria-controls": "laws-diagram" }, "Block diagram"),
      html("button", { role: "tab", id: "tab-laws-margins", "data-tab": "margins", "aria-controls": "laws-margins" }, "Margins"),
    );
    panel.replaceChildren(html("div", { class: "law-tools" }, this.switch, tabs), this.problem, this.list, this.drawing, margins);
    this.margins = new MarginsView(margins, link);
    this.tabs = new Tabs(tabs, (shown) => this.margins.watch(shown === "margins"));
    this.diagram = new ControlDiagram(this.drawing, link);
    link.on("laws", ({ laws }) => this.fill(laws));
    link.on("control", (control) => this.show(control));
    link.on("aircraft", (aircraft) => this.diagram.setAircraft(aircraft));
  }

  /** Another aircraft: gains of the one before would not fit it. */
  fill(laws) {
    if (!this.cards.size) {
      for (const [name, words] of Object.entries(WORDS)) {
        const law = laws.find((one) => one.name === name);
        if (law) this.cards.set(name, new LawCard(law, words, (text) => this.engage(name, text)));
      }
      this.list.replaceChildren(this.settings, this.notes, ...[...this.cards.values()].map(({ element }) => element));
    }
    for (const card of this.cards.values()) card.forget();
    this.last = namesOf(this.last).filter((name) => name !== SENSORS).join("; ");
    if (this.control) this.show(this.control);
  }

  show(control) {
    this.control = control;
    const parts = new Map(control.text.split(";").map((part) => [part.trim().split(" ")[0], part.trim()]));
    const on = control.text !== NONE;
    if (on) {
      this.last = [...parts].filter(([name]) => name !== SENSORS).map(([, part]) => part).join("; ");
      this.sensors.show(control.gains[SENSORS] ?? { lag: 0, delay: 0 }, control.frame);
    }
    this.others = on ? [...parts].filter(([name]) => !(name in WORDS) && name !== SENSORS).map(([, part]) => part) : []; // one's own
    if (!this.busy) {
      for (const [name, card] of this.cards) {
        const achieved = control.achieved.find(({ law }) => law === name);
        const { sampled, frame } = control;
        card.show(achieved ? { part: parts.get(name), gains: control.gains[name], achieved, sampled, frame } : null);
      }
    }
    this.switch.textContent = on ? "Disengage" : "Engage";
    this.switch.setAttribute("aria-pressed", on);
    this.domain.select.value = control.sampled ? "z" : "s";
    this.actuators.checked = control.actuators.on;
    const { bandwidth, rate_limit, reason } = control.actuators;
    this.actuatorWords.textContent = `Actuators, ${figure(bandwidth, 2)} rad/s, ${figure(degrees(rate_limit), 2)} deg/s`;
    this.actuatorWords.title = `First order; bandwidth and rate limit are assumed: ${reason}`;
    this.notes.replaceChildren(...control.notes.map((note) => html("p", {}, note)));
    this.diagram.show(control);
  }

  /** One law flown as `text` says, or not at all; the others stay as they are. */
  engage(name, text) {
    return this.fly([...[...this.cards].map(([other, { part }]) => (other === name ? text : part)), ...this.others].filter(Boolean));
  }

  /** Other sensors, for the laws as they are. With none engaged they come with the first. */
  sense() {
    const laws = [...[...this.cards.values()].map(({ part }) => part), ...this.others].filter(Boolean);
    if (laws.length) return this.fly(laws, this.sensors.entered());
    this.sensors.keep();
    this.problem.textContent = this.sensors.text() ? "No law measures anything yet: lag and delay come with the first that is engaged." : "";
    return true;
  }

  /** All on, as they were last, or all off. Resolves to a sentence that says which. */
  async toggle() {
    const off = this.control && this.control.text !== NONE;
    const done = await this.fly(off ? [] : [this.last]);
    if (!done) return this.problem.textContent;
    return off ? "Control laws off: the stick moves the surfaces." : `Engaged: ${namesOf(this.last).map((name) => WORDS[name]?.title ?? name).join(", ")}.`;
  }

  /** The laws with a wish designed once more, in the domain that was chosen. */
  again() {
    return this.fly([...[...this.cards.values()].map((card) => card.part && card.again()), ...this.others].filter(Boolean));
  }

  fly(parts, sensors = this.sensors.text()) {
    const text = parts.length ? [...parts, sensors].filter(Boolean).join("; ") : NONE;
    return this.say("law", { text, sampled: this.domain.select.value === "z" });
  }

  /** Sends a command; while one is under way the newest waits, so that a slider never floods the server. */
  async say(name, fields) {
    this.waiting = { name, fields };
    if (this.busy) return true;
    this.busy = true;
    let done = true;
    while (this.waiting) {
      const early = this.sent + PERIOD - performance.now();
      if (early > 0) await new Promise((rest) => setTimeout(rest, early));
      const asked = this.waiting;
      this.waiting = null;
      this.sent = performance.now();
      try {
        await this.link.command(asked.name, asked.fields);
        this.problem.textContent = "";
        done = true;
      } catch (error) {
        this.problem.textContent = error.message;
        done = false;
      }
    }
    this.busy = false;
    if (this.control) this.show(this.link.latest.get("control") ?? this.control);
    return done;
  }
}

const namesOf = (text) => text.split(";").map((part) => part.trim().split(" ")[0]);
