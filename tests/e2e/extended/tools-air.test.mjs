/**
 * The tools that act on the gas, with a real mouse and keys. What they call is in `web/tool-effects.test.mjs`.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { canUndo, chord, drag, openTools, toolStatus, tool, WIDE } from '../tools.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

/** What a tool calls meanwhile: each call's name and arguments. @param {() => Promise<unknown>} act */
async function calls(tab, act) {
  await tab.fire((fire) => {
    window.calls = [];
    for (const name of ['stir', 'sparks']) fire[name] = async (...call) => void window.calls.push([name, ...call]);
  });
  await act();
  return tab.until('a call', () => window.calls.length > 0 && window.calls);
}

test('a drag blows flames its way, and keys blow and throw sparks from the cross; none is a step', async () => {
  const tab = await openTools(browser, WIDE, 'scene=default&paused&quality=low');
  await tool(tab, 'blow');
  assert.match(await toolStatus(tab), /^Blow: Drag to blow/);
  const left = await calls(tab, () => drag(tab, [0.1, 0.3], [-0.1, 0.3]));
  assert.ok(left.every(([name, , , u]) => name === 'stir' && u <= 0) && left.some(([, , , u]) => u < 0), `${left}`);
  await tab.page.focus('.hearth-overlay');
  const cross = () => tab.page.$eval('.hearth-overlay .cross', (path) => path.getBoundingClientRect().y);
  await tab.key('Enter');
  const middle = await cross();
  for (let down = 0; down < 4; down += 1) await chord(tab, 'Shift', 'ArrowDown');
  const at = await cross();
  assert.ok(at > middle, 'with Shift, an arrow moves the cross');
  const right = await calls(tab, () => tab.key('ArrowRight'));
  assert.ok(
    right.every(([, , , u]) => u > 0),
    `${right}`,
  );
  assert.equal(await cross(), at, 'an arrow blows and moves nothing');
  await tab.key('k');
  const [sparks] = await calls(tab, () => tab.key('Enter'));
  assert.equal(sparks[0], 'sparks');
  assert.equal(await canUndo(tab), false);
  await tab.fire((fire) => fire.set('model', 'classic'));
  await tab.key('b');
  await tab.key('k');
  assert.match(await toolStatus(tab), /The classic model has none/);
  assert.deepEqual(tab.problems, []);
});
