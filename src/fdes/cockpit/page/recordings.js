/** The Recordings tab, and the bar that plays one: every flight is recorded by itself from the first stick movement. */

import { fetchJson, html } from "./dom.js";
import { minutes } from "./units.js";

const FEW = 4; // changes of an aircraft that are named in the list
export const MOST = 4; // recordings overlaid: as many as there are colors for

export class RecordingsPanel {
  /** `command(name, fields)` sends a command and shows its error. */
  constructor(panel, command) {
    this.panel = panel;
    this.command = command;
    this.onWhatIf = () => {}; // told the name of a recording, and what to call it
    this.playing = null; // the name of the recording that plays
    this.growing = null; // the name of the one being made
    this.marked = new Map(); // name -> label, in the order in which they were marked
    this.overlayButton = html("button", { onclick: () => this.overlay() }, "Overlay the marked");
    this.refusal = html("span", { role: "status" });
  }

  async refresh() {
    try {
      const list = await fetchJson("/api/recordings");
      this.panel.replaceChildren(list.length ? html("div", {}, html("p", { class: "overlay-bar" }, this.overlayButton, this.refusal), this.list(list)) : lesson());
    } catch (error) {
      this.panel.replaceChildren(
        html("p", { class: "problem", role: "alert" }, `The recordings could not be read. ${error.message}`),
      );
    }
  }

  /** Lays the marked recordings over one another; that which was marked first is the one compared with. */
  async overlay() {
    try {
      const { Overlay, recordingSet } = await import("./overlay.js");
      this.dialog ??= new Overlay();
      await this.dialog.open(await Promise.all([...this.marked].map(([name, label]) => recordingSet(name, label))));
    } catch (error) {
      this.panel.prepend(html("p", { class: "problem", role: "alert" }, `The overlay could not be drawn. ${error.message}`));
    }
  }

  /** Marks a recording for the overlay, or not. One too many is refused: its box is empty again, and words say why. */
  mark(box, name, label) {
    const refused = box.checked && this.marked.size >= MOST;
    if (refused) box.checked = false;
    else if (box.checked) this.marked.set(name, label);
    else this.marked.delete(name);
    this.refusal.textContent = refused ? `${MOST} are marked, and no more can be told apart. Unmark one first.` : "";
    this.overlayButton.disabled = !this.marked.size;
  }

  async remove(recording, what) {
    if (!confirm(`Delete the recording of ${what}, ${when(recording.started)}? It cannot be brought back.`)) return;
    await this.command("delete", { recording: recording.name });
    await this.refresh();
  }

  list(recordings) {
    for (const name of this.marked.keys()) if (!recordings.some((one) => one.name === name)) this.marked.delete(name);
    this.overlayButton.disabled = !this.marked.size;
    return html(
      "ul",
      { class: "recordings", "aria-label": "Recordings, newest first" },
      recordings.map((recording) => {
        const file = `/api/recordings/${encodeURIComponent(recording.name)}`;
        const what = `${recording.aircraft}, ${recording.condition_name ?? recording.condition}`;
        const flownAs = recording.what_if === null ? [] : [`what if: ${recording.what_if || "as it was"}`];
        const growing = recording.name === this.growing ? ["being recorded"] : [];
        const details = [...growing, ...flownAs, when(recording.started), minutes(recording.seconds), size(recording.bytes)];
        const began = beganWith(recording);
        return html(
          "li",
          { class: recording.name === this.playing ? "is-playing" : "" },
          html("input", {
            type: "checkbox",
            checked: this.marked.has(recording.name),
            "aria-label": `Mark ${what}, ${when(recording.started)}, for the overlay`,
            title: "Mark for the overlay: up to four",
            onchange: ({ target }) => this.mark(target, recording.name, `${what}, ${when(recording.started)}`),
          }),
          html("div", {}, html("b", {}, what), html("small", {}, details.join(" · ")), began ? html("small", { title: "With what the recording began" }, began) : null),
          html(
            "span",
            { class: "row-actions" },
            html(
              "button",
              {
                onclick: () => this.command("replay", { recording: recording.name }),
                "aria-label": `Replay ${what}, ${when(recording.started)}`,
              },
              "Replay",
            ),
            html(
              "button",
              {
                onclick: () => this.onWhatIf(recording.name, `${what}, ${when(recording.started)}`),
                "aria-label": `Fly ${what}, ${when(recording.started)}, again with changes`,
                title: "Fly the same stick again with other derivatives, law, integrator or aircraft",
              },
              "What if…",
            ),
            html(
              "a",
              {
                class: "button",
                href: `${file}.csv`,
                download: `${recording.name}.csv`,
                "aria-label": `Download ${what} as CSV`,
                title: "Columns with units, for a spreadsheet",
              },
              "CSV",
            ),
            html(
              "a",
              {
                class: "button",
                href: `${file}.fdes`,
                download: `${recording.name}.fdes`,
                "aria-label": `Download ${what} as FDES recording`,
                title: "Every number as it was flown, for fdes and Python",
              },
              "FDES",
            ),
            html("a", { class: "button", href: `${file}.nc`, download: `${recording.name}.nc`, title: "Labeled data, for xarray and others", "aria-label": `Download ${what} as NetCDF` }, "NetCDF"),
            html("a", { class: "button", href: `${file}.mat`, download: `${recording.name}.mat`, title: "Column vectors, for MATLAB", "aria-label": `Download ${what} for MATLAB` }, "MATLAB"),
            html(
              "button",
              { onclick: () => this.remove(recording, what), "aria-label": `Delete ${what}, ${when(recording.started)}` },
              "Delete",
            ),
          ),
        );
      }),
    );
  }
}

/** What is not as in the aircraft's file, flown bare and linear; nothing where all is. Older recordings say less. */
function beganWith({ variant, changes, law, plant }) {
  const laws = (law ?? "direct").split(";").map((part) => part.trim().split(" ")[0].replaceAll("_", " "));
  return [
    ...(variant === "printed" ? ["as printed"] : []),
    ...(plant === "nonlinear" ? ["nonlinear"] : []),
    ...(changes?.length ? [changes.slice(0, FEW).join(", ") + (changes.length > FEW ? ` and ${changes.length - FEW} more` : "")] : []),
    ...laws.filter((name) => name !== "direct"),
  ].join(" · ");
}

function lesson() {
  return html(
    "div",
    { class: "lesson" },
    html("h3", {}, "No recordings yet"),
    html(
      "p",
      {},
      "Move the stick: recording starts by itself. End it with the Record button or the key C, and it appears here " +
        "to be replayed, or downloaded as CSV.",
    ),
  );
}

function when(started) {
  const date = new Date(started);
  return Number.isNaN(date.getTime())
    ? String(started)
    : date.toLocaleString("en-GB", {
        day: "numeric",
        month: "short",
        hour: "2-digit",
        minute: "2-digit",
        second: "2-digit",
      });
}

const size = (bytes) => (bytes < 1e6 ? `${Math.max(1, Math.round(bytes / 1e3))} kB` : `${(bytes / 1e6).toFixed(1)} MB`);

/** The bar over the world while a recording plays: where it is, and a way out. */
export class ReplayBar {
  /** `left()` is called when somebody has gone back to the flight. */
  constructor(bar, command, left) {
    this.bar = bar;
    this.slider = bar.querySelector("input");
    this.clock = bar.querySelector("output");
    this.held = false;
    this.slider.addEventListener("input", () => {
      this.held = true;
      command("seek", { t: Number(this.slider.value) });
    });
    this.slider.addEventListener("change", () => (this.held = false));
    bar.querySelector("button").addEventListener("click", async () => (await command("stop_replay")) && left());
  }

  /** `replay` as in the status message, or null. */
  show(replay) {
    this.bar.hidden = !replay;
    if (!replay) return;
    this.slider.max = replay.duration;
    this.duration = replay.duration;
    this.move(replay.t);
  }

  move(t) {
    if (this.bar.hidden) return;
    if (!this.held) this.slider.value = t;
    this.clock.textContent = `${minutes(t)} / ${minutes(this.duration)}`;
  }
}
