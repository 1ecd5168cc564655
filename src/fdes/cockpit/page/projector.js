/** Points of the land through a camera onto a 2-D canvas, cut off in front of the eye. */

import { toBody } from "./camera.js";

const NEAR = 12; // m ahead of the eye: what is closer is cut off
const FINEST = 0.5; // px: a strip is never drawn thinner, or it would flicker

export class Projector {
  constructor(context, cam) {
    this.context = context;
    this.cam = cam;
    this.together = null;
    this.spread = Math.hypot(cam.width / 2, cam.height - cam.cy) / cam.f;
    this.slant = Math.hypot(1, this.spread);
  }

  /** Body coordinates of a place on the ground, or `up` meters above it. */
  place(north, east, up = 0) {
    const { cam } = this;
    return toBody(cam.axes, north - cam.north, east - cam.east, cam.eye - up);
  }

  /** Whether a disc of `radius` on the ground lies wholly outside the cone that the screen's corners span. */
  outside(north, east, radius) {
    const [x, y, z] = this.place(north, east);
    return Math.hypot(y, z) - this.slant * radius > Math.max(0, x + radius) * this.spread;
  }

  toScreen([x, y, z]) {
    const { cx, cy, f } = this.cam;
    return [cx + (f * y) / x, cy + (f * z) / x];
  }

  /** A flat rectangle on the ground. */
  rectangle(south, north, west, east, color) {
    this.polygon(
      [
        [south, west],
        [north, west],
        [north, east],
        [south, east],
      ],
      color,
    );
  }

  /** A filled polygon of ground points [north, east]. */
  polygon(points, color) {
    this.fill(
      points.map(([n, e]) => this.place(n, e)),
      color,
    );
  }

  /** A filled polygon of points [north, east, up]. */
  solid(points, color) {
    this.fill(
      points.map(([n, e, up]) => this.place(n, e, up)),
      color,
    );
  }

  /** The ground between two lines of points, drawn link by link: a long curved band is no convex polygon. */
  band(left, right, color) {
    for (let i = 1; i < left.length; i++) this.polygon([left[i - 1], left[i], right[i], right[i - 1]], color);
  }

  /** Straight roads [n0, e0, n1, e1] of `width` [m]; in the distance hairlines. */
  strips(roads, width, color) {
    const hairlines = new Path2D();
    this.ofOne(color, () => {
      for (const [n0, e0, n1, e1] of roads) {
        const line = clip([this.place(n0, e0), this.place(n1, e1)], false);
        if (line.length < 2) continue;
        hairlines.moveTo(...this.toScreen(line[0]));
        hairlines.lineTo(...this.toScreen(line[1]));
        const along = [n1 - n0, e1 - e0];
        const half = width / 2 / Math.hypot(...along);
        const [dn, de] = [-along[1] * half, along[0] * half];
        this.polygon([
          [n0 + dn, e0 + de],
          [n1 + dn, e1 + de],
          [n1 - dn, e1 - de],
          [n0 - dn, e0 - de],
        ]);
      }
    });
    const { context } = this;
    context.strokeStyle = color;
    context.lineWidth = FINEST;
    context.stroke(hairlines);
  }

  /** A light on the ground: never smaller than a pixel, so that it is seen from afar. */
  lamp(north, east, color) {
    const point = this.place(north, east, 0.5);
    if (point[0] < NEAR) return;
    const [x, y] = this.toScreen(point);
    const size = Math.min(3, Math.max(1.1, (this.cam.f * 0.8) / point[0]));
    this.context.fillStyle = color;
    this.context.fillRect(x - size / 2, y - size / 2, size, size);
  }

  fill(corners, color) {
    const path = this.together ?? new Path2D();
    const visible = clip(corners, true);
    if (visible.length < 3) return;
    visible.forEach((corner, i) => path[i ? "lineTo" : "moveTo"](...this.toScreen(corner)));
    if (this.together) return;
    this.context.fillStyle = color;
    this.context.fill(path);
  }

  /** What `draw` draws is of one `color`, and is filled together: a fill for each would cost too much. */
  ofOne(color, draw) {
    this.together = new Path2D();
    draw();
    this.context.fillStyle = color;
    this.context.fill(this.together);
    this.together = null;
  }
}

/** The part of a polygon (or, if not `closed`, of a line) ahead of the near plane. Sutherland and Hodgman (1974). */
function clip(corners, closed) {
  if (corners.every(([x]) => x >= NEAR)) return corners;
  const kept = [];
  const sides = closed ? corners.length : corners.length - 1;
  for (let i = 0; i < corners.length; i++) {
    const [a, b] = [corners[i], corners[(i + 1) % corners.length]];
    if (a[0] >= NEAR) kept.push(a);
    if (i < sides && a[0] >= NEAR !== b[0] >= NEAR) {
      const share = (NEAR - a[0]) / (b[0] - a[0]);
      kept.push([NEAR, a[1] + share * (b[1] - a[1]), a[2] + share * (b[2] - a[2])]);
    }
  }
  return kept;
}
