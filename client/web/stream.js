// The stream as the page sees it: poses and settings out, pictures in, each acknowledged once it is on display.

import { Connection } from './connection.js';
import { diagnose, stream_url } from './api.js';
import { LatestFrame, make_decode } from './decoder.js';
import { ack_message, camera_message, clock_message, hello_message, read_frame } from './protocol.js';

const camera_interval_ms = 10;       // fast displays must not exceed the server's rate of messages
const settings_interval_ms = 30;     // nor may a slider
const congested_bytes = 16 * 1024;   // a pose that would wait behind this many is held back: a newer one follows
const patience_hidden_ms = 10000;    // a glance at another tab costs no reconnect

export class Stream {
  #pose_sequence = 0;
  #camera_sent_ms = 0;
  #owed = [];
  #unsent = {};
  #clock = null;
  #settings_timer = null;
  #hidden_timer = null;

  // `size_px()` is what to ask for now; `on_state`, `on_message` and `on_frame(header)` tell the page.
  constructor({ state, display, measures, token, size_px, on_state, on_message, on_frame }) {
    Object.assign(this, { state, display, measures, size_px, on_message, on_frame });
    this.frames = new LatestFrame({
      decode: make_decode(),
      show: (image, frame, decode_ms) => this.#show(image, frame, decode_ms),
      skip: frame => this.#acknowledge(frame.header.frame_id, 0),
    });
    this.connection = new Connection({
      url: stream_url(), token, on_state, diagnose: () => diagnose(token()), hello: () => this.#hello(),
      on_message: message => this.#message(message), on_frame: data => this.#frame(data),
    });
    document.addEventListener('visibilitychange', () => this.#visibility());
  }

  open() {
    this.connection.open();
  }

  close() {
    this.connection.close();
  }

  // Whether the pose went out; false: it is to be offered again, or a newer one.
  offer_pose() {
    const now_ms = performance.now();
    const { connection } = this;
    if (!connection.is_live || connection.buffered_bytes > congested_bytes) return false;
    if (now_ms - this.#camera_sent_ms < camera_interval_ms) return false;
    this.#camera_sent_ms = now_ms;
    this.measures.sent(++this.#pose_sequence, now_ms);
    connection.send(camera_message(this.#pose_sequence, this.state.chosen.pose, this.state.chosen.time_s));
    return true;
  }

  // Merged for a moment, and until there is a welcome; a later hello carries them anyway.
  settings(members) {
    Object.assign(this.#unsent, members);
    this.#settings_timer ??= setTimeout(() => this.#send_settings(), settings_interval_ms);
  }

  // Merged likewise.
  turn_clock(members) {
    this.#clock = { ...this.#clock, ...members };
    this.#settings_timer ??= setTimeout(() => this.#send_settings(), settings_interval_ms);
  }

  #send_settings() {
    this.#settings_timer = null;
    if (!this.connection.is_live) return;
    if (Object.keys(this.#unsent).length > 0) this.connection.send({ type: 'settings', ...this.#unsent });
    if (this.#clock) this.connection.send(clock_message(this.#clock));
    this.#unsent = {};
    this.#clock = null;
  }

  #hello() {
    this.#unsent = {};
    this.#clock = null;
    this.frames.reset();
    this.#owed = [];
    return hello_message(this.state.chosen, this.size_px());
  }

  #message(message) {
    if (message.type === 'welcome') {
      this.state.welcome(message);
      this.#send_settings();
    }
    this.on_message(message);
  }

  #frame(data) {
    const frame = read_frame(data);
    this.measures.received(data.byteLength, performance.now());
    this.frames.submit(frame);
  }

  #show(image, { header }, decode_ms) {
    this.display.show(image, header);
    this.measures.shown(header, performance.now());
    this.#acknowledge(header.frame_id, decode_ms);
    this.on_frame(header);
  }

  // Nothing is on display in a hidden tab: what is owed holds the server back until the tab is seen again.
  #acknowledge(frame_id, decode_ms) {
    if (document.hidden) this.#owed.push(ack_message(frame_id, decode_ms));
    else this.connection.send(ack_message(frame_id, decode_ms));
  }

  #visibility() {
    clearTimeout(this.#hidden_timer);
    if (document.hidden) {
      this.#hidden_timer = setTimeout(() => this.connection.rest(), patience_hidden_ms);
    } else if (!this.connection.wake()) {
      for (const ack of this.#owed.splice(0)) this.connection.send(ack);
    }
  }
}
