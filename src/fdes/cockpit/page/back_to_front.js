/**
 * The order in which the facets of a solid hide one another, for any eye: a binary space partition. H. Fuchs,
 * Z. Kedem, B. Naylor, "On visible surface generation by a priori tree structures", SIGGRAPH 1980.
 */

import { normalOf } from "./aircraft_shape.js";

const SAME = 0.004; // m: what is nearer to a plane lies in it
const TRIED = 12; // facets tried as the next plane
const PER_SPLIT = 6; // facets that a cut is worth, when planes are compared

/** A tree of { facets, plane: [a, b, c, d], front, back } of facets with `corners`; null for none. */
export function partition(facets) {
  if (!facets.length) return null;
  let best = null;
  const step = Math.max(1, Math.floor(facets.length / TRIED));
  for (let k = 0; k < facets.length; k += step) {
    const plane = planeOf(facets[k]);
    const sides = facets.map((one) => sideOf(plane, one));
    const cuts = sides.filter((side) => side === "cut").length;
    const lean = Math.abs(sides.filter((side) => side === "front").length - sides.filter((side) => side === "back").length);
    const cost = PER_SPLIT * cuts + lean;
    if (!best || cost < best.cost) best = { cost, plane, sides, own: k };
  }
  const [inPlane, front, back] = [[], [], []];
  facets.forEach((one, k) => {
    const side = k === best.own ? "in" : best.sides[k];
    if (side === "in") inPlane.push(one);
    if (side === "front") front.push(one);
    if (side === "back") back.push(one);
    if (side !== "cut") return;
    front.push({ ...one, corners: cutAway(one.corners, best.plane, 1) });
    back.push({ ...one, corners: cutAway(one.corners, best.plane, -1) });
  });
  return { facets: inPlane, plane: best.plane, front: partition(front), back: partition(back) };
}

/** Calls `paint(facet)` for every facet of `tree`, the farthest from the eye (x, y, z) first. */
export function walk(tree, x, y, z, paint) {
  if (!tree) return;
  const [a, b, c, d] = tree.plane;
  const ahead = a * x + b * y + c * z > d;
  walk(ahead ? tree.back : tree.front, x, y, z, paint);
  for (let k = 0; k < tree.facets.length; k++) paint(tree.facets[k]);
  walk(ahead ? tree.front : tree.back, x, y, z, paint);
}

function planeOf({ corners }) {
  const normal = normalOf(corners);
  const distance = corners.reduce((sum, corner) => sum + height([...normal, 0], corner), 0) / corners.length;
  return [...normal, distance];
}

const height = ([a, b, c, d], [x, y, z]) => a * x + b * y + c * z - d;

function sideOf(plane, { corners }) {
  let [front, back] = [false, false];
  for (const corner of corners) {
    const above = height(plane, corner);
    if (above > SAME) front = true;
    if (above < -SAME) back = true;
  }
  return front ? (back ? "cut" : "front") : back ? "back" : "in";
}

function cutAway(corners, plane, sign) {
  const kept = [];
  corners.forEach((a, k) => {
    const b = corners[(k + 1) % corners.length];
    const [ha, hb] = [sign * height(plane, a), sign * height(plane, b)];
    if (ha >= 0) kept.push(a);
    if (ha >= 0 === hb >= 0) return;
    const share = ha / (ha - hb);
    kept.push(a.map((value, i) => value + share * (b[i] - value)));
  });
  return kept;
}
