// The figures in the corner: frames a second, latency, bitrate, renderer, how far the resting view is refined.

import { final_stage } from './protocol.js';

const memory_ms = 2000;   // figures are averages over this time
const rest_ms = 1000;     // tuned: slower than one picture a second counts as rest
const refresh_ms = 250;   // tuned: readable, yet fresh

// What arrived and was shown, as sums over the last moments. Times are of performance.now().
export class Measures {
  #shown = [];
  #received = [];
  #sent = new Map();
  latency_ms = null;

  sent(pose_sequence, now_ms) {
    this.#sent.set(pose_sequence, now_ms);
    if (this.#sent.size > 256) this.#sent.delete(this.#sent.keys().next().value);
  }

  received(bytes, now_ms) {
    this.#received.push({ at: now_ms, bytes });
  }

  // The latency is that of the pose's first frame; later ones only refine it.
  shown({ pose_sequence }, now_ms) {
    this.#shown.push({ at: now_ms });
    const sent_ms = this.#sent.get(pose_sequence);
    if (sent_ms === undefined) return;
    const latency_ms = now_ms - sent_ms;
    this.latency_ms = this.latency_ms === null ? latency_ms : 0.7 * this.latency_ms + 0.3 * latency_ms;
    for (const sequence of this.#sent.keys()) if (sequence <= pose_sequence) this.#sent.delete(sequence);
  }

  figures(now_ms) {
    const recent = list => list.filter(({ at }) => now_ms - at < memory_ms);
    [this.#shown, this.#received] = [recent(this.#shown), recent(this.#received)];
    const bytes = this.#received.reduce((sum, { bytes }) => sum + bytes, 0);
    const count = this.#shown.length;
    const span_ms = count > 1 ? this.#shown[count - 1].at - this.#shown[0].at : 0;
    const rests = count === 0 || now_ms - this.#shown[count - 1].at > rest_ms;
    return {
      rests, frames_per_second: span_ms > 0 ? (count - 1) * 1000 / span_ms : 0,
      bits_per_second: bytes * 8 / (memory_ms / 1000), latency_ms: this.latency_ms,
    };
  }
}

export function stage_word(quality_stage) {
  if (quality_stage === final_stage) return 'finished';
  return quality_stage === 0 ? 'moving' : `refining ${quality_stage}`;
}

export function bitrate_text(bits_per_second) {
  if (bits_per_second >= 1e6) return `${(bits_per_second / 1e6).toFixed(1)} Mbit/s`;
  return `${Math.round(bits_per_second / 1e3)} kbit/s`;
}

export class Hud {
  #timer = null;
  #header = null;

  constructor({ root, measures }) {
    this.measures = measures;
    const nodes = [...root.querySelectorAll('[data-figure]')];
    this.fields = Object.fromEntries(nodes.map(node => [node.dataset.figure, node]));
  }

  renderer({ renderer, software }) {
    this.fields.renderer.textContent = software ? 'software' : 'GPU';
    this.fields.renderer.title = renderer;
  }

  stats({ render_ms, encode_ms, round_trip_ms }) {
    const parts = { render: render_ms, encode: encode_ms, 'round trip': round_trip_ms };
    this.fields.latency.title = 'From a movement to its picture on the screen. The server says: ' +
      Object.entries(parts).map(([name, value]) => `${name} ${value?.toFixed(1)} ms`).join(', ');
  }

  frame(header) {
    this.#header = header;
    this.#timer ??= setInterval(() => this.refresh(), refresh_ms);
  }

  refresh() {
    const { rests, frames_per_second, bits_per_second, latency_ms } = this.measures.figures(performance.now());
    const header = this.#header;
    const rate = frames_per_second.toFixed(frames_per_second < 9.5 ? 1 : 0);
    this.fields.fps.textContent = rests || !frames_per_second ? 'at rest' : `${rate} fps`;
    this.fields.latency.textContent = latency_ms === null ? '' : `${Math.round(latency_ms)} ms`;
    this.fields.bitrate.textContent = rests ? '' : bitrate_text(bits_per_second);
    this.fields.size.textContent = header ? `${header.width_px} × ${header.height_px}` : '';
    this.fields.stage.textContent = header ? stage_word(header.quality_stage) : '';
    this.fields.stage.dataset.stage = header ? stage_word(header.quality_stage).split(' ')[0] : '';
    // A view at rest costs nothing here either.
    if (rests) {
      clearInterval(this.#timer);
      this.#timer = null;
    }
  }
}
