/** Attitude indicator: pitch from the horizon, bank on the outer scale. Sky above, earth below. */

import { AMBER, BLACK, WHITE } from "../page/dial.js";
import { DEG, clamp, degrees } from "../page/units.js";

export const title = "attitude";
export const needs = ["phi", "theta"];

const PER_DEGREE = 0.021; // radii
const BANKS = [-60, -45, -30, -20, -10, 10, 20, 30, 45, 60];
const INNER = 0.72; // the ball; outside it the bank ring

export function draw(dial, { phi, theta }) {
  dial.clipped(() => dial.turned(-phi, () => ring(dial)));
  dial.clipped(() => dial.turned(-phi, () => ball(dial, degrees(theta))), INNER);
  aircraft(dial);
}

/** The part that only banks: its ground and sky show which side is up when the horizon is out of sight. */
function ring(dial) {
  dial.box(-1, -1, 2, 1, "#2a70b4");
  dial.box(-1, 0, 2, 1, "#5a391a");
  for (const bank of BANKS) dial.tick(bank * DEG, 0.755, bank % 30 ? 0.82 : 0.865, bank % 30 ? 0.016 : 0.026);
  dial.polygon(
    [
      [0, -0.745],
      [-0.06, -0.865],
      [0.06, -0.865],
    ],
    WHITE,
  );
}

function ball(dial, pitch) {
  const { context, radius } = dial;
  const horizon = clamp(pitch * PER_DEGREE, -0.66, 0.66);
  const fill = (from, to, top, high) => {
    const shade = context.createLinearGradient(0, top * radius, 0, (top + high) * radius);
    shade.addColorStop(0, from);
    shade.addColorStop(1, to);
    dial.box(-1, top, 2, high, shade);
  };
  fill("#1d66ad", "#62b5ee", horizon - 1.6, 1.6);
  fill("#92612f", "#48290f", horizon, 1.6);
  dial.line(
    [
      [-1, horizon],
      [1, horizon],
    ],
    0.018,
  );
  const nearest = Math.round(pitch / 5) * 5;
  for (let mark = nearest - 25; mark <= nearest + 25; mark += 5) {
    const y = (pitch - mark) * PER_DEGREE;
    if (mark === 0 || Math.abs(mark) > 90 || Math.abs(y) > 0.58) continue;
    const half = mark % 10 ? 0.1 : 0.21;
    dial.line(
      [
        [-half, y],
        [half, y],
      ],
      0.014,
    );
    if (mark % 10 === 0) for (const side of [-1, 1]) dial.text(String(Math.abs(mark)), side * 0.31, y, 0.1);
  }
}

function aircraft(dial) {
  dial.polygon(
    [
      [0, -0.735],
      [-0.055, -0.635],
      [0.055, -0.635],
    ],
    AMBER,
  );
  for (const [width, color] of [
    [0.085, BLACK],
    [0.05, AMBER],
  ]) {
    for (const side of [-1, 1])
      dial.line(
        [
          [side * 0.54, 0],
          [side * 0.2, 0],
          [side * 0.2, 0.07],
        ],
        width,
        color,
        "round",
      );
    dial.disc(0, 0, width * 0.7, color);
  }
}
