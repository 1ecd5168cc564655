/** Tabs after the WAI-ARIA pattern: arrows, Home and End move between them, only the chosen one is in the tab order. */

export class Tabs {
  /** `list` is the element with role tablist; each tab names its panel in aria-controls. */
  constructor(list, onShow = () => {}) {
    this.tabs = [...list.querySelectorAll("[role=tab]")];
    this.onShow = onShow;
    for (const tab of this.tabs) {
      tab.addEventListener("click", (event) => {
        this.show(tab);
        if (event.detail > 0) tab.blur(); // clicked with a mouse: the arrow keys go back to the stick
      });
      tab.addEventListener("keydown", (event) => this.move(event, tab));
    }
    this.show(this.tabs[0]);
  }

  get shown() {
    return this.tabs.find((tab) => tab.getAttribute("aria-selected") === "true").dataset.tab;
  }

  show(chosen) {
    for (const tab of this.tabs) {
      const selected = tab === chosen;
      tab.setAttribute("aria-selected", selected);
      tab.tabIndex = selected ? 0 : -1;
      document.getElementById(tab.getAttribute("aria-controls")).hidden = !selected;
    }
    this.onShow(chosen.dataset.tab);
  }

  move(event, tab) {
    const at = this.tabs.indexOf(tab);
    const count = this.tabs.length;
    const to = { ArrowRight: (at + 1) % count, ArrowLeft: (at + count - 1) % count, Home: 0, End: count - 1 }[
      event.key
    ];
    if (to === undefined) return;
    event.preventDefault();
    this.show(this.tabs[to]);
    this.tabs[to].focus();
  }
}
