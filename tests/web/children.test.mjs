/**
 * Children of a fire without a browser: which list the engine gets, and when.
 */
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { powerOf } from '../../web/mask/burning.js';

/** @type {(() => void)[]} */
let frames = [];
/** Calls of observers of attributes. @type {(() => void)[]} */
let observers = [];
let isPhone = false;
/** The elements that are observed. @type {Set<any>} */
const observed = new Set();

/** An element of the fake page. */
class FakeElement {
  /** @type {string[]} */
  static observedAttributes = [];
  localName = '';
  id = '';
  fire;
  #attributes = new Map();

  getAttribute(name) {
    return this.#attributes.get(name) ?? null;
  }

  getAttributeNames() {
    return [...this.#attributes.keys()];
  }

  hasAttribute(name) {
    return this.#attributes.has(name);
  }

  setAttribute(name, value) {
    this.#attributes.set(name, value);
    this.#changed(name);
  }

  removeAttribute(name) {
    this.#attributes.delete(name);
    this.#changed(name);
  }

  closest() {
    return this.fire;
  }

  #changed(name) {
    const { observedAttributes } = /** @type {any} */ (this.constructor);
    if (observedAttributes.includes(name)) /** @type {any} */ (this).attributeChangedCallback(name);
  }
}

/** @type {{[name: string]: new () => any}} */
const classes = {};
Object.assign(globalThis, {
  HTMLElement: FakeElement,
  customElements: { get: () => undefined, define: (name, made) => (classes[name] = made) },
  document: { readyState: 'complete', hidden: false },
  requestAnimationFrame: (act) => frames.push(act),
  cancelAnimationFrame: () => {},
  matchMedia: () => ({ matches: isPhone }),
  MutationObserver: class {
    targets = [];
    constructor(act) {
      observers.push(() => act([{ target: new FakeElement(), attributeName: 'id' }]));
    }
    observe(target) {
      this.targets.push(target);
      observed.add(target);
    }
    disconnect() {
      for (const target of this.targets.splice(0)) observed.delete(target);
    }
  },
});
Object.defineProperty(globalThis, 'navigator', { value: { hardwareConcurrency: 8 }, configurable: true });
const { Children } = await import('../../web/element/children/children.js');

/** A fire of a fake page, whose engine keeps what it gets. */
class Page {
  /** @type {any[]} */
  elements = [];
  /** The calls, in order. @type {any[][]} */
  calls = [];
  /** @type {{resolve: Function, reject: Function}[]} */
  answers = [];
  live = true;
  state = {
    started: true,
    objects: [],
    settings: {},
    params: {},
    get guess() {
      return isPhone ? 'low' : 'medium';
    },
  };
  fire = Object.assign(new FakeElement(), { querySelectorAll: () => this.elements });
  warnings = [];
  reports = {
    refused: (errors) => this.warnings.push(...errors.map(({ message }) => message)),
    loads: (/** @type {Promise<any>} */ code) => code,
  };

  constructor() {
    frames = [];
    observers = [];
    this.children = new Children(/** @type {any} */ (this));
  }

  /** A call of the page or of the children, as the session makes it. */
  call(...call) {
    if (call[0] !== 'children') this.children.send();
    this.calls.push(call);
    return new Promise((resolve, reject) => this.answers.push({ resolve, reject }));
  }

  /** An element with these attributes, behind the others. */
  append(name, attributes = {}) {
    const element = new classes[name]();
    Object.assign(element, { localName: name, fire: this.fire, id: attributes.id ?? '' });
    for (const [attribute, value] of Object.entries(attributes)) element.setAttribute(attribute, value);
    this.elements.push(element);
    return element;
  }

  /** The list of the last call after the next frame; undefined if there is no call. */
  frame() {
    this.calls = [];
    for (const act of frames.splice(0)) act();
    assert.ok(this.calls.length <= 1, 'one list a frame');
    return this.calls[0]?.[1];
  }

  /** The engine reports these objects. */
  report(objects, settings = {}) {
    Object.assign(this.state, { objects, settings });
    this.children.report(/** @type {any} */ ({ type: 'changed' }));
  }
}

test('the engine gets the list of all children once a frame, with the names of what is stated anew', () => {
  const page = new Page();
  const solid = page.append('hearth-solid', { x: '0.1' });
  page.append('hearth-source', { power: '80' });
  page.children.update();
  const all = page.frame();
  assert.deepEqual(
    all.map(({ id, kind, values }) => [id, kind, values]),
    [
      [1001, 'solid', { x: '0.1' }],
      [1002, 'source', { power: '80' }],
    ],
  );
  assert.equal(page.frame(), undefined);
  solid.setAttribute('x', '0.2');
  solid.removeAttribute('y');
  solid.setAttribute('x', '0.3');
  const [first, second] = page.frame();
  assert.deepEqual([first.values, first.changed], [{ x: '0.3' }, ['x', 'y']]);
  assert.deepEqual([second.values, second.changed], [{ power: '80' }, []]);
  page.elements.shift();
  page.children.update();
  assert.deepEqual(
    page.frame().map(({ id }) => id),
    [1002],
  );
  // Nothing has changed.
  page.children.update();
  assert.equal(page.frame(), undefined);
});

test('attributes and calls of the page keep their order', () => {
  const page = new Page();
  const solid = page.append('hearth-solid', { x: '0.1' });
  page.children.update();
  page.frame();
  page.calls = [];
  solid.setAttribute('x', '0.2');
  page.call('changeObject', 1001, { x: 0.3 });
  solid.setAttribute('y', '0.4');
  const calls = page.calls.map(([name]) => name);
  assert.deepEqual(calls, ['children', 'changeObject']);
  assert.deepEqual(page.frame()[0].changed, ['y']);
});

test('without a fire the list waits for no frame, and what an engine has not answered goes to the next one', async () => {
  const page = new Page();
  page.live = false;
  const solid = page.append('hearth-solid', { x: '0.1' });
  page.children.update();
  await Promise.resolve();
  assert.deepEqual([page.calls.length, frames.length], [1, 0]);
  page.live = true;
  solid.setAttribute('y', '0.2');
  page.frame();
  page.answers[1].reject(new Error('the engine has stopped'));
  await new Promise(setImmediate);
  assert.equal(page.frame(), undefined, 'no list while there is no engine');
  page.children.report(/** @type {any} */ ({ type: 'ready' }));
  assert.deepEqual(page.frame()[0].changed, ['y']);
});

test('a child has the id of its object while the fire has one', () => {
  const page = new Page();
  const source = page.append('hearth-source');
  page.state.objects = [{ id: 1001, kind: 'source' }];
  page.children.update();
  assert.equal(page.frame()[0].id, 1002);
  assert.equal(source.objectId, null);
  page.report([{ id: 1002, kind: 'source' }], { children: [{ id: 1002 }] });
  assert.equal(source.objectId, 1002);
  page.report([{ id: 1002, kind: 'solid' }], { children: [{ id: 1002 }] });
  assert.equal(source.objectId, null);
  // A call has removed it, and the page has a source with that id.
  page.report([{ id: 1002, kind: 'source' }], { children: [{ id: 1002, state: 'removed' }] });
  assert.equal(source.objectId, null);
  page.elements = [];
  page.children.update();
  assert.equal(source.objectId, null);
});

test('a name of a solid is its id from the first list, and follows it', () => {
  const page = new Page();
  const warned = [];
  const { warn } = console;
  console.warn = (message) => warned.push(message);
  const source = page.append('hearth-source', { shape: 'solid', solid: '#log' });
  const log = page.append('hearth-solid', { id: 'log' });
  const ball = page.append('hearth-solid', { id: 'ball', 'hangs-from': '#none' });
  page.children.update();
  const [first, , third] = page.frame();
  assert.deepEqual([first.values.solid, third.values.hangs_from], [1002, 0]);
  // Another solid takes the name.
  [log.id, ball.id] = ['ashes', 'log'];
  observers[0]();
  const [other] = page.frame();
  assert.deepEqual([other.values.solid, other.changed], [1003, ['solid']]);
  source.setAttribute('solid', '5');
  assert.equal(page.frame()[0].values.solid, '5');
  console.warn = warn;
  assert.deepEqual(warned, [
    '<hearth-fire>: <hearth-solid id="ball">: hangs-from = #none has no effect now: no <hearth-solid> of this fire has that id.',
  ]);
});

test('a refusal names the element and the attribute, and one for lack of room comes once', () => {
  const page = new Page();
  page.append('hearth-source');
  page.append('hearth-solid', { id: 'lid', 'heat-capacity': '0' });
  page.children.update();
  page.frame();
  const error = (id, message) => ({ id, value: '0', message: `${id} ${message}` });
  const [call] = [.../** @type {any} */ (page.children).sent.keys()];
  const named = () =>
    page.children.named(
      [error('children[1].heat_capacity', 'is refused'), error('children[0].objects', 'are many')],
      call,
    );
  assert.deepEqual(
    named()?.map(({ id, message }) => [id, message]),
    [
      ['heat-capacity', '<hearth-solid id="lid">: heat-capacity is refused'],
      ['objects', '<hearth-source>: objects are many'],
    ],
  );
  assert.equal(named()?.length, 1);
  const other = { ...error('children', 'has no code') };
  assert.deepEqual(page.children.named([other], call), [other]);
  assert.equal(page.children.named([error('bloom', 'is refused')], Promise.resolve()), undefined);
});

test('an invalid target and a text that is too long are refused', () => {
  const page = new Page();
  const solid = page.append('hearth-solid', { of: 'headline', points: '0,0 '.repeat(30_000), name: 'a'.repeat(2000) });
  page.children.update();
  const [{ values }] = page.frame();
  assert.deepEqual(
    [values.points, values.name],
    ['a text of more than 66000 letters', 'a text of more than 1000 letters'],
  );
  assert.match(page.warnings[0], /<hearth-solid>: of = headline is refused: it must be # and the id of an element/);
  solid.removeAttribute('of');
  assert.equal(page.warnings.length, 1);
});

test('a child that leaves the fire is observed no longer', () => {
  const page = new Page();
  observed.clear();
  const [first, second] = ['a', 'b'].map((id) => page.append('hearth-solid', { id }));
  page.children.update();
  assert.deepEqual([...observed], [first, second]);
  page.elements = [second];
  page.children.update();
  assert.deepEqual([...observed], [second]);
});

/** A page with a solid that burns, and what the engine gets of it. */
async function burning(attributes, page = new Page()) {
  const solid = page.append('hearth-solid', { burning: '', shape: 'box', width: '1', height: '0.291', ...attributes });
  page.children.update();
  assert.deepEqual(page.frame(), [], 'its code is not loaded');
  await import('../../web/element/children/child-burning.js');
  await null;
  return { page, solid, all: page.frame() };
}

test('a solid that burns is glowing coal before the flame, with a source on its outline', async () => {
  const { page, solid, all } = await burning({});
  const [coal, flame] = all;
  assert.deepEqual([coal.id, coal.kind, flame.id, flame.kind], [1001, 'solid', 1002, 'source']);
  const { material, plane, temperature, width } = coal.values;
  assert.deepEqual([material, plane, temperature, width], ['coal', 'before', 800, '1']);
  const { shape, solid: of, power } = flame.values;
  assert.deepEqual([shape, of, power], ['solid', 1001, Math.round(119 * 2 * 1.291)]);
  assert.deepEqual(flame.changed, Object.keys(flame.values));

  solid.setAttribute('material', 'iron');
  const [iron, same] = page.frame();
  assert.deepEqual([iron.values.material, same.changed], ['iron', []]);
  solid.setAttribute('burning', 'false');
  assert.deepEqual(
    page.frame().map(({ id, values }) => [id, values.plane]),
    [[1001, undefined]],
  );
});

test('a flame that an engine has not answered is stated anew, and a refusal of it names the solid', async () => {
  const { page, all } = await burning({ id: 'logo' });
  const call = [...page.children.sent.keys()].at(-1);
  const error = { id: 'children[1].power', message: 'children[1].power = -1 is refused' };
  const [named] = page.children.named([/** @type {any} */ (error)], call) ?? [];
  assert.match(String(named.message), /^<hearth-solid id="logo">: power/);
  for (const { reject } of page.answers) reject({});
  await new Promise(setImmediate);
  page.children.report(/** @type {any} */ ({ type: 'ready' }));
  assert.deepEqual(page.frame()[1].changed, all[1].changed);
});

/** The scene Burning word. */
const burningWord = () => JSON.parse(readFileSync(new URL('../../scenes/burning-word.json', import.meta.url), 'utf8'));

test('the power by the outline is that of the scene for its word, and less by the root of its height', () => {
  const { objects } = burningWord();
  const [{ power }, word] = objects;
  assert.ok(Math.abs(powerOf(word) / power - 1) < 0.01, `${powerOf(word)} kW/m`);
  const small = { ...word, width: word.width / 4, height: word.height / 4 };
  assert.ok(Math.abs(powerOf(small) / (powerOf(word) / 4 / 2) - 1) < 1e-9);
});

/**
 * The numbers of particles that the engine gets of a solid that burns in a domain of 2 × 1 m, and of the changes that follow.
 * @param {string} height of the solid [m]
 * @param {{attributes?: {[name: string]: string}, params?: object, later?: ((page: Page, solid: any) => void)[]}} [about]
 */
async function particlesOf(height, { attributes = {}, params = {}, later = [] } = {}) {
  const page = new Page();
  for (const [name, value] of Object.entries(attributes)) page.fire.setAttribute(name, value);
  page.state.params = { domain_width: 2, domain_height: 1, particles: 3000, ...params };
  const stated = [];
  const call = page.call.bind(page);
  page.call = (...given) => {
    if (given[0] !== 'set') return call(...given);
    const { particles } = given[1];
    stated.push(particles);
    page.state.params.particles = particles;
    page.state.settings = { values: { particles } };
    return Promise.resolve();
  };
  const { solid } = await burning({ width: '0.3', height }, page);
  for (const act of later) {
    // The last call is answered.
    await null;
    act(page, solid);
    page.frame();
  }
  return stated;
}

test('the gas is as fine as an eighteenth of what burns, by as many particles as the level above a requested one has', async () => {
  const needed = (/** @type {number} */ height) => Math.round(2 * (18 / height) ** 2);
  assert.deepEqual(await particlesOf('0.35'), [needed(0.35)]);
  const scene = burningWord();
  assert.ok(scene.objects[1].height / 18 < scene.values.spacing, 'finer than in the scene');
  // No coarser than without it, and no finer than the level high.
  assert.deepEqual(await particlesOf('0.8'), [3000]);
  assert.deepEqual(await particlesOf('0.1'), [6700]);
  assert.deepEqual(await particlesOf('0.1', { attributes: { quality: 'low' } }), [3000]);
  isPhone = true;
  assert.deepEqual(await particlesOf('0.1'), [3000]);
  assert.deepEqual(await particlesOf('0.1', { attributes: { quality: 'medium' } }), [6700]);
  isPhone = false;
  assert.deepEqual(await particlesOf('0.8', { attributes: { quality: 'high' } }), [6700]);
  assert.deepEqual(await particlesOf('0.8', { params: { particles: 9000 } }), [9000], 'those of a scene');
});

test('a page that states its particles keeps them, and a target that changes little changes no gas', async () => {
  for (const name of ['particles', 'spacing'])
    assert.deepEqual(await particlesOf('0.1', { attributes: { [name]: '900' } }), []);
  const height = (/** @type {string} */ text) => (/** @type {Page} */ _, /** @type {any} */ solid) =>
    solid.setAttribute('height', text);
  assert.deepEqual(await particlesOf('0.35', { later: [height('0.34'), height('0.36')] }), [5290]);
  assert.deepEqual(await particlesOf('0.35', { later: [height('0.3'), height('0.35')] }), [5290, 6700]);
  const sets = (/** @type {object} */ values) => (/** @type {Page} */ page) => page.report([], { values });
  assert.deepEqual(await particlesOf('0.35', { later: [sets({ particles: 500 }), height('0.1')] }), [5290]);
  assert.deepEqual(await particlesOf('0.35', { later: [sets({ spacing: 0.05 }), height('0.1')] }), [5290]);
  // Another scene states none.
  assert.deepEqual(await particlesOf('0.35', { later: [sets({})] }), [5290, 5290]);
  // A source of the page on a thin solid is no recipe's.
  const thin = (/** @type {Page} */ page) => {
    page.append('hearth-solid', { id: 'rod', height: '0.01' });
    page.append('hearth-source', { shape: 'solid', solid: '#rod', power: '50' });
    page.children.update();
  };
  assert.deepEqual(await particlesOf('0.35', { later: [thin] }), [5290]);
});
