// HTTP as bytes on a socket, for what no HTTP client would send.
import { connect } from 'node:net';

// Sends `parts` (a number is a pause in ms) and collects what comes until the server closes or `timeout_ms` is over.
export function exchange(port, parts, { timeout_ms = 3000, until = () => false, local, read_after_ms = 0 } = {}) {
  return new Promise(resolve => {
    const socket = connect({ port, host: '127.0.0.1', localAddress: local });
    const started = Date.now();
    let received = Buffer.alloc(0), ended = false, error = null;
    const done = closed => {
      if (ended) return;
      ended = true;
      clearTimeout(timer);
      socket.destroy();
      resolve({ text: received.toString('latin1'), bytes: received, closed, error, after_ms: Date.now() - started });
    };
    const timer = setTimeout(() => done(false), timeout_ms);
    socket.on('data', data => {
      received = Buffer.concat([received, data]);
      if (until(received.toString('latin1'))) done(false);
    });
    socket.on('close', () => done(true));
    socket.on('error', ({ code }) => { error = code; done(true); });
    socket.on('connect', async () => {
      if (read_after_ms) {
        socket.pause();
        setTimeout(() => socket.resume(), read_after_ms);
      }
      for (const part of [parts].flat()) {
        if (ended) return;
        if (typeof part === 'number') await new Promise(next => setTimeout(next, part));
        else socket.write(typeof part === 'string' ? Buffer.from(part, 'latin1') : part);
      }
    });
  });
}

// The status codes of the responses in `text`, in order.
export const statuses = text => [...text.matchAll(/HTTP\/1\.[01] (\d{3}) /g)].map(match => Number(match[1]));

export const has_whole_answer = text => {
  const head = text.indexOf('\r\n\r\n');
  if (head < 0) return false;
  const length = text.slice(0, head).match(/^content-length: (\d+)$/mi);
  return text.length >= head + 4 + Number(length?.[1] ?? 0);
};

export function request(line, headers = {}, body = '') {
  const lines = Object.entries({ Host: 'localhost', ...headers })
    .filter(([, value]) => value !== null)
    .flatMap(([name, value]) => [value].flat().map(each => `${name}: ${each}`));
  return `${line}\r\n${lines.map(each => each + '\r\n').join('')}\r\n${body}`;
}

export const websocket_headers = {
  Connection: 'Upgrade', Upgrade: 'websocket', 'Sec-WebSocket-Version': '13',
  'Sec-WebSocket-Key': 'dGhlIHNhbXBsZSBub25jZQ==', 'Sec-WebSocket-Protocol': 'cloudscape.v1',
};
export const upgrade = (changes = {}, line = 'GET /api/v1/stream HTTP/1.1') =>
  request(line, { ...websocket_headers, ...changes });
