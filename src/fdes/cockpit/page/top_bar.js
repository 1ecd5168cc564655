/** Top bar and messages: what the server and the loop tell, in chips and words. */

import { byId } from "./dom.js";
import { FLAG } from "./link.js";
import { compass, degrees, feet, knots, minutes } from "./units.js";

const MESSAGE_STAYS = 6000; // ms
const SLOW_CLOCK = 0.98; // real-time factor below which the clock is said to lag

/** Sets text only when it changes: assistive technology is told of every change. */
function write(element, text) {
  if (element.textContent !== text) element.textContent = text;
}

export class TopBar {
  constructor(link, cockpit, stick) {
    Object.assign(this, {
      link,
      cockpit,
      stick,
      flags: null,
      status: null,
      notice: null,
      framesBefore: 0,
      timer: null,
    });
    stick.onNotice = (words) => this.say(words);
  }

  showHello(hello) {
    byId("link").title = `Session ${hello.session}, FDES ${hello.fdes}`;
    this.session = hello.session;
    this.showConnection(true);
  }

  showAircraft(aircraft) {
    write(byId("aircraft-name"), aircraft.name);
    write(byId("aircraft-condition"), aircraft.condition_name + (aircraft.variant === "printed" ? ", as printed" : ""));
    write(byId("method-words"), `${aircraft.integrator} · 1/${Math.round(1 / aircraft.dt)} s · ${aircraft.plant === "linear" ? aircraft.form : aircraft.plant}`);
    const linear = aircraft.plant === "linear";
    write(byId("plant-words"), linear ? "linear" : "");
    byId("method").title = linear
      ? "Integrator, its step, and the form of the linear equations. Press for the nonlinear aircraft (N)"
      : "Integrator and its step; six degrees of freedom, Levels and modes of the linearized aircraft. Press for the linear one (N)";
    document.title = `${aircraft.name} · FDES`;
  }

  showStatus(status) {
    this.status = status;
    const slow = status.real_time_factor < SLOW_CLOCK && !status.frozen && !this.link.has(FLAG.ended);
    const factor = `${status.real_time_factor.toFixed(2)}×`;
    write(byId("pace"), !this.link.has(FLAG.late) ? factor : slow ? `${factor} late` : "step late");
    byId("pace").classList.toggle("warn", slow);
    byId("pace").classList.toggle("late", this.link.has(FLAG.late));
    const lateness = `99 % of the steps less than ${status.lateness_p99_ms.toFixed(1)} ms late; ${status.slips} slips`;
    byId("pace").title = `Real-time factor: simulated seconds in a second. ${lateness}. Late: in the last second one came a frame too late, or later.`;
    write(byId("record-time"), status.recording ? minutes(status.recording.seconds) : "");
    if (!status.replay) this.announce(status.notice);
    this.flags = null;
  }

  /** Says a new notice, unless it is why the flight ended: that stands in the middle of the picture. */
  announce(notice) {
    if (notice && notice !== this.notice)
      setTimeout(() => !this.link.has(FLAG.ended) && this.notice === notice && this.say(notice), 300);
    this.notice = notice;
  }

  /** Freeze and record buttons, and the end of a flight; called each frame, so it looks for a change first. */
  showFlags() {
    if (this.link.flags === this.flags) return;
    this.flags = this.link.flags;
    const frozen = this.link.has(FLAG.frozen) && !this.link.has(FLAG.ended);
    byId("freeze").setAttribute("aria-pressed", frozen);
    write(byId("freeze-word"), frozen ? "Resume" : "Freeze");
    const recording = this.link.has(FLAG.recording);
    byId("record").setAttribute("aria-pressed", recording);
    write(byId("record-word"), recording ? "Recording" : "Record");
    const ended = this.link.has(FLAG.ended);
    byId("ended").hidden = !ended;
    if (ended) write(byId("ended-words"), this.status?.notice ?? "The flight has ended. Press R to start again.");
  }

  showConnection(open) {
    write(byId("link-words"), open ? (this.session ?? "connected") : "reconnecting");
    byId("link").classList.toggle("ok", open);
    byId("link").classList.toggle("warn", !open);
  }

  /** Once a second: pictures a second, time from stick to picture, and who moves the stick. */
  showPace() {
    const { stats } = this.cockpit;
    const frames = byId("link").classList.contains("ok") ? stats.frames - this.framesBefore : "–"; // pictures of the last thing heard are none
    const recent = stats.latencies.slice(-60).sort((a, b) => a - b);
    const latency = recent.length ? `${recent[recent.length >> 1].toFixed(0)} ms` : "–";
    write(byId("frames"), `${frames} fps · ${latency}`);
    this.framesBefore = stats.frames;
    write(byId("control-words"), this.cockpit.flying ? this.stick.source : "Observer");
  }

  say(text) {
    this.toast(text, false);
  }

  complain(text) {
    this.toast(text, true);
  }

  toast(text, bad) {
    const toast = byId("toast");
    toast.classList.toggle("problem", bad);
    write(toast, text);
    toast.hidden = false;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => (toast.hidden = true), MESSAGE_STAYS);
  }
}

/** The state in a sentence, for those who do not see the instruments. */
export function sayState({ cas, h, psi, phi, theta }) {
  const bank = Math.round(degrees(phi));
  const pitch = Math.round(degrees(theta));
  return [
    `Airspeed ${Math.round(knots(cas))} knots`,
    `altitude ${Math.round(feet(h) / 10) * 10} feet`,
    `heading ${Math.round(compass(psi)) % 360}`,
    bank ? `banked ${Math.abs(bank)} degrees ${bank > 0 ? "right" : "left"}` : "wings level",
    `pitch ${pitch} degrees.`,
  ].join(", ");
}
