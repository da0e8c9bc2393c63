// Path-traced stills: a job that is ordered, looked after until it is done, and fetched.

import { api_fetch } from './api.js';

const pause_ms = 500;

// The body of the order, from the same choices that a link has.
export function reference_body(state, { format, samples, width, height }) {
  const { chosen } = state;
  const given = names => Object.fromEntries(names.filter(name => chosen[name] !== undefined).map(name => [name, chosen[name]]));
  const camera = { ...chosen.pose };
  if (chosen.vertical_fov_deg !== undefined) camera.lens = { vertical_fov_deg: chosen.vertical_fov_deg };
  const sun = {};
  if (chosen.sun_azimuth_deg !== undefined) sun.azimuth_deg = chosen.sun_azimuth_deg;
  if (chosen.sun_elevation_deg !== undefined) sun.elevation_deg = chosen.sun_elevation_deg;
  if (chosen.sun_time_rate !== undefined) sun.place = { time_rate: chosen.sun_time_rate };
  const image = { width, height, quality: 'reference', samples, format, ...given(['time_s', 'exposure_ev', 'tone_curve']) };
  return { cloudscape: chosen.cloudscape, camera, image, sun };
}

function paused(signal) {
  return new Promise((resolve, reject) => {
    const timer = setTimeout(resolve, pause_ms);
    signal.addEventListener('abort', () => {
      clearTimeout(timer);
      reject(signal.reason);
    }, { once: true });
  });
}

// The response that holds the picture. `on_progress(0..1)`. Who aborts `signal` cancels the job.
export async function traced(body, token, { signal, on_progress }) {
  const json = { 'Content-Type': 'application/json' };
  const ordered = await api_fetch('api/v1/references', token, { method: 'POST', headers: json, body: JSON.stringify(body), signal });
  let job = await ordered.json();
  const link = `api/v1/jobs/${job.id}`;
  try {
    while (job.state === 'queued' || job.state === 'rendering') {
      await paused(signal);
      job = await (await api_fetch(link, token, { signal })).json();
      on_progress(job.progress);
    }
    if (job.state !== 'done') throw new Error(job.error ?? 'The picture was cancelled.');
    return await api_fetch(`${link}/result`, token, { signal });
  } catch (error) {
    api_fetch(link, token, { method: 'DELETE' }).catch(() => {});
    throw error;
  }
}
