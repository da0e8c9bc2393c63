// What the page tests run against: the real program (CLOUDSCAPE_PROGRAM), or the fake server where that is not set; and
// the headless browser that looks at it.
import { spawn } from 'node:child_process';
import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import { createServer } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import jpeg from 'jpeg-js';
import { chromium } from 'playwright-core';
import { start_fake_server } from './fake_server.mjs';

export const program = process.env.CLOUDSCAPE_PROGRAM;
export const window_px = { width: 640, height: 360 };
const start_ms = 60000;  // a first start bakes, on a slow machine
// --disable-quic and the rest: no traffic but the page's own.
const browser_flags = ['--headless=new', '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run',
  '--disable-background-networking', '--disable-component-update', '--disable-sync'];

export function start_browser() {
  return chromium.launch({ executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args: browser_flags });
}

async function free_port() {
  const probe = createServer();
  await new Promise(resolve => probe.listen(0, '127.0.0.1', resolve));
  const { port } = probe.address();
  await new Promise(resolve => probe.close(resolve));
  return port;
}

async function start_program({ port, token }, folder) {
  const flags = ['serve', '--listen', `127.0.0.1:${port}`, '--cache-dir', process.env.CLOUDSCAPE_TEST_CACHE ?? join(folder, 'cache')];
  if (token) {
    await writeFile(join(folder, 'token'), token, { mode: 0o600 });
    flags.push('--token-file', join(folder, 'token'));
  }
  const child = spawn(program, flags, { stdio: ['ignore', 'pipe', 'pipe'] });
  const ended = new Promise(resolve => child.once('exit', resolve));
  let said = '';
  const url = await new Promise((resolve, reject) => {
    const late = setTimeout(() => reject(new Error(`Not ready after ${start_ms} ms: ${said}`)), start_ms);
    const hear = text => {
      said += text;
      const ready = said.match(/ready: (http:\S+)/);
      if (ready) resolve(ready[1]);
      if (ready) clearTimeout(late);
    };
    child.stdout.on('data', hear);
    child.stderr.on('data', hear);
    ended.then(code => reject(new Error(`The server ended with ${code}: ${said}`)));
  }).catch(error => {
    child.kill('SIGKILL');
    throw error;
  });
  return {
    url: url.replace(/#.*/, ''),
    async stop() {
      child.kill('SIGTERM');
      const late = setTimeout(() => child.kill('SIGKILL'), 12000);
      await ended;
      clearTimeout(late);
    },
  };
}

// A server that can be stopped and started again at the same address.
export async function start_subject(options = {}) {
  const folder = await mkdtemp(join(tmpdir(), 'cloudscape-page-'));
  const fixed = { ...options, port: await free_port() };
  const start = () => (program ? start_program(fixed, folder) : start_fake_server(fixed));
  let server = await start();
  return {
    url: server.url,
    stop: () => server.stop(),
    async start() {
      server = await start();
    },
    async end() {
      await server.stop();
      await rm(folder, { recursive: true, force: true });
    },
  };
}

// A page of its own context; `faults` collects what the console and the content security policy complain about.
export async function open_page(browser, url, options = {}) {
  const context = await browser.newContext({ viewport: window_px, acceptDownloads: true, ...options });
  const page = await context.newPage();
  const faults = [];
  page.on('console', message => ['error', 'warning'].includes(message.type()) && faults.push(message.text()));
  page.on('pageerror', error => faults.push(String(error)));
  await page.goto(url);
  return { page, faults, close: () => context.close() };
}

export async function hide_panel(page) {
  await page.evaluate(() => document.body.classList.add('no-panel', 'no-hud'));
}

// What is on the screen, as pixels.
export async function look(page) {
  return jpeg.decode(await page.screenshot({ type: 'jpeg', quality: 95 }));
}

// Mean difference of two pictures, in steps of 8 bits.
export function difference(one, other) {
  let sum = 0;
  for (let i = 0; i < one.data.length; i++) sum += Math.abs(one.data[i] - other.data[i]);
  return sum / (one.data.length * 0.75);
}

export function contrast({ data }) {
  const greens = data.filter((_, i) => i % 4 === 1);
  const mean = greens.reduce((sum, value) => sum + value, 0) / greens.length;
  return Math.sqrt(greens.reduce((sum, value) => sum + (value - mean) ** 2, 0) / greens.length);
}

// Looks until `wanted(picture)`; the time limit is for a software renderer on a busy machine.
export async function look_until(page, wanted, what, limit_ms = 25000) {
  for (const end = Date.now() + limit_ms; ;) {
    const picture = await look(page);
    if (wanted(picture)) return picture;
    if (Date.now() > end) throw new Error(`Within ${limit_ms} ms: no ${what}.`);
    await page.waitForTimeout(150);
  }
}

// The picture once the server has finished refining it.
export async function rest(page) {
  await page.waitForFunction(() => document.body.dataset.stream === 'live');
  await page.waitForFunction(() => document.body.dataset.stage === 'finished' &&
    getComputedStyle(document.getElementById('sky')).opacity === '1', null, { timeout: 40000 });
  return look(page);
}
