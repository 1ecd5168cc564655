/** Points of the land through a camera onto a 2-D canvas, cut off in front of the eye. */

import { toBody } from "./camera.js";

const NEAR = 12; // m ahead of the eye: what is closer is cut off
const FINEST = 0.5; // px: a strip is never drawn thinner, or it would flicker

/** Corners are kept in arrays that are used again and again: thousands in each picture would be garbage otherwise. */
export class Projector {
  constructor(context, cam) {
    this.context = context;
    this.cam = cam;
    this.spread = Math.hypot(cam.width / 2, cam.height - cam.cy) / cam.f;
    this.slant = Math.hypot(1, this.spread);
    this.together = null; // the path of what is filled together
    [this.xs, this.ys, this.zs, this.count, this.ahead] = [[], [], [], 0, true];
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

  /** The next corner of the polygon that `close` draws. */
  corner(north, east, up = 0) {
    const { cam, count } = this;
    const { axes } = cam;
    const [n, e, d] = [north - cam.north, east - cam.east, cam.eye - up];
    const x = axes[0] * n + axes[1] * e + axes[2] * d;
    this.xs[count] = x;
    this.ys[count] = axes[3] * n + axes[4] * e + axes[5] * d;
    this.zs[count] = axes[6] * n + axes[7] * e + axes[8] * d;
    if (x < NEAR) this.ahead = false;
    this.count = count + 1;
  }

  /** Draws the polygon whose corners were given, filled with `color`, or together with others. */
  close(color) {
    const { context, together, xs, ys, zs, count, ahead } = this;
    [this.count, this.ahead] = [0, true];
    const path = together ?? context;
    if (!together) context.beginPath();
    if (ahead) {
      const { cx, cy, f } = this.cam;
      path.moveTo(cx + (f * ys[0]) / xs[0], cy + (f * zs[0]) / xs[0]);
      for (let i = 1; i < count; i++) path.lineTo(cx + (f * ys[i]) / xs[i], cy + (f * zs[i]) / xs[i]);
    } else {
      const corners = Array.from({ length: count }, (_, i) => [xs[i], ys[i], zs[i]]);
      clip(corners, true).forEach((corner, i) => path[i ? "lineTo" : "moveTo"](...this.toScreen(corner)));
    }
    if (together) return;
    context.fillStyle = color;
    context.fill();
  }

  /** A flat rectangle on the ground. */
  rectangle(south, north, west, east, color) {
    this.corner(south, west);
    this.corner(north, west);
    this.corner(north, east);
    this.corner(south, east);
    this.close(color);
  }

  /** A filled polygon of points [north, east], or [north, east, up]. */
  polygon(points, color) {
    for (const point of points) this.corner(point[0], point[1], point[2]);
    this.close(color);
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
        this.corner(n0 + dn, e0 + de);
        this.corner(n1 + dn, e1 + de);
        this.corner(n1 - dn, e1 - de);
        this.corner(n0 - dn, e0 - de);
        this.close();
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
