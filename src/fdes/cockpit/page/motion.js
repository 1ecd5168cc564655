/**
 * Between two frames of the server the aircraft moves on: the state drawn is the last one received, carried forward
 * with its own rates to the moment of drawing, by at most 50 ms.
 */

import { clamp } from "./units.js";

const LONGEST = 0.05; // s
const DRIFT = 0.02; // share of the clock offset's error taken over with each frame: forgets a lucky early frame slowly

/**
 * Estimates when a simulation time is due on this machine's clock. Frames arrive unevenly; the fastest ones tell the
 * true offset, so that a late frame is carried further instead of making the picture stutter.
 */
export class FrameClock {
  constructor() {
    this.offset = null; // s, local clock less simulation time
  }

  receive(t, receivedAt) {
    const offset = receivedAt / 1000 - t;
    const restarted = this.offset === null || Math.abs(offset - this.offset) > LONGEST;
    if (restarted || offset < this.offset) this.offset = offset;
    else this.offset += DRIFT * (offset - this.offset);
  }

  /** Age [s] of simulation time `t` at `now` [ms], from 0 to 50 ms. */
  age(t, now) {
    return this.offset === null ? 0 : clamp(now / 1000 - this.offset - t, 0, LONGEST);
  }
}

/** Carries attitude, place and height of `state` forward by `age` [s], in place. */
export function carryForward(state, age) {
  const { phi, p, q, r } = state;
  const climb = Math.cos(phi) * q - Math.sin(phi) * r;
  state.phi += (p + state.psi_dot * Math.sin(state.theta)) * age;
  state.theta += climb * age;
  state.psi += state.psi_dot * age;
  state.north += state.ground_speed * Math.cos(state.chi) * age;
  state.east += state.ground_speed * Math.sin(state.chi) * age;
  state.h += state.h_dot * age;
  return state;
}
