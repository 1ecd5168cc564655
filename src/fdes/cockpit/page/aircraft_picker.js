/** The dialog that chooses what is flown: every aircraft of the hangar, its flight conditions, and which numbers. */

import { fetchJson, html } from "./dom.js";
import { threeView } from "./silhouette.js";
import { POUND, knots } from "./units.js";

const VARIANTS = [
  ["corrected", "Corrected", "Misprints of the source put right, each with its reason"],
  ["printed", "As printed", "The numbers as the source prints them, misprints and all"],
];

export class AircraftPicker {
  /** `fly(aircraft, condition, variant)` returns a promise; its error is shown in the dialog. */
  constructor(dialog, fly) {
    this.dialog = dialog;
    this.fly = fly;
    this.current = null;
    this.hangar = null;
    this.variant = "corrected";
    this.error = html("p", { class: "problem", role: "alert" });
    this.cards = html("div", { class: "hangar" });
    dialog.querySelector(".dialog-body").append(html("div", { class: "picker-head" }, this.choice(), this.newAircraft()), this.error, this.cards);
  }

  choice() {
    return html(
      "fieldset",
      { class: "segments" },
      html("legend", {}, "Numbers"),
      VARIANTS.map(([value, label, title]) =>
        html(
          "label",
          { title },
          html("input", {
            type: "radio",
            name: "variant",
            value,
            checked: value === this.variant,
            onchange: () => (this.variant = value),
          }),
          label,
        ),
      ),
    );
  }

  newAircraft() {
    const open = () => {
      this.dialog.close();
      document.dispatchEvent(new Event("new-aircraft"));
    };
    return html("button", { type: "button", "aria-haspopup": "dialog", onclick: open }, "New aircraft…");
  }

  setCurrent(aircraft) {
    this.current = aircraft;
    this.variant = aircraft.variant;
    for (const input of this.dialog.querySelectorAll("[name=variant]"))
      input.checked = input.value === aircraft.variant;
    this.mark();
  }

  async open() {
    this.error.textContent = "";
    if (!this.dialog.open) this.dialog.showModal();
    try {
      this.hangar ??= await fetchJson("/api/aircraft");
      this.cards.replaceChildren(...this.hangar.map((aircraft) => this.card(aircraft)));
      this.mark();
      this.cards.querySelector("[aria-current]")?.focus();
    } catch (error) {
      this.error.textContent = `The hangar could not be read. ${error.message} Close this window and open it again.`;
    }
  }

  card(aircraft) {
    const masses = [...new Set(aircraft.conditions.map(({ mass_kg }) => mass_kg))];
    const heading = `aircraft-${aircraft.id.replace(/\W/g, "")}`;
    return html(
      "article",
      { class: "plane", "aria-labelledby": heading },
      threeView(aircraft.id, aircraft.three_view),
      html("h3", { id: heading }, aircraft.name),
      html("p", { class: "summary" }, aircraft.summary),
      html(
        "p",
        { class: "facts" },
        masses.map((mass) => `${Math.round(mass).toLocaleString("en")} kg`).join(" · "),
        html("small", {}, ` (${masses.map((mass) => Math.round(mass / POUND).toLocaleString("en")).join(", ")} lb)`),
      ),
      html(
        "div",
        { class: "conditions" },
        aircraft.conditions.map((condition) => this.button(aircraft, condition)),
      ),
      html("p", { class: "source" }, `Source: ${aircraft.source}`),
    );
  }

  button(aircraft, condition) {
    return html(
      "button",
      {
        "data-aircraft": aircraft.id,
        "data-condition": condition.id,
        title: condition.confidence && `Confidence in these numbers: ${condition.confidence}`,
        onclick: () => this.choose(aircraft.id, condition.id),
      },
      html("b", {}, condition.name),
      html("span", {}, `${Math.round(knots(condition.V))} kt`),
    );
  }

  async choose(aircraft, condition) {
    this.error.textContent = "";
    try {
      await this.fly(aircraft, condition, this.variant);
      this.dialog.close();
    } catch (error) {
      this.error.textContent = error.message;
    }
  }

  mark() {
    if (!this.current) return;
    for (const button of this.cards.querySelectorAll("[data-condition]")) {
      const flown = button.dataset.aircraft === this.current.id && button.dataset.condition === this.current.condition;
      if (flown) button.setAttribute("aria-current", "true");
      else button.removeAttribute("aria-current");
    }
  }
}
