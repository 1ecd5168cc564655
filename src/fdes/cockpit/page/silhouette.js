/**
 * The proportions of known aircraft, and a small three-view made of them: enough to recognize it, not a drawing to
 * measure from. What is not known here is made from span, area and chord.
 * Lengths in meters from the nose; `sweep` is how far the tip's leading edge lies behind the root's.
 */

import { svg } from "./dom.js";

const SHAPES = {
  "A-4D": {
    length: 12.0,
    span: 8.4,
    body: 1.5,
    wing: { at: 3.6, root: 5.2, tip: 1.0, sweep: 3.9, low: true },
    tail: { at: 9.9, span: 3.5, root: 1.7, tip: 0.7, sweep: 1.1 },
    fin: { at: 8.6, height: 2.3, root: 2.6, tip: 1.0, sweep: 1.9 },
    canopy: 3,
  },
  "F-104A": {
    length: 16.7,
    span: 6.6,
    body: 1.6,
    spike: true,
    wing: { at: 7.9, root: 3.9, tip: 1.5, sweep: 1.15 },
    tail: { at: 14.6, span: 3.6, root: 1.9, tip: 0.7, sweep: 0.8, high: true },
    fin: { at: 13.0, height: 2.5, root: 3.1, tip: 1.9, sweep: 1.5 },
    canopy: 4,
  },
  NAVION: {
    length: 8.4,
    span: 10.2,
    body: 1.3,
    propeller: true,
    wing: { at: 2.2, root: 2.2, tip: 1.2, sweep: 0.35, low: true },
    tail: { at: 6.9, span: 4.0, root: 1.2, tip: 0.8, sweep: 0.25 },
    fin: { at: 6.7, height: 1.5, root: 1.5, tip: 0.8, sweep: 0.6 },
    canopy: 2.6,
  },
  Convair880: {
    length: 39.4,
    span: 36.6,
    body: 3.6,
    wing: { at: 11.2, root: 9.4, tip: 2.6, sweep: 12.6, low: true },
    tail: { at: 32.6, span: 13.4, root: 4.8, tip: 1.9, sweep: 4.6 },
    fin: { at: 31.0, height: 6.4, root: 6.6, tip: 2.6, sweep: 4.8 },
    pods: [
      [0.3, 1.1],
      [0.55, 1.1],
    ],
  },
  B747: {
    length: 68.6,
    span: 59.6,
    body: 6.5,
    hump: true,
    wing: { at: 18.6, root: 16.5, tip: 4.0, sweep: 22.5, low: true },
    tail: { at: 57.5, span: 22.2, root: 9.0, tip: 2.7, sweep: 8.8 },
    fin: { at: 53.0, height: 9.9, root: 12.4, tip: 4.2, sweep: 9.6 },
    pods: [
      [0.38, 2.3],
      [0.68, 2.3],
    ],
  },
  JetStar: {
    length: 18.4,
    span: 16.6,
    body: 2.2,
    wing: { at: 6.4, root: 4.3, tip: 1.5, sweep: 4.6, low: true },
    tail: { at: 15.2, span: 7.5, root: 2.2, tip: 0.9, sweep: 1.6, high: 0.45 },
    fin: { at: 13.8, height: 3.0, root: 3.4, tip: 1.8, sweep: 2.0 },
    rearPods: true,
  },
};

const SMALLER = 0.62; // the view from ahead is less wide than the others, to leave them room

/**
 * The proportions of an aircraft: those known of type `id`, else made from its `size`, { span, area, chord, mach } as
 * far as they are given [m, m^2, m, 1].
 */
export function proportions(id, size) {
  return SHAPES[id] ?? plain(size ?? {});
}

/** A size of zero is one that the source does not give. */
function plain({ mach = 0, ...given }) {
  const span = given.span || 12;
  const area = given.area || 0.17 * span * span;
  const chord = given.chord || area / span;
  const taper = taperOf((chord * span) / area);
  const root = (2 * area) / (span * (1 + taper));
  const swept = Math.acos(Math.min(1, 0.62 / Math.max(mach, 0.1))); // as if the wing met no more than Mach 0.62
  const sweep = Math.min((span / 2) * Math.tan(Math.min(swept, 0.8)) + 0.25 * root * (1 - taper), 1.2 * span);
  const length = Math.max(0.65 * span + 2.6 * chord, 0.45 * span + root);
  const tail = { span: span * 0.36, root: root * 0.55, tip: root * (0.2 + 0.2 * taper), sweep: sweep * 0.36 };
  const fin = { height: length * 0.14, root: root * 0.7, tip: root * 0.35, sweep: Math.max(sweep * 0.4, root * 0.3) };
  return {
    length,
    span,
    body: length * 0.1,
    wing: { at: length * 0.42 - 0.25 * root - 0.35 * sweep, root, tip: root * taper, sweep, low: true },
    tail: { at: length * 0.99 - tail.root - 0.2 * tail.sweep, ...tail },
    fin: { at: length * 0.97 - fin.root, ...fin },
    canopy: span < 18 ? length * 0.26 : undefined,
  };
}

/**
 * Taper ratio l of a trapezoidal wing whose mean aerodynamic chord is `k` mean geometric ones:
 * k = 4/3 (1 + l + l^2) / (1 + l)^2, which runs from 1 (l = 1) to 4/3 (l = 0).
 */
function taperOf(k) {
  const m = 1 - 0.75 * Math.max(1, Math.min(1.32, k));
  return Math.min(1, (1 - 2 * m - Math.sqrt(Math.max(0, 1 - 4 * m))) / (2 * m));
}

/** An SVG three-view: from above, from the side, from ahead. `given`: the size that the server tells, or null. */
export function threeView(id, given) {
  const shape = proportions(id, given);
  const gap = 0.14 * shape.length;
  const high = shape.fin.height + shape.body;
  const wide = shape.length + gap + shape.span * SMALLER;
  const floor = shape.span + gap + high - shape.body / 2; // of the two views below: the body's middle
  const ahead = shape.length + gap + (shape.span * SMALLER) / 2;
  const margin = 0.03 * wide;
  return svg(
    "svg",
    {
      class: "three-view",
      viewBox: [-margin, -margin, wide + 2 * margin, shape.span + gap + high + 2 * margin].join(" "),
      "aria-hidden": "true",
    },
    svg("g", { transform: `translate(0 ${shape.span / 2})` }, fromAbove(shape)),
    svg("g", { transform: `translate(0 ${floor})` }, fromTheSide(shape)),
    svg("g", { transform: `translate(${ahead} ${floor}) scale(${SMALLER} 0.9)` }, fromAhead(shape)),
  );
}

const path = (points) => `${points.map(([x, y], i) => `${i ? "L" : "M"}${x.toFixed(2)} ${y.toFixed(2)}`).join("")}Z`;
const piece = (points) => svg("path", { d: path(points) });

/** Both halves of a wing or tailplane; `inner` is the body's half width. */
function surfaces({ at, root, tip, sweep }, half, inner) {
  return [-1, 1].map((side) =>
    piece([
      [at, side * inner],
      [at + sweep, side * half],
      [at + sweep + tip, side * half],
      [at + root, side * inner],
    ]),
  );
}

/** The body: half its outline in shares of length and half width, and its mirror image. */
function body({ length, body: wide, spike }) {
  const nose = spike ? 0.36 : 0.16;
  const bow = [0, 0.1, 0.25, 0.45, 0.7, 1].map((share) => [share * nose, share ** (spike ? 0.75 : 0.5)]);
  const half = [...bow, [0.66, 1], [1, 0.25]].map(([along, out]) => [along * length, (out * wide) / 2]);
  return piece([...half, ...half.map(([x, y]) => [x, -y]).reverse()]);
}

function fromAbove(shape) {
  const { wing, tail, span, body: wide } = shape;
  const inner = wide * 0.4;
  const parts = [...surfaces(wing, span / 2, inner), ...surfaces(tail, tail.span / 2, wide * 0.1)];
  for (const side of [-1, 1]) {
    for (const [along, pod] of shape.pods ?? []) {
      const y = (side * along * span) / 2;
      const lead = wing.at + along * wing.sweep;
      parts.push(svg("rect", { x: lead - pod * 1.9, y: y - pod / 2, width: pod * 2.6, height: pod, rx: pod * 0.4 }));
    }
    if (shape.rearPods)
      parts.push(
        svg("rect", {
          x: shape.length * 0.62,
          y: side * wide * 0.98 - wide * 0.36,
          width: shape.length * 0.17,
          height: wide * 0.72,
          rx: wide * 0.2,
        }),
      );
  }
  parts.push(body(shape));
  if (shape.canopy)
    parts.push(svg("ellipse", { class: "glass", cx: shape.canopy, cy: 0, rx: wide * 0.8, ry: wide * 0.27 }));
  if (shape.propeller) parts.push(svg("path", { d: `M0.1 -1.1V1.1`, class: "thin" }));
  return parts;
}

function fromTheSide(shape) {
  const { fin, tail, wing, body: high, length } = shape;
  const top = -high * 0.3;
  const parts = [
    piece([
      [fin.at, top],
      [fin.at + fin.sweep, top - fin.height],
      [fin.at + fin.sweep + fin.tip, top - fin.height],
      [fin.at + fin.root, top],
    ]),
  ];
  if (shape.canopy)
    parts.push(
      svg("ellipse", { class: "glass", cx: shape.canopy * 1.05, cy: -high * 0.45, rx: high * 0.9, ry: high * 0.34 }),
    );
  if (shape.hump)
    parts.push(svg("ellipse", { cx: length * 0.17, cy: -high * 0.42, rx: length * 0.13, ry: high * 0.42 }));
  parts.push(body(shape));
  const level = tail.high ? top - fin.height * (tail.high === true ? 0.96 : tail.high) : -high * 0.15;
  const tailAt = tail.high === true ? fin.at + fin.sweep : tail.at;
  parts.push(svg("rect", { class: "edge", x: tailAt, y: level - high * 0.05, width: tail.root, height: high * 0.1 }));
  parts.push(
    svg("rect", {
      class: "edge",
      x: wing.at,
      y: wing.low ? high * 0.24 : -high * 0.03,
      width: wing.root,
      height: high * 0.12,
    }),
  );
  for (const [, pod] of shape.pods ?? [])
    parts.push(
      svg("rect", {
        x: wing.at + wing.sweep * 0.2 - pod * 0.6,
        y: high * 0.42,
        width: pod * 2.4,
        height: pod * 0.9,
        rx: pod * 0.4,
      }),
    );
  if (shape.rearPods)
    parts.push(
      svg("rect", {
        class: "edge",
        x: length * 0.62,
        y: -high * 0.3,
        width: length * 0.17,
        height: high * 0.4,
        rx: high * 0.15,
      }),
    );
  return parts;
}

function fromAhead({ span, body: wide, fin, wing, tail, pods, rearPods }) {
  const [half, root] = [wide / 2, wing.low ? wide * 0.3 : 0];
  const rise = wing.low ? span * 0.035 : -span * 0.03;
  const thick = wide * 0.09;
  const parts = [
    piece([
      [-thick * 0.7, 0],
      [-thick * 0.4, -half - fin.height],
      [thick * 0.4, -half - fin.height],
      [thick * 0.7, 0],
    ]),
  ];
  const level = tail.high ? -half - fin.height * (tail.high === true ? 0.96 : tail.high) : -half * 0.4;
  parts.push(svg("rect", { x: -tail.span / 2, y: level - thick / 2, width: tail.span, height: thick }));
  for (const side of [-1, 1]) {
    parts.push(
      piece([
        [0, root - thick],
        [(side * span) / 2, root - rise - thick * 0.3],
        [(side * span) / 2, root - rise + thick * 0.3],
        [0, root + thick],
      ]),
    );
    for (const [along, pod] of pods ?? [])
      parts.push(svg("circle", { cx: (side * along * span) / 2, cy: root + pod * 0.5, r: pod / 2 }));
    if (rearPods) parts.push(svg("circle", { cx: side * wide * 0.95, cy: -half * 0.2, r: wide * 0.3 }));
  }
  parts.push(svg("circle", { cx: 0, cy: 0, r: half }));
  return parts;
}
