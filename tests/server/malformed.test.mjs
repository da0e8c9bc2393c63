// Malformed and hostile requests on raw sockets: each gets its answer or a closed connection, and the server lives on.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { start } from './program.mjs';
import { exchange, has_whole_answer, request, statuses, upgrade } from './raw.mjs';

let server;
before(async () => { server = await start({ 'max-body-kib': 64, 'header-timeout-s': 2 }); });
after(() => server.stop());

const get = (path, headers) => request(`GET ${path} HTTP/1.1`, headers);
const still = '/api/v1/stills';
const post = (headers, body = '{}') => request(`POST ${still} HTTP/1.1`, headers, body);
const json = { 'Content-Type': 'application/json' };
const long = 'a'.repeat(5000);

// [what, bytes, the statuses of the answers; `closed` where the connection just ends]
const closed = [];
const cases = [
  ['a path that climbs out', get('/../../etc/passwd'), [404]],
  ['an encoded climb', get('/%2e%2e/%2e%2e/etc/passwd'), [404]],
  ['a climb with an encoded slash', get('/..%2f..%2fetc/passwd'), [404]],
  ['a twice encoded climb', get('/%252e%252e/etc/passwd'), [404]],
  ['a climb with backslashes', get('/..\\..\\etc\\passwd'), [404]],
  ['a climb inside a name', get('/api/v1/cloudscapes/..%2f..%2fserver'), [404]],
  ['two slashes', get('//etc/passwd'), [404]],
  ['a zero byte in front', get('/%00index.html'), [400]],
  ['a zero byte in the path', get('/index.html%00.txt'), closed],
  ['a zero byte in the query', get(`${still}?cloudscape=overcast%00x`), closed],
  ['a bad escape', get('/%zz'), [403]],
  ['a cut escape', get('/%4'), [403]],
  ['bytes that are not UTF-8 in the path', get('/api/v1/cloudscapes/%ff%fe'), [404]],
  ['bytes that are not UTF-8 in the query', get(`${still}?cloudscape=%ff%fe`), [404]],
  ['markup in a name', get(`${still}?cloudscape=<script>alert(1)</script>`), [404]],
  ['an unknown parameter', get(`${still}?cloudscape=overcast&colour=1`), [400]],
  ['a repeated parameter', get(`${still}?cloudscape=overcast&width=1&width=2`), [400]],
  ['a number that is none', get(`${still}?cloudscape=overcast&width=nan`), [400]],
  ['an infinite number', get(`${still}?cloudscape=overcast&azimuth_deg=1e999`), [400]],
  ['a huge picture', get(`${still}?cloudscape=overcast&width=99999&height=99999`), [400]],
  ['a picture above the limit', get(`${still}?cloudscape=overcast&width=4096&height=4096`), [422]],
  ['a long URI', get(`/${long}`), [414]],
  ['a long query', get(`/?x=${long}`), [414]],
  ['a URI above the header table', get(`/${'a'.repeat(20000)}`), closed],
  ['a huge header', get('/', { 'X-Long': 'a'.repeat(20000) }), closed],
  ['very many headers', get('/', Object.fromEntries([...Array(2000)].map((_, i) => [`X-${i}`, 'x']))), closed],
  ['a header of nothing but a colon', 'GET /healthz HTTP/1.1\r\nHost: localhost\r\n: x\r\n\r\n', closed],
  ['no Host', request('GET / HTTP/1.1', { Host: null }), [400]],
  ['two Hosts', get('/', { Host: ['localhost', 'evil.example'] }), [400]],
  ['a foreign Host', get('/', { Host: 'evil.example' }), [421]],
  ['a Host that starts like ours', get('/', { Host: 'localhost.evil.example' }), [421]],
  ['HTTP/2.0 in the line', request('GET / HTTP/2.0'), [505]],
  ['HTTP/0.9', 'GET /\r\n\r\n', [400]],
  ['HTTP/1.0', request('GET /healthz HTTP/1.0'), [200]],
  ['a line without a method', '/ HTTP/1.1\r\nHost: localhost\r\n\r\n', [403]],
  ['an unknown method', request('BREW /pot HTTP/1.1'), [403]],
  ['TRACE', request('TRACE / HTTP/1.1'), [403]],
  ['CONNECT', request('CONNECT localhost:22 HTTP/1.1'), closed],
  ['PATCH', request('PATCH /api/v1/cloudscapes/a HTTP/1.1', { 'Content-Length': 0 }), [405]],
  ['an HTTP/2 preface', 'PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n', [403]],
  ['TLS on the plain port', Buffer.from('16030100a5010000a10303', 'hex'), null],
  ['bytes without sense', Buffer.from([...Array(512)].map((_, i) => (i * 37) % 256)), null],
  ['a body on GET', request(`GET /healthz HTTP/1.1`, { 'Content-Length': 5 }, 'hello'), [400]],
  ['a body on DELETE', request('DELETE /api/v1/cloudscapes/a HTTP/1.1', { 'Content-Length': 2 }, '{}'), [400]],
  ['a chunked POST', post({ ...json, 'Transfer-Encoding': 'chunked' }, '2\r\n{}\r\n0\r\n\r\n'), [411]],
  ['a chunked GET', get('/healthz', { 'Transfer-Encoding': 'chunked' }) + '0\r\n\r\n', [400]],
  ['no length', post(json, ''), [411]],
  ['length and chunks', post({ ...json, 'Content-Length': 2, 'Transfer-Encoding': 'chunked' }), [400]],
  ['two lengths', post({ ...json, 'Content-Length': [2, 3] }), [400]],
  ['a negative length', post({ ...json, 'Content-Length': -2 }), [400]],
  ['a length with a sign', post({ ...json, 'Content-Length': '+2' }), [400]],
  ['a hexadecimal length', post({ ...json, 'Content-Length': '0x2' }), [400]],
  ['a length beyond 64 bits', post({ ...json, 'Content-Length': '99999999999999999999' }), [400]],
  ['a length above the limit', post({ ...json, 'Content-Length': 65537 }, ''), [413]],
  ['a length of 2^62', post({ ...json, 'Content-Length': '4611686018427387904' }, 'x'.repeat(4096)), [413]],
  ['an empty body', post({ ...json, 'Content-Length': 0 }, ''), [400]],
  ['an empty document', request('PUT /api/v1/cloudscapes/empty HTTP/1.1', { 'Content-Length': 0 }), [400]],
  ['a body that is no JSON', post({ ...json, 'Content-Length': 3 }, '{"a'), [400]],
  ['a body of the wrong type', post({ 'Content-Type': 'text/plain', 'Content-Length': 2 }), [415]],
  ['a body nested deeply', post({ ...json, 'Content-Length': 60000 }, '['.repeat(60000)), [400]],
  ['a document that is no object', request('PUT /api/v1/cloudscapes/a HTTP/1.1', { 'Content-Length': 2 }, '[]'), [400]],
  ['a document with a bad name', request('PUT /api/v1/cloudscapes/A%20b HTTP/1.1', { 'Content-Length': 2 }, '{}'), [400]],
  ['a change from a foreign page', post({ ...json, 'Content-Length': 2, Origin: 'http://evil.example' }), [403]],

  ['an upgrade to nothing known', get('/', { Connection: 'Upgrade', Upgrade: 'foo' }), [403]],
  ['an upgrade to nothing known, second', get('/healthz') + get('/', { Connection: 'Upgrade', Upgrade: 'foo' }), [200, 403]],
  ['an empty upgrade', get('/healthz', { Connection: 'Upgrade', Upgrade: '' }), null],
  ['a long upgrade', get('/', { Connection: 'Upgrade', Upgrade: 'w'.repeat(500) }), [403]],
  ['two upgrades', get('/', { Connection: 'Upgrade', Upgrade: ['websocket', 'h2c'] }), null],
  ['an upgrade to h2c', get('/', { Connection: 'Upgrade, HTTP2-Settings', Upgrade: 'h2c', 'HTTP2-Settings': 'AAMAAABkAAQAAP__' }), [400]],
  ['an h2c upgrade, second', get('/healthz') + get('/', { Connection: 'Upgrade', Upgrade: 'h2c', 'HTTP2-Settings': 'AAMAAABk' }), [200, 400]],
  ['a WebSocket elsewhere', upgrade({}, 'GET / HTTP/1.1'), [404]],
  ['a WebSocket at the stills', upgrade({}, `GET ${still} HTTP/1.1`), [404]],
  ['a WebSocket by POST', upgrade({ 'Content-Length': 0 }, 'POST /api/v1/stream HTTP/1.1'), [400]],
  ['a WebSocket in HTTP/1.0', upgrade({}, 'GET /api/v1/stream HTTP/1.0'), [400]],
  ['a WebSocket without Connection', upgrade({ Connection: null }), [400]],
  ['a WebSocket that keeps alive', upgrade({ Connection: 'keep-alive' }), [400]],
  ['a WebSocket with a long Connection', upgrade({ Connection: `Upgrade, ${'x'.repeat(200)}` }), [400]],
  ['version 8', upgrade({ 'Sec-WebSocket-Version': 8 }), [426]],
  ['version 99', upgrade({ 'Sec-WebSocket-Version': 99 }), [426]],
  ['no version', upgrade({ 'Sec-WebSocket-Version': null }), [426]],
  ['no key', upgrade({ 'Sec-WebSocket-Key': null }), [400]],
  ['a short key', upgrade({ 'Sec-WebSocket-Key': 'c2hvcnQ=' }), [400]],
  ['a long key', upgrade({ 'Sec-WebSocket-Key': 'a'.repeat(500) }), [400]],
  ['no subprotocol', upgrade({ 'Sec-WebSocket-Protocol': null }), [400]],
  ['a foreign subprotocol', upgrade({ 'Sec-WebSocket-Protocol': 'chat' }), [400]],
  ["the server's own name for HTTP", upgrade({ 'Sec-WebSocket-Protocol': 'cloudscape-http, cloudscape.v1' }), [400]],
  ['a long list of subprotocols', upgrade({ 'Sec-WebSocket-Protocol': `cloudscape.v1, ${'x'.repeat(300)}` }), [400]],
  ['a foreign Origin', upgrade({ Origin: 'http://evil.example' }), [403]],
  ['the Origin null', upgrade({ Origin: 'null' }), [403]],
  ['an Origin on another port', upgrade({ Origin: 'http://localhost:1' }), [403]],
  ['a foreign Host and its Origin', upgrade({ Host: 'evil.example', Origin: 'http://evil.example' }), [421]],
];

for (const [what, bytes, expected] of cases) {
  test(what, async () => {
    const wanted = expected?.length ?? 0;
    const enough = text => wanted > 0 && statuses(text).length >= wanted && has_whole_answer(text.slice(text.lastIndexOf('HTTP/1.')));
    const { text, closed: was_closed } = await exchange(server.port, [bytes], { timeout_ms: 4000, until: enough });
    if (expected) assert.deepEqual(statuses(text), expected, text.slice(0, 300));
    if (!wanted && expected) assert.ok(was_closed, 'the connection stayed open');
    assert.ok(!text.includes('HTTP/1.1 101'), 'the connection was upgraded');
    assert.ok(!text.includes('root:'), 'a file of the machine was served');
    assert.equal((await server.fetch('/healthz')).status, 200);
  });
}

test(`there are enough cases (${cases.length})`, () => assert.ok(cases.length >= 60));

test('the answer to a body that is too large arrives, though the client sends it all before it reads', async () => {
  const body = 'x'.repeat(16 << 20);  // more than the kernel's buffers hold
  const { text, error } = await exchange(server.port, [post({ ...json, 'Content-Length': body.length }, body)], { read_after_ms: 500 });
  assert.deepEqual(statuses(text), [413]);
  assert.equal(error, null);
});

test('what a request says is never markup, and always UTF-8 and JSON', async () => {
  const response = await server.fetch(`${still}?cloudscape=${encodeURIComponent('<script>')}%ff`);
  assert.equal(response.headers.get('content-type'), 'application/problem+json');
  assert.equal(response.headers.get('x-content-type-options'), 'nosniff');
  assert.match((await response.json()).detail, /script/);
});

test('pipelined requests are answered in order', async () => {
  const three = get('/healthz') + get('/nothing') + get('/readyz');
  const { text } = await exchange(server.port, [three], { until: text => statuses(text).length === 3, timeout_ms: 4000 });
  assert.deepEqual(statuses(text), [200, 404, 200]);
});

test('requests that arrive byte by byte are understood', async () => {
  const bytes = [...get('/healthz', { Connection: 'close' })].flatMap(byte => [byte, 2]);
  const { text } = await exchange(server.port, bytes);
  assert.deepEqual(statuses(text), [200]);
});

test('Expect: 100-continue is honoured', async () => {
  const { text } = await exchange(server.port, [
    request('PUT /api/v1/cloudscapes/expected HTTP/1.1', { 'Content-Length': 2, Expect: '100-continue' }), 200, '{}',
  ], { until: text => statuses(text).length === 2 });
  assert.deepEqual(statuses(text), [100, 201]);
});

test('the log of the refusals is short', () => {
  assert.ok(server.log.split('\n').length < 120, `${server.log.split('\n').length} lines:\n${server.log.slice(0, 2000)}`);
});
