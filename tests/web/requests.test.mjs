/**
 * Calls of an element: their order, what a flood of them sends, and copies of values.
 */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { postable } from '../../web/element/plain-data.js';
import { Requests } from '../../web/element/session/requests.js';

/** An engine that keeps what it is sent, and answers on request. */
function engine() {
  const requests = new Requests();
  /** @type {[number, any[]][]} */
  const sent = [];
  let answered = 0;
  return {
    requests,
    sent,
    connect: () => requests.connect(1, (request, call) => void sent.push([request, call])),
    /** Answers everything, and what is sent meanwhile; values below 0 are refused. */
    answer() {
      for (; answered < sent.length; answered += 1) {
        const [request, [, values]] = sent[answered];
        requests.settle(request, values?.wind < 0 ? new RangeError('below 0') : undefined);
      }
    },
  };
}

test('calls are sent at once and in order', () => {
  const { requests, sent, connect } = engine();
  connect();
  for (const call of [['set', { wind: 1 }], ['step', 1], ['set', { wind: 2 }], ['pause']]) requests.call(...call);
  assert.deepEqual(
    sent.map(([, [method]]) => method),
    ['set', 'step', 'set', 'pause'],
  );
});

test('of very many sets in one task the engine gets few, and every promise settles', async () => {
  const { requests, sent, connect, answer } = engine();
  connect();
  const answers = Array.from({ length: 300_000 }, (_, at) => requests.call('set', { wind: at }));
  const last = requests.call('export');
  answer();
  await Promise.all([...answers, last]);
  assert.ok(sent.length <= 1001, `${sent.length} calls`);
  assert.deepEqual(
    sent.slice(-2).map(([, call]) => call),
    [['set', { wind: 299_999 }], ['export']],
  );
});

test('a fire pauses while the engine answers no set', () => {
  const { requests, sent, connect } = engine();
  connect();
  for (let at = 0; at < 2000; at += 1) requests.call('set', { wind: at });
  requests.call('pause');
  assert.equal(sent.at(-1)?.[1][0], 'pause');
});

test('a set settles as the later one that replaces it', async () => {
  const { requests, connect, answer } = engine();
  connect();
  const answers = Array.from({ length: 2000 }, (_, at) => requests.call('set', { wind: at === 1999 ? -1 : at }));
  answer();
  const settled = await Promise.allSettled(answers);
  assert.equal(settled[0].status, 'fulfilled', 'the first was sent');
  assert.equal(settled[1999].status, 'rejected');
  const firstReplaced = settled.findIndex(({ status }) => status === 'rejected');
  assert.ok(firstReplaced >= 500, `${firstReplaced}`);
});

test('sets of other values are all sent, in order', () => {
  const { requests, sent, connect, answer } = engine();
  connect();
  for (let at = 0; at < 3000; at += 1) requests.call('set', { [`value${at}`]: 1 });
  answer();
  assert.deepEqual(
    sent.map(([, [, values]]) => Object.keys(values)[0]),
    Array.from({ length: 3000 }, (_, at) => `value${at}`),
  );
});

test('a fire that is removed still gets the calls before', () => {
  const { requests, sent, connect } = engine();
  connect();
  for (let at = 0; at < 600; at += 1) requests.call('set', { wind: at });
  assert.equal(sent.length, 500);
  requests.disconnect();
  assert.deepEqual(sent.at(-1)?.[1], ['set', { wind: 599 }]);
  requests.call('set', { wind: 600 });
  assert.equal(sent.length, 600);
});

test('without a fire the model goes first', () => {
  const { requests, sent, connect } = engine();
  requests.call('set', { wind: 1 });
  requests.call('set', { model: 'classic' });
  requests.call('set', { wind: 2 });
  connect();
  assert.deepEqual(
    sent.map(([, [, values]]) => values),
    [{ model: 'classic' }, { wind: 1 }, { wind: 2 }],
  );
});

test('no long text is copied', () => {
  const long = 'x'.repeat(20_000_000);
  const copy = JSON.stringify(postable({ [long]: 1, wind: long, list: [long] }, 3));
  assert.ok(copy.length < 400, `${copy.length} characters`);
  assert.equal(postable('x'.repeat(1000)), 'x'.repeat(1000));
});
