/** Altimeter with three hands (100, 1,000 and 10,000 ft) and a counter. */

import { AMBER, GREY, WHITE } from "../page/dial.js";
import { feet } from "../page/units.js";

export const title = "altitude";
export const needs = ["h"];

const TURN = 2 * Math.PI;

export function face(dial) {
  for (let i = 0; i < 50; i++) dial.tick((i / 50) * TURN, i % 5 ? 0.81 : 0.75, 0.87, i % 5 ? 0.012 : 0.024);
  for (let i = 0; i < 10; i++) dial.label(String(i), (i / 10) * TURN, 0.63, 0.165);
  dial.text("ALTITUDE", 0, -0.38, 0.085, GREY);
  // The counter stands between the middle and the 5, where no number of the rim is.
  dial.box(-0.3, 0.2, 0.6, 0.21, "#020304", "#5d6872");
}

export function draw(dial, { h }) {
  const height = feet(h);
  dial.text(counter(height), -0.06, 0.312, 0.155, WHITE);
  dial.text("FT", 0.235, 0.32, 0.075, GREY);
  tenThousands(dial, height);
  dial.needle((height / 10000) * TURN, 0.48, 0.05, { tail: 0.12 });
  dial.needle((height / 1000) * TURN, 0.82, 0.026);
  dial.cap();
}

const counter = (height) => (height < 0 ? "-" : "") + String(Math.abs(Math.round(height / 10) * 10)).padStart(5, "0");

/** A triangle at the rim, out of the way of the numbers, instead of a third hand. */
function tenThousands(dial, height) {
  dial.turned((height / 100000) * TURN, () => {
    dial.line([[0, -0.1], [0, -0.72]], 0.012, AMBER);
    dial.polygon([[0, -0.74], [-0.05, -0.87], [0.05, -0.87]], AMBER);
  });
}
