/** Building elements without markup in strings: text stays text, whatever a file or a server says. */

const SVG = "http://www.w3.org/2000/svg";

/** The element with that id. */
export const byId = (id) => document.getElementById(id);

/** An HTML element with attributes (`onclick` and the like as functions) and children (elements or text). */
export function html(tag, attributes = {}, ...children) {
  return furnish(document.createElement(tag), attributes, children);
}

/** An SVG element. */
export function svg(tag, attributes = {}, ...children) {
  return furnish(document.createElementNS(SVG, tag), attributes, children);
}

function furnish(element, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (value === null || value === undefined || value === false) continue;
    if (typeof value === "function") element.addEventListener(name.slice(2), value);
    else element.setAttribute(name, value === true ? "" : value);
  }
  element.append(...children.flat().filter((child) => child !== null && child !== undefined));
  return element;
}

/** Numbers copied out of `element` have the hyphen that other programs take for a minus sign. */
export function copyReadably(element) {
  element.addEventListener("copy", (event) => {
    event.clipboardData.setData("text/plain", String(getSelection()).replaceAll("−", "-"));
    event.preventDefault();
  });
}

/** Brings in a style sheet that only some parts of the page need. */
export function fetchStyle(url) {
  document.head.append(html("link", { rel: "stylesheet", href: url }));
}

/** The data that `url` gives as JSON. Fails with a sentence that says what could not be had. */
export async function fetchJson(url) {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`The server answered ${response.status} for ${url}.`);
  return response.json();
}
