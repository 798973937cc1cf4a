/** Elements without a box: each is named, with the reason. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { warnOfBox, whyNoBox } from '../../web/element/view/box.js';

Object.assign(globalThis, { getComputedStyle: ({ display }) => ({ display }) });

/** An element; by default it is on a page, and as large as that says. */
const fireOf = (more) =>
  /** @type {any} */ ({
    id: '',
    isConnected: true,
    display: 'block',
    offsetWidth: 300,
    offsetHeight: 200,
    checkVisibility: () => true,
    ...more,
  });

test('an element without a box has a reason, and one with a box or in a hidden part of the page has none', () => {
  assert.equal(whyNoBox(fireOf({})), '');
  assert.equal(whyNoBox(fireOf({ offsetWidth: 0, checkVisibility: () => false })), '');
  assert.match(whyNoBox(fireOf({ isConnected: false })), /on no page/);
  assert.match(whyNoBox(fireOf({ display: 'contents', checkVisibility: () => false })), /display: contents/);
  assert.match(whyNoBox(fireOf({ offsetHeight: 0 })), /300 × 0 pixels/);
});

test('the warning names the element', () => {
  const { warn } = console;
  /** @type {string[]} */
  const warnings = [];
  console.warn = (text) => warnings.push(text);
  warnOfBox(fireOf({ id: 'hero', isConnected: false }));
  warnOfBox(fireOf({ id: 'x'.repeat(1000), offsetWidth: 0 }));
  warnOfBox(fireOf({}));
  console.warn = warn;
  assert.equal(warnings.length, 2);
  assert.match(warnings[0], /^<hearth-fire id="hero"> is on no page/);
  assert.ok(warnings[1].length < 300);
});
