// Slow and greedy clients, shutdown, and the other mitigations of libwebsockets 4.1.6's measured faults.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { connect } from 'node:net';
import { join } from 'node:path';
import { test } from 'node:test';

import { start, sleep, until } from './program.mjs';
import { exchange, request, statuses, upgrade } from './raw.mjs';
import { Viewer } from './viewer.mjs';

const cloudscape = 'fair-weather-cumulus';

async function with_server(settings, options, use) {
  const server = await start(settings, options);
  try {
    await use(server);
  } finally {
    await server.stop();
  }
}

test('slow clients', () => with_server({ 'header-timeout-s': 2, 'body-timeout-s': 2, 'idle-ping-s': 1, 'idle-hangup-s': 3 }, {}, async server => {
  const head = request('PUT /api/v1/cloudscapes/drip HTTP/1.1', { 'Content-Length': 1000 });
  const drip = [...Array(40)].flatMap(() => [500, ' ']);
  const [silent, dripped_header, dripped_body, stalled_body, idle, lifeless] = await Promise.all([
    exchange(server.port, [], { timeout_ms: 9000 }),
    exchange(server.port, ['GET /healthz HTTP/1.1\r\nHost: localhost\r\nX-Drip: ', ...drip], { timeout_ms: 9000 }),
    exchange(server.port, [head, ...drip], { timeout_ms: 9000 }),
    exchange(server.port, [head], { timeout_ms: 9000 }),
    exchange(server.port, [request('GET /healthz HTTP/1.1')], { timeout_ms: 25000 }),
    exchange(server.port, [upgrade(), Buffer.from('')], { timeout_ms: 9000 }),  // never answers a ping
    (async () => {
      for (let i = 0; i < 20; ++i) {
        const started = Date.now();
        assert.equal((await server.fetch('/healthz')).status, 200);
        assert.ok(Date.now() - started < 1900, 'others had to wait');  // the silent one stays for 2 s
        await sleep(100);
      }
    })(),
  ]);
  assert.ok(silent.closed && silent.after_ms < 8000, `a silent connection stayed for ${silent.after_ms} ms`);
  assert.ok(dripped_header.closed && dripped_header.after_ms < 5000, `a dripped header: ${dripped_header.after_ms} ms`);
  for (const body of [dripped_body, stalled_body]) {
    assert.deepEqual(statuses(body.text), [408]);
    assert.ok(body.closed && body.after_ms < 7000, `a slow body: ${body.after_ms} ms`);
  }
  assert.ok(idle.closed, 'an idle connection was kept for ever');
  assert.ok(lifeless.closed && lifeless.after_ms < 8000, `a lifeless viewer stayed for ${lifeless.after_ms} ms`);
}));

test('a living viewer that is at rest stays', () => with_server({ 'idle-ping-s': 1, 'idle-hangup-s': 2 }, {}, async server => {
  const viewer = await Viewer.open(server);
  viewer.hello({ cloudscape, size_px: [64, 48] });
  let pings = 0;
  viewer.socket.on('ping', () => ++pings);
  await sleep(5000);
  assert.equal(viewer.socket.readyState, 1);
  assert.ok(pings >= 2, `${pings} pings`);
  viewer.socket.terminate();
}));

test('a still that takes too long is 503, and its render ends', () => with_server({ 'still-timeout-s': 0.5 }, {}, async server => {
  const response = await server.fetch(`/api/v1/stills?cloudscape=${cloudscape}&width=1920&height=1080&samples=64`);
  assert.equal(response.status, 503);
  assert.ok(response.headers.get('retry-after'));
  assert.match((await response.json()).detail, /still_timeout_s/);
  await until(async () => await server.metric('cloudscape_stills_waiting') === 0, 'the render ends', 5000);
}));

// The processor time of the process, or of one thread of it, s.
function processor_s(server, thread) {
  const folder = `/proc/${server.child.pid}${thread ? `/task/${thread}` : ''}`;
  const fields = readFileSync(`${folder}/stat`, 'latin1').split(') ')[1].split(' ');
  return (Number(fields[11]) + Number(fields[12])) / 100;
}

test('more clients than descriptors neither stop nor heat the server', () => with_server({ 'max-connections': 1000 }, { open_files: 160 }, async server => {
  const sockets = [...Array(400)].map(() => connect({ port: server.port, host: '127.0.0.1' }).on('error', () => {}));
  await sleep(1000);
  const before = processor_s(server);
  await sleep(1000);
  const used = processor_s(server) - before;
  assert.ok(used < 0.2, `${used} s of processor time in a second`);
  assert.ok(!server.log.includes('errno 24'), 'it ran out of descriptors');
  for (const socket of sockets) socket.destroy();
  await until(() => server.fetch('/healthz').then(answer => answer.status === 200, () => false), 'the server recovers');
  assert.ok(await server.metric('cloudscape_refused_total{reason="connections"}') > 0);
  assert.ok(server.log.length < 20000, 'the log is flooded');
}));

test('no more connections than max_connections', () => with_server({ 'max-connections': 10 }, {}, async server => {
  const sockets = [...Array(10)].map(() => connect({ port: server.port, host: '127.0.0.1' }).on('error', () => {}));
  await sleep(1000);
  await assert.rejects(server.fetch('/healthz'));
  sockets[0].destroy();
  await until(() => server.fetch('/healthz').then(answer => answer.status === 200, () => false), 'a place is free again');
  for (const socket of sockets) socket.destroy();
}));

test('bytes behind a request for a still are answered after it', () => with_server({}, {}, async server => {
  const still = request(`GET /api/v1/stills?cloudscape=${cloudscape}&width=64&height=48&quality=draft HTTP/1.1`);
  const health = request('GET /healthz HTTP/1.1', { Connection: 'close' });
  const { text } = await exchange(server.port, [still + health], { timeout_ms: 20000 });
  assert.deepEqual(statuses(text), [200, 200]);
}));

test('bytes behind a request for a still cost nothing while it waits', () => with_server({}, {}, async server => {
  const still = request(`GET /api/v1/stills?cloudscape=${cloudscape}&width=640&height=360&samples=64 HTTP/1.1`);
  const health = request('GET /healthz HTTP/1.1');
  for (const parts of [[still + health], [still, 100, health]]) {
    const waiting = exchange(server.port, parts, { timeout_ms: 2500 });
    await sleep(500);
    assert.ok(await server.metric('cloudscape_stills_waiting') > 0, 'the still was done too soon to measure');
    const before = processor_s(server, server.child.pid);  // the network thread is the first
    await sleep(1000);
    const used = processor_s(server, server.child.pid) - before;
    assert.ok(used < 0.05, `${used} s of processor time in a second`);
    await waiting;
  }
}));

test('SIGTERM: viewers get 1001, stills finish, readiness ends first', () => with_server({}, {}, async server => {
  const viewers = await Promise.all([...Array(3)].map(() => Viewer.open(server)));
  for (const viewer of viewers) viewer.hello({ cloudscape, size_px: [64, 48] });
  await Promise.all(viewers.map(viewer => viewer.frame()));
  const still = server.fetch(`/api/v1/stills?cloudscape=${cloudscape}&width=640&height=360&samples=8&azimuth_deg=3`);
  await until(async () => await server.metric('cloudscape_stills_waiting') > 0, 'the still waits');
  const lingering = connect({ port: server.port, host: '127.0.0.1' });
  server.signal('SIGTERM');
  assert.deepEqual(await Promise.all(viewers.map(async viewer => (await viewer.closed).code)), [1001, 1001, 1001]);
  const readiness = await server.fetch('/readyz').catch(() => null);  // unless the still was done already
  if (readiness) assert.equal(readiness.status, 503);
  assert.equal((await still).status, 200);
  assert.deepEqual(await server.exit, { code: 0, signal: null });
  lingering.destroy();
}));

test('SIGTERM ends within drain_s though a viewer does not read', () => with_server({ 'drain-s': 2 }, {}, async server => {
  const viewer = await Viewer.open(server);
  viewer.hello({ cloudscape, size_px: [640, 360] });
  await viewer.message('welcome');
  viewer.socket.pause();
  await sleep(500);
  const started = Date.now();
  server.signal('SIGINT');
  assert.equal((await server.exit).code, 0);
  assert.ok(Date.now() - started < 6000, `${Date.now() - started} ms`);
  viewer.socket.terminate();
}));

test('a token is asked for, and taken in all its forms', async () => {
  const token = 'a-token-of-this-test-0123';
  await with_server({}, { environment: { CLOUDSCAPE_TOKEN: token } }, async server => {
    const status = async (path, headers = {}) => (await server.fetch(path, { headers })).status;
    for (const open of ['/', '/healthz', '/readyz']) assert.equal(await status(open), 200, open);
    for (const closed of ['/metrics', '/api/v1/cloudscapes', '/api/v1/openapi.json']) {
      assert.equal(await status(closed), 401, closed);
      assert.equal(await status(closed, { authorization: `Bearer ${token}` }), 200, closed);
      assert.equal(await status(closed, { authorization: `Bearer ${token.replace('3', '4')}` }), 401, closed);
    }
    await assert.rejects(Viewer.open(server), /401/);
    await assert.rejects(Viewer.open(server, { subprotocols: ['cloudscape.v1', 'bearer.wrong-token-of-this-test'] }), /401/);
    const viewer = await Viewer.open(server, { subprotocols: ['cloudscape.v1', `bearer.${token}`] });
    assert.equal(viewer.socket.protocol, 'cloudscape.v1');
    viewer.socket.terminate();
    (await Viewer.open(server, { headers: { authorization: `Bearer ${token}` } })).socket.terminate();
    assert.ok(!server.log.includes(token), 'the token is in the log');
  });
});

test('beyond loopback a token is made and stands in the ready link', () => with_server({ listen: '0.0.0.0:0' }, {}, async server => {
  assert.match(server.token, /^[0-9a-f]{32}$/);
  assert.equal((await server.fetch('/metrics')).status, 401);
  assert.equal((await server.fetch('/metrics', { headers: { authorization: `Bearer ${server.token}` } })).status, 200);
}));

test('what cannot be listened on or read is one sentence', async () => {
  const failure = async settings => {
    const error = await start(settings).then(server => server.stop().then(() => null), reason => reason);
    assert.ok(error, 'the server started');
    const lines = error.message.trim().split('\n').slice(1).filter(line => !/ (info|debug) /.test(line));
    assert.equal(lines.length, 1, error.message);
    return lines[0];
  };
  await with_server({}, {}, async server => {
    assert.match(await failure({ listen: `127.0.0.1:${server.port}` }), /Another program listens on 127\.0\.0\.1:\d+ already/);
    const token_file = join(server.folder, 'token');
    writeFileSync(token_file, 'short\n', { mode: 0o600 });
    assert.match(await failure({ 'token-file': token_file }), /16 to 96/);
  });
  assert.match(await failure({ 'token-file': '/nonexistent' }), /cannot be read/);
  assert.match(await failure({ listen: '127.0.0.1' }), /must be HOST:PORT/);
});
