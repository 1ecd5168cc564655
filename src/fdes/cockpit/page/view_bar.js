/** Over the world: which view is shown, by three buttons or the key V, and a way to the choice of instruments. */

import { VIEWS } from "./cockpit.js";
import { html } from "./dom.js";

const SAYS = {
  cockpit: "From the pilot's seat, with the head-up display",
  chase: "From behind, following the path",
  tower: "From beside the runway, zoomed in",
};

export class ViewBar {
  constructor(bar, cockpit, complain) {
    Object.assign(this, { cockpit, complain, wanted: cockpit.view });
    this.buttons = VIEWS.map((view) =>
      html("button", { title: `${SAYS[view]} (V: next view)`, "aria-pressed": "false", onclick: () => this.show(view) }, name(view)),
    );
    bar.append(
      ...this.buttons,
      html("button", { title: "Choose the instruments (I)", "aria-haspopup": "dialog", onclick: () => this.chooseInstruments() }, "Instruments"),
    );
    this.mark();
  }

  async chooseInstruments() {
    try {
      const { IndicatorChooser } = await import("./indicators.js");
      this.chooser ??= new IndicatorChooser(this.cockpit.panel);
      await this.chooser.open();
    } catch (error) {
      this.complain(`The instruments could not be listed. ${error.message}`);
    }
  }

  next() {
    return this.show(VIEWS[(VIEWS.indexOf(this.wanted) + 1) % VIEWS.length]);
  }

  async show(view) {
    this.wanted = view; // a view is fetched when it is first shown: the key may be pressed again meanwhile
    try {
      await this.cockpit.setView(view);
    } catch (error) {
      this.wanted = this.cockpit.view;
      this.complain(`The ${view} view could not be fetched. ${error.message}`);
    }
    this.mark();
  }

  mark() {
    VIEWS.forEach((view, i) => this.buttons[i].setAttribute("aria-pressed", view === this.cockpit.view));
  }
}

const name = (view) => view[0].toUpperCase() + view.slice(1);
