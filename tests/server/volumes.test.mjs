// Volumes from files over HTTP: found in their folder alone, told in a sentence where they cannot be used, and looked at anew when
// they change.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';

import { start } from './program.mjs';

let server, folder;
before(async () => {
  folder = mkdtempSync(join(tmpdir(), 'cloudscape-volumes-'));
  server = await start({ 'volume-dir': folder });
});
after(async () => {
  await server.stop();
  rmSync(folder, { recursive: true, force: true });
});

const write = (name, floats) => writeFileSync(join(folder, name), Buffer.from(new Float32Array(floats).buffer));
const of_file = (file, grid = {}) => ({ kind: file.endsWith('.vdb') ? 'vdb' : 'grid', origin_m: [-500, 1000, 500], size_m: [1000, 1000, 1000],
  grid: { file, size: [2, 2, 2], ...grid } });
const still = volume => server.fetch('/api/v1/stills', { method: 'POST', headers: { 'content-type': 'application/json' },
  body: JSON.stringify({ cloudscape: { volume }, image: { width: 32, height: 24, quality: 'draft', format: 'png' } }) });
async function refused(volume, status, pattern, pointer) {
  const answer = await still(volume);
  const problem = await answer.json();
  assert.equal(answer.status, status, problem.detail);
  assert.match(problem.detail, pattern);
  assert.ok(!problem.detail.includes(folder), 'where the folder is is no business of a client');
  if (pointer) assert.equal(problem.pointer, pointer);
}

test('a volume of the folder is rendered, and again when it changes', async () => {
  write('a.raw', Array(8).fill(1));
  const first = await still(of_file('a.raw')), first_bytes = Buffer.from(await first.arrayBuffer());
  assert.equal(first.status, 200);
  const same = await still(of_file('a.raw'));
  assert.equal(same.headers.get('etag'), first.headers.get('etag'));
  assert.deepEqual(Buffer.from(await same.arrayBuffer()), first_bytes);
  write('a.raw', [1, 0, 0, 0, 0, 0, 0, 0]);
  const changed = await still(of_file('a.raw'));
  assert.notEqual(changed.headers.get('etag'), first.headers.get('etag'));
  assert.notDeepEqual(Buffer.from(await changed.arrayBuffer()), first_bytes);
});

test('only bare names, of the kind\'s own type', async () => {
  for (const file of ['../a.raw', '/etc/passwd.raw', 'a.txt', 'dir\\a.raw', '.raw'])
    await refused(of_file(file), 400, /bare name/, '/cloudscape/volume/grid/file');
});

test('files that cannot be used are told in a sentence, and the server goes on', async () => {
  await refused(of_file('none.raw'), 422, /'none\.raw' is not in the folder of volumes/);
  write('short.raw', [1, 2, 3]);
  await refused(of_file('short.raw'), 422, /'short\.raw' has 12 bytes, and 2x2x2 voxels of 32 bits have 32/);
  write('negative.raw', [1, 1, 1, 1, 1, 1, 1, -1]);
  await refused(of_file('negative.raw'), 422, /negative/);
  write('gap.raw', [1, 1, 1, 1, 1, 1, 1, NaN]);
  await refused(of_file('gap.raw'), 422, /not finite/);
  write('air.raw', Array(8).fill(0));
  await refused(of_file('air.raw'), 422, /empty/);
  for (const [name, bytes] of [['text.vdb', 'no volume'], ['empty.vdb', ''], ['text.exr', 'no picture']]) {
    writeFileSync(join(folder, name), bytes);
    await refused(of_file(name), 422, new RegExp(`'${name}'`));
    await refused(of_file(name), 422, new RegExp(`'${name}'`));
  }
  await refused(of_file('large.vdb', { resolution: 512 }), 422, /max_bake_mib/, '/cloudscape/volume/grid/resolution');
  await refused(of_file('large.raw', { size: [512, 512, 512] }), 422, /max_bake_mib/, '/cloudscape/volume/grid/size');
  write('a.raw', Array(8).fill(1));
  assert.equal((await still(of_file('a.raw'))).status, 200);
  assert.ok(server.alive);
});
