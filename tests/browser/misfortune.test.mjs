// The page where things go wrong, against a server that does so on demand.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { start_fake_server } from './fake_server.mjs';
import { open_page, start_browser } from './subject.mjs';

let browser;
before(async () => {
  browser = await start_browser();
});
after(() => browser?.close());

async function open(t, options, fragment = '', context = {}) {
  const server = await start_fake_server(options);
  const opened = await open_page(browser, server.url + fragment, context);
  t.after(async () => {
    await opened.close();
    await server.stop();
  });
  return { server, ...opened };
}
const notice = (page, kind) => page.waitForSelector(`#notice[data-kind=${kind}]:not([hidden])`);
const live = page => page.waitForFunction(() => document.body.dataset.stream === 'live');

test('an unknown sky is named, and another one is offered', async t => {
  const { server, page } = await open(t, { fatal: { message: 'There is no cloudscape "x".', pointer: '', fatal: false } }, '#cloudscape=x');
  await notice(page, 'cloudscape');
  assert.match(await page.locator('#notice').innerText(), /There is no cloudscape "x"/);
  delete server.options.fatal;
  await page.locator('#again').click();
  await live(page);
  assert.deepEqual(server.log.hellos.map(hello => hello.cloudscape), ['x', 'fair-weather-cumulus']);
});

test('a protocol error is told and not tried again by itself', async t => {
  const { server, page } = await open(t, { fatal: { message: 'Version 1 is not served.', pointer: '/version' } });
  await notice(page, 'protocol');
  await page.waitForTimeout(1500);
  assert.equal(server.log.hellos.length, 1);
});

test('a full server is waited for', async t => {
  const { server, page } = await open(t, { full: true });
  await notice(page, 'waiting');
  assert.match(await page.locator('#notice').innerText(), /max_streams/);
  server.options.full = false;
  await page.locator('#again').click();
  await live(page);
  await page.waitForSelector('#notice', { state: 'hidden' });
});

test('a sky whose first picture takes long is said to be prepared', async t => {
  const { server, page } = await open(t, { frozen: true });
  await notice(page, 'preparing');
  assert.match(await page.locator('#notice').innerText(), /Preparing Fair-weather cumulus/);
  server.options.frozen = false;
  await page.keyboard.press('ArrowLeft', { delay: 100 });
  await page.waitForSelector('#notice', { state: 'hidden' });
});

test('a server that starts says so, and the page waits', async t => {
  const { server, page } = await open(t, { starting: true });
  await notice(page, 'waiting');
  assert.match(await page.locator('#notice').innerText(), /renderer is starting/);
  server.options.starting = false;
  await live(page);
});

test('while the next picture is awaited the last one turns with the hand', async t => {
  const { server, page } = await open(t, {});
  await page.waitForFunction(() => document.body.dataset.stage === 'finished');
  const transform = () => page.evaluate(() => document.getElementById('sky').style.transform);
  assert.equal(await transform(), 'none');
  server.options.frozen = true;
  await page.mouse.move(200, 180);
  await page.mouse.down();
  await page.mouse.move(240, 180, { steps: 3 });
  await page.mouse.up();
  assert.match(await transform(), /^matrix3d/);
  const point = await page.evaluate(() => {
    const matrix = new DOMMatrix(document.getElementById('sky').style.transform);
    const { x, y, w } = matrix.transformPoint(new DOMPoint(0, 0, 0, 1));
    return [x / w, y / w];
  });
  // The sky is held: what was in the middle moved as far as the hand did, but for the tangent and the tilt.
  assert.ok(Math.abs(point[0] - 40) < 6 && Math.abs(point[1]) < 3, String(point));
  server.options.frozen = false;
  await page.keyboard.press('ArrowLeft', { delay: 100 });
  await page.waitForFunction(() => document.getElementById('sky').style.transform === 'none');
});

test('a refused still shows the server\'s sentence, and a running one can be stopped', async t => {
  const { server, page } = await open(t, { still_error: 'The picture is too large: at most 4096 pixels a side.' });
  await live(page);
  await page.click('#still_open');
  await page.click('#still_save');
  await page.waitForSelector('#still_message.failed');
  assert.match(await page.locator('#still_message').textContent(), /at most 4096 pixels/);
  Object.assign(server.options, { still_error: undefined, still_ms: 30000 });
  await page.click('#still_save');
  await page.waitForSelector('#still_progress', { state: 'visible' });
  await page.click('#still_save');
  await page.waitForFunction(() => document.querySelector('#still_save').textContent === 'Save');
});

test('every frame is acknowledged once, and a view at rest is quiet', async t => {
  const { server, page } = await open(t, {});
  await page.waitForFunction(() => document.body.dataset.stage === 'finished');
  await page.waitForTimeout(300);
  const ids = server.log.acks.map(ack => ack.frame_id);
  assert.deepEqual(ids, [...new Set(ids)]);
  assert.ok(ids.length >= 3 && server.log.acks.every(ack => ack.decode_ms >= 0));
  const sent = server.log.cameras.length + server.log.acks.length;
  await page.waitForTimeout(700);
  assert.equal(server.log.cameras.length + server.log.acks.length, sent);
});

test('the stream has the window\'s device pixels, follows its size, and a GPU gives more', async t => {
  const { server, page } = await open(t, { software: false }, '', { viewport: { width: 1000, height: 500 }, deviceScaleFactor: 2 });
  await live(page);
  const asked = async wanted => {
    const size_px = () => server.log.settings.at(-1)?.size_px ?? [0, 0];
    for (let tries = 0; tries < 100 && !wanted(size_px()); ++tries) await page.waitForTimeout(100);
    assert.ok(wanted(size_px()), `asked for ${size_px()}`);
  };
  await asked(size => size[0] === 2000 && size[1] === 1000);
  const [width, height] = server.log.hellos[0].size_px;
  assert.ok(width * height <= 960 * 540);
  await page.setViewportSize({ width: 600, height: 400 });
  await asked(size => size[0] === 1200 && size[1] === 800);
  await page.selectOption('#resolution', '360');
  await asked(size => size[0] * size[1] <= 640 * 360 && size[0] > 500);
});

test('time runs at the chosen rate, and only when asked', async t => {
  const { server, page } = await open(t, {});
  await live(page);
  assert.equal(server.log.clocks.length, 0);
  await page.check('[name=rate][value="60"]', { force: true });
  await page.click('#play');
  await page.waitForTimeout(300);
  await page.click('#play');
  await page.locator('#time_s').fill('600');
  await page.waitForTimeout(300);
  const told = name => server.log.clocks.map(change => change[name]).filter(value => value !== undefined);
  assert.deepEqual([told('rate'), told('paused'), told('time_s')], [[60], [false, true], [600]]);
  assert.equal(server.log.cameras.length, 0);
});

test('a link\'s moment is its own until somebody here turns the clock', async t => {
  const { server, page } = await open(t, {}, '#cloudscape=overcast&time_s=300');
  await live(page);
  assert.equal(server.log.hellos[0].time_s, 300);
  assert.equal(await page.locator('#time_s').inputValue(), '300');
  await page.click('#play');
  await page.waitForTimeout(300);
  assert.deepEqual(server.log.clocks.map(({ time_s, paused }) => [time_s, paused]), [[300, false]]);
  await page.waitForFunction(() => !location.hash.includes('time_s'));
});

test('the time of day runs only where the sky has a place', async t => {
  const without = await open(t, {});
  await live(without.page);
  assert.equal(await without.page.locator('#sun_time').isVisible(), false);
  const { server, page } = await open(t, { time_utc: '2026-06-21T05:30:00Z' });
  await live(page);
  assert.equal(await page.locator('#time_of_day').textContent(), '05:30 UTC');
  await page.check('#sun_runs');
  await page.locator('#time_s').fill('3600');
  await page.waitForFunction(() => document.querySelector('#time_of_day').textContent === '06:30 UTC');
  assert.deepEqual([server.log.settings.at(-1).sun_time_rate, server.log.settings.at(-1).sun_azimuth_deg], [1, null]);
  await page.locator('#sun_elevation_deg').fill('3');
  assert.equal(await page.locator('#sun_runs').isChecked(), false, 'a sun that is put somewhere stands there');
});

test('a sky\'s name and description are text, never markup', async t => {
  const { page } = await open(t, { cloudscapes: [{ name: 'x', title: '<img src=x onerror=fail()>', description: '<b>bold</b>' }] });
  await live(page);
  assert.equal(await page.locator('#cloudscapes img').count(), 0);
  assert.equal(await page.locator('#cloudscapes small').textContent(), '<b>bold</b>');
});

test('who prefers less motion gets a camera without glide', async t => {
  const { server, page } = await open(t, {}, '', { reducedMotion: 'reduce' });
  await live(page);
  await page.locator('#sky').focus();
  await page.keyboard.down('w');
  await page.waitForTimeout(400);
  await page.keyboard.up('w');
  await page.waitForTimeout(150);
  const count = server.log.cameras.length;
  await page.waitForTimeout(400);
  assert.ok(count > 3);
  assert.equal(server.log.cameras.length, count);
});
