/** Altimeter with three hands (100, 1,000 and 10,000 ft) and a counter. */

import { AMBER, GREY, WHITE } from "../page/dial.js";
import { feet } from "../page/units.js";

export const title = "altitude";
export const needs = ["h"];

const TURN = 2 * Math.PI;

export function face(dial) {
  for (let i = 0; i < 50; i++) dial.tick((i / 50) * TURN, i % 5 ? 0.81 : 0.75, 0.87, i % 5 ? 0.012 : 0.024);
  for (let i = 0; i < 10; i++) dial.label(String(i), (i / 10) * TURN, 0.63, 0.165);
  dial.text("ALTITUDE FT", 0, -0.36, 0.08, GREY);
}

export function draw(dial, { h }) {
  const height = feet(h);
  tenThousands(dial, height);
  dial.needle((height / 10000) * TURN, 0.53, 0.05, { tail: 0.12 });
  dial.needle((height / 1000) * TURN, 0.82, 0.026);
  dial.cap();
  // The counter lies over the hands, so that it can always be read; the hands' tips reach beyond it.
  dial.box(-0.27, 0.17, 0.54, 0.19, "#020304", "#5d6872");
  dial.text(counter(height), 0, 0.27, 0.15, WHITE);
}

function counter(height) {
  const tens = Math.round(height / 10) * 10;
  return (tens < 0 ? "-" : "") + String(Math.abs(tens)).padStart(tens < 0 ? 4 : 5, "0");
}

/** A triangle at the rim, out of the way of the numbers, instead of a third hand. */
function tenThousands(dial, height) {
  dial.turned((height / 100000) * TURN, () => {
    dial.line(
      [
        [0, -0.1],
        [0, -0.72],
      ],
      0.012,
      AMBER,
    );
    dial.polygon(
      [
        [0, -0.74],
        [-0.05, -0.87],
        [0.05, -0.87],
      ],
      AMBER,
    );
  });
}
