// Stills: asks the server for a picture of the current view and saves it, with progress and a way to stop.

import { api_fetch } from './api.js';
import { reference_body, traced } from './reference.js';

const light_names = ['vertical_fov_deg', 'time_s', 'sun_azimuth_deg', 'sun_elevation_deg', 'exposure_ev', 'tone_curve'];

// The still's query from the same choices that a link has.
export function still_query(state, { format, quality, width, height }) {
  const { chosen } = state;
  const query = new URLSearchParams({ cloudscape: chosen.cloudscape });
  if (chosen.pose) {
    query.set('position', chosen.pose.position_m.join(','));
    for (const name of ['azimuth_deg', 'elevation_deg', 'roll_deg']) query.set(name, chosen.pose[name]);
  }
  for (const name of light_names) {
    if (chosen[name] !== undefined) query.set(name, chosen[name]);
  }
  if (chosen.sun_time_rate !== undefined) query.set('time_rate', chosen.sun_time_rate);
  for (const [name, value] of Object.entries({ width, height, quality, format })) query.set(name, value);
  return query;
}

async function read_body(response, on_progress) {
  const whole = Number(response.headers.get('Content-Length'));
  const parts = [];
  let bytes = 0;
  for (const reader = response.body.getReader(); ;) {
    const { done, value } = await reader.read();
    if (done) return new Blob(parts, { type: response.headers.get('Content-Type') ?? '' });
    parts.push(value);
    bytes += value.length;
    if (whole) on_progress(bytes / whole);
  }
}

function save(blob, name) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60000);
}

export class Stills {
  #abort = null;

  constructor({ state, token, window_size_px }) {
    Object.assign(this, { state, token, window_size_px });
  }

  get busy() {
    return this.#abort !== null;
  }

  cancel() {
    this.#abort?.abort();
  }

  // `on_progress(null)` while the server renders, then 0..1. Resolves to the file's name, or to null where cancelled;
  // throws the server's sentence. `samples`: of a path-traced picture, whose progress comes while it is rendered.
  async take({ format, quality, samples, scale, on_progress }) {
    const [width, height] = this.window_size_px().map(side => Math.round(side * scale));
    this.#abort = new AbortController();
    const { signal } = this.#abort;
    try {
      on_progress(null);
      const response = quality === 'reference'
        ? await traced(reference_body(this.state, { format, samples, width, height }), this.token(), { signal, on_progress })
        : await api_fetch(`api/v1/stills?${still_query(this.state, { format, quality, width, height })}`, this.token(), { signal });
      const name = `${this.state.chosen.cloudscape}-${width}x${height}.${format}`;
      save(await read_body(response, on_progress), name);
      return name;
    } catch (error) {
      if (error.name === 'AbortError') return null;
      throw error instanceof TypeError ? new Error('The server does not answer.') : error;
    } finally {
      this.#abort = null;
    }
  }
}
