// What is being looked at: the person's choices over the document's own values, which `welcome` tells.

import { view_members } from './protocol.js';

const light = ['sun_azimuth_deg', 'sun_elevation_deg', 'exposure_ev', 'tone_curve', 'vertical_fov_deg', 'time_utc', 'sun_time_rate'];

export class ViewState {
  chosen = {};
  #document = { sun_azimuth_deg: 180, sun_elevation_deg: 40, exposure_ev: 0, tone_curve: 'agx', vertical_fov_deg: 50,
    time_utc: '', sun_time_rate: 0 };

  get(name) {
    return this.chosen[name] ?? this.#document[name];
  }

  // Takes new choices in and returns the protocol's members that tell the server. Exposure and tone curve travel
  // as one.
  choose(members) {
    const together = 'exposure_ev' in members || 'tone_curve' in members
      ? { exposure_ev: this.get('exposure_ev'), tone_curve: this.get('tone_curve'), ...members } : members;
    Object.assign(this.chosen, together);
    return view_members(together);
  }

  // A sun that is put by its angles no longer runs with the time; one that runs, or stands where its place has it, has no
  // angles of its own.
  choose_sun(members) {
    const placed = 'sun_time_rate' in members;
    for (const name of placed ? ['sun_azimuth_deg', 'sun_elevation_deg'] : ['sun_time_rate']) delete this.chosen[name];
    return { ...(placed && { sun_azimuth_deg: null }), ...this.choose(members) };
  }

  // Another sky, seen as its document proposes. How it is drawn stays the person's choice.
  open(cloudscape) {
    const { quality } = this.chosen;
    this.chosen = { cloudscape, ...(quality && { quality }) };
  }

  welcome(message) {
    const values = { ...message, ...message.display, vertical_fov_deg: message.lens.vertical_fov_deg };
    for (const name of light) if (values[name] !== undefined) this.#document[name] = values[name];
  }
}
