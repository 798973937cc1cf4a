/**
 * The server of `cargo xtask serve`: types, no caching, nothing outside its folder.
 */
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { mkdir, mkdtemp, rm, writeFile } from 'node:fs/promises';
import { connect } from 'node:net';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';

const SERVE = fileURLToPath(new URL('../../crates/xtask/scripts/serve.mjs', import.meta.url));

/** @type {string} */
let folder;
/** @type {{server: import('node:child_process').ChildProcess, address: URL}} */
let running;

/** Starts a server of the site, and waits for its address. */
async function start() {
  const server = spawn(process.execPath, [SERVE, path.join(folder, 'site')], { stdio: ['pipe', 'pipe', 'inherit'] });
  const [line] = await once(server.stdout, 'data');
  return { server, address: new URL(String(line).trim()) };
}

/** Ends a server as its command does: with its input. */
async function end({ server }) {
  server.stdin.end();
  await once(server, 'exit');
}

/** The whole answer to a request, which no client has made safe. */
async function answer(request) {
  const { hostname, port, host } = running.address;
  const visitor = connect(Number(port), hostname);
  visitor.end(`${request} HTTP/1.1\r\nHost: ${host}\r\nConnection: close\r\n\r\n`);
  const chunks = [];
  for await (const chunk of visitor) chunks.push(chunk);
  return Buffer.concat(chunks).toString('latin1');
}

before(async () => {
  folder = await mkdtemp(path.join(tmpdir(), 'hearth-serve-'));
  await mkdir(path.join(folder, 'site/web'), { recursive: true });
  await writeFile(path.join(folder, 'site/index.html'), '<p>fire</p>');
  await writeFile(path.join(folder, 'site/web/engine_bg.wasm'), '\0asm');
  await writeFile(path.join(folder, 'secret'), 'secret');
  running = await start();
});
after(async () => {
  await end(running);
  await rm(folder, { recursive: true });
});

test('files have their type and are not stored', async () => {
  const [page, module, head] = await Promise.all(
    ['GET /', 'GET /web/engine_bg.wasm?v=1', 'HEAD /index.html'].map(answer),
  );
  for (const response of [page, module, head]) {
    assert.match(response, /^HTTP\/1\.1 200 OK\r\n/);
    // Without these a browser asks for the file each time.
    assert.doesNotMatch(response, /Last-Modified|ETag|Expires/);
  }
  assert.match(page, /\r\nContent-Type: text\/html.*\r\n\r\n<p>fire<\/p>$/s);
  assert.match(module, /\r\nContent-Type: application\/wasm\r\n.*\r\n\r\n\0asm$/s);
  assert.match(head, /\r\nContent-Length: 11\r\n.*\r\n\r\n$/s);
});

test('nothing outside the folder is served', async () => {
  for (const request of [
    'GET /no.js',
    'GET /../secret',
    'GET /web/../../secret',
    'GET /%2e%2e/secret',
    'GET /..%2fsecret',
    'GET /..%5csecret',
    'POST /',
  ]) {
    assert.match(await answer(request), /^HTTP\/1\.1 4/, request);
  }
  assert.match(await answer('GET /web'), /\r\nLocation: \/web\/\r\n/);
});

test('its port is free after its end', async () => {
  const ended = await start();
  await end(ended);
  // A child process listens. A child that stays fails by the timeout of the test.
  const { hostname, port } = ended.address;
  const isOpen = () =>
    new Promise((resolve) => {
      const visitor = connect(Number(port), hostname, () => resolve(true)).on('error', () => resolve(false));
      visitor.on('connect', () => visitor.destroy());
    });
  while (await isOpen());
});

test('only a requested port must be free', async () => {
  const second = await start();
  assert.notEqual(second.address.port, running.address.port);
  await end(second);
  const refused = spawn(process.execPath, [SERVE, path.join(folder, 'site'), running.address.port], {
    stdio: 'ignore',
  });
  assert.deepEqual(await once(refused, 'exit'), [1, null]);
});
