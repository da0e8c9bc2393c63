// The page's modules alone, without a browser: protocol, flight, links, sizes, the policy of the decoder, reconnecting.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Clock, time_of_day } from '../../client/web/clock.js';
import { altitude_m, FlightCamera, sum_intents, view_axes } from '../../client/web/camera.js';
import { Connection, wait_ms } from '../../client/web/connection.js';
import { LatestFrame } from '../../client/web/decoder.js';
import { Measures, stage_word } from '../../client/web/hud.js';
import { stick_value } from '../../client/web/input_gamepad.js';
import { frame_header_bytes, hello_message, read_frame, subprotocols } from '../../client/web/protocol.js';
import { reference_body } from '../../client/web/reference.js';
import { css_transform, homography } from '../../client/web/reproject.js';
import { budget_px, stream_size_px } from '../../client/web/stream_size.js';
import { format_fragment, parse_fragment } from '../../client/web/url_state.js';
import { ViewState } from '../../client/web/view_state.js';

const level = { position_m: [0, 0, 1000], azimuth_deg: 0, elevation_deg: 0, roll_deg: 0 };
const close = (actual, expected, tolerance = 1e-9) =>
  assert.ok(Math.abs(actual - expected) <= tolerance, `${actual} is not ${expected} within ${tolerance}`);

function sample_frame() {
  const buffer = new ArrayBuffer(frame_header_bytes + 3);
  const data = new DataView(buffer);
  data.setUint8(0, 1);
  data.setUint8(1, 255);
  data.setUint32(4, 77, true);
  data.setBigUint64(8, 5n, true);
  data.setUint16(16, 640, true);
  data.setUint16(18, 360, true);
  data.setFloat32(20, 50, true);
  [1, -2, 3.5, 10, 20, 30, 40].forEach((value, i) => data.setFloat64(24 + 8 * i, value, true));
  data.setFloat32(80, 12, true);
  data.setFloat32(84, 2, true);
  data.setUint32(88, 3, true);
  new Uint8Array(buffer).set([9, 8, 7], frame_header_bytes);
  return buffer;
}

test('a frame is split into its header and its image', () => {
  const { header, image } = read_frame(sample_frame());
  assert.deepEqual([...image], [9, 8, 7]);
  assert.deepEqual(header, {
    quality_stage: 255, image_type: 'image/jpeg', lens_kind: 'perspective', frame_id: 77, pose_sequence: 5, width_px: 640,
    height_px: 360, vertical_fov_deg: 50, pose: { position_m: [1, -2, 3.5], azimuth_deg: 10, elevation_deg: 20, roll_deg: 30 },
    time_s: 40, render_ms: 12, encode_ms: 2,
  });
});

test('a short, a foreign and a truncated frame are refused in words', () => {
  assert.throws(() => read_frame(new ArrayBuffer(20)), /20 bytes is shorter/);
  const foreign = sample_frame();
  new DataView(foreign).setUint8(0, 2);
  assert.throws(() => read_frame(foreign), /version 2/);
  assert.throws(() => read_frame(sample_frame().slice(0, -1)), /announces 3 bytes of image and carries 2/);
});

test('hello leaves out what was not chosen', () => {
  assert.deepEqual(hello_message({ cloudscape: 'a' }, [64, 32]), { type: 'hello', version: 1, cloudscape: 'a', size_px: [64, 32] });
  const hello = hello_message({ cloudscape: 'a', pose: level, vertical_fov_deg: 30, exposure_ev: 1, tone_curve: 'aces' }, [64, 32]);
  assert.deepEqual(hello.lens, { kind: 'perspective', vertical_fov_deg: 30 });
  assert.deepEqual(hello.display, { dither: true, exposure_ev: 1, tone_curve: 'aces' });
  assert.deepEqual(subprotocols('t'), ['cloudscape.v1', 'bearer.t']);
});

test('the axes of the view are orthonormal and follow the compass', () => {
  const east = view_axes({ azimuth_deg: 90, elevation_deg: 0, roll_deg: 0 });
  east.forward.forEach((value, i) => close(value, [1, 0, 0][i]));
  east.right.forEach((value, i) => close(value, [0, -1, 0][i]));
  view_axes({ azimuth_deg: 0, elevation_deg: 0, roll_deg: 90 }).up.forEach((value, i) => close(value, [1, 0, 0][i]));
  const { forward, right, up } = view_axes({ azimuth_deg: 33, elevation_deg: -41, roll_deg: 17 });
  const cross = [right[1] * forward[2] - right[2] * forward[1], right[2] * forward[0] - right[0] * forward[2], right[0] * forward[1] - right[1] * forward[0]];
  cross.forEach((value, i) => close(value, up[i]));
});

test('flight does not depend on the frame rate and comes to the set speed', () => {
  const fly = (steps, dt_s) => {
    const camera = new FlightCamera(level);
    const intent = sum_intents([{ forward: 1 }, { turn_right: 0 }]);
    for (let i = 0; i < steps; i++) camera.step(dt_s, intent);
    return camera.pose.position_m;
  };
  fly(240, 1 / 240).forEach((value, i) => close(value, fly(15, 1 / 15)[i], 1e-6));
  const way_m = fly(600, 1 / 60)[1] - fly(540, 1 / 60)[1];
  close(way_m, new FlightCamera(level).speed_m_per_s, 1e-3);
});

test('without a wish the camera comes to rest and stays', () => {
  const camera = new FlightCamera(level);
  camera.step(1, sum_intents([{ forward: 1, turn_right: 1 }]));
  let steps = 0;
  while (camera.step(1 / 60, sum_intents([])) && steps < 600) steps++;
  assert.ok(steps > 5 && steps < 200, `rests after ${steps} steps`);
  const rest = structuredClone(camera.pose);
  camera.step(1 / 60, sum_intents([]));
  assert.deepEqual(camera.pose, rest);
});

test('the camera stays above the round ground, looks no further than straight up, and wraps its azimuth', () => {
  const camera = new FlightCamera({ ...level, position_m: [60000, 0, 0] });
  close(altitude_m([60000, 0, 0]), 60000 ** 2 / (2 * 6360e3), 1);
  for (let i = 0; i < 600; i++) camera.step(1, sum_intents([{ up: -1, fast: true }]));
  close(altitude_m(camera.pose.position_m), 2, 0.1);
  camera.look(-30, 500);
  assert.deepEqual([camera.pose.azimuth_deg, camera.pose.elevation_deg], [330, 90]);
});

test('a turned picture is where its directions are now', () => {
  const apply = (m, [x, y]) => {
    const [u, v, w] = m.map(row => row[0] * x + row[1] * y + row[2]);
    return [u / w, v / w];
  };
  // Ten degrees to the right: what was ahead is now ten degrees left. Ten degrees up: it is now below.
  const right = apply(homography(level, { ...level, azimuth_deg: 10 }, 500), [0, 0]);
  close(right[0], -500 * Math.tan(Math.PI / 18));
  close(apply(homography(level, { ...level, elevation_deg: 10 }, 500), [0, 0])[1], 500 * Math.tan(Math.PI / 18));
  // The camera rolls clockwise: the picture turns the other way.
  apply(homography(level, { ...level, roll_deg: 90 }, 500), [0, -100]).forEach((value, i) => close(value, [-100, 0][i]));
  const [one, other] = [{ ...level, azimuth_deg: 12, elevation_deg: 5, roll_deg: 3 }, { ...level, azimuth_deg: 350, elevation_deg: -20 }];
  apply(homography(other, one, 400), apply(homography(one, other, 400), [33, -44])).forEach((value, i) => close(value, [33, -44][i], 1e-6));
  assert.equal(css_transform(homography(one, one, 400)), 'none');
  assert.equal(homography(level, { ...level, azimuth_deg: 90 }, 400), null);
});

test('a link carries the view there and back', () => {
  const chosen = {
    cloudscape: 'a b', pose: { position_m: [1.5, -200, 1e4], azimuth_deg: 359.25, elevation_deg: -3, roll_deg: 2 },
    vertical_fov_deg: 40, sun_azimuth_deg: 10, sun_elevation_deg: -2.5, exposure_ev: 1.3, tone_curve: 'aces', quality: 'high', time_s: 60,
  };
  assert.deepEqual(parse_fragment(`#${format_fragment(chosen)}`), { chosen, token: undefined });
  assert.equal(format_fragment({ cloudscape: 'x' }), 'cloudscape=x');
});

test('nonsense in a link is left out, the token is found', () => {
  const { chosen, token } = parse_fragment('#token=s3&position=1,2&exposure_ev=NaN&elevation_deg=5&quality=best&sun_elevation_deg=99&time_s=1e9');
  assert.deepEqual([chosen, token], [{}, 's3']);
});

test('the stream has the window\'s pixels within budget and limits, on even sides', () => {
  const size = (width_css, height_css, device_pixel_ratio, budget, max_size_px = [3840, 2160]) =>
    stream_size_px({ width_css, height_css, device_pixel_ratio, budget, max_size_px });
  assert.deepEqual(size(640, 360, 1, budget_px('automatic', true)), [640, 360]);
  assert.deepEqual(size(641, 361, 2, budget_px('full', true)), [1282, 722]);
  const [width, height] = size(1920, 1080, 2, budget_px('automatic', true));
  assert.deepEqual([width, height], [960, 540]);
  const [tall_width, tall_height] = size(390, 844, 3, budget_px(undefined, true));
  assert.ok(tall_width * tall_height <= 960 * 540 && tall_width % 2 === 0 && tall_height % 2 === 0);
  close(tall_width / tall_height, 390 / 844, 0.01);
  assert.deepEqual(size(5000, 1000, 1, Infinity, [2000, 2000]), [2000, 400]);
});

test('one frame decodes at a time, the newest waits, the others are skipped', async () => {
  const [finish, shown, skipped] = [[], [], []];
  const frames = new LatestFrame({
    decode: frame => new Promise((resolve, reject) => finish.push({ frame, resolve, reject })),
    show: (image, frame) => shown.push(frame), skip: frame => skipped.push(frame), now: () => 0,
  });
  [1, 2, 3].forEach(frame => frames.submit(frame));
  assert.deepEqual([finish.map(({ frame }) => frame), skipped], [[1], [2]]);
  finish[0].resolve({});
  await new Promise(setImmediate);
  assert.deepEqual([finish[1].frame, shown], [3, [1]]);
  finish[1].reject(new Error('broken'));
  await new Promise(setImmediate);
  assert.deepEqual([shown, skipped], [[1], [2, 3]]);
});

test('a frame of a stream that is gone is closed, not shown', async () => {
  let closed = 0, resolve_decode;
  const frames = new LatestFrame({
    decode: () => new Promise(resolve => { resolve_decode = resolve; }), show: () => assert.fail('shown'), skip: () => assert.fail('skipped'),
  });
  frames.submit(1);
  frames.reset();
  resolve_decode({ close: () => closed++ });
  await new Promise(setImmediate);
  assert.equal(closed, 1);
});

class FakeSocket {
  static all = [];
  readyState = 0;
  sent = [];
  constructor(url, protocols) {
    Object.assign(this, { url, protocols });
    FakeSocket.all.push(this);
  }
  send(text) { this.sent.push(JSON.parse(text)); }
  close() { this.readyState = 3; }
  accept() { this.readyState = 1; this.onopen(); this.onmessage({ data: '{"type":"welcome"}' }); }
}
function connection(diagnosis) {
  FakeSocket.all = [];
  const states = [];
  const made = new Connection({
    url: 'ws://x/', token: () => '', hello: () => ({ type: 'hello', view: 'kept' }), diagnose: async () => diagnosis,
    on_state: (name, detail) => states.push({ name, ...detail }), on_message() {}, on_frame() {}, WebSocketClass: FakeSocket,
  });
  return { made, states };
}

test('a lost connection comes back by itself and says hello again', t => {
  t.mock.timers.enable({ apis: ['setTimeout'] });
  const { made, states } = connection();
  made.open();
  FakeSocket.all[0].accept();
  FakeSocket.all[0].onclose({ code: 1006, reason: '' });
  assert.equal(states.at(-1).name, 'waiting');
  t.mock.timers.tick(600);
  FakeSocket.all[1].accept();
  assert.deepEqual(FakeSocket.all[1].sent, [{ type: 'hello', view: 'kept' }]);
  assert.equal(states.at(-1).name, 'live');
});

test('a refusal is final and keeps the server\'s sentence', async () => {
  const { made, states } = connection({ kind: 'token', message: 'A token is needed.', retry: false });
  made.open();
  await FakeSocket.all[0].onclose({ code: 1006, reason: '' });
  assert.deepEqual(states.at(-1), { name: 'refused', kind: 'token', message: 'A token is needed.' });
  made.open();
  FakeSocket.all[1].readyState = 1;
  FakeSocket.all[1].onopen();
  FakeSocket.all[1].onmessage({ data: '{"type":"error","message":"There is no x.","pointer":"","fatal":false}' });
  assert.deepEqual(states.at(-1), { name: 'refused', kind: 'protocol', message: 'There is no x.' });
  assert.equal(FakeSocket.all.length, 2);
});

test('a frame that cannot be read ends the stream in words', () => {
  const { made, states } = connection();
  made.on_frame = read_frame;
  made.open();
  FakeSocket.all[0].accept();
  FakeSocket.all[0].onmessage({ data: new ArrayBuffer(3) });
  assert.equal(states.at(-1).name, 'refused');
  assert.match(states.at(-1).message, /3 bytes is shorter/);
});

test('a hidden page rests and wakes; one that was refused stays refused', () => {
  const { made, states } = connection();
  made.open();
  FakeSocket.all[0].accept();
  made.rest();
  assert.equal(states.at(-1).name, 'closed');
  assert.equal(made.wake(), true);
  assert.equal(FakeSocket.all.length, 2);
  made.close();
  made.rest();
  assert.equal(made.wake(), false);
});

test('waits grow, are spread, and end at a quarter of a minute', () => {
  assert.deepEqual([0, 1, 2, 20].map(attempt => wait_ms(attempt, () => 1)), [500, 1000, 2000, 15000]);
  assert.equal(wait_ms(3, () => 0), 2000);
});

test('choices stand over the document, exposure and tone curve travel together', () => {
  const state = new ViewState();
  state.open('a');
  state.welcome({ lens: { vertical_fov_deg: 60 }, display: { exposure_ev: 2, tone_curve: 'aces' }, sun_azimuth_deg: 10, sun_elevation_deg: 3 });
  assert.deepEqual([state.get('vertical_fov_deg'), state.get('exposure_ev'), state.chosen], [60, 2, { cloudscape: 'a' }]);
  assert.deepEqual(state.choose({ exposure_ev: -1 }), { display: { dither: true, exposure_ev: -1, tone_curve: 'aces' } });
  assert.deepEqual(state.choose({ sun_azimuth_deg: 5 }), { sun_azimuth_deg: 5 });
});

test('a clock runs on from what it was told', () => {
  let now_ms = 1000;
  const clock = new Clock(() => now_ms);
  assert.deepEqual([clock.time_s, clock.paused], [0, true]);
  clock.tell({ time_s: 100, rate: 10, paused: false });
  now_ms += 2000;
  assert.equal(clock.time_s, 120);
  clock.tell({ rate: 60 });
  now_ms += 1000;
  assert.equal(clock.time_s, 180, 'another rate is no jump');
  clock.tell({ paused: true });
  now_ms += 9000;
  assert.deepEqual([clock.time_s, clock.rate], [180, 60]);
  assert.equal(time_of_day('2026-06-21T23:30:00Z', 60, 90), '01:00 UTC');
});

test('latency counts a pose\'s first frame once', () => {
  const measures = new Measures();
  measures.sent(1, 0);
  measures.sent(2, 50);
  measures.received(1000, 90);
  measures.shown({ pose_sequence: 2 }, 100);
  measures.shown({ pose_sequence: 2 }, 900);
  const { latency_ms, bits_per_second, frames_per_second } = measures.figures(1000);
  assert.deepEqual([latency_ms, bits_per_second, frames_per_second], [50, 4000, 1.25]);
  assert.equal(measures.figures(9000).rests, true);
  assert.deepEqual([0, 2, 255].map(stage_word), ['moving', 'refining 2', 'finished']);
});

test('a stick at rest does nothing, at its end everything', () => {
  assert.deepEqual([0.1, -0.1, 1, -1].map(value => stick_value(value) + 0), [0, 0, 1, -1]);
});

test('a reference is ordered from the same choices as a still', () => {
  const state = { chosen: { cloudscape: 'a', pose: { position_m: [1, 2, 3], azimuth_deg: 4, elevation_deg: 5, roll_deg: 0 },
    vertical_fov_deg: 40, sun_azimuth_deg: 100, time_s: 7 } };
  assert.deepEqual(reference_body(state, { format: 'exr', samples: 16, width: 8, height: 4 }), {
    cloudscape: 'a',
    camera: { position_m: [1, 2, 3], azimuth_deg: 4, elevation_deg: 5, roll_deg: 0, lens: { vertical_fov_deg: 40 } },
    image: { width: 8, height: 4, quality: 'reference', samples: 16, format: 'exr', time_s: 7 },
    sun: { azimuth_deg: 100 },
  });
});
