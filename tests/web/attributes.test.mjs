/** Properties that reflect attributes: what frameworks and servers write is what it means. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { FireAttributes } from '../../web/element/attributes/attributes.js';

/** An element without a DOM, with these attributes. */
class Element extends FireAttributes {
  #attributes;
  constructor(attributes = {}) {
    super();
    this.#attributes = new Map(Object.entries(attributes));
  }
  getAttribute(name) {
    return this.#attributes.get(name) ?? null;
  }
  setAttribute(name, value) {
    this.#attributes.set(name, value);
  }
  removeAttribute(name) {
    this.#attributes.delete(name);
  }
}

/** The texts and the values of a flag that is off and of one that is on. */
const OFF = [false, 'false', null];
const ON = [true, 'true', ''];

for (const [name, on] of [
  ['interactive', true],
  ['controls', true],
  ['warm', 3],
]) {
  test(`${name} is off by false and on by true, as an attribute and as a property, in text too`, () => {
    assert.equal(new Element()[name], false);
    for (const text of ['false']) assert.equal(new Element({ [name]: text })[name], false);
    for (const text of ['', 'true']) assert.equal(new Element({ [name]: text })[name], on);
    const element = new Element();
    for (const [value, expected] of [...ON.map((value) => [value, on]), ...OFF.map((value) => [value, false])]) {
      element[name] = value;
      assert.equal(element[name], expected, String(value));
    }
  });
}

test('a flag with a value has that value', () => {
  const element = new Element({ warm: '5', controls: 'wind' });
  assert.deepEqual([element.warm, element.controls], [5, 'wind']);
  element.warm = 2;
  element.controls = 'gravity';
  assert.deepEqual([element.warm, element.controls], [2, 'gravity']);
});

test('undefined states nothing, and null removes the attribute', () => {
  const values = { preset: 'candle', autoplay: 'false', poster: 'a.png', fit: 'cover', zoom: '2', interactive: '' };
  const element = new Element(values);
  const before = Object.keys(values).map((name) => element[name]);
  for (const name of Object.keys(values)) element[name] = undefined;
  assert.deepEqual(
    Object.keys(values).map((name) => element[name]),
    before,
  );
  for (const name of Object.keys(values)) element[name] = null;
  const bare = new Element();
  for (const name of Object.keys(values)) assert.equal(element[name], bare[name], name);
});

test('undefined after a value of the same property removes the attribute, as React takes a property away', () => {
  const values = { preset: 'candle', autoplay: false, poster: 'a.png', fit: 'cover', zoom: 2, interactive: true };
  const [element, bare] = [new Element(), new Element()];
  Object.assign(element, values);
  for (const name of Object.keys(values)) {
    assert.notEqual(element[name], bare[name], name);
    element[name] = undefined;
    assert.equal(element[name], bare[name], name);
  }
});
