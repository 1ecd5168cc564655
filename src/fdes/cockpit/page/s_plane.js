/**
 * The natural modes in the s-plane, as SVG. Slow modes would be one dot at the origin: a second plane beside the first
 * magnifies it. Rays are lines of constant damping ratio, ellipses of constant natural frequency.
 */

import { svg } from "./dom.js";
import { figure } from "./units.js";

const SLOW = 0.12; // share of the fastest mode's frequency below which a mode goes into the magnified plane
const DAMPING = [0.2, 0.4, 0.6, 0.8];
const PAD = { top: 16, bottom: 17, left: 4, right: 4 };

/** Fills the SVG element `plane`, `width` by `height` px, with `modes` as the server describes them. */
export function drawSPlane(plane, modes, width, height) {
  plane.setAttribute("viewBox", `0 0 ${width} ${height}`);
  plane.replaceChildren();
  if (!modes.length || width < 60) return;
  const fastest = Math.max(...modes.map(({ omega_n }) => omega_n));
  const slow = modes.filter(({ omega_n }) => omega_n < SLOW * fastest);
  const magnified = slow.length > 0 && slow.length < modes.length;
  const share = magnified ? 0.6 : 1;
  const fast = magnified ? modes.filter((mode) => !slow.includes(mode)) : modes;
  drawPane(plane, fast, modes, { x: 0, width: width * share - (magnified ? 4 : 0), height, title: "s-plane, rad/s" });
  if (magnified) {
    const pane = { x: width * share + 4, width: width * (1 - share) - 4, height };
    drawPane(plane, slow, slow, { ...pane, title: "near the origin" });
  }
}

function drawPane(plane, named, all, { x, width, height, title }) {
  const reals = named.map(({ eigenvalue }) => eigenvalue[0]);
  const widest = Math.max(...named.map(({ omega_n }) => omega_n));
  const left = Math.min(...reals, -0.25 * widest) * 1.25;
  const right = Math.max(Math.max(...reals) * 1.4, -0.28 * left);
  const top = Math.max(...named.map(({ eigenvalue }) => eigenvalue[1]), 0.6 * widest) * 1.18;
  const area = { left: x + PAD.left, right: x + width - PAD.right, top: PAD.top, bottom: height - PAD.bottom };
  const sx = (area.right - area.left) / (right - left);
  const sy = (area.bottom - area.top) / (2 * top);
  const at = { x: (re) => area.left + (re - left) * sx, y: (im) => (area.top + area.bottom) / 2 - im * sy };
  const clipId = `pane-${Math.round(x)}`;
  const box = { x, y: 0, width, height, rx: 6 };

  const grid = svg("g", { class: "s-grid", "clip-path": `url(#${clipId})` });
  grid.append(svg("rect", { class: "s-unstable", x: at.x(0), y: 0, width: Math.max(0, x + width - at.x(0)), height }));
  const step = roundStep(top / 2);
  for (let r = step; r < 1.6 * Math.hypot(left, top); r += step) grid.append(svg("ellipse", { cx: at.x(0), cy: at.y(0), rx: r * sx, ry: r * sy }));
  for (const zeta of DAMPING) {
    const far = 3 * Math.hypot(left, top);
    for (const side of [-1, 1]) grid.append(svg("path", { class: "s-ray", d: `M${at.x(0)} ${at.y(0)}L${at.x(-zeta * far)} ${at.y(side * Math.sqrt(1 - zeta * zeta) * far)}` }));
  }
  grid.append(svg("path", { class: "s-axis", d: `M${x} ${at.y(0)}H${x + width}M${at.x(0)} 0V${height}` }));

  plane.append(svg("clipPath", { id: clipId }, svg("rect", box)), svg("rect", { class: "s-pane", ...box }), grid);
  for (let im = step; im < top; im += step) plane.append(svg("text", { class: "s-number", x: at.x(0) + 3, y: at.y(im) + 3.5 }, figure(im, 2)));
  plane.append(svg("text", { class: "s-title", x: x + 6, y: 11 }, title));
  plane.append(svg("text", { class: "s-number s-end", x: x + width - 5, y: height - 5 }, "unstable →"));
  plane.append(svg("text", { class: "s-number", x: x + 6, y: height - 5 }, figure(left / 1.25, 2)));
  placeLabels(plane, named, at, { x, width });
}

/** Crosses, and names beside those in the upper half; names that would touch are moved apart. */
function placeLabels(plane, modes, at, { x, width }) {
  let lowest = -Infinity;
  const above = [...modes].sort((a, b) => b.eigenvalue[1] - a.eigenvalue[1]);
  for (const mode of above) {
    const [re, im] = mode.eigenvalue;
    const group = svg("g", { class: `s-root s-${mode.axis}${re > 0 ? " s-divergent" : ""}`, "data-mode": mode.name });
    for (const side of im ? [1, -1] : [1]) {
      const [px, py] = [at.x(re), at.y(side * im)];
      group.append(svg("path", { d: `M${px - 4} ${py - 4}l8 8m0-8l-8 8` }));
    }
    group.append(svg("title", {}, `${modeName(mode.name)}: ${figure(re)} ${im ? `± ${figure(im)} i` : ""} rad/s`));
    const name = modeName(mode.name);
    const wide = name.length * 5.6;
    const room = x + width - at.x(re) - 10 > wide;
    const y = Math.max(at.y(im) + (im ? 3.5 : -8), lowest + 12);
    lowest = im ? y : lowest;
    group.append(svg("text", { x: at.x(re) + (im ? (room ? 8 : -8) : 0), y, "text-anchor": im ? (room ? "start" : "end") : clampAnchor(at.x(re), wide, x, width) }, name));
    plane.append(group);
  }
}

const clampAnchor = (px, wide, x, width) => (px - wide / 2 < x + 4 ? "start" : px + wide / 2 > x + width - 4 ? "end" : "middle");

/** "short_period" -> "Short period". */
export function modeName(name) {
  const words = name.replaceAll("_", " ");
  return words[0].toUpperCase() + words.slice(1);
}

function roundStep(value) {
  const power = 10 ** Math.floor(Math.log10(value));
  const lead = value / power;
  return (lead < 1.5 ? 1 : lead < 3.5 ? 2 : lead < 7.5 ? 5 : 10) * power;
}
