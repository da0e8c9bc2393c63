// Starts the server under test on a free port of 127.0.0.1, and stops it.
import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

// The rest of the environment has no CLOUDSCAPE_ in it: a setting of the user's, or a name that is none, would matter.
const { CLOUDSCAPE_PROGRAM: program, CLOUDSCAPE_TEST_CACHE: cache } = process.env;
const environment_of_user = Object.fromEntries(Object.entries(process.env).filter(([name]) => !name.startsWith('CLOUDSCAPE_')));

// `settings`: flags of `cloudscape serve` without their dashes. `open_files`: the process's limit.
export async function start(settings = {}, { open_files = 0, environment = {}, command = [program, 'serve'] } = {}) {
  const folder = mkdtempSync(join(tmpdir(), 'cloudscape-server-'));
  const flags = Object.entries({ listen: '127.0.0.1:0', 'cache-dir': cache ?? join(folder, 'cache'), ...settings })
    .flatMap(([name, value]) => (value === true ? [`--${name}`] : [`--${name}`, String(value)]));
  const limit = open_files ? `ulimit -n ${open_files}; ` : '';
  const child = spawn('sh', ['-c', `${limit}exec "$@"`, 'sh', ...command, ...flags], {
    env: { ...environment_of_user, ...environment }, stdio: ['ignore', 'pipe', 'pipe'] });
  const server = new Program(child, folder);
  await server.link_told;
  return server;
}

class Program {
  constructor(child, folder) {
    this.child = child;
    this.folder = folder;
    this.log = '';
    this.exit = new Promise(resolve => child.on('exit', (code, signal) => resolve({ code, signal })));
    child.stderr.on('data', text => { this.log += text; });
    this.link_told = new Promise((resolve, reject) => {
      let out = '';
      child.stdout.on('data', text => {
        out += text;
        const link = out.match(/^ready: (\S+)$/m);
        if (link) resolve(this.#take_link(link[1]));
      });
      this.exit.then(({ code }) => reject(new Error(`the server ended with ${code} before it was ready:\n${this.log}`)));
    });
  }
  #take_link(link) {
    const url = new URL(link);
    this.link = link;
    this.port = Number(url.port);
    this.origin = url.origin;
    this.stream_url = `ws://${url.host}/api/v1/stream`;
    this.token = new URLSearchParams(url.hash.slice(1)).get('token');
  }
  get alive() { return this.child.exitCode === null && this.child.signalCode === null; }
  fetch(path, options = {}) { return fetch(this.origin + path, options); }
  async json(path) { return (await this.fetch(path)).json(); }
  // The value of one series of /metrics; 0 where there is none.
  async metric(series) {
    const text = await (await this.fetch('/metrics')).text();
    const line = text.split('\n').find(each => each.startsWith(`${series} `));
    return line ? Number(line.slice(series.length + 1)) : 0;
  }
  signal(name = 'SIGTERM') { this.child.kill(name); }
  async stop() {
    const killer = setTimeout(() => this.child.kill('SIGKILL'), 15000);
    if (this.alive) this.signal();
    const exit = await this.exit;
    clearTimeout(killer);
    rmSync(this.folder, { recursive: true, force: true });
    return exit;
  }
}

export const sleep = ms => new Promise(resolve => setTimeout(resolve, ms));

export async function until(condition, what, timeout_ms = 10000) {
  const end = Date.now() + timeout_ms;
  for (;;) {
    const value = await condition();
    if (value) return value;
    if (Date.now() > end) throw new Error(`${what}: not within ${timeout_ms} ms`);
    await sleep(20);
  }
}

// What compares speeds: another program of the machine may slow either side, and a fault of ours slows every attempt.
export async function one_of_three(attempt) {
  for (let i = 1; ; ++i) {
    try {
      return await attempt();
    } catch (error) {
      if (i === 3 || error.code !== 'ERR_ASSERTION') throw error;
    }
  }
}
