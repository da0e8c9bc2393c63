// Path-traced stills as jobs.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';

import { start, until } from './program.mjs';

let server, folder;
before(async () => {
  folder = mkdtempSync(join(tmpdir(), 'cloudscape-references-test-'));
  server = await start({ 'jobs-dir': folder });
});
after(async () => {
  await server.stop();
  rmSync(folder, { recursive: true });
});

const cloudscape = { volume: { kind: 'sphere', origin_m: [-1000, 4000, 800], size_m: [2000, 2000, 2000] } };
const image = { width: 16, height: 9, format: 'png', quality: 'reference', samples: 2 };
const posted = (route, body) => server.fetch(route, {
  method: 'POST', headers: { 'content-type': 'application/json' }, body: JSON.stringify(body) });
const order = image => posted('/api/v1/references', { cloudscape, image });
const link = job => `/api/v1/jobs/${job.id}`;

test('a reference is a job whose result is the picture', async () => {
  const answer = await order(image);
  const job = await answer.json();
  assert.equal(answer.status, 202, JSON.stringify(job));
  assert.equal(answer.headers.get('location'), link(job));
  assert.deepEqual([job.kind, job.frames, job.samples], ['reference', 1, 2]);
  const done = await until(async () => {
    const now = await server.json(link(job));
    return ['done', 'failed'].includes(now.state) && now;
  }, 'the end of the job', 60000);
  assert.equal(done.state, 'done', done.error);
  assert.deepEqual([done.progress, done.frames_done], [1, 1]);
  const result = await server.fetch(done.result);
  assert.equal(result.headers.get('content-type'), 'image/png');
  const bytes = new Uint8Array(await result.arrayBuffer());
  const still = await posted('/api/v1/stills', { cloudscape, image });
  assert.deepEqual(bytes, new Uint8Array(await still.arrayBuffer()), 'as the same still');
});

test('one that takes long says how far it is, and can be cancelled', async () => {
  const job = await (await order({ ...image, width: 320, height: 180, samples: 4096 })).json();
  const under_way = await until(async () => {
    const now = await server.json(link(job));
    return now.progress > 0 && now;
  }, 'progress', 60000);
  assert.ok(under_way.progress < 1 && under_way.state === 'rendering');
  assert.equal((await server.fetch(link(job), { method: 'DELETE' })).status, 204);
  assert.equal((await server.fetch(link(job))).status, 404);
});

test('what is no reference, or too much for a still, is refused with the way out', async () => {
  const wrong = await order({ ...image, quality: 'standard' });
  assert.equal(wrong.status, 400);
  assert.match((await wrong.json()).detail, /must be reference/);
  const large = await posted('/api/v1/stills', { cloudscape, image: { ...image, width: 640, height: 360, samples: 256 } });
  assert.equal(large.status, 422);
  assert.match((await large.json()).detail, /\/api\/v1\/references/);
});
