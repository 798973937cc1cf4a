/**
 * The k-th call of a kind fails in a short run: a fire burns, its visitor takes two steps, and a film is recorded. The
 * fire burns again, at the latest when its visitor presses the button, with every step that it accepted, and undo leads
 * back. The film is whole, or its promise rejects with a reason.
 */
import { Browser } from '../../driver.mjs';
import { struck } from './counted.mjs';
import { limited } from './memory.mjs';
import { outcome, retry } from './outcome.mjs';

/** @typedef {import('./outcome.mjs').Finding} Finding */
/** @typedef {'webgl' | 'fetch' | 'message' | 'allocation' | 'canvas'} Kind */

/** Few pixels and particles: a case is about calls alone. */
const BODY = `<hearth-fire quality="low" particles="400" max-pixels="3000" style="width: 120px; height: 150px">
  <p slot="poster">A poster</p></hearth-fire>`;

/** Maximum real time until each of a run's promises settles [ms]. */
const SETTLED_MS = 60_000;

/**
 * Runs in the page and in its workers before their scripts: spoils the call of that number on a thread; 0 spoils none
 * and posts how many there are.
 * @param {Kind} kind @param {number} number @param {string} thread  `page`, `engine` or `film`
 */
function spoil(kind, number, thread) {
  const scope = /** @type {any} */ (globalThis);
  const own = scope.document ? 'page' : scope.name === 'hearth-film' ? 'film' : 'engine';
  const channel = number === 0 ? new BroadcastChannel('calls') : undefined;
  let calls = 0;
  const fails = () => {
    calls += 1;
    channel?.postMessage([own, calls]);
    return own === thread && calls === number;
  };
  const failure = (/** @type {string} */ name) => new Error(`${name} fails in a test`);
  /** @type {(holder: any, name: string, give?: (name: string) => unknown, counts?: (first: any) => boolean) => void} */
  const method = (holder, name, give, counts = () => true) => {
    const original = holder?.[name];
    if (typeof original !== 'function') return;
    holder[name] = function spoilt(...args) {
      if (!counts(args[0]) || !fails()) return original.apply(this, args);
      if (give) return give(name);
      throw failure(name);
    };
  };
  /** @type {(name: string, counts?: (first: any) => boolean) => void} */
  const made = (name, counts = () => true) => {
    if (!scope[name]) return;
    scope[name] = new Proxy(scope[name], {
      construct(original, args, target) {
        if (counts(args[0]) && fails()) throw new RangeError(`${name}: allocation failed in a test`);
        return Reflect.construct(original, args, target);
      },
    });
  };
  const canvases = [scope.HTMLCanvasElement, scope.OffscreenCanvas].map((type) => type?.prototype);
  const rejects = (/** @type {string} */ name) => Promise.reject(failure(name));
  if (kind === 'webgl') {
    const { prototype } = scope.WebGL2RenderingContext;
    const members = Object.entries(Object.getOwnPropertyDescriptors(prototype));
    for (const [name, { value }] of members)
      if (typeof value === 'function' && name !== 'constructor') method(prototype, name);
  } else if (kind === 'fetch') {
    method(scope, 'fetch', () => Promise.reject(new TypeError('Failed to fetch')));
  } else if (kind === 'message') {
    method(scope.document ? scope.Worker.prototype : scope, 'postMessage');
  } else if (kind === 'allocation') {
    const arrays = ['Uint8', 'Uint8Clamped', 'Int8', 'Uint16', 'Int16', 'Uint32', 'Int32', 'Float32', 'Float64'];
    // A view allocates no bytes.
    const copies = (/** @type {any} */ first) => !/ArrayBuffer|Memory/.test(Object.prototype.toString.call(first));
    for (const name of arrays) made(`${name}Array`, copies);
    for (const name of ['ArrayBuffer', 'Blob', 'ImageData']) made(name);
  } else {
    for (const prototype of canvases) {
      method(prototype, 'getContext', () => null);
      method(prototype, 'transferToImageBitmap');
      method(prototype, 'convertToBlob', rejects);
    }
    method(scope, 'createImageBitmap', rejects);
    made('OffscreenCanvas');
  }
}

/** Runs in the page before its scripts: counts the calls of every thread. */
function listen() {
  const counted = /** @type {any} */ (window);
  counted.calls = {};
  new BroadcastChannel('calls').onmessage = ({ data: [thread, calls] }) => {
    counted.calls[thread] = calls;
  };
}

/**
 * Runs in the page: the short run. Returns what settled, and how.
 * @param {number} limit  Maximum time of each promise [ms].
 */
async function run(limit) {
  const fire = /** @type {any} */ (document.querySelector('hearth-fire'));
  const defined = customElements.whenDefined('hearth-fire');
  await Promise.race([defined, new Promise((resolve) => setTimeout(resolve, 5000))]);
  if (!fire.history) return { steps: [], film: 'no script' };
  /** @type {(asked: () => Promise<any>) => Promise<any>} */
  const settled = async (asked) => {
    const late = new Promise((resolve) => setTimeout(() => resolve({ late: true }), limit));
    const answer = (async () => asked())().then(
      (value) => ({ value: value ?? null }),
      (error) => ({ why: String(error?.message ?? error) }),
    );
    return Promise.race([answer, late]);
  };
  const { step } = fire.history;
  const steps = [
    await settled(() => step.call(fire.history, () => fire.set({ wind: 0.5 }))),
    await settled(() => step.call(fire.history, () => fire.addObject({ kind: 'solid', x: 0.3, y: 0.7 }))),
  ];
  const { value, ...film } = await settled(() =>
    fire.record({ format: 'apng', fps: 25, seconds: 0.12, width: 48, height: 60 }),
  );
  if (!value) return { steps, film: JSON.stringify(film) };
  // Each picture has a chunk of that name, and the last chunk ends the file.
  const file = new TextDecoder('latin1').decode(await value.arrayBuffer());
  return { steps, film: file.slice(-8, -4) === 'IEND' ? file.split('fcTL').length - 1 : 'a part of a film' };
}

/**
 * Runs in the page: what is wrong with a fire that accepted these steps.
 * @param {any[]} steps
 */
async function lost(steps) {
  const fire = /** @type {any} */ (document.querySelector('hearth-fire'));
  const [wind, object] = steps.map((step) => 'value' in step);
  const wrong = [];
  if (wind && fire.params.wind !== 0.5) wrong.push(`wind is ${fire.params.wind}`);
  if (object && !fire.objects.some((/** @type {any} */ { id }) => id === steps[1].value)) wrong.push('no object');
  let undone = 0;
  while (await fire.history.undo()) undone += 1;
  const made = [wind, object].filter(Boolean).length;
  // A step whose answer was lost may have been done.
  if (undone < made) wrong.push(`${undone} of ${made} steps were undone`);
  if (fire.params.wind !== 0 || fire.objects.length !== 1) {
    wrong.push(`undone, wind is ${fire.params.wind}, and there are ${fire.objects.length} objects`);
  }
  return wrong;
}

/**
 * Opens a page whose call of that number fails, and does the run.
 * @param {Browser} browser @param {[Kind, number, string]} fault
 * @param {{[name: string]: import('../../server.mjs').Instead}} [files]
 */
async function opened(browser, fault, files) {
  const act = /** @type {any} */ (`() => (${spoil})(...${JSON.stringify(fault)})`);
  const before = /** @type {any} */ (`() => { (${listen})(); (${act})() }`);
  const tab = await browser.open(BODY, { before, beforeWorker: act, files });
  return { tab, done: await tab.evaluate(run, SETTLED_MS) };
}

/**
 * What became of a run: of its fire, its steps and its film.
 * @param {import('../../driver.mjs').Tab} tab @param {Awaited<ReturnType<typeof run>>} done
 * @param {string} fault @param {unknown} whole  The pictures of a whole film.
 * @param {boolean} [lasts]  Whether the fault strikes again and again.
 * @returns {Promise<Finding>}
 */
async function judged(tab, done, fault, whole, lasts = false) {
  const found = await outcome(tab, fault);
  // Without the element's script nobody can try again.
  if (found.outcome === 'silent' || done.film === 'no script') return found;
  const wrong = [];
  if (found.outcome === 'reported' && !lasts) {
    await retry(tab);
    const again = await outcome(tab, fault);
    if (again.outcome !== 'burns') wrong.push(`tried again: ${again.detail}`);
  }
  const late = [...done.steps, done.film].filter((step) => JSON.stringify(step).includes('late'));
  if (late.length > 0) wrong.push(`never settled: ${JSON.stringify(done)}`);
  const made = !done.film.toString().startsWith('{');
  if (made && done.film !== whole) wrong.push(`the film has ${done.film} pictures, not ${whole}`);
  if (wrong.length === 0 && done.steps.length > 0 && !(lasts && found.outcome === 'reported')) {
    const unanswered = new Promise((resolve) => setTimeout(() => resolve(['undo never settled']), SETTLED_MS));
    const asked = tab.evaluate(lost, done.steps).catch((error) => [`undo: ${error.message}`]);
    wrong.push(.../** @type {string[]} */ (await Promise.race([asked, unanswered])));
    // The fault may end the fire while undo leads back. Nothing else excuses a step that is lost.
    const ended = lasts && wrong[0]?.startsWith('undo: ') && (await outcome(tab, fault));
    if (ended && ended.outcome === 'reported') return ended;
  }
  return wrong.length === 0 ? found : { fault, outcome: 'silent', detail: wrong.join('; ') };
}

/**
 * The failures of a kind of call on each thread.
 * @param {Kind} kind
 * @returns {() => AsyncGenerator<Finding>}
 */
export const callsOf = (kind) =>
  async function* calls() {
    const browser = await Browser.launch();
    try {
      const { tab, done } = await opened(browser, [kind, 0, '']);
      const counts = await tab.evaluate(() => /** @type {any} */ (window).calls);
      if (typeof done.film !== 'number') throw new Error(`the run fails without a fault: ${JSON.stringify(done)}`);
      for (const [thread, count] of /** @type {[string, number][]} */ (Object.entries(counts))) {
        for (const number of struck(count)) {
          const fault = `${kind} ${number} of ${count}, ${thread}`;
          const failed = await opened(browser, [kind, number, thread]);
          // Each worker counts anew, so that the fault strikes the engine that follows, too.
          yield await judged(failed.tab, failed.done, fault, done.film, thread !== 'page');
        }
      }
    } finally {
      await browser.close();
    }
  };

/** The memory of the engine's wasm grows no more, from each of its pages on. @returns {AsyncGenerator<Finding>} */
export async function* memory() {
  const browser = await Browser.launch();
  try {
    const { tab, done } = await opened(browser, ['fetch', 0, '']);
    const used = (await tab.living()).memory;
    const { least, module } = limited();
    for (const page of struck(used / 65_536 - least)) {
      const files = { 'hearth-engine_bg.wasm': { body: module(least + page - 1), type: 'application/wasm' } };
      const failed = await opened(browser, ['fetch', -1, ''], files);
      yield await judged(failed.tab, failed.done, `page ${page} of memory`, done.film, true);
    }
  } finally {
    await browser.close();
  }
}
