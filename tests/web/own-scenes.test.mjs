/** The list of own scenes in the storage of a page: what is damaged is kept and reported, and nothing is lost. */
import assert from 'node:assert/strict';
import { beforeEach, test } from 'node:test';
import { damageOfScenes, deleteScene, ownScenes, renameScene, saveScene } from '../../web/panel/own-scenes.js';

const KEY = 'hearth-scenes';
const CONFIG = /** @type {any} */ ({ hearth: 3, values: { wind: 1 } });
const scene = (/** @type {string} */ name) => ({ name, config: CONFIG, picture: '' });

/** @type {Map<string, string>} */
let kept;
beforeEach(() => {
  kept = new Map();
  const localStorage = {
    getItem: (/** @type {string} */ key) => kept.get(key) ?? null,
    setItem: (/** @type {string} */ key, /** @type {string} */ text) => kept.set(key, text),
  };
  Object.defineProperty(globalThis, 'localStorage', { value: localStorage, configurable: true });
});
const damaged = () => [...kept].filter(([key]) => key !== KEY).map(([, text]) => text);

for (const [about, text, readable] of /** @type {[string, string, string[]]} */ ([
  ['half a list', JSON.stringify([scene('A'), scene('B')]).slice(0, -20), []],
  ['no JSON', 'My fires', []],
  ['no list', '{"A": {"hearth": 3}}', []],
  ['nothing at all', 'null', []],
  ['a number', '7', []],
  ['a text', '"A"', []],
  ['a scene without settings among others', JSON.stringify([scene('A'), { name: 'B' }]), ['A']],
  ['a scene without a name', JSON.stringify([{ config: CONFIG }, scene('B')]), ['B']],
  ['a hole', JSON.stringify([scene('A'), null]), ['A']],
])) {
  for (const [change, act, names] of /** @type {[string, () => unknown, string[]][]} */ ([
    ['a save', () => saveScene('New', CONFIG, ''), [...readable, 'New']],
    ['a deletion', () => deleteScene('A'), readable.filter((name) => name !== 'A')],
    ['a new name', () => renameScene(readable[0], 'C'), readable.map((name, at) => (at === 0 ? 'C' : name))],
  ])) {
    test(`a damaged list is reported, and kept beside the list of ${change}: ${about}`, () => {
      kept.set(KEY, text);
      assert.match(damageOfScenes(), /damaged/);
      act();
      assert.deepEqual(damaged(), [text]);
      assert.deepEqual(
        ownScenes().map(({ name }) => name),
        names,
      );
      assert.equal(damageOfScenes(), '');
    });
  }
}

test('each damaged list is kept, and a whole one is no damage', () => {
  for (const text of ['one', 'two']) {
    kept.set(KEY, text);
    saveScene('A', CONFIG, '');
  }
  assert.deepEqual(damaged(), ['one', 'two']);
  for (const text of ['', '[]', JSON.stringify([scene('A')])]) {
    kept.set(KEY, text);
    assert.equal(damageOfScenes(), '');
  }
});

test('a damaged list that cannot be kept is not overwritten', () => {
  kept.set(KEY, 'mine');
  localStorage.setItem = () => {
    throw new DOMException('full', 'QuotaExceededError');
  };
  assert.throws(() => saveScene('A', CONFIG, ''), /full/);
  assert.equal(kept.get(KEY), 'mine');
});
