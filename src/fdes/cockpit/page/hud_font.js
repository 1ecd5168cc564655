/**
 * Stroke letters for the head-up display, on a grid 4 wide and 6 high, as a symbol generator draws them: one polyline
 * per stroke, "xy" per point. A stroke of one point twice is a dot.
 */

const STROKES = {
  0: "10 30 41 45 36 16 05 01 10",
  1: "11 20 26|16 36",
  2: "01 10 30 41 42 06 46",
  3: "01 10 30 41 42 33 44 45 36 16 05|13 33",
  4: "36 30 04 44",
  5: "40 00 03 12 32 43 45 36 16 05",
  6: "30 20 02 05 16 36 45 44 33 13 04",
  7: "00 40 16",
  8: "13 02 01 10 30 41 42 33 13 04 05 16 36 45 44 33",
  9: "16 26 44 41 30 10 01 02 13 33 42",
  A: "06 02 20 42 46|04 44",
  B: "00 06 36 45 44 33 03|33 42 41 30 00",
  C: "41 30 10 01 05 16 36 45",
  D: "00 06 26 44 42 20 00",
  E: "40 00 06 46|03 33",
  F: "40 00 06|03 33",
  G: "41 30 10 01 05 16 36 45 43 23",
  H: "00 06|40 46|03 43",
  I: "20 26|10 30|16 36",
  J: "40 45 36 16 05",
  K: "00 06|40 03 46",
  L: "00 06 46",
  M: "06 00 23 40 46",
  N: "06 00 46 40",
  O: "10 30 41 45 36 16 05 01 10",
  P: "06 00 30 41 42 33 03",
  Q: "10 30 41 45 36 16 05 01 10|34 46",
  R: "06 00 30 41 42 33 03|23 46",
  S: "41 30 10 01 02 13 33 44 45 36 16 05",
  T: "00 40|20 26",
  U: "00 05 16 36 45 40",
  V: "00 26 40",
  W: "00 06 23 46 40",
  X: "00 46|40 06",
  Y: "00 23 40|23 26",
  Z: "00 40 06 46",
  ".": "26 26",
  ",": "26 17",
  "-": "13 33",
  "+": "03 43|21 25",
  ":": "22 22|25 25",
  "/": "06 40",
  α: "42 34 26 16 05 03 12 22 34 46",
};

const HEIGHT = 6;
const ADVANCE = 5.6;
const DOT = 1.1; // px: how long a stroke of no length is drawn

const GLYPHS = Object.fromEntries(
  Object.entries(STROKES).map(([letter, strokes]) => [
    letter,
    strokes.split("|").map((stroke) => stroke.split(" ").map((point) => [Number(point[0]), Number(point[1])])),
  ]),
);

/** Letters drawn once for each size, dark halo and green core, and copied from then on: strokes cost many times more. */
export class Lettering {
  constructor() {
    this.sheets = new Map();
  }

  /**
   * Writes `text` on `context`: letters `size` [px] high, the middle of the line at (x, y), turned by `angle` [rad].
   * `align` is -1 for text that starts at x, 0 for centered, 1 for text that ends there. `strokes` are [color, width]
   * pairs, drawn one over the other; `ratio` is device pixels per px.
   */
  write(context, { text, x, y, size, align, angle }, strokes, ratio) {
    const sheet = this.sheet(size, strokes, ratio);
    const unit = size / HEIGHT;
    const width = (text.length * ADVANCE - (ADVANCE - 4)) * unit;
    const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
    if (angle) context.setTransform(cos * ratio, sin * ratio, -sin * ratio, cos * ratio, x * ratio, y * ratio);
    const [x0, y0] = angle ? [0, 0] : [x, y];
    let left = x0 - (width * (align + 1)) / 2 - sheet.margin;
    const top = y0 - size / 2 - sheet.margin;
    for (const letter of text) {
      const picture = sheet.of(letter);
      if (picture) context.drawImage(picture, left, top, picture.width / ratio, picture.height / ratio);
      left += ADVANCE * unit;
    }
    if (angle) context.setTransform(ratio, 0, 0, ratio, 0, 0);
  }

  sheet(size, strokes, ratio) {
    const key = `${size} ${ratio}`;
    if (!this.sheets.has(key)) this.sheets.set(key, new Sheet(size, strokes, ratio));
    return this.sheets.get(key);
  }
}

/** The letters of one size. */
class Sheet {
  constructor(size, strokes, ratio) {
    Object.assign(this, { unit: size / HEIGHT, strokes, ratio, pictures: new Map() });
    this.margin = Math.max(...strokes.map(([, width]) => width)) / 2 + 1;
  }

  of(letter) {
    if (!GLYPHS[letter]) return null;
    if (!this.pictures.has(letter)) this.pictures.set(letter, this.draw(GLYPHS[letter]));
    return this.pictures.get(letter);
  }

  draw(glyph) {
    const { unit, margin, ratio, strokes } = this;
    const canvas = document.createElement("canvas");
    canvas.width = Math.ceil((4 * unit + 2 * margin) * ratio);
    canvas.height = Math.ceil((HEIGHT * unit + 2 * margin) * ratio);
    const context = canvas.getContext("2d");
    context.scale(ratio, ratio);
    context.translate(margin, margin);
    context.lineCap = context.lineJoin = "round";
    for (const [color, width] of strokes) {
      [context.strokeStyle, context.lineWidth] = [color, width];
      context.beginPath();
      for (const [[fromX, fromY], ...rest] of glyph) {
        context.moveTo(fromX * unit, fromY * unit);
        for (const [toX, toY] of rest) context.lineTo(toX * unit + (toX === fromX && toY === fromY ? DOT : 0), toY * unit);
      }
      context.stroke();
    }
    return canvas;
  }
}
