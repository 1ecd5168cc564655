/** The dialog that chooses the instruments of the head-down panel. Fetched when it is opened. */

import { fetchJson, html } from "./dom.js";
import { SIX } from "./instrument_panel.js";

const SETS = [
  ["None", []],
  ["Airspeed, altimeter, turn", ["airspeed", "altimeter", "turn_coordinator"]],
  ["Airspeed, altimeter, heading", ["airspeed", "altimeter", "heading"]],
  ["The six basic ones", SIX],
];

export class IndicatorChooser {
  constructor(panel) {
    this.panel = panel;
    this.body = html("div", { class: "dialog-body" });
    this.dialog = html(
      "dialog",
      { id: "indicators", class: "narrow", "aria-labelledby": "indicators-title" },
      html(
        "div",
        { class: "dialog-head" },
        html("h2", { id: "indicators-title" }, "Instruments under the world"),
        html("button", { class: "icon", "aria-label": "Close", onclick: () => this.dialog.close() }, "✕"),
      ),
      this.body,
    );
    this.dialog.addEventListener("click", ({ target }) => target === this.dialog && this.dialog.close());
    document.body.append(this.dialog);
  }

  async open() {
    const shelf = await fetchJson("/api/instruments");
    this.shelf = [...SIX, ...shelf.filter((name) => !SIX.includes(name))];
    this.draw();
    if (!this.dialog.open) this.dialog.showModal();
  }

  draw() {
    const chosen = this.panel.names;
    const sets = [...SETS, ["All", this.shelf]].map(([label, names]) =>
      html(
        "label",
        {},
        html("input", { type: "radio", name: "indicators", checked: names.join() === chosen.join(), onchange: () => this.use(names) }),
        label,
      ),
    );
    const singles = this.shelf.map((name) =>
      html(
        "label",
        {},
        html("input", { type: "checkbox", checked: chosen.includes(name), onchange: ({ target }) => this.use(this.shelf.filter((one) => (one === name ? target.checked : this.panel.names.includes(one)))) }),
        name.replaceAll("_", " "),
      ),
    );
    this.body.replaceChildren(
      html("fieldset", { class: "indicator-choice" }, html("legend", {}, "A set"), sets),
      html("fieldset", { class: "indicator-choice" }, html("legend", {}, "One by one"), singles),
    );
  }

  /** Shows these instruments and remembers them; the choice that has the focus keeps it. */
  async use(names) {
    const at = [...this.body.querySelectorAll("input")].indexOf(document.activeElement);
    await this.panel.use(names);
    this.panel.remember();
    this.draw();
    this.body.querySelectorAll("input")[at]?.focus();
  }
}
