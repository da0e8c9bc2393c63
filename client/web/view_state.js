// What is being looked at: the person's choices over the document's own values, which `welcome` tells.

import { view_members } from './protocol.js';

const light = ['sun_azimuth_deg', 'sun_elevation_deg', 'exposure_ev', 'tone_curve', 'vertical_fov_deg'];

export class ViewState {
  chosen = {};
  #document = { sun_azimuth_deg: 180, sun_elevation_deg: 40, exposure_ev: 0, tone_curve: 'agx', vertical_fov_deg: 50 };

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

  // Another sky, seen as its document proposes. How it is drawn stays the person's choice.
  open(cloudscape) {
    const { quality } = this.chosen;
    this.chosen = { cloudscape, time_s: 0, ...(quality && { quality }) };
  }

  welcome(message) {
    const values = { ...message, ...message.display, vertical_fov_deg: message.lens.vertical_fov_deg };
    for (const name of light) if (values[name] !== undefined) this.#document[name] = values[name];
  }
}
