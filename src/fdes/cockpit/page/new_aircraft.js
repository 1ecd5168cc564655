/** The form that makes a new aircraft, from nothing or from another one, checked by the linter as it is filled in. */

import { fetchJson, fetchStyle, html } from "./dom.js";
import { download } from "./experiment_files.js";
import { button, choice, refill, row } from "./fields.js";
import { RoleFields } from "./new_aircraft_role.js";
import { CHOICES, CONDITION, GROUPS, TEXTS, THRUST, WHY } from "./new_aircraft_fields.js";

const URL_OF = "/api/new-aircraft";
const PAUSE = 350; // ms without typing before the linter is asked
const G0 = 9.80665;
const SOURCE = "FORM";
const FLOWN = "flown";

export class NewAircraft {
  /** `fly(text)` flies the aircraft of a TOML file; `flown()` gives that of the one that flies. */
  static async made(fly, flown) {
    fetchStyle("/page/new_aircraft.css");
    return new NewAircraft(fly, flown, await fetchJson(URL_OF));
  }

  constructor(fly, flown, offered) {
    Object.assign(this, { fly, flown, units: offered.units, offered: offered.start_from });
    this.fields = new Map(); // by place in the file
    this.texts = {};
    this.role = new RoleFields(offered.roles);
    this.asked = 0;
    this.from = choice("Start from", []);
    this.from.select.addEventListener("change", () => this.attempt(() => this.start(this.from.select.value)));
    this.from.select.addEventListener("input", (event) => event.stopPropagation()); // it asks for itself
    this.verdict = html("p", { class: "verdict", role: "status" });
    this.list = html("ul", { class: "review-list" });
    const groups = GROUPS.map(([title, fields]) => this.group(title, fields));
    const close = html("button", { class: "icon", "aria-label": "Close", onclick: () => this.element.close() }, "✕");
    this.flyButton = button("Fly it", () => this.use((file) => this.fly(file.text).then(() => this.element.close())));
    const save = button("Save (.toml)", () => this.use((file) => download(file.name, file.text, "application/toml")));
    this.element = html(
      "dialog",
      { class: "new-aircraft", "aria-labelledby": "new-aircraft-title" },
      html("div", { class: "dialog-head" }, html("h2", { id: "new-aircraft-title" }, "New aircraft"), close),
      html(
        "div",
        { class: "dialog-body" },
        html("div", { class: "draft-numbers", tabindex: 0, role: "region", "aria-label": "Numbers of the aircraft" }, this.head(), this.role.element, ...groups),
        html(
          "section",
          { class: "draft-check", "aria-label": "Check of the aircraft" },
          html("h3", {}, "Check"),
          this.verdict,
          html("div", { class: "draft-found", tabindex: 0, role: "region", "aria-label": "What was found" }, this.list),
          row([this.flyButton, save]),
        ),
      ),
    );
    this.element.addEventListener("input", () => this.later());
    document.body.append(this.element);
    this.clear();
  }

  open() {
    refill(
      this.from,
      [
        ["", "nothing"],
        [FLOWN, "what flies now, with its changes"],
        ...this.offered.map((each) => [`${each.aircraft}\n${each.condition}`, `${each.name}: ${each.condition_name}`]),
      ],
      "",
    );
    this.element.showModal();
    this.review();
  }

  head() {
    const texts = TEXTS.map(([key, words, value]) => {
      this.texts[key] = html("input", { type: "text", value, "data-at": key, maxlength: 300 });
      return html("label", { class: key === "summary" || key === "source" ? "wide" : "" }, html("span", {}, words), this.texts[key]);
    });
    const choices = CHOICES.map(([key, words, options]) => {
      const { select, label } = choice(words, options.map((option) => [option, option]));
      this.texts[key] = select;
      return label;
    });
    this.system = choice("Units", [["us", "US: ft, lb, slug"], ["si", "SI: m, kg"]], "us");
    this.system.select.addEventListener("change", () => this.useUnits((each) => (this.system.select.value === "us" ? each.us : each.si)));
    this.per = choice("Derivatives", [["1/rad", "per radian"], ["1/deg", "per degree"]], "1/rad");
    this.per.select.addEventListener("change", () => this.useUnits((each) => (each.si === "1/rad" ? this.per.select.value : null), true));
    return html(
      "fieldset",
      { class: "draft-head" },
      html("legend", {}, "Name"),
      html("div", { class: "texts" }, html("div", { class: "wide" }, this.from.label), texts, choices, this.system.label, this.per.label),
    );
  }

  group(title, fields) {
    return html("fieldset", { class: fields[0].assumed ? "assumptions" : "" }, html("legend", {}, title), html("div", { class: "numbers" }, fields.map((each) => this.field(each))));
  }

  field(each) {
    const id = `new-${each.at.replaceAll(".", "-")}`;
    const input = html("input", { type: "text", inputmode: "decimal", id, maxlength: 40, autocomplete: "off", "aria-describedby": `${id}-words` });
    const units = each.si && html("select", { "aria-label": `Unit of ${each.name}` }, Object.keys(this.units[each.si]).map((unit) => html("option", {}, unit)));
    const reason = each.assumed ? html("input", { type: "text", class: "reason", maxlength: 200, "aria-label": `Reason for ${each.name}` }) : null;
    this.fields.set(each.at, { ...each, input, units, reason });
    const name = html("label", { for: id, title: each.words }, html("b", {}, each.name));
    const words = html("small", { id: `${id}-words` }, each.words + (each.optional ? " (may be empty)" : ""));
    return html("div", { class: "number-field" }, name, input, units ?? html("span"), words, reason);
  }

  /** Other units where nothing was entered, or everywhere: the numbers stay as they are. */
  useUnits(unitOf, everywhere = false) {
    for (const each of this.fields.values()) {
      const unit = each.units && unitOf(each);
      if (unit && (everywhere || each.assumed || !each.input.value.trim())) {
        if (each.assumed && each.input.value) each.input.value = short((Number(each.input.value) * this.factor(each)) / this.units[each.si][unit]);
        each.units.value = unit;
      }
    }
    this.later();
  }

  factor(each) {
    return each.units ? this.units[each.si][each.units.value] : 1;
  }

  clear() {
    this.role.fill();
    for (const [key, , value] of TEXTS) this.texts[key].value = value;
    for (const [key, , [first]] of CHOICES) this.texts[key].value = first;
    for (const each of this.fields.values()) {
      each.input.value = each.value ?? "";
      if (each.units) each.units.value = this.system.select.value === "si" && !each.assumed ? each.si : each.us;
      if (each.reason) each.reason.value = WHY;
    }
  }

  /** Fills the form from an aircraft; `chosen` is its id and condition, or what flies now, or nothing. */
  async start(chosen) {
    this.clear();
    if (chosen === FLOWN) {
      const content = await answered(await fetch(`${URL_OF}/from`, { method: "POST", body: await this.flown() }));
      this.fill(content, content.conditions[0].id);
    } else if (chosen) {
      const [aircraft, condition] = chosen.split("\n");
      this.fill(await fetchJson(`${URL_OF}/from/${encodeURIComponent(aircraft)}`), condition);
    }
    await this.review();
  }

  fill(content, id) {
    const condition = content.conditions.find((each) => each.id === id);
    if (!condition.derivatives) throw new Error("It has dimensional derivatives or tables, which this form does not ask. Start from another one.");
    const mass = { ...(condition.mass ?? content.mass), ...condition.consistent_mass };
    const assumed = { ...content.assumed, ...condition.assumed };
    const from = { geometry: content.geometry, mass, assumed, conditions: [condition] };
    for (const each of this.fields.values()) {
      const said = at(from, each.at);
      const given = typeof said === "object" && said !== null ? said : { printed: said };
      each.input.value = given.corrected ?? given.printed ?? given.value ?? "";
      if (each.units) each.units.value = given.unit ?? (each.si === "1/rad" ? "1/rad" : each.units.value);
      if (each.reason) each.reason.value = given.reason ?? WHY;
    }
    const words = { ...content, id: `${content.id}-new`, name: `${content.name}, new`, source: content.sources[condition.source], condition_name: condition.name };
    for (const [key] of [...TEXTS, ...CHOICES]) if (words[key]) this.texts[key].value = words[key];
    this.role.fill(condition.flying_qualities ?? content.flying_qualities);
  }

  /** The content of the aircraft file, with gaps where nothing was entered. */
  content() {
    this.suggestThrust();
    const said = (key) => this.texts[key].value.trim();
    const content = {
      format: 1,
      ...Object.fromEntries(["id", "name", "summary", "engine", "aileron_sense"].map((key) => [key, said(key)])),
      sources: { [SOURCE]: said("source") },
      geometry: { source: SOURCE },
      mass: { source: SOURCE },
      ...this.role.said(),
      assumed: {},
      conditions: [{ id: said("condition_name"), name: said("condition_name"), source: SOURCE, derivatives: {} }],
    };
    for (const each of this.fields.values()) {
      const value = entered(each.assumed && !each.input.value.trim() ? each.input.placeholder : each.input.value);
      if (value === null) continue;
      const place = at(content, each.at.split(".").slice(0, -1).join("."));
      const unit = each.units ? { unit: each.units.value } : {};
      place[each.name] = each.assumed ? { value, ...unit, reason: each.reason.value.trim() } : each.bare ? value : { printed: value, ...unit };
    }
    return content;
  }

  /** Twice the drag of level flight, W CD/CL: what is used while no thrust is entered. */
  suggestThrust() {
    const [W, CD, CL] = ["mass.W", `${CONDITION}.derivatives.CD`, `${CONDITION}.derivatives.CL`].map((place) => {
      const each = this.fields.get(place);
      return Number(each.input.value || NaN) * this.factor(each);
    });
    const thrust = this.fields.get(THRUST);
    const newtons = (2 * W * G0 * CD) / CL;
    thrust.input.placeholder = newtons > 0 && Number.isFinite(newtons) ? short(newtons / this.factor(thrust)) : "";
  }

  later() {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.review(), PAUSE);
  }

  /** Asks the linter. Resolves to the file, or to null as long as there is none. */
  async review() {
    clearTimeout(this.timer);
    const turn = ++this.asked;
    try {
      const response = await fetch(URL_OF, { method: "POST", headers: { "content-type": "application/json" }, body: JSON.stringify(this.content()) });
      const answer = await answered(response);
      if (turn === this.asked) this.show(answer);
      return answer.file;
    } catch (error) {
      if (turn === this.asked) this.tell(error.message);
      return null;
    }
  }

  show({ errors, findings }) {
    const gaps = errors.filter(({ what }) => what === "is missing.");
    const mistakes = errors.filter(({ what }) => what !== "is missing.");
    const marked = new Set([...mistakes, ...findings].flatMap(({ fields }) => fields));
    const empty = new Set(gaps.map(({ field }) => field));
    for (const [place, { input }] of this.fields) input.toggleAttribute("data-marked", marked.has(place));
    for (const [key, input] of Object.entries(this.texts)) input.toggleAttribute("data-marked", marked.has(key));
    const wrong = new Set(mistakes.flatMap(({ fields }) => fields));
    for (const [place, { input }] of this.fields) {
      input.setAttribute("aria-invalid", String(wrong.has(place)));
      input.toggleAttribute("data-empty", empty.has(place) && place !== THRUST);
    }
    const names = gaps.map(({ field }) => field).filter((place) => place !== THRUST || gaps.length === 1).map(nameOf);
    this.verdict.className = `verdict ${errors.length ? "is-open" : findings.length ? "is-doubted" : "is-good"}`;
    this.verdict.textContent = errors.length
      ? "It cannot fly yet."
      : findings.length
        ? `It can fly, but the linter found ${findings.length === 1 ? "something" : `${findings.length} things`}.`
        : "Nothing found. It can fly.";
    this.list.replaceChildren(
      ...mistakes.map(({ field, what }) => html("li", { class: "error" }, html("b", {}, `${nameOf(field)} ${what}`))),
      ...(gaps.length ? [html("li", { class: "gap" }, html("b", {}, "Still empty: "), names.join(", "))] : []),
      ...findings.map(({ severity, what, meaning, advice }) => html("li", { class: severity }, html("b", {}, what), html("p", {}, meaning), html("p", { class: "advice" }, advice))),
    );
    this.flyButton.disabled = errors.length > 0;
  }

  use(action) {
    return this.attempt(async () => {
      const file = await this.review();
      if (file) await action(file);
    });
  }

  async attempt(work) {
    try {
      await work();
    } catch (error) {
      this.tell(error.message);
    }
  }

  tell(sentence) {
    this.verdict.className = "verdict is-open";
    this.verdict.textContent = sentence;
    this.list.replaceChildren();
  }
}

/** What the server answered; fails with its own sentence. */
async function answered(response) {
  const text = await response.text();
  if (response.ok) return JSON.parse(text);
  throw new Error(text.startsWith("{") ? JSON.parse(text).error : text);
}

/** What stands at a place such as `mass.W`. */
function at(content, place) {
  return place.split(".").reduce((part, key) => part?.[key], content);
}

/** A number where it is one, else the text as it stands; null for nothing. */
function entered(text) {
  const plain = text.trim();
  if (!plain) return null;
  const value = Number(plain.replace("−", "-"));
  return Number.isFinite(value) ? value : plain;
}

const nameOf = (place) => place.split(".").at(-1);
const short = (value) => String(Number(value.toPrecision(7)));
