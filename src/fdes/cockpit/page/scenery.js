/**
 * What lies on the ground and where: one place for both worlds. North-east coordinates in meters from where a flight
 * begins; nothing here is drawn. The land is flat and endless: woods, lakes and farms come from a hash of their cell,
 * so that they are always the same and need no memory.
 */

/** The flight begins at the origin heading north, 1,500 ft up, with the runway ahead. */
export const RUNWAY = { south: 2600, length: 3600, width: 60, name: "36" };
export const TOWN = { north: 13500, east: 5200 };
export const FIELD = 720; // m, side of a cell of farmland
export const COUNTRY = 2400; // m, side of a cell that may hold a wood and a farm
export const LAKELAND = 9600; // m, side of a cell that may hold a lake
export const ROAD_SPACING = 4800; // m
export const ROAD_WIDTH = 14;
export const RIVER_WIDTH = 120;
export const CLOUD_CELL = 5200; // m
export const CLOUD_BASE = 2700; // m

/** Pseudo-random number in 0..1 of two integers; the shader computes the same. After lowbias32 of C. Wellons. */
export function hash(i, j, salt) {
  let h = Math.imul(i, 0x8da6b343) ^ Math.imul(j, 0xd8163841) ^ Math.imul(salt, 0xcb1ab31f);
  h ^= h >>> 16;
  h = Math.imul(h, 0x7feb352d);
  h ^= h >>> 15;
  h = Math.imul(h, 0x846ca68b);
  h ^= h >>> 16;
  return (h >>> 0) / 4294967296;
}

/** East coordinate of the river's middle at `north`. */
export const riverEast = (north) => -5200 + 1400 * Math.sin(north / 5200) + 500 * Math.sin(north / 1700 + 1);

/** How a cell of farmland is divided ("whole", along "north" or "east"), from its first random number. */
export const fieldSplit = (random) => (random < 0.35 ? "whole" : random < 0.68 ? "north" : "east");

/** Which of `count` crops grows in half `half` (0 or 1) of a cell. */
export const crop = (i, j, half, count) => Math.floor(hash(i, j, 2 + half) * count);

/** Land kept clear of woods, lakes and farms: airfield, town, and the river. */
function isClear(north, east, margin) {
  const airfield =
    Math.abs(east) < 900 + margin &&
    north > RUNWAY.south - 1800 - margin &&
    north < RUNWAY.south + RUNWAY.length + 1500 + margin;
  const town = Math.hypot(north - TOWN.north, east - TOWN.east) < 2300 + margin;
  return !airfield && !town && Math.abs(east - riverEast(north)) > 150 + margin;
}

/** The wood of country cell (i, j), or null. */
export function woodIn(i, j) {
  if (hash(i, j, 11) > 0.5) return null;
  const radius = 140 + 420 * hash(i, j, 12) ** 2;
  const north = i * COUNTRY + radius + (COUNTRY - 2 * radius) * hash(i, j, 13);
  const east = j * COUNTRY + radius + (COUNTRY - 2 * radius) * hash(i, j, 14);
  return isClear(north, east, radius) ? { north, east, radius } : null;
}

/** The lake of lake cell (i, j), or null. */
export function lakeIn(i, j) {
  if (hash(i, j, 21) > 0.55) return null;
  const radius = 380 + 620 * hash(i, j, 22);
  const room = 1.4 * radius;
  const north = i * LAKELAND + room + (LAKELAND - 2 * room) * hash(i, j, 23);
  const east = j * LAKELAND + room + (LAKELAND - 2 * room) * hash(i, j, 24);
  return isClear(north, east, room) ? { north, east, radius, phase: 6.28 * hash(i, j, 25) } : null;
}

/** Distance from the middle of a lake to its shore in the direction `angle` [rad]. */
export const shore = ({ radius, phase }, angle) =>
  radius * (1 + 0.2 * Math.sin(2 * angle + phase) + 0.12 * Math.sin(3 * angle + 2 * phase));

/** Trees { north, east, height, shade } and farm buildings (boxes) of country cell (i, j). */
export function countryside(i, j) {
  const key = `${i},${j}`;
  if (!cells.has(key)) {
    if (cells.size > 1500) cells.clear(); // a long flight must not fill the memory
    cells.set(key, growCell(i, j));
  }
  return cells.get(key);
}
const cells = new Map();

const HEDGE_TREES = 30;
const hedge = (cells_) => Math.round((cells_ * COUNTRY) / FIELD) * FIELD; // trees stand along the edges of fields

function growCell(i, j) {
  const trees = [];
  const plant = (north, east, salt) =>
    trees.push({ north, east, height: 11 + 11 * hash(i, j, salt), shade: hash(i, j, salt + 1) });
  const wood = woodIn(i, j);
  const count = wood ? Math.min(150, Math.round((wood.radius / 28) ** 2)) : 0;
  for (let n = 0; n < count; n++) {
    const [away, angle] = [wood.radius * Math.sqrt(hash(i, j, 100 + n)), 6.283 * hash(i, j, 300 + n)];
    plant(wood.north + away * Math.cos(angle), wood.east + away * Math.sin(angle), 500 + 2 * n);
  }
  for (let n = 0; n < HEDGE_TREES; n++) {
    const [north, east] = [hedge(i + hash(i, j, 900 + n)), (j + hash(i, j, 950 + n)) * COUNTRY];
    if (isClear(north, east, 0)) plant(north, east, 1000 + 2 * n);
  }
  return { trees, boxes: hash(i, j, 31) < 0.4 ? farm(i, j) : [] };
}

function farm(i, j) {
  const [north, east] = [(i + 0.15 + 0.7 * hash(i, j, 32)) * COUNTRY, (j + 0.15 + 0.7 * hash(i, j, 33)) * COUNTRY];
  if (!isClear(north, east, 60)) return [];
  return [
    box(north, east, 14, 26, 9, [0.78, 0.74, 0.68], [0.5, 0.24, 0.18]),
    box(north + 38, east + 12, 30, 16, 8, [0.56, 0.3, 0.24], [0.36, 0.34, 0.34]),
  ];
}

/** A building: middle, size along north and east, height [m]; colors of walls and roof. */
function box(north, east, deep, wide, height, wall, roof = wall) {
  return { north, east, deep, wide, height, wall, roof };
}

/** Hangars, terminal and tower west of the runway; then the town. */
export const BUILDINGS = [...airfield(), ...town()];

function airfield() {
  const middle = RUNWAY.south + RUNWAY.length / 2;
  const hangars = [-3, -2, -1, 1, 2].map((n) =>
    box(middle + n * 150, -420, 90, 70, 20, [0.66, 0.68, 0.71], [0.5, 0.54, 0.58]),
  );
  return [
    ...hangars,
    box(middle + 30, -400, 110, 44, 14, [0.85, 0.84, 0.8], [0.42, 0.43, 0.45]),
    box(middle + 115, -330, 12, 12, 42, [0.9, 0.9, 0.9]),
    box(middle + 115, -330, 20, 20, 50, [0.25, 0.36, 0.42], [0.8, 0.3, 0.25]),
  ];
}

function town() {
  const blocks = [];
  for (let i = -7; i <= 7; i++) {
    for (let j = -7; j <= 7; j++) {
      const far = Math.hypot(i, j) / 7;
      if (far > 1 || hash(i, j, 41) < 0.15 + 0.45 * far) continue;
      const height = 10 + 150 * (1 - far) ** 3 * hash(i, j, 42) + 14 * hash(i, j, 43);
      const grey = 0.5 + 0.34 * hash(i, j, 44);
      const warm = 0.06 * hash(i, j, 45);
      const wall = [grey + warm, grey, grey - warm / 2];
      const size = [60 + 90 * hash(i, j, 46), 60 + 90 * hash(i, j, 47)];
      blocks.push(
        box(
          TOWN.north + i * 260,
          TOWN.east + j * 260,
          ...size,
          height,
          wall,
          far > 0.5 ? [0.5, 0.34, 0.28] : [0.4, 0.41, 0.43],
        ),
      );
    }
  }
  return blocks;
}

/** White paint on the runway as [south, north, west, east], in meters. */
export const RUNWAY_PAINT = paint();

function paint() {
  const { south, length, width } = RUNWAY;
  const north = south + length;
  const half = width / 2;
  const marks = [-1, 1].map((side) => [south, north, side * (half - 2) - 0.9, side * (half - 2) + 0.9]);
  for (let n = south + 330; n < north - 330; n += 60) marks.push([n, n + 36, -0.7, 0.7]);
  for (const [end, inward] of [
    [south, 1],
    [north, -1],
  ]) {
    const along = (a, b) => [end + inward * a, end + inward * b].sort((p, q) => p - q);
    for (let i = -6; i <= 6; i++) if (i) marks.push([...along(12, 60), i * 4 - 1.1, i * 4 + 1.1]);
    for (const side of [-1, 1]) {
      marks.push([...along(400, 460), side * 14 - 4, side * 14 + 4]);
      for (const mark of [200, 600, 800]) marks.push([...along(mark, mark + 24), side * 12 - 3, side * 12 + 3]);
    }
  }
  return marks;
}

/** Taxiway and apron as [south, north, west, east], in meters. */
export const APRONS = [
  [RUNWAY.south, RUNWAY.south + RUNWAY.length, -210, -188],
  [RUNWAY.south, RUNWAY.south + 24, -210, -30],
  [RUNWAY.south + RUNWAY.length - 24, RUNWAY.south + RUNWAY.length, -210, -30],
  [RUNWAY.south + RUNWAY.length / 2 - 12, RUNWAY.south + RUNWAY.length / 2 + 12, -210, -30],
  [RUNWAY.south + RUNWAY.length / 2 - 560, RUNWAY.south + RUNWAY.length / 2 + 440, -380, -210],
];

/** Elevation [rad] of the skyline at a compass direction [rad]: `layer` 0 is the far range, 1 the near hills. */
export function skyline(direction, layer) {
  const wave = (frequency, phase) => 0.5 + 0.5 * Math.sin(frequency * direction + phase);
  if (layer === 0)
    return (
      0.004 +
      0.026 *
        (0.5 * wave(3, 1) * wave(7, 2) + 0.32 * wave(11, 0.4) * wave(5, 4) + 0.12 * wave(29, 3) + 0.06 * wave(61, 1))
    );
  return 0.002 + 0.011 * (0.55 * wave(5, 2.6) * wave(8, 0.2) + 0.3 * wave(17, 5) + 0.15 * wave(43, 2));
}

/** The clouds of cloud cell (i, j): { north, east, height, radius, kind }. */
export function cloudIn(i, j) {
  if (hash(i, j, 51) > 0.62) return null;
  return {
    north: (i + 0.2 + 0.6 * hash(i, j, 52)) * CLOUD_CELL,
    east: (j + 0.2 + 0.6 * hash(i, j, 53)) * CLOUD_CELL,
    height: CLOUD_BASE + 500 * hash(i, j, 54),
    radius: 500 + 900 * hash(i, j, 55) ** 2,
    kind: Math.floor(3 * hash(i, j, 56)),
  };
}

const CROPS = [
  [0.36, 0.45, 0.22],
  [0.45, 0.5, 0.25],
  [0.61, 0.57, 0.33],
  [0.3, 0.41, 0.2],
  [0.52, 0.5, 0.29],
  [0.4, 0.5, 0.26],
  [0.5, 0.42, 0.3],
];

/** Light and colors, red-green-blue in 0..1. `light` multiplies everything on the ground. `sun`: north, east, down. */
export const LOOKS = {
  day: {
    sun: [0.52, 0.5, -0.69],
    sunColor: [1, 0.95, 0.82],
    light: [1, 1, 1],
    lamps: 0,
    zenith: [0.13, 0.33, 0.66],
    sky: [0.4, 0.62, 0.86],
    horizon: [0.79, 0.87, 0.93],
    haze: [0.73, 0.81, 0.87],
    cloud: [1, 1, 1],
    cloudShade: [0.72, 0.77, 0.84],
    ranges: [
      [0.53, 0.63, 0.73],
      [0.42, 0.53, 0.56],
    ],
    crops: CROPS,
    wood: [0.17, 0.28, 0.15],
    water: [0.28, 0.45, 0.6],
    road: [0.6, 0.59, 0.56],
    apron: [0.5, 0.51, 0.52],
    runway: [0.27, 0.28, 0.3],
    paint: [0.93, 0.93, 0.92],
    grass: [0.38, 0.47, 0.25],
  },
  dusk: {
    sun: [0.955, -0.26, -0.14],
    sunColor: [1, 0.72, 0.42],
    light: [0.36, 0.32, 0.36],
    lamps: 1,
    zenith: [0.06, 0.1, 0.25],
    sky: [0.35, 0.29, 0.42],
    horizon: [0.95, 0.58, 0.34],
    haze: [0.56, 0.38, 0.34],
    cloud: [0.93, 0.62, 0.5],
    cloudShade: [0.34, 0.27, 0.36],
    ranges: [
      [0.36, 0.26, 0.33],
      [0.2, 0.16, 0.2],
    ],
    crops: CROPS,
    wood: [0.17, 0.26, 0.17],
    water: [0.95, 0.72, 0.6],
    road: [0.55, 0.52, 0.52],
    apron: [0.48, 0.47, 0.5],
    runway: [0.27, 0.27, 0.31],
    paint: [0.95, 0.93, 0.9],
    grass: [0.34, 0.4, 0.25],
  },
};
