/** The help dialog: what the keys do, and how to fly. */

import { html } from "./dom.js";
import { KEYS } from "./keys.js";

const STICK = [
  { keys: ["↓", "S"], does: "Pull: nose up" },
  { keys: ["↑", "W"], does: "Push: nose down" },
  { keys: ["←", "A"], does: "Bank left" },
  { keys: ["→", "D"], does: "Bank right" },
  { keys: ["Z"], does: "Left pedal" },
  { keys: ["X"], does: "Right pedal" },
  { keys: ["PgUp", "PgDn"], does: "Throttle" },
  { keys: ["M"], does: "The mouse as stick; M or Esc ends it" },
  { keys: ["Shift"], does: "Held with the stick: a third of its travel" },
];

const ADVICE = [
  "Tap rather than hold: the stick travels while a key is down and centers by itself.",
  "The circle with wings in the display is the flight-path marker: the aircraft goes where it points.",
  "To turn, bank with →; to roll out, bank the other way. The linear aircraft keeps its height in a turn by itself: " +
    "a real one would need a little ↓.",
  "From outside (V) the orange surfaces are drawn deflected twice as far as they are, so that a few degrees can be seen.",
  "The linear aircraft is right near its trim: beyond 15° the display says so, and it flies unlike the real one. Key N " +
    "flies on with the nonlinear aircraft, which loops and rolls; a stall that no source gives is assumed.",
  "A damper helps: press L for the yaw damper, or open Flight control for all six laws, their gains and their block diagram.",
  "A gamepad is used as soon as one of its buttons is pressed: left stick to fly, triggers for the pedals, up and down on the directional pad for the throttle.",
  "The menu in the top bar that names the keyboard hands the stick to the mouse or a gamepad, and sets a gamepad up: axes, " +
    "travel, dead zone, and what its buttons do.",
];

const table = (title, rows) =>
  html(
    "table",
    { class: "keys" },
    html("caption", {}, title),
    html(
      "tbody",
      {},
      rows.map(({ keys, does }) =>
        html(
          "tr",
          {},
          html(
            "th",
            { scope: "row" },
            keys.map((key) => html("kbd", {}, key)),
          ),
          html("td", {}, does),
        ),
      ),
    ),
  );

/** From the help to what the page does when it is told of `event`. */
function leaveFor(help, event) {
  help.close();
  document.dispatchEvent(new Event(event));
}

/** Opens the help; fetched and filled when it is opened first. */
export function openHelp(dialog) {
  if (!dialog.querySelector(".dialog-body").hasChildNodes()) fillHelp(dialog);
  if (!dialog.open) dialog.showModal();
}

function fillHelp(dialog) {
  dialog.querySelector(".dialog-body").append(
    html(
      "div",
      { class: "button-row ways" },
      html("button", { type: "button", onclick: () => leaveFor(dialog, "take-tour") }, "Take the first-flight tour"),
      html("button", { type: "button", "aria-haspopup": "dialog", onclick: () => leaveFor(dialog, "set-up-gamepad") }, "Set up the gamepad…"),
    ),
    html("div", { class: "key-tables" }, table("Stick, pedals, throttle", STICK), table("Simulation", KEYS)),
    html("h3", {}, "Flying"),
    html(
      "ul",
      { class: "notes" },
      ADVICE.map((line) => html("li", {}, line)),
    ),
  );
}
