/**
 * The history of a fire without a browser: keys, steps in steps, and answers that come late. What the engine does
 * with a step is tested in `crates/hearth-settings/tests/settings/deltas.rs` and `sequences.rs`.
 */
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { FireHistory } from '../../web/element/session/history.js';

const FIRST = { wind: 0, width: 5, gravity: 0, own: 0 };
const LARGEST = 100;

/** A fire of some values, which answers in order, after a while, as the element does. It is the session of its history. */
class Fire {
  state = { settings: FIRST };
  /** The details of its events. */
  events = [];
  reports = { emit: (_type, detail) => this.events.push(detail) };
  history = new FireHistory(/** @type {any} */ (this));
  #answers = Promise.resolve();

  get settings() {
    return this.state.settings;
  }

  /** Changes values in its turn. */
  change(values, source) {
    const [, key] = source.split(/:(.*)/s);
    const answer = this.#answers.then(async () => {
      await new Promise((resolve) => {
        setImmediate(resolve);
      });
      if (values.width > LARGEST) throw new RangeError(`width = ${values.width}`);
      const before = this.state.settings;
      const names = Object.keys(values).filter((name) => values[name] !== before[name]);
      if (names.length === 0) return;
      const [undo, redo] = [before, values].map((from) => Object.fromEntries(names.map((name) => [name, from[name]])));
      this.state.settings = { ...before, ...redo };
      if (key !== undefined) this.history.record(key, { values: undo }, { values: redo });
    });
    this.#answers = answer.catch(() => {});
    return answer;
  }

  call(name, deltas, source = 'property') {
    return this.change(name === 'restore' ? deltas[0].values : {}, source);
  }

  set(values) {
    return this.change(values, this.history.source('property'));
  }
}

test('200 sequences of steps lead back to the first values, however fast they follow, and keep what the page changes', async () => {
  for (let seed = 1; seed <= 200; seed += 1) {
    const fire = new Fire();
    let state = seed;
    const random = () => {
      state = (state * 16807) % 2147483647;
      return state % 20;
    };
    const names = ['wind', 'width', 'gravity'];
    const calls = Array.from({ length: 12 }, (_, own) => [
      fire.history.step(() => fire.set({ [names[random() % 3]]: random() })),
      fire.set({ own }),
    ]);
    await Promise.all(calls.flat());
    const last = fire.settings;
    while (await fire.history.undo());
    assert.deepEqual(fire.settings, { ...FIRST, own: 11 }, `${seed}`);
    while (await fire.history.redo());
    assert.deepEqual(fire.settings, last, `${seed}`);
  }
});

/** Drags a value: calls of one gesture. */
const drag = (fire, key, widths, act = (width) => fire.set({ width })) =>
  Promise.all(widths.map((width) => fire.history.step(() => act(width), key)));

describe('a step', () => {
  test('has a key: the changes of a drag are one step, and those of the next drag another one', async () => {
    const fire = new Fire();
    await drag(fire, 'first', [6, 7, 8]);
    await drag(fire, 'second', [9]);
    await fire.history.undo();
    assert.equal(fire.settings.width, 8);
    await fire.history.undo();
    assert.deepEqual([fire.settings, fire.history.canUndo], [FIRST, false]);
    // A step that was undone does not go on.
    await drag(fire, 'first', [7]);
    assert.deepEqual([fire.history.canUndo, fire.history.canRedo], [true, false]);
  });

  test('is what a function calls for before it returns, in steps inside of it, too', async () => {
    const fire = new Fire();
    const { history } = fire;
    const calls = history.step(() => [
      fire.set({ wind: 1 }),
      history.step(() => fire.set({ width: 2 })),
      fire.set({ gravity: 3 }),
    ]);
    await Promise.all([...calls, fire.set({ own: 4 })]);
    const seen = [];
    while (await history.undo()) seen.push(fire.settings);
    assert.deepEqual(seen, [{ ...FIRST, own: 4 }]);
    assert.throws(
      () =>
        history.step(() => {
          throw new Error('no');
        }),
      /no/,
    );
    assert.equal(history.source('property'), 'property');
    assert.throws(() => history.step(null), { name: 'TypeError', message: 'act must be a function, not null' });
    assert.throws(() => history.step(() => {}, Symbol('key')), { message: 'key must be a text, not symbol' });
    assert.throws(() => history.step(() => assert.fail(), 'k'.repeat(1001)), {
      name: 'RangeError',
      message: 'key must have at most 1000 characters, not 1001',
    });
  });

  test('needs a change: there is none of a drag there and back, the same value, a rejection', async () => {
    const fire = new Fire();
    await drag(fire, 'first', [6, 7, 5]);
    await drag(fire, 'second', [5]);
    await assert.rejects(
      drag(fire, 'third', [LARGEST + 1]).then(() => {}),
      RangeError,
    );
    assert.equal(fire.history.canUndo, false);
  });

  test('is reported by an event, and so are undo and redo', async () => {
    const fire = new Fire();
    await drag(fire, 'first', [6]);
    await fire.history.undo();
    await fire.history.redo();
    assert.deepEqual(
      fire.events.map(({ type, key }) => [type, key]),
      ['step', 'undo', 'redo'].map((type) => [type, 'first']),
    );
  });

  test('that goes on while it is undone leaves no other step', async () => {
    const fire = new Fire();
    await drag(fire, 'first', [6, 7]);
    const { call } = fire;
    fire.call = (name, ...rest) => {
      const answer = call.call(fire, name, ...rest);
      // The fire answers this between the two calls of undo.
      if (name !== 'restore') drag(fire, 'first', [8]);
      return answer;
    };
    await fire.history.undo();
    assert.deepEqual([fire.settings, fire.history.canUndo, fire.history.canRedo], [FIRST, false, true]);
  });

  test('that follows an undo at once stays', async () => {
    const fire = new Fire();
    await fire.history.step(() => fire.set({ wind: 1 }));
    const undone = fire.history.undo();
    const second = fire.history.step(() => fire.set({ width: 2 }));
    assert.deepEqual([await undone, await second], [true, undefined]);
    assert.deepEqual(fire.settings, { ...FIRST, width: 2 });
    await fire.history.undo();
    assert.deepEqual([fire.settings, fire.history.canUndo], [FIRST, false]);
  });

  test('whose undo changes nothing keeps what it did, and goes on', async () => {
    const fire = new Fire();
    await drag(fire, 'first', [6]);
    await fire.set({ width: FIRST.width });
    await fire.history.undo();
    assert.deepEqual(fire.settings, FIRST);
    await fire.history.redo();
    assert.deepEqual(fire.settings, { ...FIRST, width: 6 });
    // A redo that changes nothing, either.
    await fire.history.undo();
    await fire.set({ width: 6 });
    await fire.history.redo();
    await drag(fire, 'first', [7]);
    await fire.history.undo();
    assert.deepEqual([fire.settings, fire.history.canUndo], [FIRST, false]);
  });

  test('is a scene that replaces every value, whoever chooses it, once the fire was ready', async () => {
    const fire = new Fire();
    const scene = (wind) => fire.change({ ...FIRST, wind }, fire.history.sourceOfScene('preset'));
    await scene(1);
    fire.history.begun = true;
    const first = fire.settings;
    await scene(2);
    await fire.history.step(() => scene(3), 'card');
    assert.deepEqual([fire.history.canUndo, fire.events.length], [true, 2]);
    while (await fire.history.undo());
    assert.deepEqual(fire.settings, first);
  });

  test('that the fire now rejects is dropped, and the rejection is reported', async () => {
    const fire = new Fire();
    await drag(fire, 'first', [6]);
    const { call } = fire;
    fire.call = async (name, ...rest) => (name === 'restore' ? Promise.reject(error) : call.call(fire, name, ...rest));
    // A fire that stops may take the step back when it is followed by another.
    let error = new Error('stopped');
    await assert.rejects(fire.history.undo(), /stopped/);
    assert.deepEqual([fire.history.canUndo, fire.history.canRedo], [true, false]);
    error = new RangeError('no more');
    await assert.rejects(fire.history.undo(), /no more/);
    assert.deepEqual([fire.history.canUndo, fire.history.canRedo], [false, false]);
  });

  test('of long ago is forgotten, so that a long day fills no memory', async () => {
    const fire = new Fire();
    for (let value = 0; value < 300; value += 1) await fire.history.step(() => fire.set({ wind: value % 2 ? 1 : 2 }));
    let count = 0;
    while (await fire.history.undo()) count += 1;
    assert.ok(count >= 100 && count < 300, `${count} steps`);
  });
});
