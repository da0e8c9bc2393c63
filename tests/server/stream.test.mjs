// The stream protocol from an independent client (npm ws): frames, acknowledgements, settings, errors, and what one
// viewer does to another.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { one_of_three, start, sleep, until } from './program.mjs';
import { Viewer } from './viewer.mjs';

let server;
before(async () => { server = await start({ 'max-streams': 6, 'messages-per-s': 100 }); });
after(() => server.stop());

const cloudscape = 'fair-weather-cumulus';
const hello = { cloudscape, size_px: [96, 64] };

async function with_viewer(use, options) {
  const viewer = await Viewer.open(server, options);
  try {
    return await use(viewer);
  } finally {
    viewer.socket.terminate();
    await viewer.closed;
  }
}

test('a viewer is welcomed and sees pictures of its own size and pose', () => with_viewer(async viewer => {
  viewer.hello({ ...hello, pose: { position_m: [1, 2, 300], azimuth_deg: 77 } });
  const welcome = await viewer.message('welcome');
  assert.deepEqual(welcome.size_px, [96, 64]);
  assert.equal(welcome.pose.azimuth_deg, 77);
  assert.ok(welcome.renderer.length > 0);
  const frame = await viewer.frame();
  assert.deepEqual([frame.width, frame.height], [96, 64]);
  assert.deepEqual(frame.position_m, [1, 2, 300]);
  assert.equal(frame.azimuth_deg, 77);
  assert.equal(frame.image.readUInt16BE(0), 0xffd8);  // a JPEG starts so
  assert.equal(frame.image.readUInt16BE(frame.image.length - 2), 0xffd9);
  assert.deepEqual(Viewer.jpeg_size(frame.image), [96, 64]);
}));

test('the newest pose is shown, and a view at rest costs nothing', () => with_viewer(async viewer => {
  viewer.hello(hello);
  await viewer.frame();
  for (let sequence = 1; sequence <= 20; ++sequence) viewer.camera(sequence, { azimuth_deg: sequence });
  const last = await viewer.frame(frame => frame.pose_sequence === 20n);
  assert.equal(last.azimuth_deg, 20);
  await viewer.frame(frame => frame.quality_stage === 255, 60000);
  viewer.frames.length = 0;
  await sleep(600);
  assert.equal(viewer.frames.length, 0);
  viewer.camera(21, { azimuth_deg: 90 });
  assert.equal((await viewer.frame(frame => frame.pose_sequence === 21n)).azimuth_deg, 90);
}));

test('without acknowledgements at most three frames come', () => with_viewer(async viewer => {
  viewer.acknowledges = false;
  viewer.hello(hello);
  await viewer.frame();
  for (let i = 1; i <= 30; ++i) {
    viewer.camera(i, { azimuth_deg: i });
    await sleep(30);
  }
  assert.ok(viewer.frames_received <= 3, `${viewer.frames_received} frames`);
}));

test('statistics come while frames flow', () => with_viewer(async viewer => {
  viewer.hello(hello);
  const turning = setInterval(() => viewer.camera(++viewer.sequence, { azimuth_deg: viewer.sequence % 360 }), 30);
  const stats = await viewer.message('stats');
  clearInterval(turning);
  assert.ok(stats.frames_per_second > 0 && stats.bits_per_second > 0 && stats.render_ms > 0, JSON.stringify(stats));
}));

test('settings change size, document and sun; bad ones change nothing', () => with_viewer(async viewer => {
  viewer.hello(hello);
  await viewer.frame();
  viewer.send({ type: 'settings', size_px: [64, 48] });
  await viewer.frame(frame => frame.width === 64 && frame.height === 48);
  viewer.send({ type: 'settings', size_px: [64000, 48] });
  const error = await viewer.message('error');
  assert.equal(error.pointer, '/size_px');
  assert.ok(!error.fatal);
  viewer.send({ type: 'settings', cloudscape: { seed: 5, volume: { kind: 'sphere', size_m: [500, 500, 500] } } });
  viewer.camera(1, { azimuth_deg: 5 });
  assert.equal((await viewer.frame(frame => frame.azimuth_deg === 5)).width, 64);
}));

test('one clock for all who look at a document', () => with_viewer(one => with_viewer(other => with_viewer(async stranger => {
  one.hello(hello);
  other.hello(hello);
  stranger.hello({ ...hello, cloudscape: 'overcast' });
  for (const viewer of [one, other, stranger])
    assert.deepEqual(await viewer.message('clock'), { type: 'clock', time_s: 0, rate: 1, paused: true });
  one.send({ type: 'clock', time_s: 1000, rate: 60, paused: false });
  assert.equal((await other.message('clock')).rate, 60);
  const times = viewer => viewer.frames.map(frame => frame.time_s).filter(time_s => time_s > 1000);
  await until(() => times(one).length > 5 && times(other).length > 5, 'frames of a running clock', 60000);
  for (const viewer of [one, other]) {
    const shown = times(viewer);
    assert.ok(shown.every((time_s, i) => i === 0 || time_s > shown[i - 1]), `time goes on: ${shown}`);
  }
  other.send({ type: 'clock', paused: true });
  const { time_s } = await other.message('clock');
  for (const viewer of [one, other])
    assert.equal((await viewer.frame(frame => frame.quality_stage === 255 && frame.time_s >= 1000)).time_s, time_s);
  assert.equal(stranger.messages.filter(({ type }) => type === 'clock').length, 0, 'another document has another clock');
  assert.ok(stranger.frames.every(frame => frame.time_s === 0));
  other.send({ type: 'clock', time_s: 0, rate: 1 });
}))));

test('a time of its own keeps a stream from the clock until it follows again', () => with_viewer(async viewer => {
  viewer.hello({ ...hello, time_s: 77 });
  assert.equal((await viewer.frame()).time_s, 77);
  viewer.send({ type: 'clock', time_s: 500 });
  await viewer.frame(frame => frame.time_s === 500);
  viewer.send({ type: 'camera', pose_sequence: 1, pose: { azimuth_deg: 10 }, time_s: 5 });
  await viewer.frame(frame => frame.time_s === 5);
  viewer.send({ type: 'settings', time_s: null });
  await viewer.frame(frame => frame.time_s === 500);
  viewer.send({ type: 'clock', rate: 5000 });
  const error = await viewer.message('error');
  assert.deepEqual([error.pointer, error.fatal], ['/rate', false]);
  viewer.send({ type: 'clock', time_s: 0 });
  await viewer.frame(frame => frame.time_s === 0);
}));

test('a document that is put anew is seen at once', () => with_viewer(async viewer => {
  const put = document => server.fetch('/api/v1/cloudscapes/watched', {
    method: 'PUT', body: JSON.stringify(document), headers: { 'content-type': 'application/json' } });
  const medium = { volume: { kind: 'sphere', size_m: [500, 500, 500] }, noise: {} };
  assert.equal((await put({ ...medium, seed: 1 })).status, 201);
  viewer.hello({ cloudscape: 'watched', size_px: [64, 48] });
  await viewer.frame(frame => frame.quality_stage === 255, 60000);
  viewer.frames.length = 0;
  assert.equal((await put({ ...medium, seed: 2, sun: { elevation_deg: 5 } })).status, 204);
  await viewer.frame();
  assert.equal((await server.fetch('/api/v1/cloudscapes/watched', { method: 'DELETE' })).status, 204);
}));

// [what, messages after the hello, close code]
const breaches = [
  ['text that is no JSON', ['{'], 1008],
  ['NaN as a number', ['{"type":"camera","pose_sequence":1,"pose":{"azimuth_deg":NaN}}'], 1008],
  ['a binary message', [Buffer.from('{"type":"ack","frame_id":1,"decode_ms":1}')], 1008],
  ['an empty message', [''], 1008],
  ['a second hello', [JSON.stringify({ type: 'hello', ...hello })], 1008],
  ['a message of 64 KiB and one byte', ['x'.repeat(64 * 1024 + 1)], 1009],
  ['a message of 8 MiB', ['x'.repeat(8 << 20)], 1009],
  ['a flood', Array(400).fill('{"type":"ack","frame_id":1,"decode_ms":1}'), 1008],
  ['too many errors', Array(30).fill('{"type":"settings","quality":"best"}'), 1008],
];
for (const [what, messages, code] of breaches) {
  test(`${what} closes with ${code} after an error`, () => with_viewer(async viewer => {
    viewer.hello(hello);
    await viewer.message('welcome');
    for (const message of messages) viewer.socket.send(message);
    assert.equal((await viewer.closed).code, code);
    assert.ok(viewer.messages.some(message => message.type === 'error' && message.fatal), JSON.stringify(viewer.messages));
  }));
}

test('the close arrives however many messages are behind it', async () => {
  for (let i = 0; i < 12; ++i) {
    await with_viewer(async viewer => {
      viewer.hello(hello);
      await viewer.message('welcome');
      for (let n = 0; n < 40; ++n) viewer.socket.send('{"type":"settings","quality":"best"}');
      assert.equal((await viewer.closed).code, 1008);
    });
  }
});

test('numbers that are no poses are answered, and the stream goes on', () => with_viewer(async viewer => {
  viewer.hello(hello);
  await viewer.message('welcome');
  for (const bad of ['1e999', '-1e999', 'null', '"x"', '[1]', '1e300']) {
    viewer.socket.send(`{"type":"camera","pose_sequence":1,"pose":{"azimuth_deg":${bad}}}`);
    assert.match((await viewer.message('error')).pointer ?? '', /azimuth_deg|^$/);
  }
  viewer.camera(9, { azimuth_deg: 9 });
  await viewer.frame(frame => frame.pose_sequence === 9n);
}));

test('the first message must be a hello', () => with_viewer(async viewer => {
  viewer.camera(1, { azimuth_deg: 1 });
  assert.equal((await viewer.closed).code, 1008);
}));

test('one who says nothing is closed after 5 seconds', () => with_viewer(async viewer => {
  const started = Date.now();
  assert.equal((await viewer.closed).code, 1008);
  assert.ok(Math.abs(Date.now() - started - 5000) < 1500, `${Date.now() - started} ms`);
}));

test('text that is not UTF-8 is refused', () => with_viewer(async viewer => {
  viewer.hello(hello);
  await viewer.message('welcome');
  viewer.socket._sender.send(Buffer.from([0x7b, 0xff, 0xfe]), { binary: false, fin: true, opcode: 1, mask: true, rsv1: false }, () => {});
  assert.equal((await viewer.closed).code, 1007);
}));

test('a message in many fragments is one message', () => with_viewer(async viewer => {
  viewer.socket.send('{"type":"hello","clouds', { fin: false });
  viewer.socket.send(`cape":"${cloudscape}",`, { fin: false });
  viewer.socket.send('"size_px":[64,48]}');
  assert.deepEqual((await viewer.message('welcome')).size_px, [64, 48]);
}));

test('no more streams than max_streams', async () => {
  await until(async () => await server.metric('cloudscape_sessions') === 0, 'the sessions of other tests end');
  const viewers = await Promise.all([...Array(6)].map(() => Viewer.open(server)));
  await assert.rejects(Viewer.open(server), /503/);
  for (const viewer of viewers) viewer.socket.terminate();
  await until(async () => await server.metric('cloudscape_sessions') === 0, 'the sessions end');
  await with_viewer(async viewer => viewer.hello(hello));
});

// Not only when nobody flies: then a server that is always busy would keep what every stream before has left.
test('what a stream kept is freed while another one flies', () => with_viewer(async viewer => {
  viewer.hello({ cloudscape, size_px: [64, 36] });
  const turning = setInterval(() => viewer.camera(++viewer.sequence, { azimuth_deg: viewer.sequence % 360 }), 20);
  const [all, largest] = ['cloudscape_history_bytes', 'cloudscape_history_largest_bytes'];
  try {
    const most_per_pixel = 28;  // bytes; less for a moving picture that is kept at a lower resolution
    const one = most_per_pixel * 64 * 36;
    await until(async () => await server.metric('cloudscape_streams_open') === 1 && await server.metric(all) > 0, 'its memory');
    assert.ok(await server.metric(all) <= one);
    await with_viewer(async other => {
      other.hello({ cloudscape, size_px: [640, 360] });
      await until(async () => await server.metric(largest) > 2 * one, 'the memory of the larger stream');
      assert.ok(await server.metric(all) <= one + most_per_pixel * 640 * 360);
    });
    await until(async () => await server.metric(all) <= one, 'the memory of one stream');
  } finally {
    clearInterval(turning);
  }
}));

test('a viewer that reads nothing does not slow another', async () => {
  const rendered = () => server.metric('cloudscape_frames_rendered_total{kind="stream"}');
  const measure = seconds => with_viewer(async viewer => {
    viewer.hello({ cloudscape, size_px: [320, 180] });
    await viewer.frame();
    const before = await rendered();
    viewer.frames_received = 0;
    const ages = [];
    viewer.on_frame = frame => ages.push(Date.now() - viewer.sent_at.get(frame.pose_sequence));
    const turning = setInterval(() => viewer.camera(++viewer.sequence, { azimuth_deg: viewer.sequence % 360 }), 20);
    await sleep(seconds * 1000);
    clearInterval(turning);
    ages.sort((a, b) => a - b);
    return { frames: viewer.frames_received, for_others: await rendered() - before - viewer.frames_received,
      age_ms: ages[Math.floor(ages.length / 2)] };
  });
  await one_of_three(async () => {
    const alone = await measure(2);
    const slow = await Viewer.open(server);
    slow.hello({ cloudscape, size_px: [640, 360] });
    await slow.message('welcome');
    slow.socket.pause();
    const turning = setInterval(() => slow.camera(++slow.sequence, { azimuth_deg: slow.sequence % 360 }), 20);
    let last = -1;  // until it fills its window: then nothing is rendered for it any more
    await until(async () => { const now = await rendered(), full = now === last; last = now; await sleep(500); return full; }, 'the window fills', 30000);
    const beside = await measure(2);
    clearInterval(turning);
    slow.socket.terminate();
    assert.ok(beside.for_others <= 4, `${beside.for_others} frames were rendered for one who does not read`);
    // Not sharper, because other work on the machine changes the time of a frame too.
    assert.ok(beside.frames > 0.4 * alone.frames, `${beside.frames} frames beside, ${alone.frames} alone`);
    assert.ok(beside.age_ms < 2.5 * alone.age_ms + 50, `${beside.age_ms} ms beside, ${alone.age_ms} ms alone`);
  });
});
