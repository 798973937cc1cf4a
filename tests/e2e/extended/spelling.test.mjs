/**
 * Unknown names in attributes and in `controls`. Suggestions are tested in
 * tests/web/spelling.test.mjs.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser, eventually } from '../driver.mjs';
import { recording } from '../assertions.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

const SMALL = 'paused quality="low" style="width: 40px; height: 50px"';

/** Waits until the page has warned so often; gives the warnings. */
async function warnings(tab, count) {
  await eventually(
    `${count} warnings`,
    () => tab.problems,
    ({ length }) => length >= count,
    () => tab.frames(1),
  );
  return tab.problems;
}

test('attributes without effect cause one warning, in HTML or set later; removed ones cause none', async () => {
  const tab = await browser.show(
    `<hearth-fire ${SMALL} data-a="1" class="a" v-if="b" quailty="low"></hearth-fire>`.repeat(2),
  );
  await tab.ready();
  await tab.fire((fire) => {
    fire.setAttribute('expozure', '1');
    fire.toggleAttribute('interractive');
    fire.setAttribute('expozure', '2');
    fire.setAttribute('gone', '1');
    fire.removeAttribute('gone');
  });
  await warnings(tab, 3);
  await tab.frames(5);
  const [first, second, third, ...more] = tab.problems;
  assert.match(first, /^console\.warn.*<hearth-fire>.*quailty; did you mean quality\?/);
  assert.match(second, /expozure.*exposure/);
  assert.match(third, /interractive.*interactive/);
  assert.deepEqual(more, []);
});

test('content that a fire does not show causes one warning that names the first element and the remedy', async () => {
  const fire = (/** @type {string} */ content) => `<hearth-fire ${SMALL}>${content}</hearth-fire>`;
  for (const [content, words] of /** @type {[string, RegExp | undefined][]} */ ([
    ['<h1>Welcome</h1><p>Text</p>', /<hearth-fire>: <h1> inside it is not shown; close the fire by <\/hearth-fire>/],
    [fire(''), /<hearth-fire> inside it is not shown; close/],
    ['<hearth-sorce></hearth-sorce>', /<hearth-sorce> inside it is not shown; did you mean <hearth-source>\?/],
    ['<hearth-solids></hearth-solids>', /did you mean <hearth-solid>\?/],
    ['<div><img slot="poster" alt=""></div>', /<div> inside it is not shown;.*slot="poster"/],
    ['<img slot="poster" alt=""><template></template><style></style>text', undefined],
    ['<div><hearth-solid></hearth-solid></div>', undefined],
  ])) {
    const tab = await browser.show(fire(content));
    await tab.ready();
    if (words) assert.match((await warnings(tab, 1))[0], words);
    await tab.frames(3);
    assert.equal(tab.problems.length, words ? 1 : 0, tab.problems.join());
  }
});

test('`controls` names the parameters of the panel, and unknown names are reported', async () => {
  const tab = await browser.open(
    recording(
      '<hearth-fire paused quality="low" controls="fuel_power wind, palete hot-colour" style="width: 700px; height: 500px"></hearth-fire>',
    ),
    {
      files: {
        'panel.js': {
          body: `export async function mountPanel({ only }) {
      (window.mounted ??= []).push(only ?? 'all');
      return { destroy() { window.mounted.push('gone'); } };
    }`,
        },
      },
    },
  );
  const mounted = (wanted) =>
    tab.until(
      `${JSON.stringify(wanted)}`,
      (all) => JSON.stringify(/** @type {any} */ (window).mounted) === JSON.stringify(all),
      wanted,
    );
  const list = [['fuel_power', 'wind', 'hot_colour']];
  await mounted(list);
  const [error] = await tab.until('a refusal', () => {
    const all = /** @type {any} */ (window).events.filter(({ type }) => type === 'error');
    return all.length > 0 && all.map(({ detail }) => detail);
  });
  assert.deepEqual([error.kind, error.id, error.value], ['bad-parameter', 'controls', 'palete']);
  assert.match(error.message, /did you mean palette\?/);
  assert.equal(await tab.fire((fire) => fire.controls), 'fuel_power wind, palete hot-colour');
  for (const [value, shown, read] of [
    ['', 'all', true],
    ['controls', 'all', 'controls'],
    ['exposure', ['exposure'], 'exposure'],
  ]) {
    await tab.fire((fire, text) => fire.setAttribute('controls', text), value);
    list.push('gone', shown);
    await mounted(list);
    assert.equal(await tab.fire((fire) => fire.controls), read);
  }
  await tab.fire((fire) => {
    fire.controls = false;
  });
  await mounted([...list, 'gone']);
  const set = await tab.fire((fire) => {
    fire.controls = 'wind';
    const controls = fire.getAttribute('controls');
    fire.controls = true;
    return [controls, fire.getAttribute('controls')];
  });
  assert.deepEqual(set, ['wind', '']);
});

test('an element without a box causes one warning that names it, and one that is hidden or has a box causes none', async () => {
  const tab = await browser.show(`
    <hearth-fire id="boxless" style="display: contents"></hearth-fire>
    <hearth-fire id="flat" style="width: 0; height: 40px"></hearth-fire>
    <div hidden><hearth-fire id="hidden"></hearth-fire></div>
    <hearth-fire id="seen" ${SMALL}></hearth-fire>`);
  await warnings(tab, 2);
  await tab.frames(5);
  const [first, second, ...more] = tab.problems.toSorted();
  assert.match(first, /<hearth-fire id="boxless"> has display: contents/);
  assert.match(second, /<hearth-fire id="flat"> is 0 × 40 pixels large/);
  assert.deepEqual(more, []);
});
