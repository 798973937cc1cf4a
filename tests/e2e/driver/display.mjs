/**
 * A screen that nobody sees. Firefox has no WebGL2 without a window, and WebKit
 * no mode without one.
 */
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { program } from './programs.mjs';

/** @typedef {{name: string, close: () => void}} Display */

/** @returns {Promise<Display>} */
export async function display() {
  // The server picks a free number by itself and says which, in its fourth file.
  const server = spawn(
    program('HEARTH_XVFB', ['Xvfb'], 'xvfb'),
    ['-displayfd', '3', '-screen', '0', '1600x1200x24', '-nolisten', 'tcp', '-noreset'],
    { stdio: ['ignore', 'ignore', 'ignore', 'pipe'] },
  );
  const close = untilTheEnd(server);
  const failed = once(server, 'exit').then(([code]) => {
    throw new Error(`Xvfb ended with ${code} before it had a screen`);
  });
  failed.catch(() => {});
  const said = once(/** @type {any} */ (server.stdio[3]), 'data');
  const [number] = await Promise.race([said, failed]);
  return { name: `:${String(number).trim()}`, close };
}

/** What still runs. @type {Set<import('node:child_process').ChildProcess>} */
const running = new Set();
let watched = false;

/**
 * Ends a program when it is closed, and at the latest with this process.
 * @param {import('node:child_process').ChildProcess} child
 * @returns {() => void}
 */
export function untilTheEnd(child) {
  if (!watched) {
    watched = true;
    process.once('exit', () => { for (const one of running) one.kill('SIGKILL'); });
    // A signal would end this process without that event.
    for (const signal of ['SIGINT', 'SIGTERM', 'SIGHUP']) process.once(signal, () => process.exit(1));
  }
  running.add(child);
  return () => {
    running.delete(child);
    child.kill('SIGKILL');
  };
}
