/** The keys that are not the stick: one table for the cockpit and for its help. */

import { isTaken } from "./stick.js";

export const KEYS = [
  { keys: ["F", "P"], action: "freeze", does: "Freeze, resume" },
  { keys: ["R"], action: "reset", does: "Reset to trim" },
  { keys: ["."], action: "step", does: "One time step, then freeze" },
  { keys: ["C"], action: "record", does: "Start or end a recording" },
  { keys: ["V"], action: "view", does: "View: cockpit, chase, tower" },
  { keys: ["I"], action: "instruments", does: "Choose the instruments" },
  { keys: ["H"], action: "hud", does: "Head-up display: full, declutter, off" },
  { keys: ["L"], action: "law", does: "Control laws on, off" },
  { keys: ["N"], action: "plant", does: "Linear or nonlinear aircraft" },
  { keys: ["T"], action: "theme", does: "Dark, light" },
  { keys: ["?"], action: "help", does: "Help: these keys" },
];

/** Runs `actions[action]()` for each key of the table, unless somebody is typing or a dialog is open. */
export function listenToKeys(actions) {
  addEventListener("keydown", (event) => {
    if (isTaken(event) || event.repeat || document.querySelector("dialog[open]")) return;
    const pressed = event.key.length === 1 ? event.key.toUpperCase() : event.key;
    const entry = KEYS.find(({ keys }) => keys.includes(pressed));
    if (!entry) return;
    event.preventDefault();
    actions[entry.action]();
  });
}
