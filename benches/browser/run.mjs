/**
 * Measures Hearth natively, in Node and in headless Chromium, its JavaScript baselines and
 * other programs, and writes one JSON file, named by the argument.
 *
 * A round measures every case once, cases of equal particle numbers in sequence; a figure
 * is the median of the rounds.
 *
 * `HEARTH_BENCH` names the folder with the wasm-bindgen output of this package
 * (`hearth_benches.js`, `--target web`), `HEARTH_NATIVE` its two native programs,
 * `HEARTH_PROGRAMS` the other programs as JSON, `HEARTH_CHROMIUM` the browser, and
 * `HEARTH_SITE` a built site whose page is measured, too.
 */
import { execFile } from 'node:child_process';
import { readFile, writeFile } from 'node:fs/promises';
import os from 'node:os';
import path from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { promisify } from 'node:util';
import { Browser } from '../../tests/e2e/driver.mjs';
import { parse, value } from './lines.mjs';
import { Bench } from './measure.mjs';
import { onThePage } from './page.mjs';

const HERE = path.dirname(fileURLToPath(import.meta.url));
const ROUNDS = Number(process.env.HEARTH_ROUNDS ?? 7);

/** Numbers of particles; peers are too slow for more than 100,000, the paper's loop for 5,000. */
const SIZES = [1000, 5000, 20_000, 100_000, 400_000];
const PEERS = 100_000;
const PAPER = 5000;

/** @type {import('./measure.mjs').Case[]} */
const CASES = [
  ...SIZES.flatMap((count) => [
    { scene: 'block', count },
    ...(count <= PEERS
      ? [
          { scene: 'typed', count },
          { scene: 'scan', count },
        ]
      : []),
    ...(count <= PAPER ? [{ scene: 'paper', count }] : []),
  ]),
  // The default of the combustion model, and a block with as many neighbours as it has.
  { scene: 'block', count: 3000, neighbours: 28 },
  { scene: 'combustion', count: 3000, stiffness: 6 },
  { scene: 'combustion', count: 6700, stiffness: 10 },
  ...[1000, 5000, 20_000].map((count) => ({ scene: 'plume', count })),
];

/** The lowest level, which the automatic choice takes on a slow machine, and how slow that one is. */
const PHONE = { scene: 'combustion', count: 1500, stiffness: 6 };
const SLOWER = 4;

/** This process as a place to measure. */
async function inNode(folder) {
  const module = await import(pathToFileURL(path.join(folder, 'hearth_benches.js')).href);
  const bytes = await readFile(path.join(folder, 'hearth_benches_bg.wasm'));
  await module.default({ module_or_path: bytes });
  const bench = new Bench(module);
  return { name: 'node', call: async (method, ...args) => bench[method](...args) };
}

/** A page of headless Chromium as a place to measure. */
async function inChromium(tab) {
  await tab.evaluate(async () => {
    const load = (/** @type {string} */ url) => import(url);
    const module = await load('/hearth_benches.js');
    const { Bench } = await load('/measure.mjs');
    await module.default();
    Object.assign(window, { bench: new Bench(module) });
  });
  return {
    name: 'chromium',
    call: (method, ...args) =>
      tab.evaluate(
        // What is undefined would not arrive as such.
        (called, given) => /** @type {any} */ (window).bench[called](...given) ?? null,
        method,
        args,
      ),
  };
}

/** What a program prints. */
async function output([program, ...args], env, ...more) {
  const { stdout } = await promisify(execFile)(program, [...args, ...more.map(String)], {
    env: { ...process.env, ...env },
    maxBuffer: 2 ** 28,
  });
  return stdout;
}

/** Steps that a program is to measure with so many particles. */
const steps = (count) => Math.min(200, Math.max(5, Math.round(300_000 / count)));

/**
 * Everything that can be measured: each has its number of particles, what it is
 * called in a report, and a way to measure it once.
 */
async function contestants(places, native, programs, leftOut) {
  const all = [];
  for (const place of places) {
    for (const what of CASES) {
      const id = Object.values(what).join(' ');
      log(`${place.name}: ${id}`);
      const refused = await place.call('prepare', id, what);
      if (refused) {
        leftOut.push(`${id} in ${place.name}: ${refused}`);
        continue;
      }
      const measure = async () => {
        const stepMs = await place.call('round', id);
        const about = await place.call('about', id);
        return [{ name: 'Hearth', where: place.name, ...what, ...about, stepMs }];
      };
      all.push({ id, count: what.count, measure });
    }
  }
  for (const what of CASES.filter(({ scene }) => scene === 'combustion')) {
    const measure = async () => {
      const row = await output([native], {}, 'fire', what.count, what.stiffness, steps(what.count));
      return [{ name: 'Hearth', where: 'native', ...what, ...JSON.parse(row) }];
    };
    all.push({ id: Object.values(what).join(' '), count: what.count, measure });
  }
  for (const { command, env, most = Infinity, yardstick = false } of programs) {
    for (const count of SIZES.filter((size) => size <= most)) {
      const measure = async () => {
        const lines = parse(await output(command, env, count, steps(count)));
        return lines.map((line) => ({ scene: 'block', count, yardstick, ...line }));
      };
      const id = `${count} particles in ${path.basename(command.at(-1))}`;
      all.push({ id, count, measure, outside: true });
    }
  }
  return all.sort((a, b) => a.count - b.count);
}

/** Measures all of them in rounds: medians and best rounds. `before` comes before each round. */
async function compete(all, leftOut, before) {
  const figures = new Map();
  for (let round = 1; round <= ROUNDS; round += 1) {
    log(`round ${round} of ${ROUNDS}`);
    await before();
    for (const contestant of all) {
      if (contestant.failed) continue;
      try {
        for (const row of await contestant.measure()) {
          const key = [row.name, row.where, contestant.id].join();
          const times = figures.get(key)?.times ?? [];
          figures.set(key, { row, times: [...times, row.stepMs] });
        }
      } catch (error) {
        if (!contestant.outside) throw error;
        // Its last line; the command itself is of this machine.
        const why = error.stderr?.trim().split('\n').at(-1) || `ended by ${error.signal ?? error.code}`;
        leftOut.push(`${contestant.id}: ${why}`);
        contestant.failed = true;
      }
    }
  }
  return [...figures.values()].map(({ row, times }) => ({
    ...row,
    stepMs: median(times),
    bestStepMs: Math.min(...times),
  }));
}

function median(numbers) {
  return [...numbers].sort((a, b) => a - b)[numbers.length >> 1];
}

/** Measures the peak rate of each place again, and keeps the best. */
async function peak(best, places, native) {
  const note = (name, gflops) => {
    best[name] = Math.max(best[name] ?? 0, gflops);
  };
  note('native', value(await output([native], {}, 'peak'), 'gflops'));
  for (const place of places) {
    for (let again = 0; again < 5; again += 1) note(place.name, await place.call('gigaflops'));
  }
}

/** A frame's steps on a page as it is, and on one whose processor Chromium slows down. */
async function throttled(place, tab) {
  await place.call('prepare', 'phone', PHONE);
  const session = await tab.page.createCDPSession();
  const times = { 1: [], [SLOWER]: [] };
  for (let round = 0; round < ROUNDS; round += 1) {
    for (const rate of [1, SLOWER]) {
      await session.send('Emulation.setCPUThrottlingRate', { rate });
      times[rate].push(await place.call('round', 'phone'));
    }
  }
  await session.send('Emulation.setCPUThrottlingRate', { rate: 1 });
  const { particles, stepsPerFrame } = await place.call('about', 'phone');
  return {
    rate: SLOWER,
    particles,
    stepsPerFrame,
    stepMs: median(times[SLOWER]),
    bestStepMs: Math.min(...times[SLOWER]),
    freeStepMs: median(times[1]),
  };
}

/** Bytes that blocks of Hearth take. */
async function memory(program) {
  const taken = [];
  for (const count of SIZES) {
    try {
      taken.push({ particles: count, bytes: value(await output([program], {}, count), 'bytes') });
    } catch {
      // More than the model takes: the rounds report it already.
    }
  }
  return taken;
}

function log(text) {
  process.stderr.write(`  ${text}\n`);
}

const [, , file] = process.argv;
const folder = process.env.HEARTH_BENCH;
const native = process.env.HEARTH_NATIVE;
if (!file || !folder || !native) throw new Error('run this by `cargo measure bench`');
const others = JSON.parse(process.env.HEARTH_PROGRAMS ?? '{}');
const program = path.join(native, 'native');
const programs = [{ command: [program] }, ...(others.programs ?? [])];
const leftOut = others.leftOut ?? [];

// The root, for the paper's loop: the page of the tables measures it too.
const browser = await Browser.start({
  kind: 'chromium',
  folders: [folder, HERE, path.join(HERE, '../..')],
  likeGraphicsCard: true,
});
const report = {};
try {
  const tab = await browser.open('<p>Measuring</p>');
  const places = [await inNode(folder), await inChromium(tab)];
  const all = await contestants(places, program, programs, leftOut);
  report.peaks = {};
  const before = () => peak(report.peaks, places, program);
  report.results = await compete(all, leftOut, before);
  report.throttled = await throttled(places[1], tab);
  report.browser = await browser.browser.version();
} finally {
  await browser.close();
}
report.memory = await memory(path.join(native, 'memory'));
if (process.env.HEARTH_SITE) report.page = await onThePage(process.env.HEARTH_SITE);

const [processor] = os.cpus();
await writeFile(
  file,
  `${JSON.stringify(
    {
      machine: {
        processor: processor.model.trim(),
        cores: os.cpus().length,
        system: `${os.type()} ${os.arch()}`,
      },
      node: process.version,
      rounds: ROUNDS,
      ...report,
      leftOut,
    },
    null,
    2,
  )}\n`,
);
