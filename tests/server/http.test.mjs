// Stills, documents and status over HTTP, held to the OpenAPI document that the server gives of itself.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import Ajv from 'ajv/dist/2020.js';

import { start, until } from './program.mjs';
import { exchange, request, statuses } from './raw.mjs';

let server, openapi, ajv;
before(async () => {
  server = await start({ 'still-queue': 6, 'allowed-origins': 'https://friend.test', 'max-body-kib': 64 });
  openapi = await server.json('/api/v1/openapi.json');
  ajv = new Ajv({ strict: false, validateFormats: false });
  ajv.addSchema({ $id: 'openapi', ...openapi });
});
after(() => server.stop());

const cloudscape = 'fair-weather-cumulus';
const small = `cloudscape=${cloudscape}&width=32&height=24&quality=draft`;
const stills = (query = small) => `/api/v1/stills?${query}`;
const json = { 'content-type': 'application/json' };
const post = body => ({ method: 'POST', headers: json, body: JSON.stringify(body) });

// Fetches, and fails where the OpenAPI document does not describe the answer.
async function described(path, options = {}) {
  const response = await server.fetch(path, options);
  const bytes = Buffer.from(await response.arrayBuffer());
  const pattern = path.split('?')[0].replace(/^(\/api\/v1\/cloudscapes\/).+/, '$1{name}');
  const operation = openapi.paths[pattern]?.[(options.method ?? 'GET').toLowerCase()];
  assert.ok(operation, `${options.method ?? 'GET'} ${pattern} is not described`);
  const answer = operation.responses[response.status];
  assert.ok(answer, `${response.status} of ${path} is not described: ${bytes.subarray(0, 300)}`);
  const type = response.headers.get('content-type')?.split(';')[0];
  if (answer.content && options.method !== 'HEAD') {
    assert.ok(answer.content[type], `${type} of ${path} with ${response.status} is not described`);
    if (type.endsWith('json')) check(answer.content[type].schema, JSON.parse(bytes));
  }
  return { status: response.status, headers: response.headers, bytes, type, json: () => JSON.parse(bytes) };
}
function check(schema, value) {
  const validate = ajv.compile(schema.$ref ? { $ref: `openapi${schema.$ref}` } : schema);
  assert.ok(validate(value), JSON.stringify(validate.errors));
}

test('status, readiness and metrics', async () => {
  assert.equal((await described('/healthz')).status, 200);
  const ready = (await described('/readyz')).json();
  assert.ok(ready.ready && ready.renderer.length > 0 && /^\d+\.\d+/.test(ready.version), JSON.stringify(ready));
  const metrics = (await described('/metrics')).bytes.toString();
  assert.match(metrics, /^cloudscape_http_requests_total\{route="\/readyz",status="2xx"\} \d+$/m);
});

test('the page is there, whole, and revalidates', async () => {
  const page = await server.fetch('/');
  assert.equal(page.status, 200);
  assert.match(page.headers.get('content-type'), /^text\/html/);
  assert.match(page.headers.get('content-security-policy'), /default-src 'none'/);
  assert.match(await page.text(), /<!doctype html>/i);
  const etag = page.headers.get('etag');
  assert.match(etag, /^"[0-9a-f]{32}"$/);
  const again = await server.fetch('/index.html', { headers: { 'if-none-match': etag } });
  assert.equal(again.status, 304);
});

test('stills that have names are listed and rendered', async () => {
  const list = (await described('/api/v1/stills/named')).json().stills;
  assert.ok(list.some(still => still.name === 'fog-bow' && still.title && still.description), JSON.stringify(list));
  for (const { name } of list) {
    const shown = await server.fetch(`/pictures/${name}.jpg`);
    assert.equal(shown.status, 200, name);
    assert.equal(shown.headers.get('content-type'), 'image/jpeg');
  }
  const { view } = list.find(still => still.name === 'above-the-deck');
  assert.equal((await described(`/api/v1/stills?${view}&width=32&height=24&quality=draft`)).status, 200, view);
  const picture = await described('/api/v1/stills?still=fog-bow&width=32&height=24&quality=draft&samples=1&cloudscape=' + cloudscape);
  assert.equal(picture.status, 200);
  const unknown = await described('/api/v1/stills?still=fog-bwo');
  assert.equal(unknown.status, 404);
  assert.match(unknown.json().detail, /did you mean fog-bow/);
});

test('each format arrives as what it says', async () => {
  const starts = { jpeg: ['image/jpeg', 'ffd8ff'], png: ['image/png', '89504e47'], exr: ['image/x-exr', '762f3101'] };
  for (const [format, [type, magic]] of Object.entries(starts)) {
    const still = await described(stills(`${small}&format=${format}`));
    assert.equal(still.status, 200);
    assert.equal(still.type, type);
    assert.equal(still.bytes.subarray(0, magic.length / 2).toString('hex'), magic);
    assert.equal(Number(still.headers.get('content-length')), still.bytes.length);
  }
});

test('the same request is the same picture, from GET, POST and the cache', async () => {
  const query = `${small}&azimuth_deg=11`;
  const first = await described(stills(query));
  const hits = await server.metric('cloudscape_still_cache_hits_total');
  const second = await described(stills(query));
  assert.equal(await server.metric('cloudscape_still_cache_hits_total'), hits + 1);
  const posted = await described('/api/v1/stills', post({
    cloudscape, camera: { azimuth_deg: 11 }, image: { width: 32, height: 24, quality: 'draft' } }));
  assert.deepEqual(second.bytes, first.bytes);
  assert.deepEqual(posted.bytes, first.bytes);
  assert.equal(posted.headers.get('etag'), first.headers.get('etag'));
});

test('HEAD tells the length of the picture, without it', async () => {
  const query = `${small}&azimuth_deg=12`;
  const head = await described(stills(query), { method: 'HEAD' });
  assert.equal(head.bytes.length, 0);
  const still = await described(stills(query));
  assert.equal(head.headers.get('content-length'), String(still.bytes.length));
  assert.equal(head.headers.get('etag'), still.headers.get('etag'));
});

test('304 comes without rendering', async () => {
  const etag = (await described(stills())).headers.get('etag');
  const fresh = await described(stills(), { headers: { 'if-none-match': `"x", W/${etag}` } });
  assert.equal(fresh.status, 304);
  assert.equal(fresh.bytes.length, 0);
  const started = Date.now();
  const never_rendered = stills(`cloudscape=${cloudscape}&width=1920&height=1080&quality=reference&samples=4`);
  assert.equal((await described(never_rendered, { headers: { 'if-none-match': '*' } })).status, 304);
  assert.ok(Date.now() - started < 1000);
});

test('refusals name the value', async () => {
  const refused = async (query, status, pointer) => {
    const answer = await described(stills(query));
    assert.equal(answer.status, status, query);
    assert.equal(answer.type, 'application/problem+json');
    if (pointer) assert.equal(answer.json().pointer, pointer);
    return answer;
  };
  await refused('', 400, '/cloudscape');
  await refused(`${small}&width=0`, 400);
  await refused(`cloudscape=${cloudscape}&width=0`, 400, '/width');
  await refused(`cloudscape=${cloudscape}&elevation_deg=91`, 400, '/elevation_deg');
  await refused('cloudscape=nowhere', 404);
  const over = await refused(`cloudscape=${cloudscape}&width=4096&height=4096`, 422);
  assert.match(over.json().detail, /megapixels/);
  assert.equal((await described('/api/v1/stills', post({ cloudscape, camera: { azimut_deg: 1 } }))).json().pointer, '/camera/azimut_deg');
  assert.equal((await described('/api/v1/stills', { ...post({}), headers: { 'content-type': 'text/plain' } })).status, 415);
  assert.equal((await described('/api/v1/stills', post({ cloudscape: 'x'.repeat(70000) }))).status, 413);
  const wrong = await server.fetch('/api/v1/stills', { method: 'DELETE' });
  assert.equal(wrong.status, 405);
  assert.equal(wrong.headers.get('allow'), 'GET, HEAD, POST, OPTIONS');
});

test('one client waits for four stills at most, and the queue has an end', async () => {
  const slow = i => stills(`cloudscape=${cloudscape}&width=640&height=360&samples=64&azimuth_deg=${i}`);
  const stop = new AbortController();
  const waiting = [...Array(4)].map((_, i) => server.fetch(slow(i), { signal: stop.signal }).catch(() => null));
  await until(async () => await server.metric('cloudscape_stills_waiting') === 4, 'four stills wait');
  const fifth = await described(slow(5));
  assert.equal(fifth.status, 429);
  assert.ok(Number(fifth.headers.get('retry-after')) > 0);
  // Other loopback addresses are other clients.
  const from = (address, i) => exchange(server.port, [request(`GET ${slow(i)} HTTP/1.1`)], { timeout_ms: 3000, local: address });
  const others = [from('127.0.0.2', 6), from('127.0.0.2', 7)];
  await until(async () => await server.metric('cloudscape_stills_waiting') === 6, 'six stills wait');
  const full = await exchange(server.port, [request(`GET ${slow(8)} HTTP/1.1`)], { local: '127.0.0.3', until: text => statuses(text).length });
  assert.deepEqual(statuses(full.text), [503]);
  assert.match(full.text, /^retry-after: \d+/m);
  await Promise.all(others);
  stop.abort();
  await Promise.all(waiting);
  // Everybody has left: their renders are cancelled, and the next is served at once.
  await until(async () => await server.metric('cloudscape_stills_waiting') === 0, 'the renders are cancelled', 5000);
  assert.equal((await described(stills(`${small}&azimuth_deg=13`))).status, 200);
});

test('documents are listed, put, read, rendered and removed', async () => {
  const list = (await described('/api/v1/cloudscapes')).json().cloudscapes;
  assert.ok(list.some(entry => entry.name === cloudscape && entry.preset));
  const put = (name, body) => described(`/api/v1/cloudscapes/${name}`, { method: 'PUT', headers: json, body });
  const text = '{\n  // a ball\n  "volume": {"kind": "sphere"}\n}';
  assert.equal((await put('ball', text)).status, 201);
  assert.equal((await put('ball', text)).status, 204);
  assert.equal((await described('/api/v1/cloudscapes/ball')).json().volume.kind, 'sphere');
  assert.equal((await described('/api/v1/cloudscapes/ball?as=written')).bytes.toString(), text);
  assert.equal((await described('/api/v1/cloudscapes/ball?as=spoken')).status, 400);
  assert.equal((await described(stills('cloudscape=ball&width=32&height=24&quality=draft'))).status, 200);
  const bad = await put('ball', '{"medium": {"single_scattering_albedo": 1.2}}');
  assert.equal(bad.status, 400);
  assert.equal(bad.json().pointer, '/medium/single_scattering_albedo');
  assert.equal((await put(cloudscape, text)).status, 403);
  assert.equal((await described('/api/v1/cloudscapes/ball', { method: 'DELETE' })).status, 204);
  assert.equal((await described('/api/v1/cloudscapes/ball')).status, 404);
  assert.equal((await described('/api/v1/cloudscapes/ball', { method: 'DELETE' })).status, 404);
});

test('the document of each preset fits the published schema', async () => {
  const validate = new Ajv({ strict: false, validateFormats: false }).compile((await described('/api/v1/schema/cloudscape.json')).json());
  for (const { name } of (await server.json('/api/v1/cloudscapes')).cloudscapes)
    assert.ok(validate(await server.json(`/api/v1/cloudscapes/${name}`)), `${name}: ${JSON.stringify(validate.errors)}`);
});

test('a cloudscape whose textures are too large is refused before it is baked', async () => {
  const large = format => ({ volume: { resolution: 512, format } });
  const still = await described('/api/v1/stills', post({ cloudscape: large('rgba8'), image: { width: 32, height: 24 } }));
  assert.equal(still.status, 422);
  assert.equal(still.json().pointer, '/cloudscape/volume/resolution');
  assert.match(still.json().detail, /max_bake_mib/);
  const put = await described('/api/v1/cloudscapes/large', { method: 'PUT', headers: json, body: JSON.stringify(large('r16f')) });
  assert.equal(put.status, 422);
  assert.equal(put.json().pointer, '/volume/resolution');
  assert.equal((await described('/api/v1/cloudscapes/large')).status, 404);
});

test('only listed origins get CORS headers, and only they may change things', async () => {
  const preflight = origin => server.fetch('/api/v1/stills', {
    method: 'OPTIONS', headers: { origin, 'access-control-request-method': 'POST' } });
  const friend = await preflight('https://friend.test'), foe = await preflight('https://foe.test');
  assert.equal(friend.headers.get('access-control-allow-origin'), 'https://friend.test');
  assert.match(friend.headers.get('access-control-allow-methods'), /POST/);
  assert.equal(foe.headers.get('access-control-allow-origin'), null);
  const change = origin => server.fetch('/api/v1/cloudscapes/theirs', { method: 'PUT', headers: { ...json, origin }, body: '{}' });
  assert.equal((await change('https://foe.test')).status, 403);
  assert.equal((await change('https://friend.test')).status, 201);
});

test('height maps: only bare names, and one that cannot be used is told', async () => {
  const land = height_map => ({ cloudscape: { ground: { kind: 'terrain', terrain: { resolution: 64, height_map } } },
    image: { width: 16, height: 16, quality: 'draft' } });
  for (const name of ['../secret.png', '/etc/passwd.png', 'passwd']) {
    const refused = await described(stills(''), post(land(name)));
    assert.equal(refused.status, 400, name);
    assert.equal(refused.json().pointer, '/cloudscape/ground/terrain/height_map');
  }
  const missing = await described(stills(''), post(land('none.png')));
  assert.equal(missing.status, 422);
  assert.match(missing.json().detail, /'none\.png'.*--height-map-dir/);
  assert.equal((await described(stills())).status, 200, 'and the server goes on');
});
