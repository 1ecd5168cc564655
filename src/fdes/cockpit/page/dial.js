/**
 * A round instrument to draw on: lengths as shares of the radius, angles in radians clockwise from the top. Every
 * instrument of the shelf draws through it, so that it looks right at any size.
 */

export const WHITE = "#f1f4f6";
export const AMBER = "#ffb545";
export const GREY = "#9aa6b1";
export const BLACK = "#0b0e11";
export const CYAN = "#58d5e8";

const TURN = 2 * Math.PI;
const GLASS = 0.885; // radius of the visible face

export class Dial {
  constructor(context, radius) {
    this.context = context;
    this.radius = radius;
  }

  /** Runs `paint` with the dial turned by `angle` and then moved by (x, y). */
  turned(angle, paint, x = 0, y = 0) {
    const { context, radius } = this;
    context.save();
    context.rotate(angle);
    context.translate(x * radius, y * radius);
    paint();
    context.restore();
  }

  /** Runs `paint` with drawing limited to the glass, or to a circle of radius `share`. */
  clipped(paint, share = GLASS) {
    const { context, radius } = this;
    context.save();
    context.beginPath();
    context.arc(0, 0, share * radius, 0, TURN);
    context.clip();
    paint();
    context.restore();
  }

  line(points, width, color = WHITE, cap = "butt") {
    const { context } = this;
    this.path(points);
    context.lineWidth = width * this.radius;
    context.strokeStyle = color;
    context.lineCap = cap;
    context.lineJoin = "round";
    context.stroke();
  }

  polygon(points, color = WHITE) {
    this.path(points);
    this.context.closePath();
    this.context.fillStyle = color;
    this.context.fill();
  }

  path(points) {
    const { context, radius } = this;
    context.beginPath();
    points.forEach(([x, y], i) => context[i ? "lineTo" : "moveTo"](x * radius, y * radius));
  }

  disc(x, y, share, color) {
    const { context, radius } = this;
    context.beginPath();
    context.arc(x * radius, y * radius, share * radius, 0, TURN);
    context.fillStyle = color;
    context.fill();
  }

  box(left, top, wide, high, color, edge = null) {
    const { context, radius } = this;
    context.beginPath();
    context.roundRect(left * radius, top * radius, wide * radius, high * radius, 0.03 * radius);
    context.fillStyle = color;
    context.fill();
    if (!edge) return;
    context.lineWidth = Math.max(1, 0.012 * radius);
    context.strokeStyle = edge;
    context.stroke();
  }

  tick(angle, from, to, width, color = WHITE) {
    const [sin, cos] = [Math.sin(angle), -Math.cos(angle)];
    this.line(
      [
        [from * sin, from * cos],
        [to * sin, to * cos],
      ],
      width,
      color,
    );
  }

  arc(from, to, share, width, color) {
    const { context, radius } = this;
    context.beginPath();
    context.arc(0, 0, share * radius, from - Math.PI / 2, to - Math.PI / 2);
    context.lineWidth = width * radius;
    context.strokeStyle = color;
    context.lineCap = "butt";
    context.stroke();
  }

  text(text, x, y, size, color = WHITE, weight = 600) {
    const { context, radius } = this;
    context.font = `${weight} ${(size * radius).toFixed(1)}px system-ui, "Segoe UI", Roboto, "DejaVu Sans", sans-serif`;
    context.textAlign = "center";
    context.textBaseline = "middle";
    context.fillStyle = color;
    context.fillText(text, x * radius, y * radius);
  }

  /** A word or number on the rim, upright. */
  label(text, angle, share, size, color = WHITE) {
    this.text(text, share * Math.sin(angle), -share * Math.cos(angle), size, color);
  }

  /** A tapered hand with a shadow, `length` long from the middle, `tail` behind it. */
  needle(angle, length, width, { color = WHITE, tail = 0.18 } = {}) {
    const shape = [
      [-width, tail],
      [-width * 0.75, -length + 0.12],
      [0, -length],
      [width * 0.75, -length + 0.12],
      [width, tail],
    ];
    const { context, radius } = this;
    context.save();
    context.translate(0.012 * radius, 0.022 * radius);
    this.turned(angle, () => this.polygon(shape, "rgba(0, 0, 0, 0.45)"));
    context.restore();
    this.turned(angle, () => this.polygon(shape, color));
  }

  cap(share = 0.085) {
    this.disc(0, 0, share, "#343c45");
    this.disc(0, 0, share * 0.55, "#59636e");
  }

  /** A small arrow outside the scale: where the aircraft was in trim. */
  bug(angle) {
    this.turned(angle, () =>
      this.polygon(
        [
          [0, -0.74],
          [-0.045, -0.64],
          [0.045, -0.64],
        ],
        CYAN,
      ),
    );
  }

  /** The two-tone case and the dark face, under everything else. */
  case() {
    const { context, radius } = this;
    const rim = context.createLinearGradient(-radius, -radius, radius, radius);
    for (const [at, color] of [
      [0, "#6a747f"],
      [0.4, "#323941"],
      [1, "#15191d"],
    ])
      rim.addColorStop(at, color);
    this.disc(0, 0, 0.985, rim);
    this.disc(0, 0, 0.915, "#07090b");
    const face = context.createRadialGradient(0, -0.3 * radius, 0.1 * radius, 0, 0, 0.95 * radius);
    for (const [at, color] of [
      [0, "#20262c"],
      [1, "#0a0d10"],
    ])
      face.addColorStop(at, color);
    this.disc(0, 0, GLASS, face);
  }

  /** Light on the glass, over everything else. */
  glass() {
    const { context, radius } = this;
    this.clipped(() => {
      const shine = context.createLinearGradient(0, -radius, 0, 0);
      for (const [at, color] of [
        [0, "rgba(255,255,255,0.13)"],
        [1, "rgba(255,255,255,0)"],
      ])
        shine.addColorStop(at, color);
      context.beginPath();
      context.ellipse(-0.1 * radius, -0.62 * radius, 0.86 * radius, 0.5 * radius, -0.25, 0, TURN);
      context.fillStyle = shine;
      context.fill();
    });
    context.beginPath();
    context.arc(0, 0, (GLASS + 0.012) * radius, 0, TURN);
    context.lineWidth = 0.03 * radius;
    context.strokeStyle = "rgba(0, 0, 0, 0.55)";
    context.stroke();
  }
}
