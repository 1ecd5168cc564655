/**
 * The WebSocket to the server, protocol version 1: state frames in, input frames out, JSON commands with replies.
 *
 * State frame, little-endian: u8 type 1, u8 version, u16 flags, u32 sequence, f64 t [s], u32 echoed input sequence,
 * u32 zero, f64 echoed client stamp [ms]; then one float32 for each channel. Input frame: u8 type 2, u8 version,
 * u16 buttons, u32 sequence, f64 client stamp [ms], f32 pitch, roll, yaw, throttle.
 */

const HEADER = 32;
const VERSION = 1;
const STATE = 1;
const INPUT = 2;
const HISTORY = 3;
const DOCUMENT = 4;
const REPLY_WITHIN = 5000; // ms
const BACKOFF = { first: 250, longest: 5000 }; // ms
const STALE = 1500; // ms without a frame: the picture on the screen is no longer true

export const FLAG = { frozen: 1, recording: 2, replay: 4, beyondLinear: 8, ended: 16, late: 32, stalled: 64 };

export class Link {
  constructor(url) {
    this.url = url;
    this.channels = [];
    this.index = {};
    this.values = new Float32Array(0);
    this.flags = 0;
    this.t = 0;
    this.frames = 0;
    this.lost = 0;
    this.receivedAt = 0;
    this.echo = { sequence: 0, stamp: 0 };
    this.listeners = new Map();
    this.latest = new Map();
    this.waiting = new Map();
    this.sequence = 0;
    this.inputSequence = 0;
    this.commandId = 0;
    this.attempts = 0;
    this.input = new DataView(new ArrayBuffer(HEADER));
    this.open();
  }

  get connected() {
    return this.socket.readyState === WebSocket.OPEN;
  }

  /** Whether the values are fresh enough to be believed. */
  get alive() {
    return this.connected && performance.now() - this.receivedAt < STALE;
  }

  has(flag) {
    return (this.flags & flag) !== 0;
  }

  /** Calls `listener(message)` for each message of that type; at once for the last one, so that nobody misses hello. */
  on(type, listener) {
    if (!this.listeners.has(type)) this.listeners.set(type, []);
    this.listeners.get(type).push(listener);
    if (this.latest.has(type)) queueMicrotask(() => listener(this.latest.get(type)));
  }

  emit(type, message) {
    for (const listener of this.listeners.get(type) ?? []) listener(message);
  }

  open() {
    this.socket = new WebSocket(this.url);
    this.socket.binaryType = "arraybuffer";
    this.socket.onopen = () => {
      this.attempts = 0;
      this.emit("connection", true);
    };
    this.socket.onclose = () => this.retry();
    this.socket.onmessage = ({ data }) => (typeof data === "string" ? this.readText(data) : this.readFrame(data));
  }

  retry() {
    for (const { reject } of this.waiting.values()) reject(new Error("The connection to the simulator was lost."));
    this.waiting.clear();
    this.emit("connection", false);
    setTimeout(() => this.open(), Math.min(BACKOFF.longest, BACKOFF.first * 2 ** this.attempts++));
  }

  readText(text) {
    const message = JSON.parse(text);
    if (message.type === "reply") return this.settle(message);
    if (message.type === "hello") this.welcome(message);
    this.latest.set(message.type, message);
    this.emit(message.type, message);
  }

  /** `hello` brings the aircraft, its modes and the status along: they are told as if each had come by itself. */
  welcome(hello) {
    this.channels = hello.channels;
    this.inputs = hello.inputs;
    this.index = Object.fromEntries(hello.channels.map((channel, i) => [channel.name, i]));
    for (const part of ["aircraft", "modes", "status"]) {
      this.latest.set(part, hello[part]);
      queueMicrotask(() => this.emit(part, hello[part]));
    }
  }

  readFrame(buffer) {
    const header = new DataView(buffer);
    if (header.getUint8(0) !== STATE || header.getUint8(1) !== VERSION) return;
    const sequence = header.getUint32(4, true);
    if (this.sequence && sequence > this.sequence + 1) this.lost += sequence - this.sequence - 1;
    this.sequence = sequence;
    this.flags = header.getUint16(2, true);
    this.t = header.getFloat64(8, true);
    this.echo = { sequence: header.getUint32(16, true), stamp: header.getFloat64(24, true) };
    this.values = new Float32Array(buffer, HEADER);
    this.receivedAt = performance.now();
    this.frames += 1;
    this.emit("frame", this);
  }

  /** The channels of the last frame into `target`, by name. */
  copyTo(target) {
    for (let i = 0; i < this.channels.length; i++) target[this.channels[i].name] = this.values[i];
    return target;
  }

  /** Sends the stick as sampled at `stamp` [ms]. Nothing is queued on a slow line: the next sample is newer anyway. */
  sendStick(stick, stamp) {
    if (!this.connected || this.socket.bufferedAmount > 4096) return;
    const view = this.input;
    view.setUint8(0, INPUT);
    view.setUint8(1, VERSION);
    view.setUint32(4, ++this.inputSequence, true);
    view.setFloat64(8, stamp, true);
    view.setFloat32(16, stick.pitch, true);
    view.setFloat32(20, stick.roll, true);
    view.setFloat32(24, stick.yaw, true);
    view.setFloat32(28, stick.throttle, true);
    this.socket.send(view.buffer);
  }

  /** Sends a command; the promise brings the reply, or fails with the server's own sentence. */
  command(name, fields = {}) {
    return this.ask(name, (id) => JSON.stringify({ type: "command", version: VERSION, id, name, ...fields }));
  }

  /** Sends a measured history, `times` [s] and `values` [SI], for a channel; the promise is as that of a command. */
  upload(channel, { times, values }) {
    return this.ask("measured", (id) => {
      const view = new DataView(new ArrayBuffer(8 + 16 * times.length));
      view.setUint8(0, HISTORY);
      view.setUint8(1, VERSION);
      view.setUint16(2, this.inputs.indexOf(channel), true);
      view.setUint32(4, id, true);
      times.forEach((t, k) => view.setFloat64(8 + 16 * k, t, true));
      values.forEach((value, k) => view.setFloat64(16 + 16 * k, value, true));
      return view.buffer;
    });
  }

  /** Sends the text of a file: `kind` 0 is an aircraft, 1 an experiment; the promise is as that of a command. */
  openText(kind, text) {
    return this.ask("open", (id) => {
      const bytes = new TextEncoder().encode(text);
      const message = new Uint8Array(8 + bytes.length);
      const view = new DataView(message.buffer);
      view.setUint8(0, DOCUMENT);
      view.setUint8(1, VERSION);
      view.setUint16(2, kind, true);
      view.setUint32(4, id, true);
      message.set(bytes, 8);
      return message.buffer;
    });
  }

  ask(name, message) {
    if (!this.connected)
      return Promise.reject(new Error("No connection to the simulator. It is tried again by itself."));
    const id = ++this.commandId;
    const { promise, resolve, reject } = withResolvers();
    this.waiting.set(id, { resolve, reject });
    this.socket.send(message(id));
    setTimeout(() => {
      if (this.waiting.delete(id))
        reject(new Error(`The simulator did not answer "${name}" within ${REPLY_WITHIN / 1000} s.`));
    }, REPLY_WITHIN);
    return promise;
  }

  settle(reply) {
    const waiting = this.waiting.get(reply.id);
    if (!waiting) return;
    this.waiting.delete(reply.id);
    if (reply.ok) waiting.resolve(reply);
    else waiting.reject(new Error(reply.error));
  }
}

// Promise.withResolvers is younger than the browsers that classrooms have.
function withResolvers() {
  let resolve, reject;
  const promise = new Promise((yes, no) => ([resolve, reject] = [yes, no]));
  return { promise, resolve, reject };
}
