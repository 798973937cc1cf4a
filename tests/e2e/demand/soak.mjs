/**
 * A page on which visitors do everything at random, together some ten times as often as a person: scenes, panel, tools, undo,
 * children, sound, films, lost contexts, a hidden tab, and the fire comes and goes. `cargo measure soak --page MINUTES` runs it.
 * Seven times it rests: objects of scripts and of the document, arrays, wasm, objects of the graphics card, nodes, listeners
 * and workers have grown by a twentieth at most since the second rest, and nothing was reported but refusals and lost contexts.
 * The size of compiled code and the time of a frame are printed alone: the code grows up to all that there is, the time is the
 * machine's.
 *
 * The arguments are the file of the table and the minutes.
 */
import { writeFileSync } from 'node:fs';
import { STAGE, installActors } from '../actors.mjs';
import { Browser } from '../driver.mjs';
import { held } from '../held.mjs';
import { becomes } from '../waits.mjs';

/** Rounds of a run with a rest after each, those that warm up, and the growth of what is held. */
const [ROUNDS, WARM, GROWTH] = [7, 2, 0.05];

/** Visitors that act at the same time, and the longest time between two actions of one [ms]. */
const [VISITORS, BETWEEN_MS] = [4, 100];

/** Pictures whose time is measured in a rest. */
const MEASURED = 120;

/** What visitors of this page cause: random values may be refused, and contexts are lost. */
const EXPECTED =
  /is refused|context (was|is) lost|CONTEXT_LOST|GPU stall|the fire was removed|AudioContext|restoration not allowed/;

/** Runs in the page before its scripts: the actors count frames of the real clock. */
function realClock() {
  /** @type {any} */ (window).clock = { next: () => undefined, cost: 0, runs: true };
}

/**
 * Runs in the page: visitors act for so long. Returns the number of actions.
 * @param {number} seed @param {number} milliseconds @param {number} visitors @param {number} between
 */
async function act(seed, milliseconds, visitors, between) {
  const { actions, fire, log, pick, random, sow } = /** @type {any} */ (window).actors;
  sow(seed);
  const extra = {
    sound: [() => (fire.sound = random(2) / 2)],
    films: [() => fire.record({ format: pick(['webp', 'gif', 'apng']), fps: 25, seconds: 0.1, width: 32, height: 32 })],
    playing: [() => fire.play(), () => fire.pause(), () => fire.stir(0, 0.4, 1, 0), () => fire.sparks(0, 0.3)],
    again: [() => /** @type {any} */ (document.querySelector('.hearth-panel-message button'))?.click()],
  };
  // An engine that stops three times in a minute ends the fire: another file holds that.
  const [, , reinsert] = actions.restart;
  const actors = Object.values({ ...actions, ...extra, restart: [reinsert] });
  const wait = (/** @type {number} */ time) => new Promise((resolve) => setTimeout(resolve, time));
  const end = Date.now() + milliseconds;
  let done = 0;
  const visitor = async () => {
    for (; Date.now() < end; done += 1) {
      // What waits for an answer that a hidden page does not give does not hold the next action up.
      const acted = (async () => pick(pick(actors))())().catch(() => {});
      await Promise.race([acted, wait(20 * between)]);
      await wait(random(between));
      log.length = 0;
    }
  };
  await Promise.all(Array.from({ length: visitors }, visitor));
  return done;
}

/** Particles of a fire that demands more memory than visitors do. */
const LARGE = 20_000;

/**
 * Runs in the page: two large fires are filmed at once. Wasm keeps its highest mark: with the same mark in each round, what
 * it holds besides is above it.
 * @param {number} particles
 */
async function demand(particles) {
  const { fire, other, frames } = /** @type {any} */ (window).actors;
  const film = { format: 'gif', fps: 25, seconds: 0.08, width: 32, height: 32 };
  const filmed = async (/** @type {any} */ it) => {
    await it.importConfig({ preset: 'default' });
    await it.set({ particles });
    // A film that a visitor began may not have ended.
    while (!(await it.record(film).catch(() => null))) await frames(10);
    await it.importConfig({ preset: 'default' });
  };
  await Promise.all([fire, other].map(filmed));
}

/** Runs in the page: the default fire again, without what the actors made; returns the mean time of a frame [ms]. */
async function rest(/** @type {number} */ measured) {
  const { fire, frames } = /** @type {any} */ (window).actors;
  fire.sound = 0;
  fire.replaceChildren();
  await fire.importConfig({ preset: 'default' });
  await fire.play();
  // A step that no move of the history leads to is forgotten.
  for (let step = 0; step < 210; step += 1) await fire.history.step(() => fire.set('wind', (step % 10) / 20));
  await fire.importConfig({ preset: 'default' });
  await frames(measured);
  const start = performance.now();
  await frames(measured);
  return (performance.now() - start) / measured;
}

/** What browsers compile more of for as long as a page runs, up to all of its code. */
const COMPILED = /WasmNativeModule|WeakArrayList/;

/**
 * The size of all objects of a page and its workers, in all and by name, that of the data of arrays, wasm's memory among it,
 * and that of compiled code [bytes].
 * @param {import('../driver.mjs').Tab} tab
 */
async function sizes(tab) {
  const session = await tab.page.createCDPSession();
  const size = { objects: 0, arrays: 0, code: 0, byName: new Map() };
  for (const heap of [session, ...tab.page.workers().map((worker) => worker.client)]) {
    let text = '';
    const add = (/** @type {{chunk: string}} */ { chunk }) => (text += chunk);
    heap.on('HeapProfiler.addHeapSnapshotChunk', add);
    await heap.send('HeapProfiler.takeHeapSnapshot', {});
    heap.off('HeapProfiler.addHeapSnapshotChunk', add);
    const { snapshot, nodes, strings } = JSON.parse(text);
    const { node_fields: fields, node_types: types } = snapshot.meta;
    const [type, name, bytes] = ['type', 'name', 'self_size'].map((field) => fields.indexOf(field));
    for (let at = 0; at < nodes.length; at += fields.length) {
      const [kind, own] = [types[type][nodes[at + type]], strings[nodes[at + name]]];
      const isCode = kind === 'code' || COMPILED.test(own);
      const isData = own.endsWith('JSArrayBufferData');
      size[isCode ? 'code' : isData ? 'arrays' : 'objects'] += nodes[at + bytes];
      if (isCode) continue;
      const of = `${kind} ${own.slice(0, 40)}`;
      size.byName.set(of, (size.byName.get(of) ?? 0) + nodes[at + bytes]);
    }
  }
  await session.detach();
  return size;
}

const [file, given] = process.argv.slice(2);
const minutes = Number(given);
if (!(minutes > 0)) throw new Error(`the arguments are a file and a number of minutes, not "${given}"`);
const rows = [
  '| after | actions | objects | data of arrays | compiled code | wasm | objects of the graphics card | nodes | listeners | workers | a frame |',
  '|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|',
];
const MEGABYTE = 1_000_000;
// The headless shell hides no tab.
const browser = await Browser.start();
try {
  const tab = await browser.open(STAGE, { width: 680, height: 800, before: realClock });
  await tab.evaluate(installActors);
  const other = await browser.browser.newPage();
  await tab.page.bringToFront();
  // The driver waits four minutes for an answer.
  const parts = Math.max(2, Math.ceil(minutes / ROUNDS));
  const length = (minutes * 60_000) / ROUNDS / parts;
  /** @type {any} */
  let first;
  /** @type {Map<string, number>} */
  let before = new Map();
  const wrong = [];
  for (let round = 1; round <= ROUNDS; round += 1) {
    let actions = 0;
    for (let part = 0; part < parts; part += 1) {
      actions += await tab.evaluate(act, parts * round + part, length, VISITORS, BETWEEN_MS);
      if (part === 0) await tab.loseContext(300);
      await other.bringToFront();
      await tab.evaluate(becomes, /** @type {const} */ ('hidden'));
      // The engine answers in a hidden page, too.
      await tab.fire((fire) => fire.set('exposure', 1));
      await tab.page.bringToFront();
      await tab.evaluate(becomes, /** @type {const} */ ('visible'));
    }
    await tab.evaluate(demand, LARGE);
    const frame = await tab.evaluate(rest, MEASURED);
    const { memory, objects: graphics, nodes, jsEventListeners: listeners, workers } = await held(tab);
    const { objects, arrays, code, byName } = await sizes(tab);
    const now = { objects, arrays, wasm: memory, graphics, nodes, listeners, workers };
    const time = `${((round * minutes) / ROUNDS).toFixed(1)} min`;
    const [made, data, compiled, wasm] = [objects, arrays, code, memory].map(
      (size) => `${(size / MEGABYTE).toFixed(2)} MB`,
    );
    const cells = [
      time,
      actions,
      made,
      data,
      compiled,
      wasm,
      graphics,
      nodes,
      listeners,
      workers,
      `${frame.toFixed(1)} ms`,
    ];
    rows.push(`| ${cells.join(' | ')} |`);
    console.log(rows.at(-1));
    const more = [...byName].map(([name, bytes]) => [bytes - (before.get(name) ?? 0), name]);
    const most = more.toSorted(([a], [b]) => b - a).slice(0, 5);
    console.log(`  most more than before: ${most.map(([bytes, name]) => `${bytes} ${name}`).join(', ')}`);
    before = byName;
    // The first rounds load and compile code, and wasm grows to the largest scene.
    if (round === WARM) first = now;
    const problems = tab.problems.splice(0).filter((problem) => !EXPECTED.test(problem));
    wrong.push(...problems);
    for (const [name, value] of Object.entries(first ?? {})) {
      const more = /** @type {any} */ (now)[name] / value - 1;
      if (round === ROUNDS && more > GROWTH) wrong.push(`${name}: ${(100 * more).toFixed(1)} % more than ${value}`);
    }
  }
  if (wrong.length > 0) {
    console.log([...new Set(wrong)].join('\n'));
    process.exitCode = 1;
  }
} finally {
  await browser.close();
}
writeFileSync(file, `${rows.join('\n')}\n`);
