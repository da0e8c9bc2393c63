// The WebSocket that stays: opens, says hello, reconnects with jittered back-off, and tells why where it may not.

import { subprotocols } from './protocol.js';

const first_wait_ms = 500, longest_wait_ms = 15000;  // tuned: a restart is unnoticed, a lost server is not hammered
const protocol_errors = new Set([1002, 1003, 1007, 1008, 1009, 1010]);  // RFC 6455, 7.4.1: trying again changes nothing

// Between half and the whole of a doubling wait, so that many viewers do not come back at once.
export function wait_ms(attempt, random = Math.random) {
  const whole = Math.min(longest_wait_ms, first_wait_ms * 2 ** attempt);
  return whole * (0.5 + 0.5 * random());
}

// States told through `on_state(name, detail)`: connecting, live, waiting {seconds, reason}, refused {kind, message},
// closed. `hello()` gives the first message, `token()` the token, `diagnose()` promises why a socket did not open:
// {kind, message, retry, wait_s}.
export class Connection {
  #socket = null;
  #attempt = 0;
  #timer = null;
  #fatal = null;
  #live = false;
  #resting = false;

  constructor({ url, hello, token, diagnose, on_state, on_message, on_frame, WebSocketClass = globalThis.WebSocket }) {
    Object.assign(this, { url, hello, token, diagnose, on_state, on_message, on_frame, WebSocketClass });
  }

  get is_live() {
    return this.#live && this.#socket?.readyState === 1;
  }

  get buffered_bytes() {
    return this.#socket?.bufferedAmount ?? 0;
  }

  open() {
    this.#drop();
    this.#fatal = null;
    this.#resting = false;
    this.on_state('connecting', { attempt: this.#attempt });
    const socket = new this.WebSocketClass(this.url, subprotocols(this.token()));
    socket.binaryType = 'arraybuffer';
    let opened = false;
    socket.onopen = () => {
      opened = true;
      socket.send(JSON.stringify(this.hello()));
    };
    socket.onmessage = ({ data }) => (typeof data === 'string' ? this.#text(data) : this.#binary(data));
    socket.onclose = event => this.#closed(event, opened);
    this.#socket = socket;
  }

  close() {
    this.#drop();
    this.on_state('closed', {});
  }

  // Lets go of a stream, or of the wait for one, that nobody watches; `wake` opens it again and tells whether it did.
  rest() {
    this.#resting = this.#socket !== null || this.#timer !== null;
    if (this.#resting) this.close();
  }

  wake() {
    const resting = this.#resting;
    if (resting) this.open();
    return resting;
  }

  send(message) {
    if (this.is_live) this.#socket.send(JSON.stringify(message));
  }

  #drop() {
    clearTimeout(this.#timer);
    this.#timer = null;
    this.#live = false;
    if (!this.#socket) return;
    this.#socket.onopen = this.#socket.onmessage = this.#socket.onclose = null;
    this.#socket.close();
    this.#socket = null;
  }

  #text(data) {
    let message;
    try {
      message = JSON.parse(data);
    } catch {
      return this.#refuse('protocol', 'The server sent a message that is not JSON; its version may not fit this page.');
    }
    if (message.type === 'welcome') {
      this.#attempt = 0;
      this.#live = true;
    }
    // Before the welcome there is nothing to go on with: every error is the end then.
    if (message.type === 'error' && (message.fatal || !this.#live)) this.#fatal = message;
    else this.on_message(message);
    if (message.type === 'welcome') this.on_state('live', {});
    if (this.#fatal && !this.#live) this.#refuse('protocol', this.#fatal.message);
  }

  #binary(data) {
    try {
      this.on_frame(data);
    } catch (error) {
      this.#refuse('protocol', error.message);
    }
  }

  #refuse(kind, message) {
    this.#drop();
    this.on_state('refused', { kind, message });
  }

  async #closed(event, opened) {
    const socket = this.#socket;
    const reason = this.#fatal?.message || event.reason;
    if (event.code === 1013) return this.#wait(reason || 'The server is full.');
    if (this.#fatal || protocol_errors.has(event.code)) {
      return this.#refuse('protocol', reason || `The server closed the stream (code ${event.code}).`);
    }
    if (opened) return this.#wait(event.code === 1001 ? 'The server is restarting.' : 'The connection was lost.');
    const cause = await this.diagnose();
    if (socket !== this.#socket) return;
    if (cause.retry) this.#wait(cause.message, cause.wait_s);
    else this.#refuse(cause.kind, cause.message);
  }

  #wait(reason, at_least_s = 0) {
    this.#socket = null;
    this.#live = false;
    const wait = Math.max(wait_ms(this.#attempt++), at_least_s * 1000);
    this.on_state('waiting', { seconds: wait / 1000, reason });
    this.#timer = setTimeout(() => this.open(), wait);
  }
}
