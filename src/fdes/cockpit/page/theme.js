/** Dark and light: asked for in the address, else remembered, else as the system prefers, else dark. */

const KEY = "fdes.theme";
const THEMES = ["dark", "light"];

export class Theme {
  constructor(asked) {
    const remembered = read();
    const preferred = matchMedia("(prefers-color-scheme: light)").matches ? "light" : "dark";
    this.set(
      [asked, remembered, preferred].find((name) => THEMES.includes(name)),
      { remember: false },
    );
  }

  set(name, { remember = true } = {}) {
    this.name = name;
    document.documentElement.dataset.theme = name;
    this.palette = null;
    if (remember) write(name);
    this.onChange?.(name);
  }

  toggle() {
    this.set(this.name === "dark" ? "light" : "dark");
  }

  /** The colors that canvases need, read from the style sheet once for each theme. */
  get colors() {
    const style = getComputedStyle(document.documentElement);
    const value = (name) => style.getPropertyValue(name).trim();
    this.palette ??= {
      plot: value("--plot"),
      grid: value("--grid"),
      ink: value("--ink"),
      quiet: value("--quiet"),
      series: [1, 2, 3, 4].map((i) => value(`--series-${i}`)),
    };
    return this.palette;
  }
}

// Storage may be forbidden in a private window; the theme is then simply not remembered.
function read() {
  try {
    return localStorage.getItem(KEY);
  } catch {
    return null;
  }
}

function write(name) {
  try {
    localStorage.setItem(KEY, name);
  } catch {
    return;
  }
}
