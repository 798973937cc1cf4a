/**
 * The undo history without a browser: after any changes, in any order and at any speed,
 * undo returns through the same values to the first ones.
 */
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { UndoHistory } from '../../web/panel/undo-history.js';

const DEFAULTS = {
  classic: { model: 'classic', width: 1, viscosity: 5, wind: 0, particles: 1000 },
  combustion: { model: 'combustion', width: 4, viscosity: 5, wind: 0, particles: 3000 },
};
/** Ids that have a value in each model. */
const OWN = ['width', 'particles'];
const PRESETS = { default: {}, windy: { wind: 7 }, old: { model: 'classic', viscosity: 9 } };
const LARGEST = 5000;
/** The first numbers of the random gestures. */
const SEEDS = Array.from({ length: 100 }, (_, index) => index + 1);

/** A fire that answers in order, after a while, as the element does. */
class Fire {
  #state = this.#fresh('default');
  #answers = Promise.resolve();

  #fresh(preset) {
    const objects = [
      { id: 1, kind: 'source', width: 3 },
      { id: 2, kind: 'solid', width: 5 },
    ];
    const state = { preset, model: 'combustion', named: false, values: structuredClone(DEFAULTS), objects };
    this.#write(state, PRESETS[preset]);
    return state;
  }

  /** Every id but those of {@link OWN} has one value for both models. */
  #write(state, values) {
    if (values.model) state.model = values.model;
    for (const [id, value] of Object.entries(values)) {
      if (id === 'model') continue;
      if (id === 'objects') {
        state.objects = structuredClone(value);
        continue;
      }
      if (!(id in DEFAULTS.classic)) throw new RangeError(`there is no ${id}`);
      if (!(value <= LARGEST)) throw new RangeError(`${id} = ${value}`);
      const models = OWN.includes(id) ? [state.model] : Object.keys(DEFAULTS);
      for (const model of models) state.values[model][id] = value;
      // The classic number never follows the quality.
      if (id === 'particles' && state.model === 'combustion') state.named = true;
    }
  }

  get params() {
    return { ...this.#state.values[this.#state.model] };
  }

  /** The values of both models. */
  get all() {
    return structuredClone(this.#state.values);
  }

  get objects() {
    return structuredClone(this.#state.objects);
  }

  addObject(object) {
    return this.#ask(({ objects }) => {
      objects.push({ id: 1 + Math.max(0, ...objects.map(({ id }) => id)), ...object });
    });
  }

  changeObject(id, properties) {
    return this.#ask(({ objects }) => {
      const object = objects.find((candidate) => candidate.id === id);
      if (!object) throw new RangeError(`there is no object ${id}`);
      Object.assign(object, properties);
    });
  }

  removeObject(id) {
    return this.#ask(({ objects }) => {
      objects.splice(
        objects.findIndex((candidate) => candidate.id === id),
        1,
      );
    });
  }

  /** Does something in its turn: all of it or nothing. */
  #ask(act) {
    const answer = this.#answers.then(async () => {
      await new Promise((resolve) => {
        setImmediate(resolve);
      });
      const next = structuredClone(this.#state);
      const result = act(next);
      this.#state = result?.values && result.model ? result : next;
      return result?.hearth ? result : undefined;
    });
    this.#answers = answer.catch(() => {});
    return answer;
  }

  set(ids, value) {
    const values = typeof ids === 'object' ? ids : { [ids]: value };
    return this.#ask((state) => this.#write(state, values));
  }

  restore(...ids) {
    return this.#ask((state) => {
      for (const id of ids) {
        this.#write(state, { [id]: DEFAULTS[state.model][id] });
        if (id === 'particles' && state.model === 'combustion') state.named = false;
      }
    });
  }

  exportConfig() {
    return this.#ask(({ preset, model, named, values, objects }) => {
      const changed = Object.keys(DEFAULTS).map((of) => {
        const base = this.#fresh(preset).values[of];
        const differing = Object.entries(values[of]).filter(
          ([id, value]) => value !== base[id] || (id === 'particles' && named && of === 'combustion'),
        );
        return [of, Object.fromEntries(differing)];
      });
      const { [model]: present, ...other } = Object.fromEntries(changed);
      if (model !== this.#fresh(preset).model) present.model = model;
      return { hearth: 2, preset, values: present, ...other, objects: structuredClone(objects) };
    });
  }

  importConfig({ preset = 'default', values = {}, objects = undefined, ...other }) {
    return this.#ask(() => {
      const state = this.#fresh(preset);
      const { model } = state;
      for (const [of, own] of Object.entries(other)) if (of in DEFAULTS) this.#write(state, { ...own, model: of });
      state.model = model;
      this.#write(state, objects ? { ...values, objects } : values);
      return state;
    });
  }
}

/** Everything that can be seen of a fire, of the model that does not burn too. */
const seen = async (fire) => ({
  config: await fire.exportConfig(),
  params: fire.params,
  all: fire.all,
  objects: fire.objects,
});

/** Numbers from 0 to 1 that look random, the same ones each time. */
function* numbers(seed) {
  for (let x = seed; ; ) {
    x = (x * 16807) % 2147483647;
    yield x / 2147483647;
  }
}

/** An act of a user. */
function deed(steps, fire, random) {
  const pick = (list) => list[Math.floor(random.next().value * list.length)];
  const id = pick(['width', 'viscosity', 'wind', 'particles']);
  steps.press();
  return pick([
    () => steps.set(id, Math.round(random.next().value * 20)),
    () => steps.set(id, Math.round(random.next().value * 20)),
    () => steps.set('model', pick(['classic', 'combustion'])),
    () => steps.restore(id),
    () => steps.all(() => fire.restore('width', 'viscosity', 'wind', 'particles')),
    () => steps.all(() => fire.importConfig({ preset: pick(Object.keys(PRESETS)) })),
    () => steps.all(() => fire.importConfig({ values: { particles: 3000, wind: 3 } })),
  ])();
}

/** An act of a user on objects, or on a value between two such acts. */
function deedWithObjects(steps, fire, random) {
  const pick = (list) => list[Math.floor(random.next().value * list.length)];
  const value = Math.round(random.next().value * 20);
  const last = () => fire.objects.at(-1);
  steps.press();
  return pick([
    () => steps.set('wind', value),
    // By then, the object may be gone.
    () => steps.change(last()?.id, { width: value }).catch(() => {}),
    () => steps.change(2, { width: value }).catch(() => {}),
    () =>
      steps
        .changeAll(new Map(fire.objects.map((object) => [object.id, { width: object.width + value }])))
        .catch(() => {}),
    () => steps.objects(() => fire.addObject({ kind: 'solid', width: 1 })),
    () => steps.objects(() => fire.objects.length > 0 && fire.removeObject(pick(fire.objects).id)),
    () => steps.objects(() => fire.set({ objects: [...fire.objects.slice(1), ...fire.objects.slice(0, 1)] })),
    () => steps.all(() => fire.importConfig({ preset: 'windy' })),
  ])();
}

const made = () => {
  const fire = new Fire();
  let changes = 0;
  const steps = new UndoHistory(
    fire,
    () => {
      changes += 1;
    },
    (id, model) => DEFAULTS[model][id],
  );
  return { fire, steps, changes: () => changes };
};

describe('the way back', () => {
  for (const [seed, act] of SEEDS.flatMap((seed) =>
    [deed, deedWithObjects].map((act) => /** @type {const} */ ([seed, act])),
  )) {
    test(`leads through the same fires, one after another (${act.name}, ${seed})`, async () => {
      const { fire, steps } = made();
      const random = numbers(seed);
      const fires = [await seen(fire)];
      for (let count = 0; count < 25; count += 1) {
        if (fires.length > 1 && random.next().value < 0.2) {
          await steps.undo();
          fires.pop();
          assert.deepEqual(await seen(fire), fires.at(-1));
          continue;
        }
        await act(steps, fire, random);
        const now = await seen(fire);
        if (JSON.stringify(now) !== JSON.stringify(fires.at(-1))) fires.push(now);
      }
      // A new step, after which there is none to redo.
      steps.press();
      await steps.set('wind', 21);
      fires.push(await seen(fire));
      const forth = structuredClone(fires);
      while (fires.length > 1) {
        assert.deepEqual(await seen(fire), fires.pop());
        assert.equal(await steps.undo(), true);
      }
      assert.deepEqual(await seen(fire), fires[0]);
      assert.equal(await steps.undo(), false);
      for (const state of forth.slice(1)) {
        assert.equal(await steps.redo(), true);
        assert.deepEqual(await seen(fire), state);
      }
      assert.equal(await steps.redo(), false);
    });

    test(`leads back to the first fire, however fast the acts follow (${act.name}, ${seed})`, async () => {
      const { fire, steps } = made();
      const random = numbers(seed);
      const first = await seen(fire);
      await Promise.all(Array.from({ length: 12 }, () => act(steps, fire, random)));
      const last = await seen(fire);
      while (steps.canUndo) await steps.undo();
      assert.deepEqual(await seen(fire), first);
      while (steps.canRedo) await steps.redo();
      assert.deepEqual(await seen(fire), last);
    });
  }
});

describe('a step', () => {
  test('is a whole drag, and the next press is another one', async () => {
    const { fire, steps } = made();
    steps.press();
    await Promise.all([6, 7, 8].map((value) => steps.set('viscosity', value)));
    steps.press();
    await steps.set('viscosity', 9);
    await steps.undo();
    assert.equal(fire.params.viscosity, 8);
    await steps.undo();
    assert.equal(fire.params.viscosity, 5);
    assert.equal(steps.canUndo, false);
  });

  test('has no step without a change: a drag there and back, the same value, a rejection', async () => {
    const { fire, steps } = made();
    await Promise.all([6, 7, 5].map((value) => steps.set('viscosity', value)));
    steps.press();
    await steps.set('viscosity', 5);
    await assert.rejects(steps.set('viscosity', LARGEST + 1), RangeError);
    await assert.rejects(
      steps.all(() => fire.importConfig({ values: { nothing: 1 } })),
      /nothing/,
    );
    await steps.all(() => fire.importConfig({}));
    assert.equal(steps.canUndo, false);
    // And what comes next goes on as if nothing had been.
    await steps.set('wind', 1);
    assert.equal(steps.canUndo, true);
  });

  test('is a whole drag of a property, and keeps what a page changes meanwhile', async () => {
    const { fire, steps } = made();
    steps.press();
    await Promise.all([6, 7, 8].map((value) => steps.change(2, { width: value })));
    await steps.objects(() => fire.removeObject(2));
    await fire.changeObject(1, { width: 9 });
    await steps.undo();
    assert.deepEqual(fire.objects, [
      { id: 1, kind: 'source', width: 9 },
      { id: 2, kind: 'solid', width: 8 },
    ]);
    await steps.undo();
    assert.deepEqual(fire.objects[1], { id: 2, kind: 'solid', width: 5 });
    assert.equal(steps.canUndo, false);
    await steps.redo();
    await steps.redo();
    assert.deepEqual(fire.objects, [{ id: 1, kind: 'source', width: 9 }]);
  });

  test('forgets what was undone before it', async () => {
    const { steps, changes } = made();
    await steps.set('viscosity', 6);
    await steps.undo();
    assert.equal(steps.canRedo, true);
    const before = changes();
    steps.press();
    await steps.set('wind', 1);
    assert.equal(steps.canRedo, false);
    assert.ok(changes() > before);
  });

  test('leaves foreign changes alone', async () => {
    const { fire, steps } = made();
    await steps.set('viscosity', 6);
    await fire.set('wind', 3);
    await steps.undo();
    assert.deepEqual([fire.params.viscosity, fire.params.wind], [5, 3]);
  });

  test('goes back to its own model', async () => {
    const { fire, steps } = made();
    await steps.set('width', 6);
    await fire.set('model', 'classic');
    await steps.undo();
    assert.deepEqual([fire.params.model, fire.params.width], ['combustion', 4]);
  });

  test('lets the number of particles follow the quality again', async () => {
    const { fire, steps } = made();
    await steps.set('particles', 900);
    await steps.undo();
    assert.deepEqual((await fire.exportConfig()).values, {});
    await steps.redo();
    assert.deepEqual((await fire.exportConfig()).values, { particles: 900 });
  });

  test('that the fire now rejects is dropped, and the rejection is reported', async () => {
    const { fire, steps } = made();
    await steps.set('viscosity', 6);
    fire.set = () => Promise.reject(new RangeError('no more'));
    await assert.rejects(steps.undo(), /no more/);
    assert.deepEqual([steps.canUndo, steps.canRedo], [false, false]);
  });

  test('of long ago is forgotten, so that a long day fills no memory', async () => {
    const { fire, steps } = made();
    for (let value = 0; value < 300; value += 1) {
      steps.press();
      await steps.set('wind', value % 2 ? 1 : 2);
    }
    let count = 0;
    while (await steps.undo()) count += 1;
    assert.ok(count >= 100 && count < 300, `${count} steps`);
    assert.ok([1, 2].includes(fire.params.wind));
  });
});

test('what a pointer moves is one step for each press, whatever the fire reports in between', async () => {
  const fire = new Fire();
  const history = new UndoHistory(
    fire,
    () => {},
    (id, model) => DEFAULTS[model][id],
  );
  await fire.set({
    objects: [
      { id: 1, kind: 'source', x: 0, y: 0 },
      { id: 2, kind: 'solid', x: 1, y: 0 },
    ],
  });
  const places = () => fire.objects.map(({ x, y }) => [x, y]);
  const first = places();
  for (const by of [0.5, 0.25]) {
    history.press();
    const before = fire.objects;
    for (const share of [0.5, 1]) {
      for (const { id, x } of before) {
        await fire.changeObject(id, { x: x + share * by });
        history.moved(before);
      }
    }
  }
  assert.deepEqual(places(), [
    [0.75, 0],
    [1.75, 0],
  ]);
  await history.undo();
  assert.deepEqual(places(), [
    [0.5, 0],
    [1.5, 0],
  ]);
  await history.undo();
  assert.deepEqual(places(), first);
  assert.equal(history.canUndo, false);
  await history.redo();
  await history.redo();
  assert.deepEqual(places(), [
    [0.75, 0],
    [1.75, 0],
  ]);
});
