/**
 * An aircraft as a solid of flat facets, made from its size: span b, wing area S and mean chord c fix the wing's taper,
 * and from there everything that is not known is guessed. Proportions of known types (silhouette.js) are hints.
 *
 * Facets are in body axes (x forward, y right, z down) [m] from the aircraft's center: { corners, paint, hinge }. The
 * corners go around as seen from outside. `hinge` is null or { control, at, axis }: that facet turns about the line.
 */

import { proportions } from "./silhouette.js";
import { clamp } from "./units.js";

/** What moves. Angles are those of the facets: positive turns a trailing edge down, or left for the rudder. */
export const CONTROLS = ["elevator", "right aileron", "left aileron", "rudder"];

const SIDES = 8; // of the fuselage
// Shares of the length and of the half height, from the nose on; how far the middle rises behind.
const BLUNT = [[0, 0.06], [0.03, 0.4], [0.08, 0.66], [0.16, 0.88], [0.28, 1], [0.62, 1], [0.82, 0.66], [1, 0.18]];
const POINTED = [[0, 0.02], [0.12, 0.34], [0.24, 0.74], [0.36, 1], [0.66, 1], [0.84, 0.8], [1, 0.5]];
const THICK = 0.1; // of a wing, share of its chord
const HINGE = 0.74; // of a control surface, share of the chord

/** The facets of an aircraft: `id` to look for hints, `size` = { span, area, chord, mach } [m, m^2, m, 1]. */
export function aircraftShape(id, size) {
  const shape = proportions(id, size);
  const { wing, tail, fin, length, span, body } = shape;
  const center = wing.at + 0.35 * wing.root + 0.4 * wing.sweep; // near the quarter-chord point of the mean chord
  const half = body / 2;
  const x = (along) => center - along;
  const facets = [...fuselage(shape, x)];
  const low = wing.low ? half * 0.45 : -half * 0.1;
  const rise = (wing.low ? 0.07 : -0.03) * span * 0.5;
  const panel = { ...wing, reach: span / 2, inner: half * 0.5 };
  for (const [side, aileron] of [[1, "right aileron"], [-1, "left aileron"]]) {
    const place = (along, out, up) => [x(along), side * out, low - (rise * out) / panel.reach - up];
    facets.push(...blade(panel, place, { control: aileron, from: 0.58, to: 0.94 }));
  }
  const top = -half * 0.55;
  const onFin = tail.high === true ? 0.94 : (tail.high ?? 0);
  const level = onFin ? top - fin.height * onFin : -half * 0.25;
  const back = onFin ? Math.max(tail.at, fin.at + fin.sweep * onFin) : tail.at;
  const stabilizer = { ...tail, at: back, reach: tail.span / 2, inner: onFin ? 0.02 * length * 0.1 : half * 0.2 };
  for (const side of [1, -1])
    facets.push(
      ...blade(stabilizer, (along, out, up) => [x(along), side * out, level - up], { control: "elevator", from: 0.06, to: 0.96, share: 0.66 }),
    );
  facets.push(
    ...blade({ ...fin, reach: fin.height, inner: 0 }, (along, out, aside) => [x(along), aside, top - out], {
      control: "rudder",
      from: onFin ? 0.08 : 0.14,
      to: onFin === 0.94 ? 0.84 : 0.94,
      share: 0.68,
    }),
  );
  for (const side of [-1, 1]) facets.push(...pods(shape, x, side, low, rise));
  return { facets, span, length, tips: [x(wing.at + wing.sweep + wing.tip / 2), span / 2, low - rise] };
}

/** A body of rings: facets between neighbors, and its last ring closed. A ring is a list of corners. */
function loft(rings, paint, inside) {
  const facets = [];
  for (let i = 1; i < rings.length; i++) {
    const [a, b] = [rings[i - 1], rings[i]];
    for (let k = 0; k < a.length; k++) {
      const next = (k + 1) % a.length;
      facets.push(facet([a[k], a[next], b[next], b[k]], paint, inside(i)));
    }
  }
  facets.push(facet(rings.at(-1), paint, inside(rings.length - 1)));
  return facets;
}

function ring(x, middle, wide, high, sides = SIDES) {
  return Array.from({ length: sides }, (_, k) => {
    const angle = (2 * Math.PI * (k + 0.5)) / sides;
    return [x, wide * Math.cos(angle), middle + high * Math.sin(angle)];
  });
}

function tube(stations, x, paint, sides = SIDES) {
  const rings = stations.map(({ along, out = 0, middle, wide, high = wide }) => ring(x(along), middle, wide, high, sides).map(([a, b, c]) => [a, b + out, c]));
  const inside = (i) => mean([...rings[i - 1], ...rings[i]]);
  return loft(rings, paint, inside);
}

function fuselage(shape, x) {
  const { length, body } = shape;
  const half = body / 2;
  const stations = (shape.spike ? POINTED : BLUNT).map(([along, size]) => ({
    along: along * length,
    middle: along > 0.62 && !shape.spike ? -half * 0.45 * ((along - 0.62) / 0.38) : 0,
    wide: Math.max(0.02 * body, half * size),
  }));
  const facets = tube(stations, x, "body");
  if (shape.canopy) {
    const bump = [[-1, 0.05], [-0.5, 0.75], [0.1, 1], [1.1, 0.3]];
    facets.push(
      ...tube(
        bump.map(([along, size]) => ({ along: shape.canopy + along * body * 0.85, middle: -half * 0.75, wide: half * 0.55 * size, high: half * 0.6 * size })),
        x,
        "glass",
        6,
      ),
    );
  }
  if (shape.hump) {
    const deck = [[0.05, 0.1], [0.1, 0.8], [0.2, 1], [0.27, 0.7], [0.34, 0.1]];
    facets.push(
      ...tube(
        deck.map(([along, size]) => ({ along: along * length, middle: -half * 0.7, wide: half * 0.72 * size, high: half * 0.62 * size })),
        x,
        "body",
      ),
    );
  }
  return facets;
}

function pods({ pods: hung = [], rearPods, span, length, body, wing }, x, side, low, rise) {
  const nacelle = (from, long, out, middle, radius) =>
    tube(
      [[0, 0.8], [0.3, 1], [1, 0.6]].map(([along, size]) => ({ along: from + along * long, out: side * out, middle, wide: radius * size })),
      x,
      "metal",
      6,
    );
  const facets = hung.flatMap(([share, wide]) => {
    const out = (share * span) / 2;
    return nacelle(wing.at + share * wing.sweep - wide * 1.7, wide * 2.6, out, low - rise * share + wide * 0.75, wide / 2);
  });
  if (rearPods) facets.push(...nacelle(length * 0.62, length * 0.17, body * 0.86, -body * 0.12, body * 0.3));
  return facets;
}

/**
 * A wing, tailplane half or fin: `place(along, out, up)` puts a point of it in body axes. Between the shares `from` and
 * `to` of its reach the rear of it turns with `control`.
 */
function blade({ at, root, tip, sweep, reach, inner }, place, { control, from, to, share = HINGE }) {
  const sections = [0, from, to, 1].map((fraction) => {
    const out = inner + fraction * (reach - inner);
    const along = at + (sweep * out) / reach;
    const chord = root + ((tip - root) * out) / reach;
    const thick = (THICK * chord) / 2;
    return [
      place(along, out, 0),
      place(along + 0.3 * chord, out, thick),
      place(along + share * chord, out, thick * 0.5),
      place(along + chord, out, 0),
      place(along + share * chord, out, -thick * 0.5),
      place(along + 0.3 * chord, out, -thick),
    ];
  });
  const facets = [];
  for (let i = 1; i < sections.length; i++) {
    const [a, b] = [sections[i - 1], sections[i]];
    const front = mean([...a, ...b]);
    const hinge = i === 2 ? hingeOf(control, midpoint(a[2], a[4]), midpoint(b[2], b[4])) : null;
    for (let k = 0; k < 6; k++) {
      const moves = hinge && (k === 2 || k === 3);
      const next = (k + 1) % 6;
      facets.push({ ...facet([a[k], a[next], b[next], b[k]], moves ? "control" : "wing", front), hinge: moves ? hinge : null });
    }
  }
  facets.push(facet(sections.at(-1), "wing", mean(sections[2])));
  return facets;
}

/** The hinge line, its axis to the right, or down for the rudder. */
function hingeOf(control, a, b) {
  const along = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
  const length = Math.hypot(...along) * ((control === "rudder" ? along[2] : along[1]) < 0 ? -1 : 1);
  return { control: CONTROLS.indexOf(control), at: a, axis: along.map((value) => value / length) };
}

const midpoint = (a, b) => a.map((value, i) => (value + b[i]) / 2);
const mean = (points) => [0, 1, 2].map((i) => points.reduce((sum, point) => sum + point[i], 0) / points.length);

/** A facet whose corners go around so that its normal points away from `inside`. */
function facet(corners, paint, inside) {
  const normal = normalOf(corners);
  const middle = mean(corners);
  const outward = normal.reduce((sum, value, i) => sum + value * (middle[i] - inside[i]), 0) >= 0;
  return { corners: outward ? corners : [...corners].reverse(), paint, hinge: null };
}

/** The unit normal of corners that need not lie quite in a plane, by M. Newell's sum. */
export function normalOf(corners) {
  const sum = [0, 0, 0];
  corners.forEach((a, k) => {
    const b = corners[(k + 1) % corners.length];
    sum[0] += (a[1] - b[1]) * (a[2] + b[2]);
    sum[1] += (a[2] - b[2]) * (a[0] + b[0]);
    sum[2] += (a[0] - b[0]) * (a[1] + b[1]);
  });
  const length = Math.hypot(...sum) || 1;
  return sum.map((value) => clamp(value / length, -1, 1));
}
