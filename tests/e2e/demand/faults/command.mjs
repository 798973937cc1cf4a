/**
 * The k-th system call of a kind fails in each thread of the command `hearth`, through strace: writing, keeping and
 * naming files, opening them, and memory. The film is whole, or the command ends with a reason; every file is whole or
 * is not there, and an old one stays as it was. Calls before the command's own, of the loader and of Rust, are no cases.
 */
import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { program } from '../../driver/programs.mjs';
import { struck } from './counted.mjs';

/** The calls, and how each fails: `brk` gives no error but an end that has not moved. @type {[call: string, fails: string][]} */
const CALLS = [
  ['write', 'error=ENOSPC'],
  ['fsync', 'error=EIO'],
  ['rename', 'error=EACCES'],
  ['openat', 'error=EMFILE'],
  ['mmap', 'error=ENOMEM'],
  ['brk', 'retval=0'],
];

/** A film of some forty files in a folder that has two of them. */
const FILM = 'film candle --as png --force --seconds 1.4 --from 0.1 --size 32x32 --quality low --out';
const OLD = { '00001.png': 'an old picture', 'notes.txt': 'notes' };

const QUIET = /** @type {const} */ ({
  encoding: 'utf8',
  timeout: 60_000,
  env: { ...process.env, RUST_BACKTRACE: '0' },
});

/** The most calls of a kind of one thread in strace's log. @param {string} log */
const mostOfAThread = (log) => (/** @type {string} */ call) => {
  /** @type {Map<string, number>} */
  const counts = new Map([['', 0]]);
  for (const [, thread] of log.matchAll(new RegExp(`^(\\d+) +${call}\\(`, 'gm'))) {
    counts.set(thread, (counts.get(thread) ?? 0) + 1);
  }
  return Math.max(...counts.values());
};

/** @returns {AsyncGenerator<import('./outcome.mjs').Finding>} */
export async function* command() {
  const hearth = program('HEARTH_COMMAND', ['hearth'], 'hearth');
  const strace = program('HEARTH_STRACE', ['strace'], 'strace');
  const place = mkdtempSync(path.join(tmpdir(), 'hearth-faults-'));
  const out = path.join(place, 'film');
  const log = path.join(place, 'calls');
  /** Burns the film under strace. @param {...string} options */
  const film = (...options) => {
    rmSync(out, { recursive: true, force: true });
    mkdirSync(out);
    for (const [name, text] of Object.entries(OLD)) writeFileSync(path.join(out, name), text);
    const traced = ['-f', '-o', log, ...options, hearth, ...FILM.split(' '), out];
    const { status, signal, stderr } = spawnSync(strace, traced, QUIET);
    const files = Object.fromEntries(readdirSync(out).map((name) => [name, readFileSync(path.join(out, name), 'hex')]));
    return { status, signal, stderr, files };
  };
  try {
    const { status, stderr, files: whole } = film('-e', `trace=${CALLS.map(([call]) => call)}`);
    if (status !== 0) throw new Error(`the film fails without a fault: ${stderr}`);
    const calls = mostOfAThread(readFileSync(log, 'utf8'));
    spawnSync(strace, ['-f', '-o', log, hearth, '--version'], QUIET);
    const before = mostOfAThread(readFileSync(log, 'utf8'));
    for (const [call, fails] of CALLS) {
      for (const number of struck(calls(call) - before(call))) {
        const made = film('-e', `inject=${call}:${fails}:when=${before(call) + number}`);
        yield { fault: `${call} ${number} with ${fails}`, ...judged(made, whole) };
      }
    }
  } finally {
    rmSync(place, { recursive: true, force: true });
  }
}

/**
 * @param {{status: number | null, signal: string | null, stderr: string, files: {[name: string]: string}}} made
 * @param {{[name: string]: string}} whole
 * @returns {Omit<import('./outcome.mjs').Finding, 'fault'>}
 */
function judged({ status, signal, stderr, files }, whole) {
  const old = Object.entries(OLD).map(([name, text]) => [name, Buffer.from(text).toString('hex')]);
  const before = Object.fromEntries(old);
  const wrong = Object.entries(files).filter(([name, bytes]) => bytes !== whole[name] && bytes !== before[name]);
  const missing = Object.keys(status === 0 ? whole : before).filter((name) => !(name in files));
  const stale = status === 0 && Object.entries(whole).some(([name, bytes]) => files[name] !== bytes);
  const why = stderr.trim().split('\n').at(-1) ?? '';
  const detail = `status ${status ?? signal}: ${why}`;
  if (wrong.length > 0) return { outcome: 'silent', detail: `${wrong[0][0]} is not whole; ${detail}` };
  if (missing.length > 0) return { outcome: 'silent', detail: `${missing[0]} is missing; ${detail}` };
  if (stale) return { outcome: 'silent', detail: `an old picture stayed; ${detail}` };
  if (status === 0) return { outcome: 'burns' };
  const isSaid = why !== '' && !stderr.includes('panicked');
  return { outcome: isSaid ? 'reported' : 'silent', detail };
}
