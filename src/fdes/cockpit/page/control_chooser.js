/** The menu in the top bar that says what moves the stick, and lets one choose: keyboard, mouse stick, touch or gamepad. */

import { html } from "./dom.js";

const CHOICES = [
  ["keyboard", "Keyboard"],
  ["mouse", "Mouse stick (M)"],
  ["touch", "Touch"],
  ["gamepad", "Gamepad"],
];

export class ControlChooser {
  /** `button` opens the menu; `stick` is the StickInput; `say` tells a sentence. */
  constructor(button, stick, say) {
    Object.assign(this, { button, stick, say });
    this.items = CHOICES.map(([name, words]) =>
      html("button", { type: "button", role: "menuitemradio", tabindex: -1, onclick: () => this.choose(name) }, words),
    );
    this.items.push(html("button", { type: "button", role: "menuitem", tabindex: -1, "aria-haspopup": "dialog", onclick: () => this.setUp() }, "Set up the gamepad…"));
    this.menu = html("div", { class: "menu", id: "control-menu", role: "menu", "aria-label": "What moves the stick", hidden: true }, this.items);
    button.setAttribute("aria-controls", "control-menu");
    button.after(this.menu);
    button.addEventListener("click", () => (this.menu.hidden ? this.open() : this.close()));
    this.menu.addEventListener("keydown", (event) => this.key(event));
    this.menu.addEventListener("focusout", ({ relatedTarget }) => {
      if (relatedTarget !== button && !this.menu.contains(relatedTarget)) this.close(false);
    });
  }

  open() {
    CHOICES.forEach(([name], i) => this.items[i].setAttribute("aria-checked", name === this.stick.choice));
    this.menu.hidden = false;
    this.button.setAttribute("aria-expanded", true);
    const { left, bottom, width } = this.button.getBoundingClientRect();
    this.menu.style.top = `${bottom + 4}px`;
    this.menu.style.left = `${Math.max(4, left + width - this.menu.offsetWidth)}px`;
    this.items.find((item) => item.getAttribute("aria-checked") === "true").focus();
  }

  close(focus = true) {
    if (this.menu.hidden) return;
    if (focus) this.button.focus();
    this.menu.hidden = true;
    this.button.setAttribute("aria-expanded", false);
  }

  choose(name) {
    this.close();
    this.button.blur(); // space and the arrow keys go back to the cockpit
    this.say(this.stick.choose(name));
  }

  setUp() {
    this.close();
    this.button.blur();
    document.dispatchEvent(new Event("set-up-gamepad"));
  }

  /** The stick must not move while the arrows move in the menu. */
  key(event) {
    event.stopPropagation();
    const at = this.items.indexOf(document.activeElement);
    const count = this.items.length;
    const to = { ArrowDown: (at + 1) % count, ArrowUp: (at + count - 1) % count, Home: 0, End: count - 1 }[event.key];
    if (event.key === "Escape") this.close();
    else if (to !== undefined) this.items[to].focus();
    else return;
    event.preventDefault();
  }
}
