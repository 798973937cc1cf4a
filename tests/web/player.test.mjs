/**
 * The sound of a fire without a browser: what a fire does whose browser refuses it an audio context, or closes it.
 */
import assert from 'node:assert/strict';
import { after, beforeEach, test } from 'node:test';

/** Why the next context is refused. */
let refusal = '';
/** @type {string[]} */
let warnings = [];

class FakeNode extends EventTarget {
  gain = { value: 0, cancelScheduledValues() {}, setValueAtTime() {}, linearRampToValueAtTime() {} };

  constructor(context) {
    super();
    this.context = context;
  }

  connect(to) {
    return to;
  }

  disconnect() {}
}

class FakeContext extends EventTarget {
  state = 'suspended';
  currentTime = 0;
  sampleRate = 8000;
  destination = {};

  constructor() {
    super();
    if (refusal) throw new Error(refusal);
  }

  async resume() {
    this.#become('running');
  }

  async close() {
    if (this.state === 'closed') throw new Error('Cannot close a closed AudioContext');
    this.#become('closed');
  }

  #become(state) {
    this.state = state;
    this.dispatchEvent(new Event('statechange'));
  }
}

const page = new EventTarget();
Object.assign(page, { hidden: false });
const { warn } = console;
console.warn = (text) => warnings.push(text);
after(() => (console.warn = warn));
Object.assign(globalThis, {
  document: page,
  AudioContext: FakeContext,
  GainNode: FakeNode,
  WaveShaperNode: FakeNode,
  addEventListener() {},
  removeEventListener() {},
});
Object.defineProperty(globalThis, 'navigator', { value: { userActivation: { hasBeenActive: false } } });

const { Player } = await import('../../web/sound/player.js');
const { limited } = await import('../../web/sound/mixer.js');

/** A visitor's click. */
async function click() {
  navigator.userActivation.hasBeenActive = true;
  page.dispatchEvent(new Event('click'));
  await new Promise(setImmediate);
}

/** A fire that burns, and what its session is told. */
function burning() {
  const fire = Object.assign(new EventTarget(), {
    sound: 0.5,
    roar: 1,
    crackle: 0.5,
    hiss: 1,
    muted: false,
    paused: false,
    params: { seed: 1, domain_width: 1 },
  });
  const [states, sent] = [[], []];
  const session = {
    fire,
    live: true,
    muted: 'muted',
    view: {},
    send: (...call) => sent.push(call),
    reports: {
      emit: (_, { state }) => states.push(state),
      loads: () => Promise.resolve({ waitingButton: () => () => {} }),
    },
  };
  return { session, states, sent, player: new Player(/** @type {any} */ (session)) };
}

beforeEach(() => {
  [refusal, warnings] = ['', []];
  navigator.userActivation.hasBeenActive = false;
});

test('a fire that is refused a context burns silently with one warning, and sounds with a later gesture', async () => {
  refusal = 'the number of contexts is at its maximum';
  const { player, states, sent } = burning();
  assert.deepEqual(states, ['waiting']);
  for (let round = 0; round < 3; round += 1) await click();
  // A fire that follows a gesture.
  const later = burning();
  assert.deepEqual([states, later.states, player.audio], [['waiting', 'silent'], [], null]);
  assert.equal(warnings.length, 1);
  assert.match(warnings[0], /maximum/);
  refusal = '';
  await click();
  assert.deepEqual([states.at(-1), later.states.at(-1)], ['playing', 'playing']);
  assert.deepEqual(sent, [['sound', 8000, 1, 0.5, 1]]);
});

test('a fire whose context is closed sounds again with the next gesture, in another context', async () => {
  const { player, states, sent } = burning();
  await click();
  const first = player.audio?.context;
  await first?.close();
  assert.deepEqual([states.at(-1), player.audio, player.track()], ['waiting', null, undefined]);
  await click();
  assert.equal(states.at(-1), 'playing');
  assert.notEqual(player.audio?.context, first);
  assert.deepEqual(sent.slice(-3), [
    ['sound', 8000, 1, 0.5, 1],
    ['sound', undefined, 1, 0.5, 1],
    ['sound', 8000, 1, 0.5, 1],
  ]);
});

test('the limiter keeps what is within 0.7 of full scale, and bends all else below it, the louder the nearer', () => {
  for (const sample of [0, 0.1, -0.5, 0.7]) assert.equal(limited(sample), sample);
  let last = 0.7;
  for (let sample = 0.71; sample < 4; sample += 0.01) {
    const now = limited(sample);
    assert.ok(now >= last && now < 1 && now <= sample, `${sample} becomes ${now}`);
    assert.equal(limited(-sample), -now);
    last = now;
  }
});
