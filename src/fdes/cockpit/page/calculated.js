/** What is calculated of the numbers: dimensional derivatives, A and B as they fly; and airspeeds in all their forms. */

import { copyReadably, html } from "./dom.js";
import { choice, number, row } from "./fields.js";
import { FreshAnswer } from "./fresh_answer.js";
import { symbol } from "./strip_chart.js";
import { FOOT, KNOT, figure } from "./units.js";

const KINDS = [
  ["mach", "Mach"],
  ["tas", "TAS, kt"],
  ["eas", "EAS, kt"],
  ["cas", "CAS (IAS), kt"],
];

export class CalculatedPage {
  constructor(panel, link) {
    this.link = link;
    this.numbers = html("div", {});
    copyReadably(this.numbers);
    this.answer = new FreshAnswer(link, "calculate", this.numbers, (found) => this.draw(found));
    this.kind = choice("From", KINDS, "mach");
    this.value = number("Value", 0.8);
    this.height = number("Altitude, ft", 35000, 100);
    this.speeds = html("p", { class: "number speeds", role: "status" });
    for (const field of [this.kind.select, this.value.input, this.height.input])
      field.addEventListener("input", () => this.convert());
    panel.replaceChildren(
      html("h3", {}, "Airspeeds in the standard atmosphere"),
      html("div", { class: "form-row" }, this.kind.label, this.value.label, this.height.label),
      this.speeds,
      this.numbers,
    );
  }

  watch(shown) {
    this.answer.watch(shown);
    if (shown) this.convert();
  }

  /** The aircraft has changed. */
  stale() {
    this.answer.stale();
  }

  draw({ dimensional, longitudinal, lateral }) {
    const derivatives = dimensional
      ? html(
          "dl",
          { class: "dimensional number" },
          dimensional.flatMap(({ name, value, unit }) => [html("dt", {}, name), html("dd", {}, figure(value, 4), html("small", {}, unit))]),
        )
      : html("p", { class: "quiet-words" }, "The source gives dimensional derivatives: they are on the sliders.");
    this.numbers.replaceChildren(
      html("h3", {}, "Dimensional derivatives, SI and radians"),
      derivatives,
      matrices("Longitudinal: A | B, SI", longitudinal),
      matrices("Lateral: A | B, SI", lateral),
    );
  }

  async convert() {
    const kind = this.kind.select.value;
    const value = Number(this.value.input.value) * (kind === "mach" ? 1 : KNOT);
    try {
      const { mach, tas, eas, cas } = await this.link.command("airspeeds", {
        kind,
        value,
        h: Number(this.height.input.value) * FOOT,
      });
      this.speeds.textContent = `Mach ${figure(mach, 4)} · TAS ${figure(tas / KNOT, 4)} · EAS ${figure(eas / KNOT, 4)} · CAS ${figure(cas / KNOT, 4)} kt`;
    } catch (error) {
      this.speeds.textContent = error.message;
    }
  }
}

function matrices(title, { states, inputs, A, B }) {
  const head = [...states, ...inputs];
  const edge = (j) => (j === states.length ? "is-input" : "");
  return html(
    "div",
    { class: "matrix", tabindex: 0, role: "region", "aria-label": title },
    html(
      "table",
      { class: "number" },
      html("caption", {}, title),
      html("thead", {}, html("tr", {}, html("td", {}), head.map((name, j) => html("th", { scope: "col", class: edge(j) }, symbol(name))))),
      html(
        "tbody",
        {},
        states.map((name, i) =>
          html("tr", {}, html("th", { scope: "row" }, `d${symbol(name)}/dt`), [...A[i], ...B[i]].map((x, j) => html("td", { class: edge(j) }, figure(x, 4)))),
        ),
      ),
    ),
  );
}
