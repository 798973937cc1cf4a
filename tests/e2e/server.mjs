/**
 * A static web server on loopback. It serves the built site, pages of tests with their own
 * headers, and replacements of files.
 *
 * MIME types matter: a browser compiles wasm while it downloads only if the type is
 * `application/wasm`, and rejects a module script of another type.
 */
import { readFile, stat } from 'node:fs/promises';
import { createServer } from 'node:http';
import path from 'node:path';
import { answerPage, rememberContexts } from './driver/page-scripts.mjs';

const TYPES = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript; charset=utf-8',
  '.mjs': 'text/javascript; charset=utf-8',
  '.css': 'text/css; charset=utf-8',
  '.json': 'application/json',
  '.wasm': 'application/wasm',
  '.png': 'image/png',
  '.jpg': 'image/jpeg',
  '.svg': 'image/svg+xml',
  '.ico': 'image/x-icon',
};

/** @typedef {{[name: string]: string}} Headers */
/**
 * A replacement of a file.
 * @typedef {object} Instead
 * @property {number} [status]
 * @property {string} [type]  Its MIME type.
 * @property {Headers} [headers]
 * @property {string | Uint8Array} [body]
 * @property {number} [keep]  Sends only its first bytes.
 * @property {boolean} [drop]  Closes the connection, like a broken network.
 * @property {boolean} [silent]  Takes the request and never answers it.
 */
/**
 * @typedef {object} Server
 * @property {string} origin  `http://127.0.0.1:<port>`
 * @property {(html: string, headers?: Headers) => string} publish  Serves a page of a
 *   test; returns its URL.
 * @property {(files: {[end: string]: Instead}) => void} replace  Sets the
 *   replacements of files whose path ends with these names.
 * @property {(start: {pages?: string[], workers?: string[]}) => void} prepend  Sets scripts that
 *   run before those of every page and of every worker.
 * @property {boolean} cached  Whether browsers keep files and what they compile of them.
 * @property {((problem: string) => void) | undefined} refused  Is called for each failed request.
 * @property {((file: string) => void) | undefined} served  Is called for each file of the folders that is read.
 * @property {() => Promise<void>} close
 */

/**
 * Serves folders until it is closed; where two hold the same name, the first wins.
 * @param {...string} folders
 * @returns {Promise<Server>}
 */
export async function serve(...folders) {
  const roots = folders.map((folder) => path.resolve(folder));
  /** @type {Map<string, {html: string, headers: Headers}>} */
  const pages = new Map();
  /** @type {[string, Instead][]} */
  let replaced = [];
  /** @type {{pages: string[], workers: string[]}} */
  let scripts = { pages: [], workers: [] };

  const insteadOf = (/** @type {string} */ name) => replaced.find(([end]) => name.endsWith(end))?.[1] ?? {};

  /**
   * @param {URL} url
   * @param {string | undefined} known  The version that the browser has.
   * @returns {Promise<Instead & {status: number, type: string, body: string | Uint8Array, tag?: string}>}
   */
  const answer = async (url, known) => {
    const name = decodeURIComponent(url.pathname);
    const own = fromDriver(url, scripts);
    if (own !== undefined) {
      // A wrapped worker has the headers of the worker's file.
      const { headers } = insteadOf(new URL(url.searchParams.get('of') ?? url).pathname);
      return { status: 200, type: TYPES['.js'], headers, body: own };
    }
    const page = pages.get(name);
    const instead = insteadOf(name);
    const file = await find(roots, name.endsWith('/') ? `${name}index.html` : name);
    // Browsers ask for it on their own, and nothing is wrong with a page without one.
    if (name === '/favicon.ico' && file === undefined) return { status: 204, type: '', body: '' };
    if (page === undefined && file === undefined && instead.body === undefined) {
      return { status: 404, type: 'text/plain', body: `no ${name}`, ...instead };
    }
    const unchanged = served.cached && page === undefined && Object.keys(instead).length === 0;
    const tag = unchanged ? await tagOf(/** @type {string} */ (file)) : undefined;
    if (tag !== undefined && tag === known) return { status: 304, type: '', tag, body: '' };
    if (file !== undefined && page === undefined) served.served?.(file);
    const body = instead.body ?? page?.html ?? (await readFile(/** @type {string} */ (file)));
    const type = TYPES[page ? '.html' : path.extname(file ?? name)] ?? 'application/octet-stream';
    return { status: 200, type, headers: page?.headers, ...instead, tag, body };
  };

  const server = createServer(async (request, response) => {
    const url = new URL(request.url ?? '/', 'http://local');
    const { status, type, headers, tag, body, keep, drop, silent } = await answer(
      url,
      request.headers['if-none-match'],
    );
    if (silent) return;
    if (drop) {
      request.socket.destroy();
    } else {
      const kept = tag === undefined ? { 'cache-control': 'no-store' } : { 'cache-control': 'no-cache', etag: tag };
      response.writeHead(status, { ...(type && { 'content-type': type }), ...kept, ...headers });
      response.end(started(type, body, scripts.pages).subarray(0, keep));
    }
    if (drop || status >= 400) served.refused?.(`${drop ? 'dropped' : status}: ${url.pathname}`);
  });

  await new Promise((resolve) => server.listen(0, '127.0.0.1', () => resolve(undefined)));
  const address = /** @type {import('node:net').AddressInfo} */ (server.address());
  const origin = `http://127.0.0.1:${address.port}`;
  /** @type {Server} */
  const served = {
    origin,
    cached: true,
    refused: undefined,
    served: undefined,
    publish(html, headers = {}) {
      const name = `/page-${pages.size + 1}.html`;
      pages.set(name, { html, headers });
      return origin + name;
    },
    replace(files) {
      replaced = Object.entries(files);
    },
    prepend({ pages: ofPages = [], workers = [] }) {
      scripts = { pages: ofPages, workers };
    },
    async close() {
      server.closeAllConnections();
      await new Promise((resolve) => server.close(resolve));
    },
  };
  return served;
}

/**
 * The version of a file: a browser that has this version keeps its compiled code. Pages have
 * none, since inserted scripts differ.
 * @param {string} file
 */
async function tagOf(file) {
  if (file.endsWith('.html')) return undefined;
  const { mtimeMs, size } = await stat(file);
  return `"${mtimeMs.toString(36)}-${size.toString(36)}"`;
}

/**
 * Scripts of the driver: the first script of a page, and a worker that imports another.
 * @param {URL} url @param {{pages: string[], workers: string[]}} scripts
 */
function fromDriver(url, scripts) {
  const about = url.searchParams;
  const line = JSON.stringify(about.get('line'));
  if (url.pathname === '/driver/page.js') return scripts.pages.join('\n');
  if (url.pathname === '/driver/hook.js') {
    return [`(${rememberContexts})();`, `(${answerPage})(${line});`, ...scripts.workers].join('\n');
  }
  if (url.pathname !== '/driver/worker.js') return undefined;
  const hook = `/driver/hook.js?${new URLSearchParams({ line: about.get('line') ?? '' })}`;
  const files = [hook, about.get('of')].map((file) => JSON.stringify(file));
  // Imports run in order, each before the next.
  if (about.get('type') === 'module') return files.map((file) => `import ${file};`).join('\n');
  return `importScripts(${files.join(', ')});`;
}

/**
 * The body of a response; pages have the scripts before their own.
 * @param {string} type @param {string | Uint8Array} body @param {string[]} scripts
 */
function started(type, body, scripts) {
  const bytes = Buffer.from(body);
  if (scripts.length === 0 || !type.startsWith('text/html')) return bytes;
  const html = bytes.toString();
  const opening =
    ['<head', '<html', '<!doctype']
      .map((tag) => html.match(new RegExp(`${tag}(\\s[^>]*)?>`, 'i'))?.[0])
      .find((found) => found !== undefined) ?? '';
  const at = html.indexOf(opening) + opening.length;
  return Buffer.from(`${html.slice(0, at)}<script src="/driver/page.js"></script>${html.slice(at)}`);
}

/**
 * The first file of that name inside the folders.
 * @param {string[]} roots @param {string} name
 */
async function find(roots, name) {
  for (const root of roots) {
    const file = path.join(root, name);
    const found = file.startsWith(root + path.sep) ? await stat(file).catch(() => null) : null;
    if (found?.isFile()) return file;
  }
  return undefined;
}
