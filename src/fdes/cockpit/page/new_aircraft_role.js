/** Class, Category and Flight Phase of MIL-F-8785C in the form for a new aircraft, each with its words, and why. */

import { choice, refill } from "./fields.js";
import { html } from "./dom.js";

const NOT_SAID = ["", "not given"];
const pairs = (words) => Object.entries(words).map(([code, word]) => [code, `${code}: ${word}`]);

export class RoleFields {
  /** `roles` { classes, categories, phases } as the server offers them; a phase is [category, words]. */
  constructor(roles) {
    this.roles = roles;
    this.airplane = choice("Class", [NOT_SAID, ...pairs(roles.classes)], "");
    this.category = choice("Category", [NOT_SAID, ...pairs(roles.categories)], "");
    this.phase = choice("Flight Phase", [NOT_SAID], "");
    this.reason = html("input", { type: "text", maxlength: 300, "data-at": "flying_qualities.reason" });
    this.category.select.addEventListener("change", () => this.offer());
    this.offer();
    this.element = html(
      "fieldset",
      { class: "draft-head" },
      html("legend", {}, "Flying qualities: what it is judged by"),
      html("div", { class: "texts" }, this.airplane.label, this.category.label, this.phase.label, html("label", {}, html("span", {}, "Reason"), this.reason)),
    );
  }

  /** The phases of the category that is chosen. */
  offer(chosen = "") {
    const { value } = this.category.select;
    const phases = Object.entries(this.roles.phases).filter(([, [category]]) => category === value);
    refill(this.phase, [NOT_SAID, ...phases.map(([code, [, words]]) => [code, `${code}: ${words}`])], chosen);
  }

  /** `role` as in an aircraft file; nothing is said without it. */
  fill(role = {}) {
    this.airplane.select.value = role.airplane_class ?? "";
    this.category.select.value = role.category ?? "";
    this.offer(role.phase ?? "");
    this.reason.value = role.reason ?? "";
  }

  /** The block of the aircraft file, or nothing where nothing was said. */
  said() {
    const given = { airplane_class: this.airplane.select.value, category: this.category.select.value, phase: this.phase.select.value, reason: this.reason.value.trim() };
    const kept = Object.entries(given).filter(([, value]) => value);
    return kept.length ? { flying_qualities: Object.fromEntries(kept) } : {};
  }
}
