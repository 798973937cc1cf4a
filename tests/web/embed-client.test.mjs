/** The client of a page that embeds a fire: its subscriptions follow its listeners, in one page of the iframe and in the next. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { connectFire } from '../../web/embed-client.js';

const ORIGIN = 'https://fire.example';
const page = new EventTarget();
Object.assign(globalThis, { window: page, document: { baseURI: 'https://page.example/' } });

/** A connected client, what it sends, and what the page in its iframe answers. */
function embedded() {
  /** @type {any[]} */
  const sent = [];
  const iframe = Object.assign(new EventTarget(), {
    localName: 'iframe',
    src: `${ORIGIN}/embed.html`,
    isConnected: true,
    contentDocument: null,
    contentWindow: { postMessage: (/** @type {any} */ message) => void sent.push(structuredClone(message)) },
  });
  const fire = connectFire(/** @type {any} */ (iframe));
  const posts = (/** @type {object} */ data) =>
    page.dispatchEvent(
      Object.assign(new Event('message'), {
        source: iframe.contentWindow,
        origin: ORIGIN,
        data: { hearth: 1, ...data },
      }),
    );
  /** The requests that were sent since the last call. */
  const asked = () => sent.splice(0).map(({ method, args }) => [method, ...(args ?? [])]);
  return { fire, sent, posts, asked };
}

test('it subscribes to an event as long as that has a listener', (context) => {
  context.mock.timers.enable({ apis: ['setTimeout'] });
  const { fire, posts, asked } = embedded();
  posts({ event: 'hello' });
  asked();
  /** @type {string[]} */
  const received = [];
  const listener = () => received.push('one');
  const once = { handleEvent: () => received.push('once') };
  // Node calls it even after it is removed.
  const other = { handleEvent() {} };
  const [on, off] = [[['subscribe', ['stats']]], [['unsubscribe', ['stats']]]];
  const ends = new AbortController();
  for (const [act, wanted] of /** @type {[() => void, any[]][]} */ ([
    [() => fire.addEventListener('stats', listener), on],
    [() => fire.addEventListener('stats', listener), []],
    [() => fire.addEventListener('stats', other, { capture: true }), []],
    [() => fire.removeEventListener('stats', listener), []],
    [() => fire.removeEventListener('stats', other), []],
    [() => fire.removeEventListener('stats', other, true), off],
    [() => fire.addEventListener('stats', listener, { signal: ends.signal }), on],
    [() => ends.abort(), off],
    [() => fire.addEventListener('stats', listener, { signal: ends.signal }), []],
    [() => fire.addEventListener('stats', once, { once: true }), on],
    [() => posts({ event: 'stats', detail: 1 }), off],
    [() => posts({ event: 'stats', detail: 2 }), []],
  ])) {
    act();
    assert.deepEqual(asked(), wanted, `${act}`);
  }
  assert.deepEqual(received, ['once']);
  fire.close();
});

test('a request that cannot be sent or an event that there is not harms no other, not even in the next page', async (context) => {
  context.mock.timers.enable({ apis: ['setTimeout'] });
  const warnings = context.mock.method(console, 'warn', () => {});
  const { fire, sent, posts, asked } = embedded();
  const values = { exposure: 1 };
  const refused = assert.rejects(
    fire.call('set', () => {}),
    /could not be cloned/,
  );
  const kept = fire.set(values);
  values.exposure = 99;
  fire.addEventListener('sauce', () => {});
  fire.addEventListener('stats', () => {});
  asked();
  for (let load = 0; load < 2; load += 1) {
    posts({ event: 'hello' });
    const { id } = sent.find(({ args: [name] }) => `${name}` === 'sauce');
    posts({ id, ok: false, error: { message: 'there is no event “sauce”' } });
    await new Promise(setImmediate);
    assert.equal(warnings.mock.callCount(), load + 1);
    if (load === 0) posts({ id: sent.find(({ method }) => method === 'set').id, ok: true });
    const set = load === 0 ? [['set', { exposure: 1 }]] : [];
    assert.deepEqual(asked(), [['subscribe', ['sauce']], ['subscribe', ['stats']], ...set]);
  }
  await refused;
  await kept;
  fire.close();
});
