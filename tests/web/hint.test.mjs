/** The offer to burn again, and hints in the words of a finger, without a browser. */
import assert from 'node:assert/strict';
import { test } from 'node:test';

/** A button of a fake page, or the place of the hint. */
class Part extends EventTarget {
  /** @type {Part[]} */
  children = [];
  isConnected = false;

  replaceChildren(...parts) {
    for (const part of this.children) part.isConnected = false;
    this.children = parts;
    for (const part of parts) part.isConnected = true;
  }

  remove() {
    this.isConnected = false;
  }
}

let coarse = false;
Object.assign(globalThis, {
  document: { createElement: () => new Part() },
  matchMedia: () => ({ matches: coarse }),
});
const { offerAgain } = await import('../../web/pages/hint.js');
const { TOOLS, worded } = await import('../../web/tools/table.js');

test('what has burnt down offers to burn again, while it is over and not before', () => {
  const [hint, fire] = [new Part(), new Part()];
  let resets = 0;
  Object.assign(fire, { reset: () => (resets += 1) });
  offerAgain(/** @type {any} */ (hint), /** @type {any} */ (fire));
  const offered = (/** @type {object} */ detail) => {
    fire.dispatchEvent(Object.assign(new Event('stats'), { detail }));
    return hint.children.some(({ isConnected }) => isConnected);
  };
  assert.equal(offered({ fuel: 'unlit', power: 0 }), false);
  assert.equal(offered({ fuel: 'burning', power: 40 }), false);
  assert.equal(offered({ fuel: 'burnt', power: 20 }), false, 'its gas still burns');
  assert.equal(offered({ fuel: '', power: 0 }), false, 'it has no fuel that could burn down');
  assert.equal(offered({ fuel: 'burnt', power: 0 }), true);
  assert.equal(offered({ fuel: 'burning', power: 40 }), false, 'it has been lit');
  assert.equal(offered({ fuel: 'out', power: 0.2 }), true);
  hint.children[0].dispatchEvent(new Event('click'));
  assert.deepEqual([resets, hint.children[0].isConnected], [1, false]);
});

test('a finger taps, and has neither a Shift key nor a cross', () => {
  for (const { hint } of TOOLS) assert.equal(worded(hint), hint);
  coarse = true;
  for (const { hint } of TOOLS) assert.doesNotMatch(worded(hint), /click|shift|arrow|enter|cross/i);
  assert.ok(TOOLS.some(({ hint }) => /tap/i.test(worded(hint))));
});
