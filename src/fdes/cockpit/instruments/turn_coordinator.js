/** Turn coordinator: the little aircraft shows the rate of turn, the ball in its tube the slip. */

import { BLACK, GREY, WHITE } from "../page/dial.js";
import { DEG, clamp } from "../page/units.js";

export const title = "turn and slip";
export const needs = ["psi_dot", "n_y"];

const STANDARD_RATE = 3 * DEG; // rad/s: a full circle in two minutes
const MARK = 18 * DEG; // wing angle at the standard rate
const STOP = 30 * DEG;
const FULL_BALL = 0.13; // g of side force that rolls the ball to the end
const TUBE = { center: -0.62, radius: 1.08, half: 17 * DEG, bore: 0.095 }; // bent: its middle is its lowest point

const onTube = (angle) => [TUBE.radius * Math.sin(angle), TUBE.center + TUBE.radius * Math.cos(angle)];

export function face(dial) {
  for (const side of [-1, 1]) {
    for (const angle of [90 * DEG, 90 * DEG + MARK]) dial.tick(side * angle, 0.75, 0.87, 0.034);
  }
  dial.text("L", -0.66, 0.42, 0.12);
  dial.text("R", 0.66, 0.42, 0.12);
  dial.text("TURN", 0, -0.56, 0.09, GREY);
  dial.text("2 MIN", 0, 0.69, 0.085, GREY);
  tube(dial);
}

function tube(dial) {
  const along = (from, to) => Array.from({ length: 17 }, (_, i) => onTube(from + ((to - from) * i) / 16));
  dial.line(along(-TUBE.half, TUBE.half), 2.35 * TUBE.bore, "#5b655f", "round");
  dial.line(along(-TUBE.half, TUBE.half), 2.0 * TUBE.bore, "#dfe6cf", "round");
}

export function draw(dial, { psi_dot, n_y }) {
  ball(dial, clamp(-n_y / FULL_BALL, -1, 1));
  const bank = clamp((psi_dot / STANDARD_RATE) * MARK, -STOP, STOP);
  dial.turned(bank, () => {
    for (const [dx, color] of [
      [0.02, "rgba(0,0,0,0.4)"],
      [0, WHITE],
    ]) {
      dial.polygon(
        [
          [-0.7, -0.02 + dx],
          [-0.1, -0.045 + dx],
          [0.1, -0.045 + dx],
          [0.7, -0.02 + dx],
          [0.7, 0.02 + dx],
          [0.1, 0.05 + dx],
          [-0.1, 0.05 + dx],
          [-0.7, 0.02 + dx],
        ],
        color,
      );
      dial.polygon(
        [
          [-0.02, dx],
          [-0.014, -0.23 + dx],
          [0.014, -0.23 + dx],
          [0.02, dx],
        ],
        color,
      );
      dial.line(
        [
          [-0.17, -0.15 + dx],
          [0.17, -0.15 + dx],
        ],
        0.03,
        color,
        "round",
      );
      dial.disc(0, dx, 0.095, color);
    }
  });
}

/** A heavy ball rolls to where gravity and side force take it; two wires mark the middle. */
function ball(dial, share) {
  const [x, y] = onTube(share * TUBE.half);
  dial.disc(x, y, 0.082, BLACK);
  dial.disc(x - 0.025, y - 0.028, 0.022, "#69737c");
  const wire = 0.105 / TUBE.radius;
  for (const side of [-1, 1]) {
    const [wx, wy] = onTube(side * wire);
    dial.line(
      [
        [wx, wy - 0.11],
        [wx, wy + 0.11],
      ],
      0.02,
      BLACK,
    );
  }
}
