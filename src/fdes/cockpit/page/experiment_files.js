/** Saving, opening and sharing: the aircraft as a TOML file, the whole experiment as a JSON file or as a link. */

import { html } from "./dom.js";
import { button, row } from "./fields.js";

const LARGEST = 60000; // bytes: the server takes no larger message

/** Text from the base64url of a link. Throws an Error that says so when it is none. */
export function textOf(code) {
  try {
    const bytes = atob(code.replaceAll("-", "+").replaceAll("_", "/"));
    return new TextDecoder("utf-8", { fatal: true }).decode(Uint8Array.from(bytes, (letter) => letter.charCodeAt(0)));
  } catch {
    throw new Error("The link holds no experiment that can be read: it may have been cut off or changed on its way.");
  }
}

function codeOf(text) {
  const letters = Array.from(new TextEncoder().encode(text), (byte) => String.fromCharCode(byte)).join("");
  return btoa(letters).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

let dialog = null;

export function openFiles(link) {
  dialog ??= new FilesDialog(link);
  dialog.open();
}

class FilesDialog {
  constructor(link) {
    this.link = link;
    this.said = html("p", { role: "status" });
    this.address = html("input", { type: "text", readonly: true, id: "experiment-link", onfocus: () => this.address.select() });
    this.file = html("input", { type: "file", accept: ".toml,.json", "aria-label": "Open an aircraft (TOML) or an experiment (JSON)", onchange: () => this.read() });
    const close = html("button", { class: "icon", "aria-label": "Close", onclick: () => this.element.close() }, "✕");
    this.element = html(
      "dialog",
      { class: "narrow files", "aria-labelledby": "files-title" },
      html("div", { class: "dialog-head" }, html("h2", { id: "files-title" }, "Save, open and share"), close),
      html(
        "div",
        { class: "dialog-body" },
        html("h3", {}, "Save"),
        row([button("Aircraft as flown (.toml)", () => this.saveAircraft()), button("Experiment (.json)", () => this.saveExperiment())]),
        html("p", { class: "quiet-words" }, "The aircraft file keeps the printed values, and flies the same to the last bit. The experiment is aircraft, changes, laws, sensors, actuators, plant, equations and step, with all test inputs of this flight and what is held."),
        html("h3", {}, "Open"),
        row([this.file, button("New aircraft…", () => this.newAircraft())]),
        html("h3", {}, html("label", { for: "experiment-link" }, "Share by a link that reopens the experiment")),
        html("div", { class: "link-row" }, this.address, button("Copy", () => this.copy())),
        html("p", { class: "quiet-words" }, "It opens wherever FDES is served at this address; elsewhere, save the experiment and open the file."),
        this.said,
      ),
    );
    this.element.addEventListener("click", (event) => event.target === this.element && this.element.close());
    document.body.append(this.element);
  }

  open() {
    this.tell("");
    this.address.value = "";
    this.element.showModal();
    this.attempt(async () => {
      const { experiment } = await this.link.command("share");
      this.address.value = `${location.origin}/#experiment=${codeOf(JSON.stringify(experiment))}`;
    });
  }

  newAircraft() {
    this.element.close();
    document.dispatchEvent(new Event("new-aircraft"));
  }

  saveAircraft() {
    return this.attempt(async () => {
      const { name, text } = await this.link.command("save_aircraft");
      download(name, text, "application/toml");
    });
  }

  saveExperiment() {
    return this.attempt(async () => {
      const { experiment } = await this.link.command("share");
      download(`${experiment.aircraft}-experiment.json`, `${JSON.stringify(experiment, null, 2)}\n`, "application/json");
    });
  }

  copy() {
    return this.attempt(async () => {
      this.address.select();
      await navigator.clipboard.writeText(this.address.value); // not on every page: the text is selected all the same
      this.tell("The link is on the clipboard.");
    });
  }

  read() {
    const [file] = this.file.files;
    if (!file) return null;
    return this.attempt(async () => {
      if (file.size > LARGEST) throw new Error(`${file.name} has ${file.size} bytes; the largest that can be opened has ${LARGEST}.`);
      await this.link.openText(file.name.endsWith(".json") ? 1 : 0, await file.text());
      this.file.value = "";
      this.element.close();
    });
  }

  async attempt(work) {
    try {
      await work();
    } catch (error) {
      this.tell(error.message, true);
    }
  }

  tell(sentence, problem = false) {
    this.said.textContent = sentence;
    this.said.className = problem ? "problem" : "quiet-words";
  }
}

/** Keeps `text` as a file of the user's. */
export function download(name, text, type) {
  const url = URL.createObjectURL(new Blob([text], { type }));
  html("a", { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), 1000);
}
