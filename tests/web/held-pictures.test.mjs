/**
 * Pictures that the canvas of a worker holds: what waits for them, and what a lost context does.
 */
import assert from 'node:assert/strict';
import { afterEach, beforeEach, mock, test } from 'node:test';
import { holder } from '../../web/engine/held-pictures.js';

/** WebGL's answer while commands are executed. */
const EXPIRED = 0x911b;

beforeEach(() => mock.timers.enable({ apis: ['setTimeout'] }));
afterEach(() => mock.timers.reset());

/** A canvas whose commands take until `draw`, with what happens in order. */
function canvas(timer = true) {
  /** @type {unknown[]} */
  const events = [];
  let [drawn, lost] = [false, false];
  const gl = {
    TIMEOUT_EXPIRED: EXPIRED,
    getExtension: () => (timer ? {} : null),
    fenceSync: () => (lost ? null : {}),
    isContextLost: () => lost,
    flush: () => {},
    clientWaitSync: () => (drawn ? 0x911a : EXPIRED),
    deleteSync: () => {},
  };
  const engine = {
    shown: (/** @type {number} */ fire) => events.push(`shown ${fire}`),
    resume: () => events.push('resume'),
  };
  const take = (/** @type {number} */ fire) => {
    events.push(`picture ${fire}`);
    return false;
  };
  return {
    events,
    holder: /** @type {NonNullable<ReturnType<typeof holder>>} */ (
      holder(/** @type {any} */ (gl), (message) => events.push(message), take, () => /** @type {any} */ (engine))
    ),
    draw: () => (drawn = true),
    lose: () => (lost = true),
  };
}

test('a picture is taken when it is drawn, and messages keep their order', () => {
  const { events, holder: pictures, draw } = canvas();
  pictures.post({ type: 'before' });
  pictures.hold(3);
  assert.equal(pictures.held, true);
  pictures.post({ type: 'stats' });
  pictures.post({ type: 'done' });
  mock.timers.tick(500);
  assert.deepEqual(events, [{ type: 'before' }], 'nothing overtakes the picture');
  draw();
  mock.timers.tick(500);
  assert.deepEqual(events.slice(1), ['picture 3', { type: 'stats' }, { type: 'done' }, 'resume']);
  assert.equal(pictures.held, false);
  pictures.post({ type: 'after' });
  assert.deepEqual(events.at(-1), { type: 'after' });
});

for (const [when, before] of /** @type {const} */ ([['before', true], ['while', false]])) {
  test(`a context that is lost ${when} a picture is held gives no picture and ends the wait`, () => {
    const { events, holder: pictures, lose } = canvas();
    if (before) lose();
    pictures.hold(1);
    lose();
    pictures.post({ type: 'error' });
    mock.timers.tick(500);
    assert.deepEqual(events, [{ type: 'error' }, 'shown 1', 'resume']);
    assert.equal(pictures.held, false);
  });
}

test('without a timer no picture is held, because the quality follows the time of drawing', () => {
  assert.equal(canvas(false).holder, undefined);
});
