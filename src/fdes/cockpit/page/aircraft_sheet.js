/** The Aircraft tab: what is flown, and which of its numbers no source gives. */

import { html } from "./dom.js";
import { DEG, POUND, degrees, feet, figure, fixed, knots, minus } from "./units.js";

export function drawSheet(panel, aircraft) {
  panel.replaceChildren(
    html("h3", {}, `${aircraft.name}`),
    facts(aircraft),
    ...assumptions(aircraft.assumed ?? []),
    ...notes(aircraft.notes ?? []),
  );
}

function facts(aircraft) {
  const { full_stick: full } = aircraft;
  const numbers =
    aircraft.variant === "printed" ? "as printed in the source" : "corrected where the source is known to be wrong";
  const rows = [
    ["Flight condition", aircraft.condition_name],
    ["Numbers", numbers],
    ["Mass", `${whole(aircraft.mass_kg)} kg (${whole(aircraft.mass_kg / POUND)} lb)`],
    [
      "Trim speed",
      `${figure(aircraft.V, 4)} m/s (${Math.round(knots(aircraft.V))} kt true), Mach ${aircraft.mach.toFixed(2)}`,
    ],
    ["Flight begins at", `${whole(aircraft.h)} m (${whole(feet(aircraft.h))} ft)`],
    ["Trim angle of attack", `${minus(fixed(degrees(aircraft.alpha_trim), 2))}°`],
    [
      "Full stick",
      `aft: elevator ${angle(full.elevator)}; right: aileron ${angle(full.aileron)}; ` +
        `right pedal: rudder ${angle(full.rudder)}`,
    ],
    ["Equations", equations(aircraft)],
    ["Integrator", `${aircraft.integrator}, step 1/${Math.round(1 / aircraft.dt)} s`],
  ];
  return html(
    "dl",
    { class: "sheet" },
    rows.flatMap(([name, value]) => [html("dt", {}, name), html("dd", {}, value)]),
  );
}

function equations({ plant, form }) {
  if (plant === "nonlinear") return "nonlinear, six degrees of freedom; modes and Levels of the linearized aircraft";
  return `linear, form “${form}”, good to 15° from trim`;
}

const whole = (number) => Math.round(number).toLocaleString("en");
const angle = (radians) => `${minus(Number((radians / DEG).toFixed(1)))}°`;

function assumptions(assumed) {
  if (!assumed.length) return [];
  return [
    html("h3", {}, "Assumed: no source gives these"),
    html(
      "ul",
      { class: "assumed" },
      assumed.map(({ name, value, unit, reason }) =>
        html(
          "li",
          {},
          html("span", { class: "tag" }, "ASSUMED"),
          html("b", {}, `${name.replaceAll("_", " ")}: ${quantity(value, unit)}`),
          html("p", {}, reason),
        ),
      ),
    ),
  ];
}

function quantity(value, unit) {
  const number = typeof value === "number" ? String(value) : JSON.stringify(value).replaceAll('"', "");
  return unit && unit !== "1" ? `${number} ${unit}` : number;
}

function notes(list) {
  return list.length
    ? [
        html("h3", {}, "Notes"),
        html(
          "ul",
          { class: "notes" },
          list.map((note) => html("li", {}, note)),
        ),
      ]
    : [];
}
