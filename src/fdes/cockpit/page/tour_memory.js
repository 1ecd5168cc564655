/** Whether the first-flight tour has been taken or left in this browser. A forbidden storage remembers nothing. */

const KEY = "fdes.tour";

/** Whether the tour begins by itself; `asked` is what the address says of it: "on", "off" or nothing. */
export function beginsByItself(asked) {
  if (asked === "on" || asked === "off") return asked === "on";
  try {
    return localStorage.getItem(KEY) === null;
  } catch {
    return true;
  }
}

export function rememberTour() {
  try {
    localStorage.setItem(KEY, "done");
  } catch {
    return;
  }
}
