/**
 * The iframe's end of the message bridge, with a page and a fire that only record: it answers
 * allowed origins, calls listed methods and survives any message.
 */
import assert from 'node:assert/strict';
import { test } from 'node:test';

// The module reads these when it starts to answer.
const page = Object.assign(globalThis, { window: new EventTarget(), location: {} });
const { allowedOrigins, answer } = await import('../../web/embed/message-bridge.js');

const HERE = 'https://a.example';

/** A fire of two parameters; `set` settles when `settle` is called. */
class FakeFire extends EventTarget {
  params = { wind: 1, exposure: 0 };
  paused = false;
  /** @type {(() => void)[]} */
  waiting = [];

  get(id) {
    return Object.hasOwn(this.params, id) ? this.params[id] : undefined;
  }

  pause() {
    this.paused = true;
  }

  set() {
    return /** @type {Promise<void>} */ (new Promise((resolve) => this.waiting.push(resolve)));
  }

  settle() {
    for (const done of this.waiting.splice(0)) done();
  }
}

/**
 * A fire that answers a page of these origins, and what the page receives.
 * @param {string[]} [origins]
 */
function bridge(origins = [HERE]) {
  /** @type {{[field: string]: any}[]} */
  const received = [];
  const host = {
    postMessage: (/** @type {object} */ message, /** @type {string} */ origin) => received.push({ ...message, origin }),
  };
  const fire = new FakeFire();
  answer(/** @type {any} */ (fire), origins, /** @type {any} */ (host));
  /** Sends a message, and waits until everything that it causes at once has happened. */
  const send = async (/** @type {unknown} */ data, { origin = HERE, source = host } = {}) => {
    page.window.dispatchEvent(Object.assign(new Event('message'), { data, origin, source }));
    await new Promise((resolve) => setImmediate(resolve));
  };
  let last = 0;
  const ask = async (/** @type {unknown} */ method, /** @type {unknown[]} */ ...args) => {
    last += 1;
    await send({ hearth: 1, id: last, method, args });
    return received.find(({ id }) => id === last);
  };
  return { fire, received, send, ask };
}

test('exact origins are allowed, and nothing else', () => {
  const exact = ['https://a.example', 'http://localhost:8080', 'https://[::1]:90'];
  assert.deepEqual(allowedOrigins([` ${exact[0]} ,${exact[1]},`, exact[2]]), { origins: exact, refused: [] });
  for (const name of [
    '*',
    'null',
    'a.example',
    '//a.example',
    'https://*.example',
    'https://a.example/',
    'https://a.example/path',
    'https://a.example?x',
    'https://a.example#x',
    'https://u:p@a.example',
    'https://A.example',
    'https://a.example:443',
    'file:///',
    'about:blank',
    'data:text/html',
    'blob:https://a.example',
    'javascript:alert(1)',
    'https://',
    'x y',
    '%',
  ]) {
    const { origins, refused } = allowedOrigins([name]);
    assert.deepEqual([origins, refused.length], [[], 1], name);
    assert.ok(refused[0].includes(`“${name}”`), refused[0]);
  }
  const many = Array.from({ length: 40 }, (_, at) => `https://a${at}.example`);
  const { origins, refused } = allowedOrigins([many.join(',')]);
  assert.deepEqual(origins, many.slice(0, 16));
  assert.equal(refused.length, 1);
});

test('it answers its parent only, and only from an allowed origin', async (context) => {
  const warnings = context.mock.method(console, 'warn', () => {});
  const { fire, received, send } = bridge();
  received.length = 0;
  const request = { hearth: 1, id: 1, method: 'pause' };
  await send(request, { origin: 'https://b.example' });
  await send(request, { origin: 'https://b.example' });
  await send(request, { source: { postMessage: () => 0 } });
  assert.deepEqual([fire.paused, received], [false, []]);
  assert.equal(warnings.mock.callCount(), 1, 'it warns once of an origin that is not allowed');
  await send(request);
  assert.deepEqual([fire.paused, received[0].ok, received[0].origin], [true, true, HERE]);
});

test('it posts events to every allowed origin until one sends a message, then to that one', async () => {
  const { fire, received, ask } = bridge([HERE, 'https://b.example']);
  assert.deepEqual(
    received.map(({ event, origin }) => [event, origin]),
    [
      ['hello', HERE],
      ['hello', 'https://b.example'],
    ],
  );
  await ask('params');
  received.length = 0;
  fire.dispatchEvent(new CustomEvent('ready'));
  assert.deepEqual(
    received.map(({ event, origin }) => [event, origin]),
    [['ready', HERE]],
  );
});

test('it posts the subscribed events', async () => {
  const { fire, received, ask } = bridge();
  const kinds = () => received.filter(({ event }) => event).map(({ event }) => event);
  assert.deepEqual((await ask('subscribe', ['stats', 'pause']))?.value, ['ready', 'stats', 'pause']);
  for (const name of ['stats', 'play', 'pause']) fire.dispatchEvent(new CustomEvent(name));
  assert.deepEqual((await ask('unsubscribe', 'stats'))?.value, ['ready', 'pause']);
  fire.dispatchEvent(new CustomEvent('stats'));
  assert.deepEqual(kinds(), ['hello', 'stats', 'pause']);
  for (const args of [[['stats', 'everything']], []]) {
    assert.match((await ask('subscribe', ...args))?.error.message, /there is no event/);
  }
});

test('it calls the methods of its list', async () => {
  const { ask } = bridge();
  for (const method of [
    'constructor',
    '__proto__',
    'toString',
    'remove',
    'setAttribute',
    'innerHTML',
    'destroy',
    'record',
    'then',
    'has',
    '',
  ]) {
    const { ok, error } = (await ask(method, 'x')) ?? {};
    assert.deepEqual([ok, error?.name], [false, 'TypeError'], method);
    assert.match(error.message, /there is no method .*play, pause/);
  }
});

test('reading a value needs the id of a parameter', async () => {
  const { ask } = bridge();
  for (const id of [['wind'], [['wind']], { id: 'wind' }, null, 5, true, undefined]) {
    const { ok, error } = (await ask('get', id)) ?? {};
    assert.deepEqual([ok, error?.name], [false, 'TypeError'], JSON.stringify(id));
    assert.match(error.message, /a string, not/);
  }
  for (const id of ['vind', 'constructor', '__proto__']) {
    const { error } = (await ask('get', id)) ?? {};
    assert.deepEqual([error.name, error.id], ['RangeError', id]);
    assert.match(error.message, id === 'vind' ? /did you mean wind\b/ : /\.$/);
  }
  assert.equal((await ask('get', 'wind'))?.value, 1);
});

test('a message of a wrong form is refused with the reason', async () => {
  const { received, send } = bridge();
  const cyclic = /** @type {any} */ ({});
  cyclic.itself = cyclic;
  /** @type {[unknown, unknown, RegExp][]} */
  const wrong = [
    [{ hearth: 1, id: 'f', method: 7n }, 'f', /no method “a value of the type bigint”/],
    [{ hearth: 1, id: 'g', method: cyclic }, 'g', /no method “a value of the type object”/],
    [{ hearth: 1, id: 'h', method: 'subscribe', args: [[7n]] }, 'h', /no event “a value of the type bigint”/],
    [{ hearth: 1, id: 'i', method: 'get', args: [cyclic] }, 'i', /must be the id of a parameter/],
    [{ hearth: 1, id: 'a' }, 'a', /no method “undefined”/],
    [{ hearth: 1, id: 'b', method: 7 }, 'b', /no method “7”/],
    [{ hearth: 1, id: 'c', method: ['play'] }, 'c', /no method/],
    [{ hearth: 1, id: 'd', method: 'play', args: 'now' }, 'd', /“args”/],
    [{ hearth: 2, id: 'e', method: 'play' }, 'e', /version 1, not “2”/],
    [{ hearth: 1, id: { a: 1 }, method: 'play' }, null, /“id”/],
    [{ hearth: 1, id: 'x'.repeat(101), method: 'play' }, null, /“id”/],
  ];
  for (const [message, id, reason] of wrong) {
    received.length = 0;
    await send(message);
    assert.deepEqual([received.length, received[0].ok, received[0].id], [1, false, id]);
    assert.match(received[0].error.message, reason);
  }
});

test('a message that is not a request is left alone', async () => {
  const { fire, received, send } = bridge();
  received.length = 0;
  for (const message of [
    'hearth',
    null,
    7,
    [],
    { id: 1 },
    { method: 'pause', id: 2 },
    { hearth: 1, id: 3, ok: true },
    { hearth: 1, event: 'ready' },
  ])
    await send(message);
  assert.deepEqual([received, fire.paused], [[], false]);
});

test('requests wait side by side, and every one is answered', async () => {
  const { fire, received, ask } = bridge();
  received.length = 0;
  for (let at = 0; at < 300; at += 1) await ask('set', 'exposure', at);
  assert.equal((await ask('pause'))?.ok, true);
  assert.equal(received.length, 1);
  fire.settle();
  await new Promise((resolve) => setImmediate(resolve));
  assert.deepEqual([received.length, received.filter(({ ok }) => ok).length], [301, 301]);
});
