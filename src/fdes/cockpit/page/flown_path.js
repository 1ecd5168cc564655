/** The path flown in the last half minute as a ribbon that banks with the wings; its past is that of the strip charts. */

const SECONDS = 30;
const EVERY = 0.25; // s between the ribbon's corners
const MOST = SECONDS / EVERY + 2;
const WIDE = 0.1; // of the span, to each side
const NEAR = 2; // m ahead of the eye
const NEEDED = ["north", "east", "h", "phi", "theta", "psi"];
const COLOR = "#35d0ff";

export class Path {
  constructor(context, chart) {
    Object.assign(this, { context, chart });
    this.edges = new Float64Array(6 * MOST); // left and right corner of each place, in the camera's axes
    this.ends = new Float64Array(4);
  }

  /** Draws it up to where the aircraft is now, in `state` with body `axes`. */
  draw(state, axes, cam, span) {
    const { chart } = this;
    const { index, times, values, channels } = chart;
    if (NEEDED.some((name) => !(name in index))) return;
    const half = WIDE * span;
    let [count, slot] = [0, NaN];
    for (let back = chart.since(state.t - SECONDS); back < 0; back++) {
      const row = chart.row(back);
      const t = times[row];
      if (Math.floor(t / EVERY) === slot || count >= MOST - 1) continue;
      slot = Math.floor(t / EVERY);
      const at = row * channels.length;
      const [phi, theta, psi] = [values[at + index.phi], values[at + index.theta], values[at + index.psi]];
      const [sp, st, ss, cs] = [Math.sin(phi), Math.sin(theta), Math.sin(psi), Math.cos(psi)];
      const cp = Math.cos(phi);
      this.put(count++, cam, values[at + index.north], values[at + index.east], values[at + index.h], half, sp * st * cs - cp * ss, sp * st * ss + cp * cs, sp * Math.cos(theta));
    }
    this.put(count++, cam, state.north, state.east, state.h, half, axes[3], axes[4], axes[5]);
    this.paint(count, cam);
  }

  /** Both corners of place `k`: to the sides along the wing (n, e, d). */
  put(k, cam, north, east, h, half, n, e, d) {
    for (let side = 0; side < 2; side++) {
      const out = side ? half : -half;
      const [x, y, z] = [north + out * n - cam.north, east + out * e - cam.east, cam.eye - h + out * d];
      for (let i = 0; i < 3; i++)
        this.edges[6 * k + 3 * side + i] = cam.axes[3 * i] * x + cam.axes[3 * i + 1] * y + cam.axes[3 * i + 2] * z;
    }
  }

  paint(count, cam) {
    const { context, ends } = this;
    context.fillStyle = COLOR;
    for (let k = 1; k < count; k++) {
      context.globalAlpha = 0.05 + 0.4 * (k / count);
      context.beginPath();
      if (!this.edge(k, 0, cam)) continue;
      context.moveTo(ends[0], ends[1]);
      context.lineTo(ends[2], ends[3]);
      if (!this.edge(k, 1, cam)) continue;
      context.lineTo(ends[2], ends[3]);
      context.lineTo(ends[0], ends[1]);
      context.fill();
    }
    context.globalAlpha = 1;
  }

  /** One edge of the ribbon from place k - 1 to k on the screen, what is behind the eye cut off; false for nothing. */
  edge(k, side, { cx, cy, f }) {
    const { edges, ends } = this;
    const [a, b] = [6 * (k - 1) + 3 * side, 6 * k + 3 * side];
    const [xa, xb] = [edges[a], edges[b]];
    if (xa < NEAR && xb < NEAR) return false;
    for (let end = 0; end < 2; end++) {
      const [own, other] = end ? [b, a] : [a, b];
      const share = edges[own] < NEAR ? (NEAR - edges[own]) / (edges[other] - edges[own]) : 0;
      const at = (i) => edges[own + i] + share * (edges[other + i] - edges[own + i]);
      ends[2 * end] = cx + (f * at(1)) / at(0);
      ends[2 * end + 1] = cy + (f * at(2)) / at(0);
    }
    return true;
  }
}
