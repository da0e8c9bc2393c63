// A viewer on npm ws that reads the protocol by its description, not with the project's own code.
import WebSocket from 'ws';

import { until } from './program.mjs';

export class Viewer {
  static async open(server, { subprotocols = ['cloudscape.v1'], ...options } = {}) {
    const socket = new WebSocket(server.stream_url, subprotocols, { perMessageDeflate: false, ...options });
    const viewer = new Viewer(socket);
    await new Promise((resolve, reject) => { socket.once('open', resolve); socket.once('error', reject); });
    return viewer;
  }

  constructor(socket) {
    Object.assign(this, { socket, messages: [], frames: [], frames_received: 0, sequence: 100, sent_at: new Map(), acknowledges: true });
    this.closed = new Promise(resolve => socket.on('close', (code, reason) => resolve({ code, reason: String(reason) })));
    socket.on('error', () => {});
    socket.on('message', (data, binary) => (binary ? this.#receive_frame(data) : this.messages.push(JSON.parse(data))));
  }

  send(message) { if (this.socket.readyState === WebSocket.OPEN) this.socket.send(JSON.stringify(message)); }
  hello(settings) { this.send({ type: 'hello', version: 1, ...settings }); }
  camera(pose_sequence, pose) {
    this.sent_at.set(BigInt(pose_sequence), Date.now());
    this.send({ type: 'camera', pose_sequence, pose });
  }

  // The next message of `type`; it is taken out of what was received.
  message(type, timeout_ms = 60000) {
    return this.#take(this.messages, message => message.type === type, `a message ${type}`, timeout_ms);
  }
  frame(condition = () => true, timeout_ms = 60000) { return this.#take(this.frames, condition, 'a frame', timeout_ms); }

  async #take(list, condition, what, timeout_ms) {
    const index = await until(() => 1 + list.findIndex(condition), what, timeout_ms);
    return list.splice(index - 1, 1)[0];
  }

  // 92 bytes, little-endian, then the image.
  #receive_frame(data) {
    const f64 = at => data.readDoubleLE(at);
    const frame = {
      version: data[0], quality_stage: data[1], image_format: data[2], lens_kind: data[3], frame_id: data.readUInt32LE(4),
      pose_sequence: data.readBigUInt64LE(8), width: data.readUInt16LE(16), height: data.readUInt16LE(18),
      vertical_fov_deg: data.readFloatLE(20), position_m: [f64(24), f64(32), f64(40)], azimuth_deg: f64(48),
      elevation_deg: f64(56), roll_deg: f64(64), time_s: f64(72), image: data.subarray(92),
    };
    if (data.readUInt32LE(88) !== frame.image.length) throw new Error('the header tells another length than the message has');
    ++this.frames_received;
    this.frames.push(frame);
    this.on_frame?.(frame);
    if (this.acknowledges) this.send({ type: 'ack', frame_id: frame.frame_id, decode_ms: 1 });
  }

  // [width, height] of the JPEG's frame header (SOF0 to SOF2).
  static jpeg_size(image) {
    for (let at = 2; at < image.length; at += 2 + image.readUInt16BE(at + 2))
      if (image[at + 1] >= 0xc0 && image[at + 1] <= 0xc2) return [image.readUInt16BE(at + 7), image.readUInt16BE(at + 5)];
    return null;
  }
}
