// The use after free of libwebsockets 4.1.6 (CVE-2025-11677) and other odd ends of connections, under valgrind.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';

import { start, sleep } from './program.mjs';
import { exchange, request, upgrade } from './raw.mjs';

test('no memory error, whatever the upgrade', async () => {
  const { VALGRIND, SERVER_WITHOUT_RENDERER } = process.env;
  const report = join('/tmp', `cloudscape-valgrind-${process.pid}.log`);
  const server = await start({}, { command: [VALGRIND, '-q', '--error-exitcode=9', `--log-file=${report}`, SERVER_WITHOUT_RENDERER] });
  const first = request('GET /healthz HTTP/1.1');
  const unknown = request('GET / HTTP/1.1', { Connection: 'Upgrade', Upgrade: 'foo' });
  const h2c = request('GET / HTTP/1.1', { Connection: 'Upgrade', Upgrade: 'h2c', 'HTTP2-Settings': 'AAMAAABk' });
  const still = request('GET /api/v1/stills?cloudscape=overcast HTTP/1.1');
  // The fault needs a connection that has served a request before.
  for (const bytes of [[unknown], [first, 100, unknown], [first + unknown], [first + unknown + first], [first, 100, h2c],
    [first + upgrade({ 'Sec-WebSocket-Version': 99 }) + first], [first, 100, upgrade({ Origin: 'http://evil.example' })],
    [first + upgrade() + 'bytes that are no frame'], [still + first], [still + unknown], [request('CONNECT / HTTP/1.1')],
    [first + request('CONNECT / HTTP/1.1')]])
    await exchange(server.port, bytes, { timeout_ms: 700 });
  await sleep(500);
  assert.equal((await server.fetch('/healthz')).status, 200);
  const { code } = await server.stop();
  assert.equal(code, 0, readFileSync(report, 'latin1'));
});
