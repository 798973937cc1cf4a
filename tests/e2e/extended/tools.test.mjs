/**
 * The toolbar: everything with keys alone, and the toolbar inside of any element with `controls`.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { PHONES, assertScaleApart, chord, close, drag, openTools, toolStatus, WIDE } from '../tools.mjs';
import { objectsUntil as until } from '../waits.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

test('keys draw, choose, move, turn, scale, duplicate and delete without a pointer', async () => {
  const tab = await openTools(browser);
  await tab.page.focus('.hearth-overlay');
  await tab.key('5');
  await tab.key('Enter');
  for (const key of ['ArrowRight', 'ArrowUp']) await chord(tab, 'Shift', key);
  await tab.key('Enter');
  const [, box] = await until(tab, 'a box', (all) => all.length === 2);
  assert.deepEqual([box.shape, box.width, box.height], ['box', 0.1, 0.1]);
  await tab.key('Escape');
  await tab.key('2');
  await tab.key('ArrowLeft');
  await until(tab, 'to the left', ([, solid]) => close(solid.x, box.x - 0.01, 1e-4));
  await tab.key('[');
  await until(tab, 'turned', ([, solid]) => solid.angle === 5);
  await tab.key('+');
  await until(tab, 'larger', ([, solid]) => close(solid.width, 0.11, 1e-4));
  await chord(tab, 'Control', 'd');
  await until(tab, 'three', (all) => all.length === 3);
  await tab.key('Delete');
  await until(tab, 'two', (all) => all.length === 2);
  assert.match(await toolStatus(tab), /is removed/);
  await tab.page.select('.hearth-toolbar select[aria-label="Selected object"]', '2');
  await tab.page.focus('.hearth-overlay');
  await tab.key('Delete');
  await until(tab, 'one', (all) => all.length === 1);
  assert.deepEqual(tab.problems, []);
});

for (const size of [WIDE, ...PHONES]) {
  test(`at ${size.width} × ${size.height}, arrow keys follow the four groups as they are on the screen`, async () => {
    const tab = await openTools(browser, size);
    const bar = await tab.evaluate(() => {
      const groups = [...document.querySelectorAll('.hearth-toolbar [role="group"]')];
      const [material] = document.querySelectorAll('.hearth-toolbar select');
      return {
        groups: groups.map((group) => group.getAttribute('aria-label')),
        labels: groups.map((group) => /** @type {Element} */ (group.firstElementChild).checkVisibility()),
        material: /** @type {HTMLSelectElement} */ (material).value,
      };
    });
    assert.deepEqual(bar.groups, ['Fire', 'Draw', 'Edit', 'View']);
    assert.equal(bar.material, 'wood');
    assert.ok(bar.labels.every((shown) => shown === (size.height >= 780 && size.width >= 560)));
    const row = size.width < 560 || size.height < 600;
    await tab.page.focus('.hearth-toolbar button');
    await tab.key('Home');
    const reached = [];
    for (;;) {
      const at = await tab.evaluate(() => {
        const button = /** @type {HTMLElement} */ (document.activeElement);
        button.scrollIntoView({ block: 'nearest', inline: 'center' });
        const bar = /** @type {Element} */ (button.closest('.hearth-toolbar'));
        const { x, y } = button.getBoundingClientRect();
        return { name: String(button.dataset.tool), along: x + bar.scrollLeft, down: y + bar.scrollTop };
      });
      if (at.name === reached[0]?.name) break;
      reached.push(at);
      await tab.key('ArrowRight');
    }
    assert.equal(reached.length, 27);
    for (const [at, { name, along, down }] of reached.slice(1).entries()) {
      const before = reached[at];
      // The ends stick to the sides.
      if ([name, before.name].some((end) => ['undo', 'close'].includes(end))) continue;
      assert.ok(
        row ? along > before.along : down > before.down || along > before.along,
        `${name} after ${before.name}`,
      );
    }
    if (row) assert.equal(reached[0].name, 'undo');
  });
}

test('a fire with controls offers the tools inside of it, loaded on request', async () => {
  const tab = await browser.open('<hearth-fire controls style="width: 700px; height: 500px"></hearth-fire>', WIDE);
  await tab.ready();
  const loaded = () =>
    tab.evaluate(() => performance.getEntriesByType('resource').some(({ name }) => name.endsWith('/tools.js')));
  const inside = (selector) =>
    tab.until(
      `${selector} inside`,
      (wanted) => document.querySelector('hearth-fire')?.shadowRoot?.querySelector(wanted) !== null,
      selector,
    );
  await inside('.hearth-draw');
  assert.equal(await loaded(), false);
  await tab.page.click('hearth-fire >>> .hearth-draw');
  await inside('[data-tool="box"]');
  assert.equal(await loaded(), true);
  await tab.page.click('hearth-fire >>> [data-tool="box"]');
  await drag(tab, [-0.1, 1.1], [0.1, 0.9]);
  await until(
    tab,
    'a box of wood that burns',
    ([, box, flame]) => box?.material === 'wood' && flame?.solid === box.id && flame.power > 0,
  );
  await assertScaleApart(tab);
  await tab.page.click('hearth-fire >>> [data-tool="close"]');
  await tab.until(
    'no toolbar',
    () => !document.querySelector('hearth-fire')?.shadowRoot?.querySelector('.hearth-toolbar'),
  );
  await tab.fire((fire) => fire.removeAttribute('controls'));
  await tab.until('no button', () => !document.querySelector('hearth-fire')?.shadowRoot?.querySelector('.hearth-draw'));
  assert.deepEqual(tab.problems, []);
});
