/** A CSV file with measured columns, read in the browser: the server never sees the file, only its numbers. */

import { DEG, FOOT, KNOT } from "./units.js";

export const MOST_ROWS = 4000; // that the server takes
const LARGEST = 4e6; // bytes
const TO_SI = { deg: DEG, "°": DEG, rad: 1, "m/s": 1, "ft/s": FOOT, kt: KNOT, 1: 1, s: 1, ms: 1e-3, min: 60 };
const UNITS = { rad: ["deg", "°", "rad"], "m/s": ["m/s", "ft/s", "kt"], 1: ["1"], s: ["s", "ms", "min"] };

/** The columns of a chosen `file`: [{name, unit, cells}], with the file's name. Fails with a sentence for the user. */
export async function readColumns(file) {
  if (file.size > LARGEST) throw new Error(`${file.name} has ${(file.size / 1e6).toFixed(1)} MB; at most 4 MB are read.`);
  const lines = (await file.text()).replace(/^\uFEFF/, "").split(/\r?\n/);
  const rows = lines.map((line, i) => ({ number: i + 1, cells: line.split(",") })).filter(({ cells }) => cells.join("").trim());
  if (rows.length === 0) throw new Error(`${file.name} is empty. Its first line should be like: t [s],elevator [deg]`);
  const [head, ...body] = rows;
  return {
    file: file.name,
    body,
    columns: head.cells.map((cell) => {
      const [, name, unit] = /^\s*"?([^[\]"]*?)\s*(?:\[\s*([^[\]]*?)\s*\])?"?\s*$/.exec(cell) ?? [null, cell.trim()];
      return { name, unit };
    }),
  };
}

/** Times [s] and values [SI unit `si`] of a column. Fails with a sentence that says what is wrong, and where. */
export function historyOf(table, column, si) {
  const { file, body, columns } = table;
  const places = ["t", column].map((wanted) => columns.findIndex(({ name }) => name === wanted));
  if (places[0] < 0) throw new Error(`${file} has no column t, the time.`);
  const factors = places.map((place, i) => factor(file, columns[place], ["s", si][i]));
  if (body.length < 2) throw new Error(`${file} has ${body.length} rows of numbers; at least two are needed.`);
  if (body.length > MOST_ROWS)
    throw new Error(`${file} has ${body.length} rows; the cockpit takes ${MOST_ROWS}. Leave out rows, or use fdes simulate.`);
  const [times, values] = places.map((place, i) => body.map((row) => number(file, row, columns[place].name, place) * factors[i]));
  const back = times.findIndex((t, k) => k > 0 && t <= times[k - 1]);
  if (back > 0) throw new Error(`Line ${body[back].number} of ${file}: t must grow from row to row.`);
  return { times, values };
}

function factor(file, { name, unit }, si) {
  if (unit === undefined && (name === "t" || si === "1")) return 1;
  if (unit === undefined) throw new Error(`The header of ${name} in ${file} has no unit. Write it like: ${name} [${UNITS[si][0]}]`);
  if (!UNITS[si].includes(unit)) throw new Error(`${name} in ${file} is in ${unit}; here it must be in ${UNITS[si].join(", ")}.`);
  return TO_SI[unit];
}

function number(file, row, name, place) {
  const cell = row.cells[place]?.trim() ?? "";
  const value = cell === "" ? NaN : Number(cell);
  if (!Number.isFinite(value)) throw new Error(`Line ${row.number} of ${file}: ${name} is ${cell || "empty"}, not a finite number.`);
  return value;
}
