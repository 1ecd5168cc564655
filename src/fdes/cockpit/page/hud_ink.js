/** Strokes of the head-up display, collected by how they are drawn. */

/** The strokes of one picture, by how they are drawn. */
export class Ink {
  constructor() {
    this.lines = new Path2D();
    this.texts = [];
    this.dashes = new Path2D();
    this.backing = new Path2D();
  }

  line(...xy) {
    trace(this.lines, xy);
  }

  dashed(...xy) {
    trace(this.dashes, xy);
  }

  /** A polyline around (x, y): `numbers` are x, y, x, y ... in units of `scale`, or of [across, down]. */
  shape(x, y, scale, numbers) {
    const [across, down] = Array.isArray(scale) ? scale : [scale, scale];
    trace(
      this.lines,
      numbers.map((number, i) => (i % 2 ? y + down * number : x + across * number)),
    );
  }

  circle(x, y, radius) {
    this.lines.moveTo(x + radius, y);
    this.lines.arc(x, y, radius, 0, 2 * Math.PI);
  }

  text(text, x, y, size, align = 0, angle = 0) {
    this.texts.push({ text, x, y, size, align, angle });
  }
}

function trace(path, xy) {
  path.moveTo(xy[0], xy[1]);
  for (let i = 2; i < xy.length; i += 2) path.lineTo(xy[i], xy[i + 1]);
}
