/**
 * "Fly again with…": a recording's own stick on changed aircraft, up to six at once, flown by another process of the
 * server; then the table of differences, the overlay of charts, and a ghost beside the replay. Loaded when asked for.
 */

import { fetchJson, fetchStyle, html } from "./dom.js";
import { button, choice } from "./fields.js";
import { Ghost } from "./ghost.js";
import { INTEGRATORS } from "./inputs.js";
import { symbol } from "./strip_chart.js";
import { minus, shown } from "./units.js";

const MOST_VARIATIONS = 6;
const EXAMPLE = "Cm_q*=0.5; law=yaw_damper";

export class WhatIf {
  /** `replay(name)` plays a recording and resolves to whether it does; `done()` is called when there are new ones. */
  constructor({ link, cockpit, replay, showView, done }) {
    fetchStyle("/page/what_if.css");
    Object.assign(this, { link, cockpit, replay, showView, done });
    this.ghost = new Ghost(link, cockpit);
    this.rows = html("div", { class: "what-if-rows" });
    this.add = button("One more", () => this.row());
    this.go = button("Fly again", () => this.fly());
    this.go.id = "fly-again";
    this.go.classList.add("primary");
    this.state = html("p", { class: "what-if-state", role: "status" });
    this.results = html("div", { class: "what-if-results" });
    this.title = html("h2", { id: "what-if-title" });
    this.helpers = html("div", { class: "what-if-helpers" });
    this.dialog = html(
      "dialog",
      { id: "what-if", "aria-labelledby": "what-if-title" },
      html("div", { class: "dialog-head" }, this.title, html("button", { class: "icon", "aria-label": "Close", onclick: () => this.dialog.close() }, "✕")),
      html(
        "div",
        { class: "dialog-body" },
        html("p", { class: "quiet-words" }, "The same stick, test inputs and air. What is left empty is flown as it was; several changes are separated by semicolons, and come after the changes that the recording has."),
        this.rows,
        this.helpers,
        html("p", { class: "button-row" }, this.go, this.add),
        this.state,
        this.results,
      ),
    );
    this.dialog.addEventListener("click", (event) => event.target === this.dialog && this.dialog.close());
    document.body.append(this.dialog);
    link.on("what_if", (came) => came.recording === this.name && this.waiting && this.show(came));
  }

  /** Opens the dialog for the recording `name`; `label` is how a person would call it. */
  async open(name, label) {
    if (name !== this.name) {
      this.rows.replaceChildren();
      this.results.replaceChildren();
      this.state.textContent = "";
      this.waiting = false;
      this.go.disabled = false;
      this.row();
    }
    [this.name, this.label] = [name, label];
    this.title.textContent = `Fly again with… ${label}`;
    if (!this.dialog.open) this.dialog.showModal();
    this.focused.focus();
    if (!this.helpers.children.length) this.helpers.replaceChildren(...(await this.makeHelpers()));
  }

  row() {
    const entry = html("input", {
      type: "text",
      autocomplete: "off",
      spellcheck: "false",
      placeholder: EXAMPLE,
      "aria-label": "What is different",
      onfocus: () => (this.focused = entry),
      onkeydown: ({ key }) => key === "Enter" && this.fly(),
    });
    const away = html("button", { type: "button", class: "icon-small", "aria-label": "Remove this variant", title: "Remove this variant", onclick: () => this.remove(line) }, "✕");
    const line = html("div", {}, entry, away);
    this.rows.append(line);
    this.focused = entry;
    this.add.disabled = this.rows.children.length >= MOST_VARIATIONS;
    if (this.dialog.open) entry.focus();
  }

  remove(line) {
    if (this.rows.children.length > 1) line.remove();
    else line.querySelector("input").value = "";
    this.focused = this.rows.querySelector("input");
    this.add.disabled = false;
  }

  /** Choices that are put into the line that had the focus last. */
  async makeHelpers() {
    const aircraft = (await fetchJson("/api/aircraft")).map(({ id, name }) => [id, name]);
    const laws = this.link.latest.get("laws").laws.map(({ name }) => [name, name.replaceAll("_", " ")]);
    const pick = (words, key, options) => {
      const field = choice(words, [["", "as it was"], ...options], "");
      field.select.addEventListener("change", () => {
        if (field.select.value) this.put(`${key}=${field.select.value}`);
        field.select.value = "";
      });
      return field.label;
    };
    return [
      pick("Law", "law", [["direct", "none"], ...laws]),
      pick("Integrator", "integrator", INTEGRATORS.map((name) => [name, name.replaceAll("_", "-")])),
      pick("Aircraft", "aircraft", aircraft),
      button("What flies now", () => this.putPresent()),
    ];
  }

  /** The changes made to the aircraft that flies now, and its law. */
  putPresent() {
    const { changes } = this.link.latest.get("stability");
    const { text } = this.link.latest.get("control");
    this.focused.value = [...changes, ...(text === "direct" ? [] : [`law=${text}`])].join("; ");
    if (!this.focused.value) this.state.textContent = "What flies now is unchanged and has no law.";
  }

  put(text) {
    const kept = this.focused.value.split(";").map((part) => part.trim()).filter((part) => part && part.split("=")[0] !== text.split("=")[0]);
    this.focused.value = [...kept, text].join("; ");
  }

  async fly() {
    const variations = [...this.rows.querySelectorAll("input")].map(({ value }) => value.trim());
    this.results.replaceChildren();
    this.waiting = true;
    this.go.disabled = true;
    this.say(`Flying ${variations.length === 1 ? "it" : `${variations.length} variants`} again in another process; this flight goes on.`);
    try {
      await this.link.command("what_if", { recording: this.name, variations });
    } catch (error) {
      this.end(error.message);
    }
  }

  say(words, bad = false) {
    this.state.textContent = words;
    this.state.classList.toggle("problem", bad);
  }

  end(problem = null) {
    this.waiting = false;
    this.go.disabled = false;
    this.say(problem ?? "", problem !== null);
  }

  show({ flown, error }) {
    this.end(error);
    if (error) return;
    this.done();
    const signals = [...new Set(flown.flatMap(({ differences }) => Object.keys(differences)))];
    const name = (one) => (one.variation === "flown again" ? "As it was" : one.variation);
    const head = flown.map((one) =>
      html("th", { scope: "col" }, name(one), html("button", { onclick: () => this.playBeside(one), title: "Replay the recording with this flight as a ghost beside it" }, "Ghost")),
    );
    const body = signals.map((signal) => {
      const unit = flown.map(({ differences }) => differences[signal]?.unit).find(Boolean);
      const { label, factor } = shown(unit, signal);
      const cells = flown.map(({ differences }) => {
        const found = differences[signal];
        return html("td", found ? { title: `root mean square ${said(found.rms * factor)} ${label}` } : {}, found ? `${said(found.greatest * factor)} at ${found.t.toFixed(1)} s` : "0");
      });
      return html("tr", {}, html("th", { scope: "row" }, `${symbol(signal)}, ${label}`), cells);
    });
    const ends = flown.map((one) => html("td", {}, one.same ? "same in every bit" : one.departed ? `ended early: ${one.departed}` : `${one.frames} frames`));
    this.results.replaceChildren(
      html(
        "table",
        { class: "number" },
        html("caption", {}, "Greatest difference from the recording, and when"),
        html("thead", {}, html("tr", {}, html("th", { scope: "col" }, "Signal"), head)),
        html("tbody", {}, body, html("tr", {}, html("th", { scope: "row" }, "Flight"), ends)),
      ),
      button("Overlay in charts", () => this.overlay(flown.map((one) => [one.name, name(one)]), signals)),
    );
  }

  async overlay(variants, differ) {
    const { Overlay, recordingSet } = await import("./overlay.js");
    this.charts ??= new Overlay();
    const all = [[this.name, "Recording"], ...variants]; // it draws as many as it has colors for
    await this.charts.open(await Promise.all(all.map(([name, label]) => recordingSet(name, label))), differ);
  }

  /** The recording plays, and the variant flies beside it, seen from behind. */
  async playBeside({ name }) {
    try {
      await this.ghost.load(name);
    } catch (error) {
      this.say(`The ghost could not be read. ${error.message}`, true);
      return;
    }
    if (!(await this.replay(this.name))) return;
    this.dialog.close();
    this.ghost.follow(this.name);
    if (this.cockpit.view === "cockpit") await this.showView("chase");
  }
}

const said = (value) => minus(Math.abs(value) >= 0.001 || value === 0 ? Number(value.toPrecision(3)) : value.toExponential(0));
