/**
 * The history of a fire without a browser: after any changes, in any order and at any speed, undo returns through the
 * same values to the first ones, and changes of the page stay.
 */
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { FireHistory } from '../../web/element/session/history.js';
import { merged } from './merged.mjs';

/** Values that both models share, those of each, and objects. */
const FIRST = {
  preset: 'default',
  values: {},
  classic: {},
  combustion: {},
  objects: [
    { kind: 'source', id: 1, width: 3 },
    { kind: 'solid', id: 2, width: 5 },
  ],
};

/** A fire that answers in order, after a while, as the element does. It is the session of its history. */
class Fire {
  state = { settings: structuredClone(FIRST) };
  /** The details of its events. */
  events = [];
  reports = { emit: (_type, detail) => this.events.push(detail) };
  history = new FireHistory(/** @type {any} */ (this));
  #answers = Promise.resolve();

  get settings() {
    return structuredClone(this.state.settings);
  }

  /** Changes a copy of its settings in its turn, all of it or nothing. */
  change(act, source = this.history.source('property')) {
    const [, key] = source.split(/:(.*)/s);
    const answer = this.#answers.then(async () => {
      await new Promise((resolve) => {
        setImmediate(resolve);
      });
      const before = this.state.settings;
      const after = structuredClone(before);
      act(after);
      if (JSON.stringify(before) === JSON.stringify(after)) return;
      this.state.settings = after;
      if (key !== undefined) this.history.record(key, before, after);
    });
    this.#answers = answer.catch(() => {});
    return answer;
  }

  call(name, to, from, source) {
    return this.change((all) => {
      const restored = name === 'restore' && to.reduce((last, there, at) => merged(there, from[at], last), { ...all });
      Object.assign(all, structuredClone(restored));
    }, source);
  }

  /** Sets a value of a part of the settings; without a value, removes it. */
  set(part, name, value) {
    return this.change((all) => {
      if (value > LARGEST) throw new RangeError(`${name} = ${value}`);
      if (value === undefined) delete all[part][name];
      else all[part][name] = value;
    });
  }

  resize(id, width) {
    return this.change(({ objects }) => {
      const object = objects.find((candidate) => candidate.id === id);
      if (object) object.width = width;
    });
  }

  add() {
    return this.change(({ objects }) => {
      const id = 1 + Math.max(0, ...objects.map((object) => object.id));
      objects.push({ kind: 'solid', id, width: 1 });
    });
  }

  remove(id) {
    return this.change((all) => (all.objects = all.objects.filter((object) => object.id !== id)));
  }

  reverse() {
    return this.change(({ objects }) => objects.reverse());
  }

  preset(preset) {
    return this.change((all) => Object.assign(all, structuredClone(FIRST), { preset }));
  }
}

const LARGEST = 100;

/** Numbers from 0 to 1 that look random, the same ones each time. */
function* numbers(seed) {
  for (let x = seed; ; ) {
    x = (x * 16807) % 2147483647;
    yield x / 2147483647;
  }
}

/** A change at random. */
function change(fire, random) {
  const pick = (list) => list[Math.floor(random.next().value * list.length)];
  const value = Math.round(random.next().value * 20);
  const { id } = pick([...fire.state.settings.objects, { id: 9 }]);
  return pick([
    () => fire.set(pick(['values', 'classic', 'combustion']), pick(['wind', 'width']), pick([value, undefined])),
    () => fire.set('values', 'model', pick(['classic', undefined])),
    () => fire.resize(id, value),
    () => fire.add(),
    () => fire.remove(id),
    () => fire.reverse(),
    () => fire.preset(pick(['default', 'seed'])),
  ])();
}

const step = (fire, random) => fire.history.step(() => change(fire, random));

/** The first numbers of the random sequences. */
const SEEDS = Array.from({ length: 200 }, (_, index) => index + 1);

describe('200 random sequences', () => {
  test('of steps lead back through the same fires, one after another, and forth again', async () => {
    for (const seed of SEEDS) {
      const fire = new Fire();
      const random = numbers(seed);
      const fires = [fire.settings];
      for (let count = 0; count < 25; count += 1) {
        if (fires.length > 1 && random.next().value < 0.2) {
          await fire.history.undo();
          fires.pop();
        } else {
          await step(fire, random);
          if (JSON.stringify(fire.settings) !== JSON.stringify(fires.at(-1))) fires.push(fire.settings);
        }
        assert.deepEqual(fire.settings, fires.at(-1), `${seed}`);
      }
      await fire.history.step(() => fire.set('values', 'wind', 21));
      fires.push(fire.settings);
      for (const settings of fires.slice(0, -1).reverse()) {
        assert.equal(await fire.history.undo(), true);
        assert.deepEqual(fire.settings, settings, `${seed}`);
      }
      assert.equal(await fire.history.undo(), false);
      for (const settings of fires.slice(1)) {
        assert.equal(await fire.history.redo(), true);
        assert.deepEqual(fire.settings, settings, `${seed}`);
      }
      assert.equal(await fire.history.redo(), false);
    }
  });

  test('lead back to the first fire, however fast the steps follow', async () => {
    for (const seed of SEEDS) {
      const fire = new Fire();
      const random = numbers(seed);
      await Promise.all(Array.from({ length: 12 }, () => step(fire, random)));
      const last = fire.settings;
      while (await fire.history.undo());
      assert.deepEqual(fire.settings, FIRST, `${seed}`);
      while (await fire.history.redo());
      assert.deepEqual(fire.settings, last, `${seed}`);
    }
  });

  test('keep what the page changes meanwhile', async () => {
    for (const seed of SEEDS) {
      const fire = new Fire();
      const random = numbers(seed);
      const calls = Array.from({ length: 12 }, (_, at) => [
        step(fire, random),
        fire.change((all) => Object.assign(all.values, { own: at })),
      ]);
      await Promise.all(calls.flat());
      while (await fire.history.undo());
      const { own, ...values } = fire.settings.values;
      // A preset replaces it, and undoing the preset brings back the one before.
      assert.ok(Number.isInteger(own), `${seed}`);
      assert.deepEqual({ ...fire.settings, values }, FIRST, `${seed}`);
    }
  });
});

/** Drags a value: calls of one gesture. */
const drag = (fire, key, widths, act = (width) => fire.set('values', 'width', width)) =>
  Promise.all(widths.map((width) => fire.history.step(() => act(width), key)));

describe('a step', () => {
  test('has a key: the changes of a drag are one step, and those of the next drag another one', async () => {
    const fire = new Fire();
    await drag(fire, 'first', [6, 7, 8]);
    await drag(fire, 'second', [9]);
    await fire.history.undo();
    assert.equal(fire.settings.values.width, 8);
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
      fire.set('values', 'wind', 1),
      history.step(() => fire.set('values', 'width', 2)),
      fire.set('values', 'gravity', 3),
    ]);
    await Promise.all([...calls, fire.set('values', 'own', 4)]);
    const seen = [];
    while (await history.undo()) seen.push(fire.settings.values);
    assert.deepEqual(seen, [{ own: 4 }]);
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
  });

  test('needs a change: there is none of a drag there and back, the same value, a rejection', async () => {
    const fire = new Fire();
    await drag(fire, 'first', [6, 7, undefined]);
    await drag(fire, 'second', [undefined]);
    await assert.rejects(
      drag(fire, 'third', [LARGEST + 1]).then(() => {}),
      RangeError,
    );
    assert.equal(fire.history.canUndo, false);
  });

  test('keeps what the page changes while it goes on', async () => {
    const fire = new Fire();
    await drag(fire, 'first', [6, 7], async (width) => {
      const set = fire.resize(2, width);
      await set;
    });
    await fire.resize(1, 9);
    await drag(fire, 'first', [8], (width) => fire.resize(2, width));
    await fire.history.step(() => fire.remove(2));
    await fire.set('values', 'own', 1);
    await fire.history.undo();
    assert.deepEqual(fire.settings.objects, [
      { kind: 'source', id: 1, width: 9 },
      { kind: 'solid', id: 2, width: 8 },
    ]);
    await fire.history.undo();
    assert.deepEqual(fire.settings.objects[1].width, 5);
    assert.deepEqual([fire.settings.values, fire.history.canUndo], [{ own: 1 }, false]);
    await fire.history.redo();
    await fire.history.redo();
    assert.deepEqual(fire.settings.objects, [{ kind: 'source', id: 1, width: 9 }]);
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
    await fire.history.step(() => fire.set('values', 'wind', 1));
    const undone = fire.history.undo();
    const second = fire.history.step(() => fire.set('values', 'width', 2));
    assert.deepEqual([await undone, await second], [true, undefined]);
    assert.deepEqual(fire.settings.values, { width: 2 });
    await fire.history.undo();
    assert.deepEqual([fire.settings, fire.history.canUndo], [FIRST, false]);
  });

  test('whose undo changes nothing keeps what it did, and goes on', async () => {
    const fire = new Fire();
    await drag(fire, 'first', [6]);
    await fire.set('values', 'width', undefined);
    await fire.history.undo();
    assert.deepEqual(fire.settings, FIRST);
    await fire.history.redo();
    assert.deepEqual(fire.settings.values, { width: 6 });
    // A redo that changes nothing, either.
    await fire.history.undo();
    await fire.set('values', 'width', 6);
    await fire.history.redo();
    await drag(fire, 'first', [7]);
    await fire.history.undo();
    assert.deepEqual([fire.settings, fire.history.canUndo], [FIRST, false]);
  });

  test('is a scene that replaces every value, whoever chooses it, once the fire was ready', async () => {
    const fire = new Fire();
    const scene = (name) =>
      fire.change(
        (all) => Object.assign(all, structuredClone(FIRST), { preset: name }),
        fire.history.sourceOfScene('preset'),
      );
    await scene('seed');
    fire.history.begun = true;
    const first = fire.settings;
    await fire.resize(2, 7);
    await scene('match');
    await fire.history.step(() => scene('candle'), 'card');
    assert.deepEqual([fire.history.canUndo, fire.events.length], [true, 2]);
    while (await fire.history.undo());
    first.objects[1].width = 7;
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
    for (let value = 0; value < 300; value += 1)
      await fire.history.step(() => fire.set('values', 'wind', value % 2 ? 1 : 2));
    let count = 0;
    while (await fire.history.undo()) count += 1;
    assert.ok(count >= 100 && count < 300, `${count} steps`);
  });
});
