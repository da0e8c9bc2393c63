// Wires the page: inputs move the camera, the camera feeds the stream, the stream feeds the canvas and the figures.

import { AnimationLoop } from './animation_loop.js';
import { explain, list_cloudscapes } from './api.js';
import { FlightCamera, sum_intents } from './camera.js';
import { Clock } from './clock.js';
import { wait_ms } from './connection.js';
import { Display } from './display.js';
import { Gallery } from './gallery.js';
import { Hud, Measures, stage_word } from './hud.js';
import { GamepadInput } from './input_gamepad.js';
import { KeyboardInput } from './input_keyboard.js';
import { MouseInput } from './input_mouse.js';
import { TouchInput, TouchStick } from './input_touch.js';
import { Notices } from './notices.js';
import { copy_link, toggle_fullscreen, toggle_panel } from './page_actions.js';
import { Panel } from './panel.js';
import { Stills } from './still.js';
import { StillPanel } from './still_panel.js';
import { Store } from './store.js';
import { Stream } from './stream.js';
import { budget_px, stream_size_px } from './stream_size.js';
import { AddressBar, is_token, parse_fragment } from './url_state.js';
import { ViewState } from './view_state.js';

const usual_cloudscape = 'fair-weather-cumulus';
const resize_quiet_ms = 150;       // a dragged window edge asks for a size only when it rests
const turning_quiet_ms = 400;      // tuned: frames of before a scrub do not pull the slider back
const lock_deg_per_px = 0.1;       // tuned: a hand's width of mouse turns a half circle
const turn_rate_per_fov = 1.1;     // a key turns by about a picture's height in a second
const software_guess = { software: true, max_size_px: [1280, 720] };  // until the welcome tells

const $ = id => document.getElementById(id);
const store = new Store();
const state = new ViewState();
const clock = new Clock();
const measures = new Measures();
const camera = new FlightCamera({ position_m: [0, 0, 2], azimuth_deg: 0, elevation_deg: 10, roll_deg: 0 });
let server = software_guess;
let cloudscapes = [];
let pose_is_due = false;
let turned_ms = -Infinity;  // when this page last turned the clock
let kept = null;            // what the clock was to do when the connection was lost

if (matchMedia('(prefers-reduced-motion: reduce)').matches) camera.smoothing_s = 0;

const window_size_px = () => [innerWidth, innerHeight].map(side => Math.round(side * devicePixelRatio));
const size_px = () => stream_size_px({
  width_css: innerWidth, height_css: innerHeight, device_pixel_ratio: devicePixelRatio,
  budget: budget_px(store.get('resolution'), server.software), max_size_px: server.max_size_px,
});
const ask_size = () => stream.settings({ size_px: size_px() });

// --- the stream and what it tells ---
const notices = new Notices({
  toast: $('toast'), notice: $('notice'),
  on_again: kind => (kind === 'cloudscape' ? open_cloudscape(default_cloudscape()) : start()),
  on_token: token => {
    const message = 'A token has only letters, digits and - . _ ~';
    if (!is_token(token)) return notices.refused({ kind: 'token', message });
    store.token = token;
    start();
  },
});
const display = new Display({ sky: $('sky'), edge: $('edge') });
const hud = new Hud({ root: $('hud'), measures });
const receivers = { welcome, stats: values => hud.stats(values), error: ({ message }) => notices.toast(message, 6000), clock: told_clock };
const stream = new Stream({
  state, measures, size_px, display, token: () => store.token,
  on_frame: header => {
    notices.clear('preparing');
    document.body.dataset.stage = stage_word(header.quality_stage);
    hud.frame(header);
    show_time(header.time_s);
  },
  on_message: message => receivers[message.type]?.(message),
  on_state: (name, detail) => {
    document.body.dataset.stream = name;
    if (name === 'connecting') document.body.dataset.stage = stage_word(0);
    if (name === 'live') {
      notices.preparing(title_of(state.chosen.cloudscape));
      wake();
    }
    if (name === 'waiting') {
      if (!clock.is_new) kept ??= { time_s: clock.time_s, rate: clock.rate, paused: clock.paused };
      notices.waiting(detail.reason);
    }
    if (name === 'refused') refused(detail);
  },
});

function refused({ kind, message }) {
  const known = cloudscapes.some(({ name }) => name === state.chosen.cloudscape);
  if (kind === 'protocol' && !known) notices.refused({ kind: 'cloudscape', message }, 'Show another sky');
  else notices.refused({ kind, message });
}

function welcome(message) {
  const asked = String(size_px());
  server = message;
  hud.renderer(message);
  if (!state.chosen.pose) {
    state.chosen.pose = message.pose;
    camera.place(message.pose);
    display.aim(message.pose);
    address.write('replaceState');
  }
  panel.refresh();
  // The hello asked for what any server grants; this one may grant more.
  if (String(size_px()) !== asked) ask_size();
}

// --- time: the document's clock, or the link's own moment until somebody here turns the clock ---
const shown_time_s = () => state.chosen.time_s ?? clock.time_s;
const as_seen = () => ({ ...state.chosen, time_s: Math.round(shown_time_s() * 10) / 10 });

function show_clock() {
  const follows = state.chosen.time_s === undefined;
  panel.show_clock({ playing: follows && !clock.paused, rate: clock.rate });
  show_time(shown_time_s());
}

function show_time(time_s) {
  if (performance.now() - turned_ms > turning_quiet_ms) panel.show_time(time_s);
}

function told_clock(told) {
  clock.tell(told);
  // A server that was started anew has forgotten it.
  if (kept && clock.is_new && state.chosen.time_s === undefined) turn_clock(kept);
  kept = null;
  show_clock();
}

function turn_clock(change) {
  const whole = state.chosen.time_s === undefined ? change : { time_s: state.chosen.time_s, ...change };
  delete state.chosen.time_s;
  turned_ms = performance.now();
  clock.tell(whole);
  stream.turn_clock(whole);
  show_clock();
  setTimeout(show_clock, turning_quiet_ms + 1);
  if (change.rate === undefined) document.body.dataset.stage = stage_word(0);  // a rate alone changes no picture
  address.touch();
}

// --- start, other skies, links ---
const default_cloudscape = () => (cloudscapes.find(({ name }) => name === usual_cloudscape) ?? cloudscapes[0])?.name;

const title_of = wanted => cloudscapes.find(({ name }) => name === wanted)?.title ?? wanted;

let start_attempt = 0, start_timer = null;
async function start() {
  clearTimeout(start_timer);
  stream.close();
  try {
    cloudscapes = await list_cloudscapes(store.token);
  } catch (error) {
    const cause = explain(error, store.token);
    if (!cause.retry) return notices.refused(cause);
    notices.waiting(cause.message);
    start_timer = setTimeout(start, Math.max(wait_ms(start_attempt++), (cause.wait_s ?? 0) * 1000));
    return;
  }
  start_attempt = 0;
  state.chosen.cloudscape ??= default_cloudscape();
  panel.list(cloudscapes);
  document.body.classList.add('ready');
  stream.open();
}

function open_cloudscape(name) {
  address.write('replaceState');
  state.open(name);
  display.aim(null);
  address.write('pushState');
  clock.tell({ time_s: 0, rate: 1, paused: true });  // until the server tells
  kept = null;
  panel.refresh();
  show_clock();
  stream.open();
}

function follow_link() {
  const { chosen, token } = parse_fragment(location.hash);
  if (token) store.token = token;
  state.chosen = { ...chosen, cloudscape: chosen.cloudscape ?? state.chosen.cloudscape };
  if (chosen.pose) camera.place(chosen.pose);
  display.aim(chosen.pose);
  if (token) address.write('replaceState');  // the token leaves the visible address at once
  panel.refresh();
  show_clock();
}

const address = new AddressBar({ window, read: () => state.chosen });
addEventListener('hashchange', () => {
  follow_link();
  if (cloudscapes.length) stream.open();
  else start();
});

// --- flight ---
const loop = new AnimationLoop(dt_s => {
  camera.turn_rate_deg_per_s = turn_rate_per_fov * state.get('vertical_fov_deg');
  const moves = camera.step(dt_s, sum_intents(inputs.map(input => input.intent(dt_s))));
  if (moves) changed();
  if (pose_is_due && state.chosen.pose && stream.offer_pose()) pose_is_due = false;
  return moves || (pose_is_due && stream.connection.is_live) || gamepad.connected;
});
const wake = () => loop.wake();

function changed() {
  if (!state.chosen.pose) return;  // nothing to steer before the first welcome
  state.chosen.pose = { ...camera.pose, position_m: [...camera.pose.position_m] };
  pose_is_due = true;
  display.aim(state.chosen.pose);
  document.body.dataset.stage = stage_word(0);
  address.touch();
}

function look(right_px, up_px, locked) {
  if (locked) camera.look(right_px * lock_deg_per_px, up_px * lock_deg_per_px);
  else camera.drag(right_px, up_px, state.get('vertical_fov_deg') / innerHeight);
  changed();
  wake();
}

function change_speed(factor) {
  camera.change_speed(factor);
  const speed = camera.speed_m_per_s;
  notices.toast(`Speed ${speed < 10 ? speed.toFixed(1) : Math.round(speed)} m/s`);
}

// --- panel and inputs ---
const panel = new Panel({
  root: $('panel'), state,
  on_cloudscape: open_cloudscape, on_clock: turn_clock,
  on_choose: members => {
    stream.settings(state.choose(members));
    address.touch();
  },
  on_sun: members => {
    stream.settings(state.choose_sun(members));
    panel.refresh();
    address.touch();
  },
  on_resolution: choice => {
    store.set('resolution', choice);
    ask_size();
  },
});
const stills = new Stills({ state: { get chosen() { return as_seen(); } }, token: () => store.token, window_size_px });
const still_panel = new StillPanel({ root: $('panel'), stills, window_size_px });

new Gallery({
  dialog: $('gallery'), opener: $('gallery_open'), token: () => store.token,
  on_fly: view => { location.hash = view; }, on_error: sentence => notices.toast(sentence, 6000),
});

const show_panel = shown => toggle_panel($('panel'), $('show'), shown);
const toggle_hud = () => store.set('hud', document.body.classList.toggle('no-hud') ? 'off' : 'on');
const reset = () => open_cloudscape(state.chosen.cloudscape);
async function copy() {
  address.write('replaceState', as_seen());  // a link shows this very moment
  notices.toast(await copy_link());
}

const mouse = new MouseInput({
  surface: $('sky'), on_look: look, on_speed: change_speed,
  on_lock: locked => notices.toast(locked ? 'Mouse look: Escape or L ends it' : 'Mouse look ended'),
});
const keyboard = new KeyboardInput({
  window, on_active: wake,
  commands: {
    KeyH: () => show_panel(), KeyI: toggle_hud, KeyF: toggle_fullscreen, KeyR: reset, KeyL: () => mouse.toggle_lock(),
    Space: () => panel.toggle_play(),
  },
});
const touch = new TouchInput({ surface: $('sky'), on_look: look, on_active: wake });
const stick = new TouchStick({ stick: $('stick'), knob: $('knob'), on_active: wake });
const gamepad = new GamepadInput({ window, on_active: wake, on_speed: change_speed });
const inputs = [keyboard, touch, stick, gamepad];

for (const [id, action] of Object.entries({
  show: () => show_panel(true), hide: () => show_panel(false), lock: () => mouse.toggle_lock(),
  fullscreen: toggle_fullscreen, reset, copy,
})) $(id).addEventListener('click', action);

let resize_timer = null;
addEventListener('resize', () => {
  clearTimeout(resize_timer);
  resize_timer = setTimeout(() => {
    ask_size();
    still_panel.refresh();
  }, resize_quiet_ms);
});

show_panel(!matchMedia('(max-width: 600px)').matches);
document.body.classList.toggle('no-hud', store.get('hud') === 'off');
panel.resolution.value = store.get('resolution') ?? 'automatic';
follow_link();
start();
