/**
 * The natural modes in the s-plane, as SVG. Slow modes would be one dot at the origin: a second plane beside the first
 * magnifies it. Rays are lines of constant damping ratio, ellipses of constant natural frequency.
 */

import { svg } from "./dom.js";
import { clamp, figure, minus } from "./units.js";

const SLOW = 0.12; // share of the fastest mode's frequency below which a mode goes into the magnified plane
const FAR = 2; // times the frequency of the aircraft's fastest mode
const DAMPING = [0.2, 0.4, 0.6, 0.8];
const LEAST_APART = 36; // px from number to number along the real axis
const FOREIGN = 0.1; // how much the half of divergent roots counts as covered for the name of one that decays
const BESIDE = 9; // px from a cross to a name beside it
const AWAY = 5; // px² of what may not be covered that a px farther away is worth
const UNDER = 13; // px from the real axis to the foot of its numbers, which clears a cross
const PAD = { top: 10, bottom: 17, left: 4, right: 4 };

/**
 * Fills the SVG element `plane`, `width` by `height` px, with `modes` as the server describes them; `trail` are modes as
 * they were before, `bare` the roots [re, im] without control law and actuators. Roots of actuators and sensors that lie far
 * to the left of the aircraft's are left out, for they would press those together: the table has them.
 */
export function drawSPlane(plane, all, width, height, trail = [], bare = []) {
  const reach = FAR * Math.max(...all.filter(({ name }) => !isEquipment(name)).map(({ omega_n }) => omega_n));
  const near = ({ name, eigenvalue, omega_n }) => !isEquipment(name) || omega_n < reach || eigenvalue[0] > 0;
  const modes = all.filter(near);
  plane.setAttribute("viewBox", `0 0 ${width} ${height}`);
  plane.replaceChildren();
  if (!modes.length || width < 60) return;
  const fastest = Math.max(...modes.map(({ omega_n }) => omega_n));
  const slow = modes.filter(({ omega_n }) => omega_n < SLOW * fastest);
  const magnified = slow.length > 0 && slow.length < modes.length;
  const share = magnified ? 0.6 : 1;
  const fast = magnified ? modes.filter((mode) => !slow.includes(mode)) : modes;
  const [slower, faster] = [true, false].map((below) => bare.filter((root) => Math.hypot(...root) < SLOW * fastest === below));
  const past = trail.filter(near);
  drawPane(plane, fast, modes, { x: 0, width: width * share - (magnified ? 4 : 0), height, title: "s-plane, rad/s", trail: past, bare: faster });
  if (magnified) {
    const pane = { x: width * share + 4, width: width * (1 - share) - 4, height, trail: past, bare: slower };
    drawPane(plane, slow, slow, { ...pane, title: "near the origin" });
  }
}

/** Whether a root is that of an actuator, or of a sensor's lag or delay. */
const isEquipment = (name) => /_actuator|_(lag|delay)(_\d+)?$/.test(name);

function drawPane(plane, named, all, { x, width, height, title, trail, bare }) {
  const names = new Set(named.map(({ name }) => name));
  const kept = trail.filter(({ name }) => names.has(name));
  const without = bare.map((eigenvalue) => ({ eigenvalue, omega_n: Math.hypot(...eigenvalue) }));
  const seen = [...named, ...kept, ...without]; // a trail stays in sight
  const reals = seen.map(({ eigenvalue }) => eigenvalue[0]);
  const widest = Math.max(...seen.map(({ omega_n }) => omega_n));
  const left = Math.min(...reals, -0.25 * widest) * 1.25;
  const right = Math.max(Math.max(...reals) * 1.4, -0.28 * left);
  const top = Math.max(...seen.map(({ eigenvalue }) => eigenvalue[1]), 0.6 * widest) * 1.18;
  const area = { left: x + PAD.left, right: x + width - PAD.right, top: PAD.top, bottom: height - PAD.bottom };
  const sx = (area.right - area.left) / (right - left);
  const sy = (area.bottom - area.top) / (2 * top);
  const at = { x: (re) => area.left + (re - left) * sx, y: (im) => (area.top + area.bottom) / 2 - im * sy };
  const clipId = `pane-${Math.round(x)}`;
  const box = { x, y: 0, width, height, rx: 6 };

  const grid = svg("g", { class: "s-grid", "clip-path": `url(#${clipId})` });
  grid.append(svg("rect", { class: "s-unstable", x: at.x(0), y: 0, width: Math.max(0, x + width - at.x(0)), height }));
  const step = nearestStep(top / 2);
  for (let r = step; r < 1.6 * Math.hypot(left, top); r += step)
    grid.append(svg("ellipse", { cx: at.x(0), cy: at.y(0), rx: r * sx, ry: r * sy }));
  for (const zeta of DAMPING) {
    const far = 3 * Math.hypot(left, top);
    for (const side of [-1, 1])
      grid.append(
        svg("path", {
          class: "s-ray",
          d: `M${at.x(0)} ${at.y(0)}L${at.x(-zeta * far)} ${at.y(side * Math.sqrt(1 - zeta * zeta) * far)}`,
        }),
      );
  }
  grid.append(svg("path", { class: "s-axis", d: `M${x} ${at.y(0)}H${x + width}M${at.x(0)} 0V${height}` }));

  plane.append(svg("clipPath", { id: clipId }, svg("rect", box)), svg("rect", { class: "s-pane", ...box }), grid);
  plane.append(drawTrail(trail, at, clipId), drawBare(bare, at));
  const said = without.length && x === 0 ? `${title} · ◇ bare aircraft` : title;
  const middle = (at.x(0) + x + width) / 2; // of the half of divergent roots
  const words = [
    [x, x + said.length * 5.6, height - 14, height], // not to be covered: left, right, top, bottom
    [at.x(0) - 1, at.x(0) + 1, 0, height],
    [middle - 5, middle + 5, height - 50, height - 6],
  ];
  for (let im = step; im < top; im += step) {
    plane.append(svg("text", { class: "s-number", x: at.x(0) + 3, y: at.y(im) + 3.5 }, tidy(im)));
    words.push([at.x(0), at.x(0) + 22, at.y(im) - 5, at.y(im) + 4]);
  }
  let across = nearestStep(-left / 2.4);
  if (across * sx < LEAST_APART) across *= 2;
  for (let re = across; at.x(-re) > x + 14; re += across) {
    plane.append(svg("text", { class: "s-number s-middle", x: at.x(-re), y: at.y(0) + UNDER }, tidy(-re)));
    words.push([at.x(-re) - 11, at.x(-re) + 11, at.y(0) + UNDER - 8, at.y(0) + UNDER + 1]);
    grid.append(svg("path", { class: "s-axis", d: `M${at.x(-re)} ${at.y(0) - 2}v4` }));
  }
  plane.append(svg("text", { class: "s-title", x: x + 6, y: height - 5 }, said));
  if (x === 0) plane.append(svg("text", { class: "s-number s-middle", transform: `translate(${middle + 3} ${height - 28}) rotate(-90)` }, "unstable"));
  placeLabels(plane, named, at, { x, width, height }, words);
}

/** Where the roots have been: one path of dots for each axis of motion; roots that fall on one pixel are one dot. */
function drawTrail(trail, at, clipId) {
  const group = svg("g", { class: "s-trails", "clip-path": `url(#${clipId})` });
  for (const axis of ["longitudinal", "lateral"]) {
    const dots = new Set();
    for (const { axis: own, eigenvalue } of trail) {
      const [re, im] = eigenvalue;
      if (own === axis) for (const side of im ? [1, -1] : [1]) dots.add(`M${Math.round(at.x(re))} ${Math.round(at.y(side * im))}h.01`);
    }
    if (dots.size) group.append(svg("path", { class: `s-trail s-${axis}`, d: [...dots].join("") }));
  }
  return group;
}

/** Where the roots are without control law and actuators: hollow diamonds. */
function drawBare(bare, at) {
  const group = svg("g", { class: "s-bare" }, svg("title", {}, "The bare aircraft, without control law and actuators"));
  for (const [re, im] of bare) group.append(svg("path", { d: `M${at.x(re) - 4} ${at.y(im)}l4 -4l4 4l-4 4z` }));
  for (const [re, im] of bare.filter((root) => root[1])) group.append(svg("path", { d: `M${at.x(re) - 4} ${at.y(-im)}l4 -4l4 4l-4 4z` }));
  return group;
}

/** Crosses, and names beside those of the upper half, where they touch neither a cross nor another name. */
function placeLabels(plane, modes, at, pane, words) {
  const crosses = modes.flatMap(({ eigenvalue: [re, im] }) =>
    (im ? [1, -1] : [1]).map((side) => ({ x: at.x(re), y: at.y(side * im), reach: 6 })),
  );
  const taken = [
    ...words,
    ...crosses.map(({ x: px, y: py, reach }) => [px - reach, px + reach, py - reach, py + reach]),
  ];
  for (const mode of modes) {
    const [re, im] = mode.eigenvalue;
    const group = svg("g", { class: `s-root s-${mode.axis}${re > 0 ? " s-divergent" : ""}`, "data-mode": mode.name });
    for (const side of im ? [1, -1] : [1]) {
      const [px, py] = [at.x(re), at.y(side * im)];
      group.append(svg("path", { d: `M${px - 4} ${py - 4}l8 8m0-8l-8 8` }));
    }
    group.append(svg("title", {}, `${modeName(mode.name)}: ${figure(re)} ${im ? `± ${figure(im)} i` : ""} rad/s`));
    const name = modeName(mode.name);
    const divergent = [at.x(0), pane.x + pane.width, 0, pane.height, FOREIGN];
    const spot = freeSpot(at.x(re), at.y(im), name.length * 5.8, pane, re > 0 ? taken : [...taken, divergent]);
    taken.push(spot.box);
    group.append(leader(at.x(re), at.y(im), spot.box), svg("text", { x: spot.x, y: spot.y }, name));
    plane.append(group);
  }
}

/** A line from a cross to a name that is not beside it. */
function leader(px, py, [left, right, top, bottom]) {
  const [x, y] = [clamp(px, left, right), clamp(py, top, bottom)];
  return Math.hypot(x - px, y - py) > 2 * BESIDE ? svg("line", { x1: px, y1: py, x2: x, y2: y }) : "";
}

/** Where a name `wide` px long goes: left, right, above or below its cross, or farther; where it covers least. */
function freeSpot(px, py, wide, { x, width, height }, taken) {
  const within = (left) => clamp(left, x + 5, x + width - wide - 5);
  const center = within(px - wide / 2);
  const spots = [
    [px - 9 - wide, py + 3.5],
    [px + 9, py + 3.5],
    [center, py - 9],
    [center, py + 17],
    [px - 9 - wide, py + 13],
    [px - 9 - wide, py - 6],
    [px + 9, py - 6],
    [center, py - 19],
    [center, py + 28],
    [center, py - 30],
    [center, py + 39],
    [center, py - 41],
    ...[-9, 17, -19, 28, -30, 39, -41].flatMap((up) => [within(px - wide), within(px)].map((left) => [left, py + up])),
  ];
  if (Math.abs(py - (PAD.top + height - PAD.bottom) / 2) < 1) spots.unshift(spots[2]); // not along the real axis
  const candidates = spots.map(([left, base]) => ({ x: left, y: base, box: [left, left + wide, base - 9, base + 2] }));
  const overlap = ([l, r, t, b]) => {
    let area = 0;
    for (const [L, R, T, B, weight = 1] of taken)
      area += weight * Math.max(0, Math.min(r, R) - Math.max(l, L)) * Math.max(0, Math.min(b, B) - Math.max(t, T));
    return area;
  };
  const inside = ({ box: [l, r, t, b] }) => l > x + 3 && r < x + width - 3 && t > 0 && b < height;
  const away = ([l, r, t, b]) => Math.hypot(px - clamp(px, l, r), py - clamp(py, t, b));
  for (const spot of candidates) spot.cost = overlap(spot.box) + AWAY * Math.max(0, away(spot.box) - BESIDE);
  return candidates.filter(inside).sort((one, other) => one.cost - other.cost)[0] ?? candidates[0];
}

const tidy = (value) => minus(Number(value.toPrecision(3)));

/** "short_period" -> "Short period". */
export function modeName(name) {
  const words = name.replace(/^(e|a|r)\w+_actuator/, "δ$1 actuator").replace(/_(lag|delay)/, " sensor $1").replaceAll("_", " ");
  return isEquipment(name) ? words : words[0].toUpperCase() + words.slice(1);
}

function nearestStep(value) {
  const power = 10 ** Math.floor(Math.log10(value));
  const lead = value / power;
  return (lead < 1.5 ? 1 : lead < 3.5 ? 2 : lead < 7.5 ? 5 : 10) * power;
}
