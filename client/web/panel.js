// The panel: sliders, selects and the list of skies, bound to the view's state.

import { time_of_day } from './clock.js';

const compass = ['N', 'NE', 'E', 'SE', 'S', 'SW', 'W', 'NW'];

export function clock_text(seconds) {
  const whole = Math.floor(Math.abs(seconds));
  const two = value => String(value).padStart(2, '0');
  return `${seconds <= -1 ? '-' : ''}${Math.floor(whole / 3600)}:${two(Math.floor(whole / 60) % 60)}:${two(whole % 60)}`;
}

const degrees = value => `${Math.round(value * 10) / 10}°`;
const texts = {
  sun_azimuth_deg: value => `${Math.round(value)}° ${compass[Math.round(value / 45) % 8]}`,
  sun_elevation_deg: degrees,
  vertical_fov_deg: degrees,
  exposure_ev: value => `${value > 0 ? '+' : ''}${value.toFixed(1)} EV`,
  time_s: clock_text,
};
const selects = ['tone_curve', 'quality'];
const suns = ['sun_azimuth_deg', 'sun_elevation_deg'];

export class Panel {
  #time_s = 0;
  // `on_choose({name: value})` for what the stream knows, `on_sun` for where the sun stands or how it runs;
  // `on_cloudscape(name)`; `on_clock({time_s, rate, paused})` with what is to change; `on_resolution(choice)`.
  constructor({ root, state, on_choose, on_sun, on_cloudscape, on_clock, on_resolution }) {
    Object.assign(this, { root, state, on_cloudscape, on_clock });
    this.playing = false;
    for (const name of Object.keys(texts)) {
      const slider = this.#control(name);
      const changed = name === 'time_s' ? on_clock : suns.includes(name) ? on_sun : on_choose;
      slider.addEventListener('input', () => {
        changed({ [name]: slider.valueAsNumber });
        this.#show_slider(name, slider.valueAsNumber);
      });
    }
    this.#control('sun_runs').addEventListener('change', event => {
      on_sun({ sun_time_rate: event.target.checked ? 1 : 0 });
      this.refresh();
    });
    for (const name of selects) {
      this.#control(name).addEventListener('change', event => on_choose({ [name]: event.target.value }));
    }
    this.resolution = this.#control('resolution');
    this.resolution.addEventListener('change', () => on_resolution(this.resolution.value));
    this.play = this.#control('play');
    this.play.addEventListener('click', () => this.toggle_play());
    for (const radio of this.#rates()) radio.addEventListener('change', () => on_clock({ rate: Number(radio.value) }));
  }

  toggle_play() {
    this.on_clock({ paused: this.playing });
  }

  show_clock({ playing, rate }) {
    this.playing = playing;
    this.play.setAttribute('aria-pressed', String(playing));
    for (const radio of this.#rates()) radio.checked = Number(radio.value) === rate;
  }

  // `title` and `description` come from documents: they are text, never markup.
  list(cloudscapes) {
    const group = this.#control('cloudscapes');
    for (const old of group.querySelectorAll('label')) old.remove();
    for (const { name, title, description } of cloudscapes) {
      const label = document.createElement('label');
      label.title = description ?? '';
      const radio = Object.assign(document.createElement('input'), { type: 'radio', name: 'cloudscape', value: name });
      radio.addEventListener('change', () => this.on_cloudscape(name));
      const heading = Object.assign(document.createElement('b'), { textContent: title || name });
      label.append(radio, heading, Object.assign(document.createElement('small'), { textContent: description ?? '' }));
      group.append(label);
    }
    this.refresh();
  }

  refresh() {
    for (const name of Object.keys(texts)) if (name !== 'time_s') this.#show_slider(name, this.state.get(name) ?? 0);
    this.#show_sun();
    for (const name of selects) this.#control(name).value = this.state.get(name) ?? 'standard';
    for (const radio of this.root.querySelectorAll('[name=cloudscape]')) {
      radio.checked = radio.value === this.state.chosen.cloudscape;
    }
  }

  show_time(time_s) {
    this.#time_s = time_s;
    this.#show_slider('time_s', time_s);
    this.#show_sun();
  }

  // A sun that has been put somewhere by hand stands there; the document's own can run with the time where it has one.
  #show_sun() {
    const time_utc = this.state.get('time_utc'), turned = suns.some(name => this.state.chosen[name] !== undefined);
    const rate = turned ? 0 : this.state.get('sun_time_rate') ?? 0;
    this.#control('sun_time').hidden = !time_utc;
    this.#control('sun_runs').checked = rate !== 0;
    this.#control('time_of_day').textContent = time_utc && !turned ? time_of_day(time_utc, rate, this.#time_s) : '';
  }

  #control(id) {
    return this.root.querySelector(`#${id}`);
  }

  #rates() {
    return [...this.root.querySelectorAll('[name=rate]')];
  }

  #show_slider(name, value) {
    const slider = this.#control(name);
    const shown = name === 'sun_azimuth_deg' ? ((value % 360) + 360) % 360 : value;
    if (slider.valueAsNumber !== shown) slider.value = shown;
    const share = (slider.valueAsNumber - slider.min) / (slider.max - slider.min);
    slider.style.setProperty('--at', `${100 * share}%`);
    slider.nextElementSibling.textContent = texts[name](shown);
    slider.setAttribute('aria-valuetext', texts[name](shown));
  }
}
