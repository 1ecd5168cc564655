/**
 * The first-flight tour: a card low in the outside view that says what to fly next, and sees when it has been flown.
 * It takes neither keys nor the focus. Who flies on without it for a while, or takes another aircraft, has left it.
 */

import { fetchStyle, html } from "./dom.js";
import { FLAG } from "./link.js";
import { rememberTour } from "./tour_memory.js";
import { FAREWELL, handles, stepsFor } from "./tour_steps.js";

const EVERY = 50; // ms between two looks
const STICK = ["stick_pitch", "stick_roll", "stick_yaw"];
const TOUCHED = 0.1; // of the stick's travel: more is a pull or a kick
const CENTERED = 0.05;
const JUMP = 50; // m
const READING = 3; // s a step stays when it is done
const GOODBYE = 15; // s
const FLIES_ON = 15; // s of stick off its center in one step without doing it
const LEFT = "The tour is over: you fly by yourself. Help (?) has it whenever you want it.";

/** What the pilot has done since a step began. */
class Watch {
  constructor(link, state) {
    this.link = link;
    this.state = state;
    this.modesBefore = this.modes;
    [this.t, this.north, this.east] = [link.t, state.north, state.east];
    this.seconds = this.flown = 0;
    this.wasReset = false;
    this.isArmed = false; // whether the first part of the step is done
    this.pull = { axis: "stick_pitch", out: false, ago: -1 };
    this.kick = { axis: "stick_yaw", out: false, ago: -1 };
  }

  get modes() {
    return this.link.latest.get("modes")?.modes ?? [];
  }

  get changes() {
    return this.link.latest.get("stability")?.changes ?? [];
  }

  get laws() {
    return (this.link.latest.get("control")?.achieved.length ?? 0) > 0;
  }

  get frozen() {
    return this.link.has(FLAG.frozen);
  }

  /** Seconds since the stick was let go after a pull, or -1. */
  get sincePull() {
    return this.pull.ago;
  }

  get sinceKick() {
    return this.kick.ago;
  }

  /** One look at the flight, `dt` [s] after the last one. What happens before `first` is fulfilled does not count. */
  look(dt, first) {
    const { link, state } = this;
    this.seconds += dt;
    if (this.jumped()) this.wasReset = true;
    [this.t, this.north, this.east] = [link.t, state.north, state.east];
    if (!this.frozen && STICK.some((axis) => Math.abs(state[axis]) > TOUCHED)) this.flown += dt;
    this.isArmed ||= !first || first(this);
    if (!this.isArmed) return;
    for (const move of [this.pull, this.kick]) this.follow(move, dt);
  }

  /** Whether the aircraft is elsewhere than it can have flown since the last look: it has been put back to trim. */
  jumped() {
    const { link, state } = this;
    const far = Math.hypot(state.north - this.north, state.east - this.east);
    return far > 2 * state.V * Math.abs(link.t - this.t) + JUMP;
  }

  follow(move, dt) {
    const size = Math.abs(this.state[move.axis]);
    if (size > TOUCHED) [move.out, move.ago] = [true, -1];
    else if (move.ago >= 0) move.ago += dt;
    else if (move.out && size < CENTERED) move.ago = 0;
  }
}

export class Tour {
  /** `view` holds the card; `say` tells a sentence. */
  constructor({ link, cockpit, stick, view, say }) {
    fetchStyle("/page/tour.css");
    Object.assign(this, { link, cockpit, stick, view, say, at: 0 });
    this.steps = stepsFor(link.latest.get("knobs")?.knobs ?? []);
    this.aircraft = link.latest.get("aircraft").id;
    this.words = html("div", { class: "tour-words", role: "status" });
    this.dots = html(
      "span",
      { class: "tour-dots", "aria-hidden": "true" },
      this.steps.map(() => html("i")),
    );
    this.skip = this.button("Skip step", () => this.go(this.at + 1));
    this.close = this.button("End tour", () => this.end());
    this.card = html("div", { class: "tour", role: "group", "aria-label": "First-flight tour" });
    this.card.append(this.words, html("div", { class: "tour-foot" }, this.dots, this.skip, this.close));
    view.append(this.card);
    view.classList.add("with-tour");
    this.lookedAt = performance.now();
    this.timer = setInterval(() => this.look(), EVERY);
    requestAnimationFrame(() => this.go(0)); // a live region tells what changes in it, not what it is made with
  }

  /** A button that gives the keys back to the stick when it was clicked. */
  button(words, does) {
    const press = ({ detail, currentTarget }) => {
      if (detail > 0) currentTarget.blur();
      does();
    };
    return html("button", { type: "button", onclick: press }, words);
  }

  get step() {
    return this.steps[this.at] ?? FAREWELL;
  }

  go(at) {
    this.at = at;
    this.doneFor = null;
    this.watch = new Watch(this.link, this.cockpit.drawn);
    this.control = this.stick.choice;
    this.skip.hidden = at >= this.steps.length;
    this.card.classList.remove("is-done");
    [...this.dots.children].forEach((dot, i) => (dot.className = i < at ? "done" : i === at ? "now" : ""));
    this.point(null);
    this.tell(this.step.notice(this.watch));
    if (at < this.steps.length) return;
    rememberTour();
    this.close.textContent = "Close";
  }

  tell(notice) {
    const { at, steps } = this;
    const where = at < steps.length ? [html("span", { class: "unseen" }, `Tour, step ${at + 1} of ${steps.length}. `)] : [];
    this.words.replaceChildren(
      html("p", { class: "tour-does" }, ...where, ...this.step.does(handles(this.control))),
      html("p", { class: "tour-notice" }, notice),
    );
  }

  look() {
    const now = performance.now();
    const dt = Math.min(0.25, (now - this.lookedAt) / 1000);
    this.lookedAt = now;
    const away = this.link.has(FLAG.replay) || !this.cockpit.flying;
    this.card.hidden = away;
    if (away || !this.watch) return;
    if (this.link.latest.get("aircraft").id !== this.aircraft) return this.leave();
    if (this.control !== this.stick.choice) {
      this.control = this.stick.choice;
      this.tell(this.step.notice(this.watch));
    }
    this.watch.look(dt, this.step.first);
    if (this.at >= this.steps.length) return this.watch.seconds > GOODBYE && this.end();
    if (this.doneFor !== null) return (this.doneFor += dt) > READING && this.go(this.at + 1);
    this.point(this.step.points?.map((selector) => document.querySelector(selector)).find(Boolean));
    if (this.watch.isArmed && this.step.isDone(this.watch)) this.finish();
    else if (this.watch.flown > FLIES_ON) this.leave();
  }

  finish() {
    this.doneFor = 0;
    this.point(null);
    this.card.classList.add("is-done");
    this.dots.children[this.at].className = "done";
    const after = this.step.after?.(this.watch);
    if (after) this.tell(after);
  }

  /** Rings what is to be pressed. */
  point(element) {
    if (element === this.target) return;
    this.target?.classList.remove("tour-target");
    element?.classList.add("tour-target");
    element?.scrollIntoView({ block: "nearest" });
    this.target = element;
  }

  leave() {
    this.end();
    this.say(LEFT);
  }

  end() {
    clearInterval(this.timer);
    rememberTour();
    this.point(null);
    this.card.remove();
    this.view.classList.remove("with-tour");
  }
}
