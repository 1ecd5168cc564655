/** The ghost: another flight of the same stick, flying in step with the recording that is replayed. */

import { fetchJson } from "./dom.js";

const COLUMNS = ["north", "east", "h", "phi", "theta", "psi", "elevator", "aileron", "rudder"];

export class Ghost {
  constructor(link, cockpit) {
    Object.assign(this, { link, cockpit, of: null, flight: null, state: {} });
    link.on("frame", ({ t }) => this.of !== null && this.move(t));
    link.on("status", ({ replay }) => this.of !== null && this.watch(replay));
  }

  /** Fetches the flight `name`. */
  async load(name) {
    const { t, values } = await fetchJson(`/api/recordings/${encodeURIComponent(name)}.json?columns=${COLUMNS.join(",")}`);
    this.flight = { t: t.map((time) => time - t[0]), values };
  }

  /** Flies beside the replay of the recording `of`, as long as that is shown. */
  follow(of) {
    this.of = of;
    this.seen = false;
    this.move(0);
    return this.cockpit.ghost(this.state);
  }

  leave() {
    this.of = null;
    return this.cockpit.ghost(null);
  }

  /** A status from before the replay began does not end it. */
  watch(replay) {
    if (replay?.name === this.of) this.seen = true;
    else if (this.seen) this.leave();
  }

  /** Where it is at `t` [s] after the start; where it ended, when that is later. */
  move(t) {
    const { t: times, values } = this.flight;
    let [low, high] = [0, times.length - 1];
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (times[middle] <= t) low = middle;
      else high = middle;
    }
    const span = times[high] - times[low];
    const share = span > 0 ? Math.min(1, Math.max(0, (t - times[low]) / span)) : 0;
    for (const name of COLUMNS) {
      const [a, b] = [values[name][low], values[name][high]];
      const turned = Math.abs(b - a) > Math.PI && (name === "psi" || name === "phi"); // through half a turn
      this.state[name] = turned ? a : a + share * (b - a);
    }
  }
}
