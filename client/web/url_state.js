// A link is a view: the choices in the URL's fragment, under the names that the stills' query has.

const numbers = {
  azimuth_deg: { digits: 2 }, elevation_deg: { digits: 2 }, roll_deg: { digits: 2 },
  vertical_fov_deg: { digits: 1 }, sun_azimuth_deg: { digits: 1 }, sun_elevation_deg: { digits: 1 },
  sun_time_rate: { digits: 2 }, exposure_ev: { digits: 2 }, time_s: { digits: 1 },
};
const pose_names = ['azimuth_deg', 'elevation_deg', 'roll_deg'];
const limits = {
  azimuth_deg: [-36000, 36000], elevation_deg: [-90, 90], roll_deg: [-360, 360], vertical_fov_deg: [1, 170],
  sun_azimuth_deg: [-360, 360], sun_elevation_deg: [-90, 90], sun_time_rate: [-3600, 3600],
  exposure_ev: [-20, 20], time_s: [-1.6e7, 1.6e7],
};
export const tone_curves = ['agx', 'aces', 'reinhard', 'none'];
export const qualities = ['draft', 'interactive', 'standard', 'high', 'finest'];

// The characters that fit in a header and in a WebSocket subprotocol alike.
export function is_token(text) {
  return /^[A-Za-z0-9._~-]+$/.test(text ?? '');
}

function short(value, digits) {
  return String(Number(value.toFixed(digits)));
}

// The fragment, without '#'. Only what was chosen is named, so that a document's own light can still improve.
export function format_fragment(chosen) {
  const parts = [];
  const add = (name, text) => parts.push(`${name}=${text}`);
  if (chosen.cloudscape) add('cloudscape', encodeURIComponent(chosen.cloudscape));
  if (chosen.pose) {
    add('position', chosen.pose.position_m.map(value => short(value, 1)).join(','));
    for (const name of pose_names) {
      if (name !== 'roll_deg' || chosen.pose.roll_deg) add(name, short(chosen.pose[name], numbers[name].digits));
    }
  }
  for (const name of Object.keys(numbers)) {
    if (pose_names.includes(name) || chosen[name] === undefined) continue;
    add(name, short(chosen[name], numbers[name].digits));
  }
  for (const name of ['tone_curve', 'quality']) if (chosen[name] !== undefined) add(name, chosen[name]);
  return parts.join('&');
}

function read_number(parameters, name) {
  const text = parameters.get(name);
  if (text === null || text.trim() === '') return undefined;
  const value = Number(text);
  const [least, most] = limits[name];
  return Number.isFinite(value) && value >= least && value <= most ? value : undefined;
}

function read_pose(parameters) {
  const position_m = (parameters.get('position') ?? '').split(',').map(Number);
  const given = parameters.has('position') && position_m.length === 3 &&
    position_m.every(value => Number.isFinite(value) && Math.abs(value) <= 1e7);
  if (!given) return undefined;
  const [azimuth_deg, elevation_deg, roll_deg] = pose_names.map(name => read_number(parameters, name) ?? 0);
  return { position_m, azimuth_deg, elevation_deg, roll_deg };
}

// The choices of a fragment (with or without '#'), and the token if it has one. What makes no sense is left out.
export function parse_fragment(fragment) {
  const parameters = new URLSearchParams(fragment.replace(/^#/, ''));
  const chosen = {};
  const keep = (name, value) => { if (value !== undefined) chosen[name] = value; };
  keep('cloudscape', parameters.get('cloudscape') || undefined);
  keep('pose', read_pose(parameters));
  for (const name of Object.keys(numbers)) if (!pose_names.includes(name)) keep(name, read_number(parameters, name));
  keep('tone_curve', tone_curves.find(name => name === parameters.get('tone_curve')));
  keep('quality', qualities.find(name => name === parameters.get('quality')));
  const token = parameters.get('token');
  return { chosen, token: is_token(token) ? token : undefined };
}

const interval_ms = 400;  // Safari refuses more than 100 history changes in 30 s

// Keeps the address bar at the view: at once for a new cloudscape (a step in the history), else a few times a second.
export class AddressBar {
  #timer = null;
  #written = '';

  constructor({ window, read }) {
    this.window = window;
    this.read = read;
  }

  touch() {
    this.#timer ??= setTimeout(() => this.write('replaceState'), interval_ms);
  }

  write(how, view = this.read()) {
    clearTimeout(this.#timer);
    this.#timer = null;
    this.#written = `#${format_fragment(view)}`;
    if (this.window.location.hash !== this.#written) this.window.history[how](null, '', this.#written);
  }
}
