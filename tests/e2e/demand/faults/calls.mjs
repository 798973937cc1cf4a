/**
 * Random calls of the element's methods, properties and attributes, with values of every kind, in every
 * browser. Each call settles, refusals are errors with words, values stay in their ranges, and a fire
 * with its own values again burns.
 */
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { BROWSERS, Browser } from '../../driver.mjs';
import { SITE } from '../../site.mjs';
import { FIRE, outcome } from './outcome.mjs';

const GROUPS = 25;
const CALLS = 40;

/**
 * Runs in the page: makes so many random calls and returns what is wrong.
 * @param {number} seed
 * @param {number} calls
 * @param {{id: string, property: string, attribute: string, min?: number, max?: number, choices?: string[]}[]}
 *   parameters
 */
async function callAtRandom(seed, calls, parameters) {
  const fire = /** @type {any} */ (document.querySelector('hearth-fire'));
  let state = seed;
  const random = (/** @type {number} */ below) => {
    state = (state + 0x6d2b79f5) | 0;
    let bits = Math.imul(state ^ (state >>> 15), state | 1);
    bits ^= bits + Math.imul(bits ^ (bits >>> 7), bits | 61);
    return ((bits ^ (bits >>> 14)) >>> 0) % below;
  };
  const oneOf = (/** @type {any} */ all) => all[random(all.length)];
  const odd = () =>
    oneOf([
      undefined,
      null,
      true,
      false,
      10n,
      0,
      -0,
      1,
      -1,
      0.5,
      1e300,
      5e-324,
      NaN,
      Infinity,
      '',
      '0',
      '-1',
      'auto',
      'fire',
      '#f40',
      'NaN',
      '__proto__',
      'x'.repeat(10_000),
      '\u{1f525}',
      '\ud800',
      {},
      [],
      [[]],
      { kind: 'source' },
      { hearth: 3, values: {} },
      Symbol('s'),
      () => 1,
      new Date(0),
      new Map(),
      document,
      window,
      new Proxy({}, {}),
      Object.create(null),
      new Float64Array(3),
      /x/,
      {
        toString() {
          throw new Error('a text that fails');
        },
      },
      { valueOf: () => 0.5 },
      document.all,
    ]);
  const fair = (/** @type {any} */ { min, max, choices }) => {
    if (choices) return oneOf(choices);
    return min === undefined
      ? oneOf([true, false, '#123456'])
      : min + ((Math.min(max, min + 2000) - min) * random(1000)) / 999;
  };
  const parameter = () => oneOf(parameters);
  const pair = () => {
    const known = parameter();
    return { [known.id]: random(4) ? fair(known) : odd() };
  };
  const some = () => (random(3) ? fair({ min: -1, max: 400 }) : odd());
  /** @type {(() => unknown)[]} */
  const acts = [
    () => fire.set(pair()),
    () => fire.set({ ...pair(), ...pair(), ...pair() }),
    () => fire.set(odd(), odd()),
    () => (fire[parameter().property] = random(2) ? odd() : 0.5),
    () => fire.setAttribute(parameter().attribute, random(2) ? '0.5' : 'none of these'),
    () => fire.removeAttribute(parameter().attribute),
    () =>
      fire.setAttribute(
        oneOf(['preset', 'quality', 'fit', 'align', 'warm', 'fps-limit', 'max-pixels', 'seed', 'objects', 'model']),
        oneOf(['', 'auto', 'candle', 'low', '1', 'left', 'cover', '[]', '{', 'classic']),
      ),
    () => fire.addObject(random(2) ? { kind: 'source', x: some(), y: some() } : odd()),
    () => fire.changeObject(random(4), random(2) ? { x: some() } : odd()),
    () => fire.removeObject(random(2) ? random(4) : odd()),
    () => fire.to(random(2) ? pair() : odd(), random(2) ? { seconds: 0.1 } : odd()),
    () => fire.restore(random(2) ? parameter().id : odd()),
    () => fire.importConfig(odd()),
    () => fire.exportConfig().then((/** @type {any} */ config) => fire.importConfig(config)),
    () => fire.step(random(2) ? random(20) : odd()),
    () => fire.stir(some(), some(), some(), some()),
    () => fire.sparks(some(), some(), some()),
    () => fire.spray(some(), some(), some(), some(), some()),
    () => fire.toMetres(some(), some()),
    () => fire.toPixels(some(), some()),
    () => fire.get(random(2) ? parameter().id : odd()),
    () => fire.toBlob(odd(), odd()),
    () => fire.reset(),
    () => fire.play(),
    () => fire.pause(),
    () => (fire.style.width = `${oneOf([0, 1, 60, 120, 400])}px`),
    () => {
      fire.remove();
      document.body.append(fire);
    },
  ];
  /** @type {string[]} */
  const wrong = [];
  const settled = Array.from({ length: calls }, async () => {
    const act = oneOf(acts);
    try {
      await act();
    } catch (error) {
      const words = error instanceof Error && error.message;
      if (!words || words.length > 2000) wrong.push(`${act} was refused with ${String(words).slice(0, 100)}`);
    }
  });
  // A paused fire out of sight makes no steps, and a promise may wait for its size.
  fire.style.width = '';
  await Promise.race([
    Promise.all(settled),
    new Promise((resolve) => setTimeout(resolve, 60_000)).then(() => wrong.push('a call is pending after a minute')),
  ]);
  for (const { id, min, max, choices } of parameters) {
    const value = fire.params[id];
    if (
      choices
        ? !choices.includes(value)
        : min !== undefined && !(Number.isFinite(value) && value >= min - 1e-6 && value <= Number(max) + 1e-6)
    ) {
      wrong.push(`${id} is ${value}`);
    }
  }
  for (const name of fire.getAttributeNames()) if (name !== 'style') fire.removeAttribute(name);
  await Promise.all([fire.restore(), fire.restore('objects'), fire.play()]).catch((error) => wrong.push(error.message));
  return wrong;
}

/** @returns {AsyncGenerator<import('./outcome.mjs').Finding>} */
export async function* calls() {
  const { PARAMETERS } = await import(pathToFileURL(path.join(SITE, 'web/parameters.js')).href);
  for (const kind of BROWSERS) {
    const browser = await Browser.start(kind);
    try {
      const tab = await browser.open(FIRE);
      await tab.burnt(0.1);
      for (let group = 1; group <= GROUPS; group += 1) {
        const fault = `${kind}, seed ${group}`;
        const wrong = await tab.evaluate(callAtRandom, group, CALLS, PARAMETERS);
        wrong.push(...tab.problems.splice(0).filter((problem) => problem.startsWith('uncaught')));
        const found = await outcome(tab, fault);
        yield wrong.length === 0 ? found : { fault, outcome: 'silent', detail: wrong.join('; ').slice(0, 1000) };
      }
    } finally {
      await browser.close();
    }
  }
}
