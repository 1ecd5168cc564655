/** How finely the outside world is drawn: coarser on a machine that cannot keep up, finer again when it can. */

const SLOW = 21; // ms between pictures: more than one missed at 60 Hz
// Pictures at first that do not count; share of slow ones that is too much; ones in time before it is finer again.
const PATIENCE = { start: 120, slow: 0.6, quiet: 150 };
const LONG = 100; // ms: so slow from the first picture on that waiting is no use
const STEP = { down: 0.8, up: 1.15 };

export class Resolution {
  constructor(least) {
    Object.assign(this, { least, scale: 1, slowness: 0, quiet: 0, seen: 0 });
  }

  /** Takes note of `elapsed` ms between two pictures. True when the scale has changed. */
  adapt(elapsed) {
    if (this.seen++ < PATIENCE.start && elapsed < LONG) return false; // a page that is still loading stutters
    const weight = Math.min(0.15, (0.05 * elapsed) / SLOW); // a long picture counts for more, but one pause for little
    this.slowness = this.slowness * (1 - weight) + (elapsed > SLOW ? weight : 0);
    this.quiet = this.slowness < 0.04 ? this.quiet + 1 : 0;
    const before = this.scale;
    if (this.slowness > PATIENCE.slow) this.scale = Math.max(this.least, this.scale * STEP.down);
    else if (this.quiet > PATIENCE.quiet) this.scale = Math.min(1, this.scale * STEP.up);
    if (this.scale !== before) [this.slowness, this.quiet] = [0, 0];
    return this.scale !== before;
  }

  /** Whether even the coarsest picture is too slow. */
  get exhausted() {
    return this.scale <= this.least && this.slowness > PATIENCE.slow;
  }
}
