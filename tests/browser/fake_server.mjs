// A small server that speaks the page's side of the API over pictures of gradients, and refuses on demand: for what the
// real server does only by misfortune, and for quick work on the page.
import { createServer } from 'node:http';
import { readFile } from 'node:fs/promises';
import { dirname, extname, join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';
import jpeg from 'jpeg-js';
import { WebSocketServer } from 'ws';

const page_folder = join(dirname(fileURLToPath(import.meta.url)), '../../client/web');
const types = { '.html': 'text/html; charset=utf-8', '.js': 'text/javascript', '.css': 'text/css', '.svg': 'image/svg+xml' };
export const content_security_policy = "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:; " +
  "connect-src 'self' ws: wss:; worker-src 'self' blob:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

export const cloudscapes = [
  { name: 'broken-sunset', title: 'Broken field at sunset', description: 'A broken field of cumulus, lit from below the deck by a low sun.', preset: true },
  { name: 'congestus', title: 'Towering congestus', description: 'A few tall towers with hard, bright heads over a hazy plain.', preset: true },
  { name: 'fair-weather-cumulus', title: 'Fair-weather cumulus', description: 'Small cumulus with flat bases at 900 m, drifting in a clear summer sky.', preset: true },
  { name: 'morning-puffs', title: 'Sparse morning puffs', description: 'The first thermals of the day: sparse puffs in clean air.', preset: true },
  { name: 'overcast', title: 'Overcast', description: 'A closed grey deck, soft light from everywhere.', preset: true },
  { name: 'stratocumulus', title: 'Stratocumulus deck', description: 'Rolls of stratocumulus with gaps, seen from just above.', preset: true },
];
const start_pose = { position_m: [0, 0, 600], azimuth_deg: 30, elevation_deg: 12, roll_deg: 0 };

// A sky that depends on everything that a test changes: pose, sun and time.
function picture({ pose, sun_azimuth_deg = 135, sun_elevation_deg = 40, time_s = 0 }, [width, height], quality) {
  const data = Buffer.alloc(width * height * 4);
  for (let y = 0; y < height; y++) {
    const elevation = pose.elevation_deg + (0.5 - y / height) * 50;
    for (let x = 0; x < width; x++) {
      const azimuth = pose.azimuth_deg + (x / width - 0.5) * 80;
      const cloud = Math.max(0, Math.sin(azimuth / 9 + pose.position_m[0] / 300 + time_s / 50) *
        Math.sin(elevation / 5 + pose.position_m[1] / 500) + 0.3 * Math.sin(azimuth / 2.3) * Math.sin(elevation / 1.7));
      const sun = Math.exp(-Math.hypot((azimuth - sun_azimuth_deg + 540) % 360 - 180, elevation - sun_elevation_deg) / 15);
      const up = Math.max(0, Math.min(1, elevation / 60));
      [190 - 130 * up, 210 - 90 * up, 235 - 40 * up].forEach((sky, i) => {
        data[4 * (y * width + x) + i] = Math.min(255, sky + (250 - sky) * Math.min(1, cloud) + 120 * sun);
      });
    }
  }
  return jpeg.encode({ data, width, height }, quality).data;
}

function frame_message(stream, quality_stage) {
  const [width, height] = stream.size_px.map(side => Math.max(16, side >> 1));
  const image = picture(stream, [width, height], quality_stage ? 90 : 60);
  const header = Buffer.alloc(92);
  header.set([1, quality_stage, 0, 0]);
  header.writeUInt32LE(++stream.frame_id, 4);
  header.writeBigUInt64LE(BigInt(stream.pose_sequence), 8);
  header.writeUInt16LE(width, 16);
  header.writeUInt16LE(height, 18);
  header.writeFloatLE(50, 20);
  const { position_m, azimuth_deg, elevation_deg, roll_deg } = stream.pose;
  [...position_m, azimuth_deg, elevation_deg, roll_deg, stream.time_s ?? 0].forEach((value, i) => header.writeDoubleLE(value, 24 + 8 * i));
  header.writeFloatLE(7, 80);
  header.writeFloatLE(1, 84);
  header.writeUInt32LE(image.length, 88);
  return Buffer.concat([header, image]);
}

// Options may be changed while it runs: token, full or starting (no stream), frozen (no frames), still_error, fatal (an error in place of the welcome).
export async function start_fake_server(options = {}) {
  const log = { hellos: [], cameras: [], settings: [], clocks: [], acks: [] };
  const clock = { time_s: 0, rate: 1, paused: true };
  const allowed = given => !options.token || given === options.token;
  const problem = (response, status, detail, pointer) => {
    response.writeHead(status, { 'Content-Type': 'application/problem+json' });
    response.end(JSON.stringify({ status, title: 'Refused', detail, pointer }));
  };

  async function answer(request, response) {
    const { pathname, searchParams } = new URL(request.url, 'http://localhost');
    if (pathname.startsWith('/api/') || pathname === '/readyz') {
      if (!allowed(request.headers.authorization?.replace('Bearer ', ''))) return problem(response, 401, 'A token is needed.');
      if (pathname === '/api/v1/cloudscapes') return response.end(JSON.stringify({ cloudscapes: options.cloudscapes ?? cloudscapes }));
      if (pathname === '/readyz') return options.starting ? problem(response, 503, 'The renderer is starting.') : response.end('{}');
      if (options.still_error) return problem(response, 422, options.still_error, '/width');
      log.still = searchParams;
      await new Promise(resolve => setTimeout(resolve, options.still_ms ?? 50));
      return response.end(Buffer.from(`a ${searchParams.get('format')} picture`));
    }
    const name = normalize(pathname === '/' ? 'index.html' : pathname.slice(1));
    const body = await readFile(join(page_folder, name)).catch(() => null);
    response.writeHead(body ? 200 : 404, {
      'Content-Type': types[extname(name)] ?? 'text/plain', 'Content-Security-Policy': content_security_policy,
    });
    response.end(body ?? 'not found');
  }

  function serve(socket) {
    let stream = null, in_flight = 0, stage = 0, timer = null;
    const pump = () => {
      if (!stream || options.frozen || in_flight >= 2 || stage > 3) return;
      in_flight++;
      socket.send(frame_message(stream, stage === 3 ? 255 : stage));
      stage++;
      timer = setTimeout(pump, 30);
    };
    socket.on('close', () => clearTimeout(timer));
    socket.on('message', text => {
      const message = JSON.parse(text);
      if (message.type === 'ack') {
        in_flight--;
        log.acks.push(message);
      } else if (message.type === 'hello') {
        log.hellos.push(message);
        if (options.fatal) {
          socket.send(JSON.stringify({ type: 'error', fatal: true, ...options.fatal }));
          return socket.close(1008);
        }
        stream = { pose: start_pose, pose_sequence: 0, frame_id: 0, ...message };
        socket.send(JSON.stringify({
          type: 'welcome', program_version: '0', renderer: 'fake gradients', software: options.software ?? true, cloudscape: message.cloudscape,
          pose: stream.pose, lens: message.lens ?? { kind: 'perspective', vertical_fov_deg: 50, width_m: 10000 },
          display: { exposure_ev: 0, tone_curve: 'agx', dither: true, ...message.display },
          sun_azimuth_deg: message.sun_azimuth_deg ?? 135, sun_elevation_deg: message.sun_elevation_deg ?? 40,
          size_px: stream.size_px, max_size_px: [3840, 2160], time_utc: options.time_utc ?? '', sun_time_rate: message.sun_time_rate ?? 0,
        }));
        socket.send(JSON.stringify({ type: 'clock', ...clock }));
      } else if (message.type === 'clock') {
        log.clocks.push(message);
        Object.assign(clock, message);
        stream.time_s = clock.time_s;
        socket.send(JSON.stringify({ ...clock, type: 'clock' }));
        stage = 0;
      } else {
        log[message.type === 'camera' ? 'cameras' : 'settings'].push(message);
        Object.assign(stream, message);
        stage = 0;
      }
      clearTimeout(timer);
      timer = setTimeout(pump, 10);
    });
  }

  const sockets = new WebSocketServer({ noServer: true, handleProtocols: () => 'cloudscape.v1' });
  const server = createServer((request, response) => void answer(request, response));
  server.on('upgrade', (request, socket, head) => {
    const offered = (request.headers['sec-websocket-protocol'] ?? '').split(/,\s*/);
    const token = offered.find(name => name.startsWith('bearer.'))?.slice('bearer.'.length);
    const status = !allowed(token) ? '401 Unauthorized' : options.full || options.starting ? '503 Service Unavailable' : null;
    if (status) return socket.end(`HTTP/1.1 ${status}\r\nContent-Length: 0\r\nConnection: close\r\n\r\n`);
    sockets.handleUpgrade(request, socket, head, serve);
  });
  await new Promise(resolve => server.listen(options.port ?? 0, '127.0.0.1', resolve));
  return {
    log, options, port: server.address().port, url: `http://127.0.0.1:${server.address().port}/`,
    close_streams: code => sockets.clients.forEach(client => client.close(code)),
    async stop() {
      sockets.clients.forEach(client => client.close(1001));
      server.closeAllConnections();
      await new Promise(resolve => server.close(resolve));
    },
  };
}
