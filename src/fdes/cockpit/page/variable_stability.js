/** The Variable stability tab: every number of the aircraft on a slider, changed in flight. */

import { fetchStyle, html } from "./dom.js";
import { button, row } from "./fields.js";
import { openFiles } from "./experiment_files.js";
import { Edits, nameOf } from "./edits.js";
import { KnobRow } from "./knob_row.js";
import { CalculatedPage } from "./calculated.js";
import { Tabs } from "./tabs.js";
import { figure } from "./units.js";

const PAGES = [
  ["longitudinal", "Longitudinal"],
  ["lateral", "Lateral"],
  ["mass, size and condition", "Mass, speed"],
];

export class VariableStability {
  /** `link` is the wire. */
  constructor(panel, link) {
    fetchStyle("/page/variable_stability.css");
    this.panel = panel;
    this.rows = new Map();
    this.problem = html("p", { class: "problem", role: "alert" });
    this.edits = new Edits(link, (sentence) => (this.problem.textContent = sentence));
    this.edits.onChange = (stability) => this.show(stability);
    this.search = html("input", {
      type: "search",
      placeholder: "Find, such as Cm_q",
      "aria-label": "Find a number by its name or meaning",
      oninput: () => this.find(),
    });
    this.undo = button("Undo", () => this.edits.undo());
    this.redo = button("Redo", () => this.edits.redo());
    this.resetAll = button("Reset all", () => this.edits.resetAll());
    this.undo.title = "Ctrl+Z";
    this.redo.title = "Ctrl+Y";
    this.changed = html("div", { class: "changed-list", role: "group", "aria-label": "Changed numbers", tabindex: 0 });
    this.points = html("p", { class: "points number" });
    const list = html("div", { role: "tablist", class: "sub", "aria-label": "Kinds of numbers" });
    this.pages = {};
    const panels = [...PAGES, ["calculated", "Calculated"]].map(([group, title]) => {
      const id = `knobs-${group.split(",")[0]}`;
      list.append(html("button", { role: "tab", id: `tab-${id}`, "data-tab": id, "aria-controls": id }, title));
      this.pages[group] = html("div", { role: "tabpanel", id, "aria-labelledby": `tab-${id}`, tabindex: 0 });
      return this.pages[group];
    });
    const files = button("Files…", () => openFiles(link));
    files.setAttribute("aria-haspopup", "dialog");
    const line = html("div", { class: "changed-line" }, this.changed, files);
    const tools = html("div", { class: "knob-tools" }, this.search, row([this.undo, this.redo, this.resetAll]));
    panel.replaceChildren(tools, line, this.problem, list, ...panels);
    this.calculated = new CalculatedPage(this.pages.calculated, link);
    this.tabs = new Tabs(list, (tab) => this.calculated.watch(tab === "knobs-calculated"));
    link.on("knobs", ({ knobs }) => this.fill(knobs, link.latest.get("stability")));
    link.on("aircraft", (aircraft) => this.showPoints(aircraft.static));
    addEventListener("keydown", (event) => this.key(event));
  }

  fill(knobs, stability) {
    this.rows.clear();
    for (const [group] of PAGES) {
      const mine = knobs.filter((knob) => knob.group === group).map((knob) => new KnobRow(knob, this.edits));
      for (const each of mine) this.rows.set(each.knob.name, each);
      this.pages[group].replaceChildren(...mine.map(({ element }) => element));
    }
    this.rows.get("cg")?.element.append(this.points);
    this.find();
    if (stability) this.show(stability);
  }

  show({ changes, values, undo, redo }) {
    const names = new Set(changes.map(nameOf));
    for (const [name, value] of Object.entries(values)) {
      const knob = this.rows.get(name);
      knob?.show(value, value !== knob.knob.value);
    }
    this.undo.disabled = undo === 0;
    this.redo.disabled = redo === 0;
    this.resetAll.disabled = changes.length === 0;
    const chips = changes.map((change) =>
      html(
        "button",
        { type: "button", title: `Take back all changes of ${nameOf(change)}`, onclick: () => this.edits.reset(nameOf(change)) },
        `${shorter(change)} ✕`,
      ),
    );
    this.changed.replaceChildren(...(names.size ? chips : ["As in the source. Move a slider to change it."]));
    this.calculated.stale();
  }

  showPoints(figures) {
    this.points.textContent = figures
      ? `Static margin ${figure(100 * figures.static_margin)} %` +
        (figures.neutral_point === null
          ? " · the source does not say where the cg is"
          : ` · neutral point ${figure(figures.neutral_point)} · maneuver ${figure(figures.maneuver_point)}`)
      : "";
  }

  find() {
    const text = this.search.value.trim().toLowerCase();
    let first = null;
    for (const each of this.rows.values()) {
      const fits = each.fits(text);
      each.element.hidden = !fits;
      if (fits) first ??= each;
    }
    const shown = this.tabs?.shown;
    const here = [...this.rows.values()].some(({ element }) => !element.hidden && element.parentElement.id === shown);
    if (text && first && !here) this.tabs.show(document.getElementById(`tab-${first.element.parentElement.id}`));
  }

  key(event) {
    if (!(event.ctrlKey || event.metaKey) || event.altKey || event.target.closest?.("input[type=text], input[type=search]"))
      return;
    const key = event.key.toLowerCase();
    if (key !== "z" && key !== "y") return;
    event.preventDefault();
    if (key === "y" || event.shiftKey) this.edits.redo();
    else this.edits.undo();
  }
}

/** A change for the eye: its number with five digits. */
function shorter(change) {
  return change.replace(/=(-?[\d.]+(?:e[-+]?\d+)?)/i, (_, number) => `=${Number(Number(number).toPrecision(5))}`);
}
