/** Transitions of values: their steps, and what interrupts them. The animation of the browser is a clock that a test sets. */
import assert from 'node:assert/strict';
import { beforeEach, test } from 'node:test';
import { run } from '../../web/element/session/transition.js';

/** The share of the time of all transitions. */
let clock = 0;
/** Callbacks of the next frame. @type {(() => void)[]} */
const waiting = [];
const page = Object.assign(new EventTarget(), { hidden: false });
Object.assign(globalThis, {
  document: page,
  requestAnimationFrame: (/** @type {() => void} */ act) => waiting.push(act),
  KeyframeEffect: class {
    /** @param {unknown} _target @param {unknown} _frames @param {{easing: string}} timing */
    constructor(_target, _frames, { easing }) {
      if (easing === 'nonsense') throw new TypeError('no easing');
    }
    getComputedTiming() {
      return { progress: clock };
    }
  },
  Animation: class {
    play() {}
    cancel() {}
  },
});
beforeEach(() => {
  clock = 0;
  page.hidden = false;
});

const settled = () => new Promise(setImmediate);

/** A fire whose engine answers at once and refuses a wind of more than 3. @param {{calm?: boolean, isConnected?: boolean}} [how] */
function burning({ calm = false, isConnected = true } = {}) {
  /** @type {{[id: string]: any}} */
  const params = {
    wind: 0,
    exposure: 0,
    time_scale: 0.25,
    viscosity: 0.125,
    model: 'combustion',
    seed: 1,
    background: '#000000',
  };
  /** @type {any} */
  const calls = [];
  /** @type {string[]} */
  const sources = [];
  const fire = {
    isConnected,
    get: (/** @type {string} */ id) => params[id],
    get params() {
      return { ...params };
    },
  };
  const session = /** @type {any} */ ({
    fire,
    playback: { prefersStill: () => calm },
    hexOf: () => '#808080',
    reports: {
      refuse: (/** @type {string} */ id, /** @type {unknown} */ value, /** @type {string} */ allowed) =>
        Object.assign(new RangeError(`${id} = ${value} is refused: it must be ${allowed}`), { id }),
    },
    /** @type {(...call: any[]) => Promise<unknown>} */
    call(...call) {
      const [method, values, ...rest] = call;
      const answer = Promise.resolve().then(() => {
        if (values?.wind > 3) throw new RangeError('wind');
        if (method === 'restore') Object.assign(params, ...values.map((/** @type {any} */ whole) => whole.values));
        if (method !== 'set') return;
        // Another model has other values.
        if (values.model) params.viscosity = 0.25;
        Object.assign(params, values);
        sources.push(rest[0]);
      });
      calls.push([call, answer]);
      answer.catch(() => {});
      return answer;
    },
  });
  return {
    params,
    sources,
    session,
    /** Begins a transition. @param {object} values @param {unknown} [how] */
    to(values, how) {
      const checked = session.call('check', values);
      return run(calls, session, checked, how, 'to');
    },
    /** What another caller sets. @param {object} values */
    set: (values) => session.call('set', values, 'property').catch(() => {}),
    /** Puts the clock. @param {number} share */
    async at(share) {
      clock = share;
      for (let turn = 0; turn < 3; turn += 1) {
        await settled();
        for (const act of waiting.splice(0)) act();
      }
      await settled();
    },
  };
}

test('numbers go evenly, or by equal ratios, and arrive exactly; an easing that overshoots keeps to the ends', async () => {
  const { params, sources, to, at } = burning();
  const done = to({ wind: 1, time_scale: 1 });
  await at(0.5);
  assert.deepEqual([params.wind, params.time_scale], [0.5, 0.5]);
  await at(-0.2);
  assert.deepEqual([params.wind, params.time_scale], [0, 0.25]);
  await at(1.2);
  assert.deepEqual([params.wind, params.time_scale], [1, 1]);
  assert.equal(await done, true);
  assert.ok(sources.length > 2 && sources.every((source) => source === 'to'));
});

test('choices and whole numbers change at once, and the others move from what they are in another model', async () => {
  const { params, to, at } = burning();
  const done = to({ model: 'classic', seed: 7, viscosity: 0.75, background: '#ffffff' });
  await at(0);
  assert.deepEqual([params.model, params.seed, params.viscosity], ['classic', 7, 0.25]);
  await at(0.5);
  assert.deepEqual([params.viscosity, params.background], [0.5, '#808080']);
  await at(1);
  assert.deepEqual([await done, params.viscosity, params.background], [true, 0.75, '#ffffff']);
});

test('a call that sets a value ends its transition, one that is refused does not, and the others continue', async () => {
  const { params, to, set, at } = burning();
  const one = to({ wind: 1, exposure: 1 });
  await at(0.5);
  set({ wind: 9 });
  await at(0.6);
  assert.deepEqual([params.wind, params.exposure], [0.6, 0.6]);
  set({ wind: -1 });
  await at(0.75);
  assert.deepEqual([params.wind, params.exposure], [-1, 0.75]);
  await at(1);
  assert.deepEqual([await one, params.wind, params.exposure], [false, -1, 1]);
});

test('a younger transition goes on from where the older one is', async () => {
  const { params, to, at } = burning();
  const older = to({ wind: 1 });
  await at(0.5);
  clock = 0;
  const younger = to({ wind: -0.5 });
  await at(0);
  assert.deepEqual([params.wind, await older], [0.5, false]);
  await at(0.5);
  assert.equal(params.wind, 0);
  await at(1);
  assert.deepEqual([params.wind, await younger], [-0.5, true]);
});

test('undo ends the transitions of the values that it changes, and settings those of all', async () => {
  const { params, session, to, at } = burning();
  const [wind, exposure, other] = [to({ wind: 1 }), to({ exposure: 1 }), to({ time_scale: 1 })];
  await at(0.5);
  session.call('restore', [{ values: { wind: 0 } }], [{ values: { wind: 0.5 } }], 'property: move');
  await at(0.75);
  assert.deepEqual([params.wind, params.exposure, await wind], [0, 0.75, false]);
  session.call('import', {}, 'property');
  await at(0.9);
  assert.deepEqual([await exposure, await other], [false, false]);
});

test('values arrive at once out of sight, on a hidden page and with reduced motion', async () => {
  for (const how of [{ calm: true }, { isConnected: false }]) {
    const { params, to, at } = burning(how);
    const done = to({ wind: 1 }, { duration: 1e9 });
    await at(0);
    assert.deepEqual([await done, params.wind], [true, 1]);
  }
  const { params, to, at } = burning();
  const done = to({ wind: 1 });
  await at(0.25);
  assert.equal(params.wind, 0.25);
  page.hidden = true;
  page.dispatchEvent(new Event('visibilitychange'));
  await at(0.25);
  assert.deepEqual([await done, params.wind], [true, 1]);
});

test('other options are refused by name, and nothing moves', async () => {
  const { params, to } = burning();
  for (const [how, words] of /** @type {[any, RegExp][]} */ ([
    [7, /^options must be an object/],
    [{ duration: -1 }, /^duration = -1 is refused: it must be a number of milliseconds/],
    [{ duration: '1' }, /^duration = 1 is refused/],
    [{ easing: 'nonsense' }, /^easing = nonsense is refused: it must be an easing of CSS/],
    [{ easing: {} }, /^easing = something of type object is refused/],
  ]))
    await assert.rejects(to({ wind: 1 }, how), { message: words });
  assert.equal(params.wind, 0);
});

test('a call with odd arguments passes, and leaves the transitions alone', async () => {
  const { params, session, to, at } = burning();
  const done = to({ wind: 1 });
  await at(0.5);
  for (const odd of [{ toString: 1 }, null, 7, [{ toString: 1 }]]) session.call('changeObject', odd, { toString: 1 });
  await at(1);
  assert.deepEqual([await done, params.wind], [true, 1]);
});
