/**
 * A small client of W3C WebDriver, JSON over HTTP, for WebKit: a program that is packaged
 * with the browser answers it.
 */
import { spawn } from 'node:child_process';
import { setTimeout as sleep } from 'node:timers/promises';
import { createServer } from 'node:net';
import { killAtExit } from './display.mjs';

/** Attempts to reach the program, 50 ms apart. */
const TRIES = 400;

/** A browser that a WebDriver program has started. */
export class Session {
  /** @param {string} address @param {() => void} end */
  constructor(address, end) {
    this.address = address;
    this.end = end;
  }

  /**
   * Starts the program, and a browser with it.
   * @param {string} file
   * @param {object} capabilities
   * @param {NodeJS.ProcessEnv} env
   */
  static async start(file, capabilities, env) {
    const port = await freePort();
    const end = killAtExit(spawn(file, [`--port=${port}`], { env, stdio: 'ignore' }));
    try {
      const address = `http://127.0.0.1:${port}`;
      await listening(address);
      const { sessionId } = await ask('POST', `${address}/session`, {
        capabilities: { alwaysMatch: capabilities },
      });
      return new Session(`${address}/session/${sessionId}`, end);
    } catch (error) {
      end();
      throw error;
    }
  }

  /** @param {string} path */
  get(path) {
    return ask('GET', `${this.address}/${path}`);
  }

  /** @param {string} path @param {object} [body] */
  post(path, body = {}) {
    return ask('POST', `${this.address}/${path}`, body);
  }

  /**
   * Runs a script whose last argument is a function that takes its result.
   * @param {string} script @param {unknown[]} args
   */
  run(script, args) {
    return this.post('execute/async', { script, args });
  }

  async close() {
    // The browser's process ends with its session.
    await ask('DELETE', this.address).finally(this.end);
  }
}

/** @param {string} method @param {string} url @param {object} [body] */
async function ask(method, url, body) {
  const response = await fetch(url, { method, body: body && JSON.stringify(body) });
  const { value } = /** @type {any} */ (await response.json());
  if (!response.ok) throw new Error(`WebDriver: ${value.error}: ${value.message}`);
  return value;
}

/** @param {string} address */
async function listening(address) {
  for (let left = TRIES; ; left -= 1) {
    try {
      await ask('GET', `${address}/status`);
      return;
    } catch (error) {
      if (left === 0) throw error;
      await sleep(50);
    }
  }
}

/** A free port of this machine. */
async function freePort() {
  const server = createServer();
  await new Promise((resolve) => server.listen(0, '127.0.0.1', () => resolve(undefined)));
  const address = /** @type {import('node:net').AddressInfo} */ (server.address());
  await new Promise((resolve) => server.close(resolve));
  return address.port;
}
