/** Labelled form fields: a choice, a number, a button. */

import { html } from "./dom.js";

export function button(name, action) {
  return html("button", { type: "button", onclick: action }, name);
}

export function row(children) {
  return html("div", { class: "button-row" }, children);
}

/** `options` are names, or pairs of value and words. */
export function choice(name, options, chosen) {
  const select = html("select", {});
  const field = { select, label: html("label", {}, html("span", {}, name), select) };
  refill(field, options, chosen);
  return field;
}

export function refill({ select }, options, chosen) {
  const pairs = options.map((option) => (Array.isArray(option) ? option : [option, option.replaceAll("_", "-")]));
  select.replaceChildren(...pairs.map(([value, words]) => html("option", { value, selected: value === chosen }, words)));
}

export function number(name, value, step = "any") {
  const input = html("input", { type: "number", value, step });
  return { input, label: html("label", {}, html("span", {}, name), input) };
}
