/**
 * A virtual display: Firefox has no WebGL2 without a window, and WebKit has no headless
 * mode.
 */
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { program } from './programs.mjs';

/** @typedef {{name: string, close: () => void}} Display */

/** Its size [px of a page]. */
export const SCREEN = { width: 1600, height: 1200 };

/** @param {number} [ratio]  Its pixels for each of a page's. @returns {Promise<Display>} */
export async function display(ratio = 1) {
  const screen = `${SCREEN.width * ratio}x${SCREEN.height * ratio}x24`;
  // The server picks a free display number and writes it to its fourth file.
  const server = spawn(
    program('HEARTH_XVFB', ['Xvfb'], 'xvfb'),
    ['-displayfd', '3', '-screen', '0', screen, '-nolisten', 'tcp', '-noreset'],
    { stdio: ['ignore', 'ignore', 'ignore', 'pipe'] },
  );
  const close = killAtExit(server);
  const failed = once(server, 'exit').then(([code]) => {
    throw new Error(`Xvfb ended with ${code} before it had a screen`);
  });
  failed.catch(() => {});
  const answered = once(/** @type {any} */ (server.stdio[3]), 'data');
  const [number] = await Promise.race([answered, failed]);
  return { name: `:${String(number).trim()}`, close };
}

/** Running programs. @type {Set<import('node:child_process').ChildProcess>} */
const running = new Set();
let watched = false;

/**
 * Returns a function that kills a program; the exit of this process kills it, too.
 * @param {import('node:child_process').ChildProcess} child
 * @returns {() => void}
 */
export function killAtExit(child) {
  if (!watched) {
    watched = true;
    process.once('exit', () => {
      for (const child of running) child.kill('SIGKILL');
    });
    // A signal would end this process without an exit event.
    for (const signal of ['SIGINT', 'SIGTERM', 'SIGHUP']) process.once(signal, () => process.exit(1));
  }
  running.add(child);
  return () => {
    running.delete(child);
    child.kill('SIGKILL');
  };
}
