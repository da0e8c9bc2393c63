// The page in headless Chromium: it shows the sky, flies, keeps links, reconnects, refuses and saves in clear words.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { after, before, test } from 'node:test';
import { contrast, difference, hide_panel, look, look_until, open_page, program, rest, start_browser, start_subject } from './subject.mjs';

const changed = 2;   // tuned: a turn of some degrees changes a picture by 5 to 30 steps, noise and JPEG by less than 1
const view = '#cloudscape=fair-weather-cumulus&quality=draft&position=0,0,1200&azimuth_deg=40&elevation_deg=4';
let browser, server;
before(async () => {
  browser = await start_browser();
  server = await start_subject();
});
after(async () => {
  await browser?.close();
  await server?.end();
});

async function open_view(t, fragment = view, options) {
  const opened = await open_page(browser, server.url + fragment, options);
  t.after(opened.close);
  await opened.page.waitForSelector('#sky.shown', { timeout: 40000 });
  return opened;
}

async function drag(page, right_px, down_px) {
  await page.mouse.move(200, 180);
  await page.mouse.down();
  await page.mouse.move(200 + right_px, 180 + down_px, { steps: 5 });
  await page.mouse.up();
}

test('the page shows a sky, without complaints of the console or the content security policy', async t => {
  const { page, faults } = await open_view(t, '');
  assert.ok(await page.locator('#cloudscapes label').count() >= 6);
  assert.match(await page.locator('#cloudscapes label').first().getAttribute('title'), /\w+ \w+/);
  assert.match(await page.locator('[data-figure=renderer]').textContent(), /^(software|GPU)$/);
  await hide_panel(page);
  assert.ok(contrast(await look(page)) > 3, 'the canvas is blank');
  assert.deepEqual(faults, []);
});

test('dragging turns the view, and flying moves it', async t => {
  const { page, faults } = await open_view(t);
  await hide_panel(page);
  const first = await rest(page);
  await drag(page, 160, 40);
  await look_until(page, picture => difference(picture, first) > changed, 'turned picture');
  const turned = await rest(page);
  assert.ok(difference(turned, first) > changed);
  await page.locator('#sky').press('Home');
  await page.mouse.wheel(0, -600);
  await page.keyboard.down('w');
  await page.waitForTimeout(1200);
  await page.keyboard.up('w');
  await look_until(page, picture => difference(picture, turned) > changed, 'moved picture');
  assert.deepEqual(faults, []);
});

test('a link is a view: another window shows the same picture', async t => {
  const { page } = await open_view(t);
  await hide_panel(page);
  const first = await rest(page);
  await drag(page, -140, 30);
  await look_until(page, picture => difference(picture, first) > changed, 'turned picture');
  const turned = await rest(page);
  await page.waitForTimeout(500);
  const link = page.url();
  assert.match(link, /#cloudscape=.*position=0,0,1200.*azimuth_deg=/);
  const other = await open_page(browser, link);
  t.after(other.close);
  await hide_panel(other.page);
  const same = await rest(other.page);
  assert.ok(difference(same, turned) < changed, `differs by ${difference(same, turned)}`);
});

test('two windows on one sky show the same time', { skip: !program }, async t => {
  const one = await open_view(t), other = await open_view(t);
  const shown_s = ({ page }) => page.locator('#time_s').evaluate(slider => slider.valueAsNumber);
  try {
    await one.page.locator('#time_s').fill('1800');
    await other.page.waitForFunction(() => document.getElementById('time_s').valueAsNumber === 1800);
    await other.page.check('[name=rate][value="60"]', { force: true });
    await other.page.click('#play');
    await one.page.waitForFunction(() => document.getElementById('play').getAttribute('aria-pressed') === 'true');
    await one.page.waitForFunction(() => document.getElementById('time_s').valueAsNumber > 1900);
    await one.page.click('#play');
    await other.page.waitForFunction(() => document.getElementById('play').getAttribute('aria-pressed') === 'false');
    await Promise.all([one, other].map(({ page }) => hide_panel(page)));
    const [mine, theirs] = await Promise.all([rest(one.page), rest(other.page)]);
    assert.ok(Math.abs(await shown_s(one) - await shown_s(other)) <= 1);
    assert.ok(difference(mine, theirs) < changed, `differs by ${difference(mine, theirs)}`);
    assert.deepEqual([...one.faults, ...other.faults], []);
  } finally {  // the other tests expect a clock that stands at 0
    if (await one.page.locator('#play').getAttribute('aria-pressed') === 'true') await one.page.locator('#play').evaluate(button => button.click());
    await one.page.locator('#time_s').evaluate(slider => {
      slider.value = 0;
      slider.dispatchEvent(new Event('input'));
    });
    await one.page.waitForTimeout(300);
  }
});

test('the sun\'s slider changes the light; another sky is a step in the history', async t => {
  const { page } = await open_view(t);
  const first = await rest(page);
  await page.locator('#sun_elevation_deg').fill('2');
  await look_until(page, picture => difference(picture, first) > changed, 'other light');
  await page.waitForFunction(() => location.hash.includes('sun_elevation_deg=2'));
  const before_link = page.url();
  await page.locator('#cloudscapes label:not(:has(:checked))').first().click();
  await page.waitForFunction(() => !location.hash.includes('sun_elevation_deg'));
  await page.goBack();
  await page.waitForFunction(() => document.body.dataset.stream === 'live');
  assert.equal(page.url(), before_link);
  assert.equal(await page.locator('#sun_elevation_deg').inputValue(), '2');
});

test('the view survives a restart of the server', async t => {
  const { page } = await open_view(t);
  await hide_panel(page);
  await drag(page, 90, 20);
  await page.waitForTimeout(600);
  const picture = await rest(page);
  const link = page.url();
  await server.stop();
  await page.waitForSelector('#notice[data-kind=waiting]:not([hidden])');
  assert.match(await page.locator('#notice p').textContent(), /Reconnecting/);
  await server.start();
  await page.locator('#again').click({ timeout: 1000 }).catch(() => {});  // it may have come back by itself
  await page.waitForSelector('#notice', { state: 'hidden', timeout: 40000 });
  const again = await rest(page);
  assert.equal(page.url(), link);
  assert.ok(difference(again, picture) < changed, `differs by ${difference(again, picture)}`);
});

test('the gallery shows pictures, and a way to where they were taken', { skip: !program }, async t => {
  const { page, faults } = await open_view(t);
  await page.click('#gallery_open');
  const pictures = page.locator('#pictures img');
  await pictures.first().waitFor();
  assert.ok(await pictures.count() >= 10);
  for (const picture of await pictures.all()) {
    await picture.scrollIntoViewIfNeeded();
    await picture.evaluate(image => image.decode());
    assert.ok(await picture.evaluate(image => image.naturalWidth) >= 400, await picture.getAttribute('alt'));
  }
  await page.locator('#pictures figure', { hasText: 'Above the deck' }).getByRole('button').click();
  await page.waitForFunction(() => location.hash.includes('cloudscape=stratocumulus-deck'));
  await page.waitForFunction(() => document.body.dataset.stream === 'live');
  assert.equal(await page.locator('#gallery').evaluate(dialog => dialog.open), false);
  assert.equal(await page.locator('#sun_elevation_deg').inputValue(), '7');
  assert.deepEqual(faults, []);
});

test('a still is saved as PNG and as EXR', async t => {
  const { page } = await open_view(t);
  await page.click('#still_open');
  await page.selectOption('#still_quality', 'interactive');
  const magic = { png: [0x89, 0x50, 0x4e, 0x47], exr: [0x76, 0x2f, 0x31, 0x01] };
  for (const format of ['png', 'exr']) {
    await page.check(`[name=format][value=${format}]`, { force: true });
    const [download] = await Promise.all([page.waitForEvent('download', { timeout: 60000 }), page.click('#still_save')]);
    assert.match(download.suggestedFilename(), new RegExp(`-640x360\\.${format}$`));
    const bytes = await readFile(await download.path());
    if (program) assert.deepEqual([...bytes.subarray(0, 4)], magic[format]);
  }
  await page.waitForFunction(() => document.querySelector('#still_message').textContent.startsWith('Saved'));
});

test('the panel hides with H, and nothing in it keeps the focus', async t => {
  const { page } = await open_view(t);
  assert.ok(await page.locator('#panel').isVisible());
  await page.locator('#quality').focus();
  await page.locator('#exposure_ev').focus();
  await page.keyboard.press('h');
  await page.waitForSelector('#panel', { state: 'hidden' });
  assert.equal(await page.evaluate(() => document.activeElement.id), 'show');
  await page.locator('#show').click();
  assert.ok(await page.locator('#panel').isVisible());
});

test('on a phone the sky fills the screen, the panel opens as a sheet and a finger looks around', async t => {
  const { page, faults } = await open_view(t, view, { viewport: { width: 360, height: 640 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 });
  assert.ok(await page.locator('#panel').isHidden());
  const first = await rest(page);
  await page.evaluate(() => {
    const sky = document.getElementById('sky');
    sky.setPointerCapture = () => {};
    const send = (type, x) => sky.dispatchEvent(new PointerEvent(type, { pointerId: 7, pointerType: 'touch', clientX: x, clientY: 300, bubbles: true }));
    send('pointerdown', 100);
    send('pointermove', 260);
    send('pointerup', 260);
  });
  await look_until(page, picture => difference(picture, first) > changed, 'turned picture');
  await page.locator('#show').tap();
  const sheet = await page.locator('#panel').boundingBox();
  assert.ok(sheet.width === 360 && sheet.height < 640 * 0.7, JSON.stringify(sheet));
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 360);
  assert.deepEqual(faults, []);
});

test('a wrong token is refused in words, the right one opens the sky and leaves the address', async t => {
  const guarded = await start_subject({ token: 'a-token-for-the-tests-0123456789abcdef' });
  t.after(guarded.end);
  const { page, close } = await open_page(browser, `${guarded.url}#token=wrong&quality=draft`);
  t.after(close);
  await page.waitForSelector('#notice[data-kind=token]:not([hidden])');
  assert.match(await page.locator('#notice').innerText(), /token/i);
  assert.ok(!page.url().includes('token'));
  await page.fill('#token', 'a-token-for-the-tests-0123456789abcdef');
  await page.keyboard.press('Enter');
  await page.waitForSelector('#sky.shown', { timeout: 40000 });
  assert.ok(await page.locator('#notice').isHidden());
  assert.ok(!page.url().includes('token'));
});
