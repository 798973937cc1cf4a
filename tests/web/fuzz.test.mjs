/**
 * What a page, a link or an embedding page can send keeps the laws of its decoder: random
 * messages to the iframe, and random addresses. `cargo measure fuzz --minutes N` looks for longer.
 */
import assert from 'node:assert/strict';
import { test } from 'node:test';

// The module reads these when it starts to answer.
const page = Object.assign(globalThis, { window: new EventTarget(), location: {} });
const { allowedOrigins, answer } = await import('../../web/embed/message-bridge.js');
const { elementCode, fromQuery, iframeCode, toQuery } = await import('../../web/share.js');
const { PARAMETERS } = await import('../../web/parameters.js');

const HERE = 'https://a.example';
const METHODS = [
  'play',
  'pause',
  'reset',
  'step',
  'set',
  'get',
  'params',
  'restore',
  'addObject',
  'option',
  'subscribe',
  'hello',
];
const TEXTS = [
  '',
  '0',
  'NaN',
  'wind',
  'scene',
  'fireside',
  '__proto__',
  'constructor',
  'toString',
  'autoplay',
  'stats',
  '%',
  '%00',
  '%E0%A4',
  '"><script>',
  "'",
  '&amp;',
  '\u{1f525}',
  '\ud800',
  '\0',
  'https://a.example',
  '*',
  'javascript:alert(1)',
  'x'.repeat(70_000),
];
const NUMBERS = [0, -0, 1, -1, 0.5, 1e300, 5e-324, 2 ** 53, Number.NaN, Infinity, -Infinity];
/** The names of all that objects inherit, which no decoder may change. */
const INHERITED = Object.getOwnPropertyNames(Object.prototype).join();

/** Runs one case after another, each with a seed of its own, which a failure names. */
async function cases(count, run) {
  const { HEARTH_FUZZ_MINUTES: minutes, HEARTH_FUZZ_SEED: first = '1' } = process.env;
  const end = performance.now() + 60_000 * Number(minutes);
  for (let at = 0; minutes ? performance.now() < end : at < count; at += 1) {
    const seed = Number(first) + at;
    try {
      await run(chance(seed));
      assert.equal(Object.getOwnPropertyNames(Object.prototype).join(), INHERITED);
    } catch (error) {
      throw new Error(`\`cargo measure fuzz --seed ${seed}\` repeats this case first: ${error.message}`, {
        cause: error,
      });
    }
  }
}

/** Whole numbers below another, the same for the same seed. */
function chance(seed) {
  let state = seed;
  return (below) => {
    state = (state + 0x6d2b79f5) | 0;
    let bits = Math.imul(state ^ (state >>> 15), state | 1);
    bits ^= bits + Math.imul(bits ^ (bits >>> 7), bits | 61);
    return ((bits ^ (bits >>> 14)) >>> 0) % below;
  };
}

const oneOf = (random, all) => all[random(all.length)];
const text = (random) =>
  random(3) ? oneOf(random, TEXTS) : String.fromCharCode(...list(random, 40, () => random(0x10000)));
const list = (random, most, make) => Array.from({ length: random(most) }, make);

/** Any value that can be posted. */
function value(random, depth) {
  switch (random(depth ? 9 : 6)) {
    case 0:
      return oneOf(random, [undefined, null, true, false, 10n]);
    case 1:
    case 2:
      return oneOf(random, NUMBERS);
    case 3:
    case 4:
      return text(random);
    case 5:
      return oneOf(random, [new Date(0), new Map([[1, 2]]), new ArrayBuffer(8), /x/, Object.create(null)]);
    case 6:
      return list(random, 6, () => value(random, depth - 1));
    default:
      return Object.fromEntries(list(random, 5, () => [text(random), value(random, depth - 1)]));
  }
}

/** What is made, unless a name is refused. */
function orRefused(make) {
  try {
    return [make()];
  } catch (error) {
    assert.ok(error instanceof RangeError, error);
    return [];
  }
}

/** A fire of which every method that is called is noted. */
function recorder(called) {
  const own = { params: { wind: 1 }, objects: [], stats: {}, ready: Promise.resolve(), addEventListener() {} };
  return new Proxy(own, {
    get: (target, name) =>
      target[name] ??
      ((...args) => {
        called.push(name);
        if (args.length > 3) throw new RangeError('too many arguments');
        return null;
      }),
  });
}

test('a random message is ignored or answered once, and calls methods of the list alone', async (context) => {
  context.mock.method(console, 'warn', () => {});
  const events = page.window;
  await cases(2000, async (random) => {
    const [called, posted] = [[], []];
    const host = { postMessage: (message, origin) => posted.push({ ...message, origin }) };
    page.window = new EventTarget();
    answer(recorder(called), [HERE], host);
    posted.length = 0;
    const data = random(8) ? { hearth: 1, id: random(4) ? random(100) : value(random, 2) } : value(random, 3);
    if (typeof data === 'object' && data !== null && random(8)) {
      const method = random(4) ? oneOf(random, METHODS) : value(random, 2);
      Object.assign(data, { method, args: random(8) ? list(random, 4, () => value(random, 4)) : value(random, 3) });
    }
    const origin = random(8) ? HERE : text(random);
    page.window.dispatchEvent(Object.assign(new Event('message'), { data, origin, source: host }));
    await new Promise((resolve) => setImmediate(resolve));
    assert.ok(posted.length <= 1);
    for (const reply of posted) {
      assert.deepEqual([reply.origin, reply.hearth, typeof reply.ok], [HERE, 1, 'boolean']);
      assert.equal(typeof (reply.error?.message ?? ''), 'string');
    }
    const listed = [...METHODS, 'setAttribute', 'getAttribute', 'removeAttribute'];
    assert.deepEqual(
      called.filter((name) => !listed.includes(name)),
      [],
    );
    assert.ok(called.length === 0 || origin === HERE);
  });
  page.window = events;
});

test('a random address gives settings that give the same address, and code without other markup', async () => {
  await cases(2000, async (random) => {
    const name = () => (random(4) ? oneOf(random, PARAMETERS).id : text(random));
    const query = list(random, 6, () => `${name()}=${encodeURIComponent(text(random).toWellFormed())}`).join(
      oneOf(random, ['&', '&&', '#', '?']),
    );
    const { config } = fromQuery(query);
    const again = fromQuery(toQuery(config)).config;
    assert.deepEqual(fromQuery(toQuery(again)).config, again);
    for (const code of [await iframeCode(config, HERE), ...orRefused(() => elementCode(config, HERE))]) {
      assert.match(code, /^(<\/?(script|hearth-fire|iframe)( [^<>]*)?>\s*)+$/);
    }
  });
});

test('a random list of origins allows exact origins alone', async () => {
  await cases(2000, (random) => {
    const { origins } = allowedOrigins(
      list(random, 4, () => `${text(random)},${oneOf(random, ['http://', 'https://'])}${text(random)}`),
    );
    for (const origin of origins) assert.equal(new URL(origin).origin, origin);
  });
});
