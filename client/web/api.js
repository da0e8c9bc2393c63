// The HTTP side of the server: the list of cloudscapes, stills, and why a stream could not be opened.

export class ApiError extends Error {
  constructor(status, message, wait_s = 0) {
    super(message);
    Object.assign(this, { status, wait_s });
  }
}

function authorization(token) {
  return token ? { Authorization: `Bearer ${token}` } : {};
}

// Errors are RFC 9457 problem documents: `detail` is the sentence for people.
async function api_error(response) {
  const problem = await response.json().catch(() => ({}));
  const where = problem.pointer ? ` (${problem.pointer})` : '';
  const sentence = problem.detail ?? problem.title ?? `The server answered ${response.status} ${response.statusText}`;
  const wait_s = Number(response.headers.get('Retry-After')) || 0;
  return new ApiError(response.status, sentence.includes(problem.pointer) ? sentence : sentence + where, wait_s);
}

export async function api_fetch(path, token, options = {}) {
  const response = await fetch(new URL(path, document.baseURI), { ...options, headers: { ...options.headers, ...authorization(token) } });
  if (!response.ok) throw await api_error(response);
  return response;
}

export async function list_cloudscapes(token) {
  const response = await api_fetch('api/v1/cloudscapes', token, { cache: 'no-cache' });
  return (await response.json()).cloudscapes;
}

export async function list_stills(token) {
  const response = await api_fetch('api/v1/stills/named', token, { cache: 'no-cache' });
  return (await response.json()).stills;
}

export function stream_url() {
  const url = new URL('api/v1/stream', document.baseURI);
  url.protocol = url.protocol === 'https:' ? 'wss:' : 'ws:';
  url.hash = '';
  return url.href;
}

// What an error of the HTTP side means to a person who wants to watch.
export function explain(error, token) {
  if (!(error instanceof ApiError)) return { kind: 'away', message: 'The server does not answer.', retry: true };
  const { status, message, wait_s } = error;
  const wanted = token ? 'The server did not accept this token.' : 'This server asks for its access token.';
  if (status === 401) return { kind: 'token', message: wanted, retry: false };
  if (status === 403) return { kind: 'forbidden', message, retry: false };
  if (status === 429 || status >= 500) return { kind: 'busy', message, retry: true, wait_s };
  return { kind: 'protocol', message, retry: false };
}

// A browser hides the HTTP answer to a failed WebSocket handshake, so the likely causes are asked for over HTTP.
export async function diagnose(token) {
  try {
    await list_cloudscapes(token);
    await api_fetch('readyz', token, { cache: 'no-store' });
  } catch (error) {
    return explain(error, token);
  }
  const message = 'The server answers but opens no stream: it may have all the viewers that it takes (max_streams), ' +
    'or not know this page’s address (allowed_origins).';
  return { kind: 'full', message, retry: true, wait_s: 2 };
}
