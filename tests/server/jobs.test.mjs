// Sequences as jobs: ordered, looked after, fetched, deleted; and what they must not do to others.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import Ajv from 'ajv/dist/2020.js';

import { one_of_three, sleep, start, until } from './program.mjs';
import { Viewer } from './viewer.mjs';

let server, folder;
before(async () => {
  folder = mkdtempSync(join(tmpdir(), 'cloudscape-jobs-test-'));
  server = await start({ 'jobs-dir': join(folder, 'jobs'), 'max-job-frames': 100000, 'max-job-gigasteps': 1000000 });
});
after(async () => {
  await server.stop();
  rmSync(folder, { recursive: true });
});

const path = { keys: [0, 1, 2].map(s => ({ time_s: s, pose: { position_m: [100 * s, 5, 300], azimuth_deg: 20 * s },
  vertical_fov_deg: 40 + 10 * s })) };
const image = { width: 48, height: 32, quality: 'draft', format: 'png' };
const body = { cloudscape: 'fair-weather-cumulus', path, image, frames: { last: 2, frames_per_second: 1 } };
const long = { ...body, image: { ...image, width: 320, height: 180 }, frames: { frames_per_second: 1000 } };

const order = (members = body, to = server) => to.fetch('/api/v1/sequences', {
  method: 'POST', headers: { 'content-type': 'application/json' },
  body: typeof members === 'string' ? members : JSON.stringify(members) });
async function ordered(members = body, to = server) {
  const answer = await order(members, to);
  const job = await answer.json();
  assert.equal(answer.status, 202, JSON.stringify(job));
  assert.equal(answer.headers.get('location'), `/api/v1/jobs/${job.id}`);
  return job;
}
const link = job => `/api/v1/jobs/${job.id}`;
const ended = (job, to = server) => until(async () => {
  const now = await to.json(link(job));
  return ['done', 'failed', 'cancelled'].includes(now.state) && now;
}, 'the end of the job', 60000);
const remove = (job, to = server) => to.fetch(link(job), { method: 'DELETE' });
const files = () => readdirSync(join(folder, 'jobs')).flatMap(each => readdirSync(join(folder, 'jobs', each)));

test('a job goes from its order to its result', async () => {
  const job = await ordered();
  assert.match(job.id, /^[0-9a-f]{32}$/);
  assert.equal(job.kind, 'sequence');
  assert.equal(job.frames, 3);
  assert.equal(job.result, null);
  assert.ok(['queued', 'rendering'].includes(job.state), job.state);
  const done = await ended(job);
  assert.equal(done.state, 'done', done.error);
  assert.equal(done.frames_done, 3);
  assert.equal(done.progress, 1);
  assert.ok(Date.parse(done.expires) - Date.parse(done.ended) === 3600_000);
  assert.equal(done.result, `${link(job)}/result`);

  const result = await server.fetch(done.result);
  const bytes = Buffer.from(await result.arrayBuffer());
  assert.equal(result.status, 200);
  assert.equal(result.headers.get('content-type'), 'application/zip');
  assert.equal(bytes.length, done.bytes);
  assert.equal(Number(result.headers.get('content-length')), bytes.length);
  const zip = join(folder, 'result.zip'), out = join(folder, 'frames');
  writeFileSync(zip, bytes);
  execFileSync('python3', ['-m', 'zipfile', '-t', zip]);
  execFileSync('python3', ['-m', 'zipfile', '-e', zip, out]);
  assert.deepEqual(readdirSync(out).sort(), ['frame_0000.png', 'frame_0001.png', 'frame_0002.png']);
  for (const s of [0, 1, 2]) {
    const still = await server.fetch(`/api/v1/stills?cloudscape=fair-weather-cumulus&width=48&height=32&quality=draft&format=png`
      + `&position=${100 * s},5,300&azimuth_deg=${20 * s}&elevation_deg=10&vertical_fov_deg=${40 + 10 * s}&time_s=${s}`);
    assert.equal(still.status, 200);
    assert.deepEqual(readFileSync(join(out, `frame_000${s}.png`)), Buffer.from(await still.arrayBuffer()), `second ${s}`);
  }

  const etag = result.headers.get('etag');
  assert.equal((await server.fetch(done.result, { headers: { 'if-none-match': etag } })).status, 304);
  const part = await server.fetch(done.result, { headers: { range: 'bytes=10-19' } });
  assert.equal(part.status, 206);
  assert.equal(part.headers.get('content-range'), `bytes 10-19/${bytes.length}`);
  assert.deepEqual(Buffer.from(await part.arrayBuffer()), bytes.subarray(10, 20));
  const changed = await server.fetch(done.result, { headers: { range: 'bytes=10-19', 'if-range': '"other"' } });
  assert.equal(changed.status, 200);
  await changed.arrayBuffer();
  assert.equal((await server.fetch(done.result, { headers: { range: `bytes=${bytes.length}-` } })).status, 416);

  assert.equal((await remove(job)).status, 204);
  assert.equal((await server.fetch(link(job))).status, 404);
  assert.equal((await server.fetch(done.result)).status, 404);
  await until(() => files().length === 0, 'the file is removed');
});

test('the OpenAPI document describes orders and jobs', async () => {
  const openapi = await server.json('/api/v1/openapi.json');
  const ajv = new Ajv({ strict: false, validateFormats: false });
  ajv.addSchema({ $id: 'openapi', ...openapi });
  const check = (name, value) => {
    const validate = ajv.compile({ $ref: `openapi#/components/schemas/${name}` });
    return validate(value) || assert.fail(JSON.stringify(validate.errors));
  };
  check('SequenceRequest', body);
  check('SequenceRequest', { ...body, path: 'fly-around', camera: { lens: { kind: 'fisheye' } }, container: 'avi' });
  assert.throws(() => check('SequenceRequest', { ...body, camera: { azimuth_deg: 3 } }));
  assert.throws(() => check('SequenceRequest', { cloudscape: 'overcast' }));
  const job = await ordered();
  check('Job', job);
  check('Job', await ended(job));
  for (const [path, method, statuses] of [['/api/v1/sequences', 'post', [202, 400, 404, 415, 422, 429, 503]],
    ['/api/v1/jobs/{id}', 'get', [200, 404]], ['/api/v1/jobs/{id}', 'delete', [204, 404]],
    ['/api/v1/jobs/{id}/result', 'get', [200, 206, 304, 404, 409, 416]]])
    for (const status of statuses) assert.ok(openapi.paths[path][method].responses[status], `${method} ${path} ${status}`);
  await remove(job);
});

test('an AVI is the JPEG frames in a RIFF', async () => {
  const job = await ordered({ ...body, image: { ...image, format: 'jpeg' }, container: 'avi' });
  const done = await ended(job);
  assert.equal(done.state, 'done', done.error);
  const answer = await server.fetch(done.result);
  assert.equal(answer.headers.get('content-type'), 'video/x-msvideo');
  const avi = Buffer.from(await answer.arrayBuffer());
  assert.equal(avi.toString('latin1', 0, 4) + avi.toString('latin1', 8, 12), 'RIFFAVI ');
  assert.equal(avi.readUInt32LE(4), avi.length - 8);
  const first = avi.indexOf('00dc');
  assert.equal(avi.subarray(first + 8, first + 10).toString('hex'), 'ffd8');
  await remove(job);
});

test('a job is cancelled while it renders, and nothing of it stays', async () => {
  const job = await ordered(long);
  await until(async () => (await server.json(link(job))).frames_done > 0, 'the first frame');
  const early = await server.fetch(`${link(job)}/result`);
  assert.equal(early.status, 409);
  assert.equal(early.headers.get('content-type'), 'application/problem+json');
  assert.match((await early.json()).detail, /frame \d+ of 2001/);
  assert.equal(files().length, 1);
  assert.equal((await remove(job)).status, 204);
  assert.equal((await remove(job)).status, 404);
  await until(() => files().length === 0, 'the file is removed');
  const rendered = await server.metric('cloudscape_job_frames_total');
  await sleep(300);
  assert.ok(await server.metric('cloudscape_job_frames_total') <= rendered + 1);
  assert.equal(await server.metric('cloudscape_jobs_ended_total{state="cancelled"}'), 1);
});

test('wrong orders are refused with the place', async () => {
  for (const [members, status, pointer] of [
    ['', 400], ['{', 400], ['[]', 400], [{ ...body, path: 'fly-arund' }, 404], [{ ...body, path: { keys: [] } }, 400, '/path/keys'],
    [{ ...body, cloudscape: 'nothing' }, 404], [{ ...body, cloudscape: undefined }, 400, '/cloudscape'],
    [{ ...body, frames: { last: 3, frames_per_second: 1 } }, 400, '/frames'], [{ ...body, container: 'mp4' }, 400, '/container'],
    [{ ...body, container: 'avi' }, 400, '/container'], [{ ...body, image: { width: 100000 } }, 400, '/image/width'],
    [{ ...body, image: { width: 4097 } }, 422, '/image/width'], [{ ...body, camera: { azimuth_deg: 1 } }, 400, '/camera/azimuth_deg'],
  ]) {
    const answer = await order(members);
    const problem = await answer.json();
    assert.equal(answer.status, status, JSON.stringify(problem));
    assert.equal(answer.headers.get('content-type'), 'application/problem+json');
    if (pointer) assert.equal(problem.pointer, pointer);
  }
  const text = await server.fetch('/api/v1/sequences', { method: 'POST', headers: { 'content-type': 'text/plain' }, body: '{}' });
  assert.equal(text.status, 415);
  assert.equal((await server.fetch('/api/v1/sequences')).status, 405);
  assert.equal((await server.fetch('/api/v1/jobs')).status, 404, 'there is no list: an id is a key');
  assert.equal((await server.fetch(`/api/v1/jobs/${'0'.repeat(32)}`)).status, 404);
});

test('a client has half of the jobs, and its stills go first', async () => {
  const jobs = [await ordered(long), await ordered(long)];
  const third = await order(long);
  assert.equal(third.status, 429);
  assert.ok(Number(third.headers.get('retry-after')) > 0);
  const started = Date.now();
  const still = await server.fetch('/api/v1/stills?cloudscape=fair-weather-cumulus&width=64&height=36&quality=draft&azimuth_deg=77');
  assert.equal(still.status, 200);
  assert.ok(Date.now() - started < 5000);
  for (const job of jobs) assert.equal((await remove(job)).status, 204);
});

test('a stream stays fluent while a job runs', async () => {
  const viewer = await Viewer.open(server);
  viewer.hello({ cloudscape: 'fair-weather-cumulus', size_px: [64, 48], quality: 'draft' });
  await viewer.frame();
  let sequence = 0;
  const fly = async seconds => {
    const end = Date.now() + 1000 * seconds, before = viewer.frames_received;
    for (; Date.now() < end; await sleep(15)) viewer.camera(++sequence, { azimuth_deg: sequence % 360 });
    return viewer.frames_received - before;
  };
  await fly(2);
  await one_of_three(async () => {
    const alone = await fly(3);
    const job = await ordered(long);
    const beside = await fly(3);
    await remove(job);
    assert.ok(beside > 0.6 * alone, `${beside} frames beside a job, ${alone} without`);
  });
  viewer.socket.close();
});

test('results expire, fill their room, and die with the server', async () => {
  const root = join(folder, 'other');
  mkdirSync(join(root, 'cloudscape-jobs-killed'), { recursive: true });
  writeFileSync(join(root, 'cloudscape-jobs-killed', '1'), 'left by a process that was killed');
  const other = await start({ 'jobs-dir': root, 'job-kept-s': 1, 'job-results-mib': 1, 'max-job-frames': 10 });
  try {
    const [own, ...more] = readdirSync(root);
    assert.deepEqual(more, [], 'what was left is removed');
    assert.equal(statSync(join(root, own)).mode & 0o777, 0o700);
    assert.equal((await order({ ...body, frames: { frames_per_second: 30 } }, other)).status, 422);
    const job = await ordered(body, other);
    assert.equal((await ended(job, other)).state, 'done');
    await until(() => readdirSync(join(root, own)).length === 0, 'the result expires');
    await until(async () => (await other.fetch(link(job))).status === 404, 'the job expires');
    const large = await ordered({ ...body, image: { width: 640, height: 480, quality: 'draft', format: 'exr', exr_type: 'float' } }, other);
    const failed = await ended(large, other);
    assert.equal(failed.state, 'failed');
    assert.match(failed.error, /job_results_mib/);
    assert.equal((await other.fetch(`${link(large)}/result`)).status, 409);
    await until(() => readdirSync(join(root, own)).length === 0, 'nothing half-written stays');
    await ordered({ ...body, frames: { last: 9, frames_per_second: 5 } }, other);
  } finally {
    assert.equal((await other.stop()).code, 0);
  }
  assert.deepEqual(readdirSync(root), []);
});

test('a token guards jobs too', async () => {
  const guarded = await start({ 'jobs-dir': join(folder, 'guarded') }, { environment: { CLOUDSCAPE_TOKEN: 'a-token-of-some-length' } });
  try {
    assert.equal((await order(body, guarded)).status, 401);
    assert.equal((await guarded.fetch(`/api/v1/jobs/${'0'.repeat(32)}`)).status, 401);
  } finally {
    await guarded.stop();
  }
  assert.ok(existsSync(join(folder, 'guarded')));
});
