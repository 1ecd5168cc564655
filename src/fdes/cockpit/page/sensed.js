/**
 * What sensors with a lag and a delay say of the signals on the wire, reckoned here: the wire carries what is, not what
 * the laws measure. Good to how far a signal goes between two frames.
 */

const LEAP = 0.5; // s without a frame: the flight began anew, or went on elsewhere
const MORE = 0.1; // s kept beyond the delay

export class Sensed {
  /** `names`: the signals; `lag` and `delay` in s. */
  constructor(names, { lag, delay }) {
    Object.assign(this, { names, lag, delay, past: [] });
  }

  /** The signals of `v`, with v.t in s, as the sensors say them; all else as it is. */
  of(v) {
    const last = this.past.at(-1);
    if (!last || v.t < last.t || v.t > last.t + LEAP) this.past = [this.row(v, null)];
    else if (v.t > last.t) this.past.push(this.row(v, last));
    while (this.past.length > 2 && this.past[1].t < v.t - this.delay - MORE) this.past.shift();
    return { ...v, ...this.at(v.t - this.delay) };
  }

  row(v, last) {
    const row = { t: v.t };
    const left = last && this.lag ? Math.exp((last.t - v.t) / this.lag) : 0;
    for (const name of this.names) row[name] = v[name] + left * ((last?.[name] ?? v[name]) - v[name]);
    return row;
  }

  at(t) {
    const k = this.past.findIndex((row) => row.t >= t);
    if (k <= 0) return this.only(this.past[k < 0 ? this.past.length - 1 : 0]);
    const [one, two] = [this.past[k - 1], this.past[k]];
    const share = (t - one.t) / (two.t - one.t);
    return Object.fromEntries(this.names.map((name) => [name, one[name] + share * (two[name] - one[name])]));
  }

  only(row) {
    return Object.fromEntries(this.names.map((name) => [name, row[name]]));
  }
}
