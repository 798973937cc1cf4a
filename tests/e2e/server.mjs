/**
 * A static web server on loopback for the tests: the built site, as any static
 * host would serve it, and pages that a test writes in its own lines.
 *
 * MIME types matter: a browser compiles wasm while it downloads only if the
 * type is `application/wasm`, and refuses a module script of another type.
 */
import { createReadStream } from 'node:fs';
import { stat } from 'node:fs/promises';
import { createServer } from 'node:http';
import path from 'node:path';

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

/**
 * @typedef {object} Server
 * @property {string} origin  `http://127.0.0.1:<port>`
 * @property {(html: string) => string} publish  Serves a page of a test beside the site; gives its URL.
 * @property {() => Promise<void>} close
 */

/**
 * Serves folders until it is closed; where two hold the same name, the first wins.
 * @param {...string} folders
 * @returns {Promise<Server>}
 */
export async function serve(...folders) {
  const roots = folders.map((folder) => path.resolve(folder));
  /** @type {Map<string, string>} */
  const pages = new Map();

  const server = createServer(async (request, response) => {
    const name = decodeURIComponent(new URL(request.url ?? '/', 'http://local').pathname);
    const page = pages.get(name);
    if (page !== undefined) {
      response.writeHead(200, { 'content-type': TYPES['.html'] }).end(page);
      return;
    }
    const file = await find(roots, name.endsWith('/') ? `${name}index.html` : name);
    if (file === undefined) {
      response.writeHead(404, { 'content-type': 'text/plain' }).end(`no ${name}`);
      return;
    }
    const type = TYPES[path.extname(file)] ?? 'application/octet-stream';
    response.writeHead(200, { 'content-type': type, 'cache-control': 'no-store' });
    createReadStream(file).pipe(response);
  });

  await new Promise((resolve) => server.listen(0, '127.0.0.1', () => resolve(undefined)));
  const address = server.address();
  const origin = `http://127.0.0.1:${typeof address === 'object' && address ? address.port : 0}`;
  return {
    origin,
    publish(html) {
      const name = `/page-${pages.size + 1}.html`;
      pages.set(name, html);
      return origin + name;
    },
    async close() {
      server.closeAllConnections();
      await new Promise((resolve) => server.close(resolve));
    },
  };
}

/**
 * The first file of that name that stands inside one of the folders.
 * @param {string[]} roots @param {string} name
 */
async function find(roots, name) {
  for (const root of roots) {
    const file = path.join(root, name);
    const found = file.startsWith(root + path.sep) && (await stat(file).catch(() => null));
    if (found && found.isFile()) return file;
  }
  return undefined;
}
