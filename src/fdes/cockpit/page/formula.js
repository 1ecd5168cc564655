/** Words with formulas as the command line writes them, set as a book sets them: zeta_sp is ζ with sp below, s^2 is s². */

import { html } from "./dom.js";

const GREEK = { alpha: "α", beta: "β", delta: "δ", omega: "ω", phi: "φ", tau: "τ", theta: "θ", zeta: "ζ" };
const LETTER = new RegExp(`(?<![\\w])(${Object.keys(GREEK).join("|")})(?:_(\\w+))?(?!\\w)`);
const POWERS = { "^2": "²", "^3": "³" };

/** `text` as nodes for an HTML element. What is no formula stays as it is. */
export function formula(text) {
  const words = text.replace(/\^[23]/g, (power) => POWERS[power]).split(LETTER); // words, letter, subscript, words, ...
  return words.flatMap((word, i) => (i % 3 === 0 ? [word] : i % 3 === 1 ? [GREEK[word]] : word ? [html("sub", {}, word)] : []));
}

/** `text` in one line of plain letters, for drawings: what would be below stands beside. */
export const plainFormula = (text) =>
  formula(text)
    .map((part) => part.textContent ?? part)
    .join("");
