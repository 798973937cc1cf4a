/**
 * `<hearth-source>` and `<hearth-solid>` in a browser: its parser, observers and frames, the code that they load, and the
 * engine. Tables of lists are in `children.rs` of the tests of `hearth-settings`, and `web/children.test.mjs`.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { events, recording } from '../assertions.mjs';
import { acts, fireOf, openChildren, owned, settled, warnings } from '../children.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

/** The objects of the fire, each as `kind x`, in their order. */
const listed = (tab) => tab.fire((fire) => fire.objects.map(({ kind, x }) => `${kind} ${x}`));

/** The ids of the objects of all children. */
const ids = (tab) =>
  tab.fire((fire) => [...fire.querySelectorAll('hearth-source, hearth-solid')].map(({ objectId }) => objectId));

test('attributes and places of children are live, in any markup, and keep the order of calls', async () => {
  const tab = await openChildren(
    browser,
    '<hearth-source x="0.2" power="80"></hearth-source><hearth-solid x="0.1" y="0.8"></hearth-solid>',
    'source-width="0.1"',
  );
  assert.deepEqual(await listed(tab), ['source 0.2', 'solid 0.1']);
  assert.deepEqual(await tab.fire(({ params }) => [params.fuel_power, params.source_width]), [80, 0.1]);
  const values = async () => (({ x, y, width }) => [x, y, width])((await owned(tab))[1]);
  await acts(tab, (fire) => fire.lastElementChild.setAttribute('width', '0.3'));
  await acts(tab, (fire) => fire.changeObject(fire.lastElementChild.objectId, { x: -0.2, y: 1 }));
  assert.deepEqual(await values(), [-0.2, 1, 0.3]);
  // The same text is a change as well; the other properties stay.
  await acts(tab, (fire) => fire.lastElementChild.setAttribute('x', '0.1'));
  assert.deepEqual(await values(), [0.1, 1, 0.3]);
  await acts(tab, (fire) => {
    fire.lastElementChild.removeAttribute('width');
    fire.lastElementChild.removeAttribute('y');
  });
  // Of a call and an attribute in one task, the later one wins.
  await acts(tab, (fire) => {
    fire.lastElementChild.setAttribute('x', '0.2');
    fire.changeObject(fire.lastElementChild.objectId, { x: 0.3 });
  });
  assert.deepEqual(await values(), [0.3, 0.5, 0.2]);
  const origins = (await events(tab, 'objects-change')).map(({ source }) => source);
  assert.deepEqual(origins, ['child', 'property', 'child', 'child', 'child', 'property']);
  for (const markup of [
    '<p><hearth-solid x="0.1"></hearth-solid><br><hearth-solid x="0.2"></hearth-solid></p>',
    '<hearth-solid x="0.1" /><hearth-solid x="0.2" />',
    '<ul><li><hearth-solid x="0.1"></hearth-solid><ul><li><hearth-solid x="0.2"></hearth-solid></ul></ul>',
    '<hearth-solid x="0.1"></hearth-solid><div><hearth-solid x="0.2" /></div>',
  ]) {
    await acts(tab, (fire, markup) => (fire.innerHTML = markup), markup);
    assert.deepEqual(await listed(tab), ['source 0', 'solid 0.1', 'solid 0.2'], markup);
    await acts(tab, (fire) => fire.querySelectorAll('hearth-solid')[1].setAttribute('x', '0.3'));
    assert.deepEqual(await listed(tab), ['source 0', 'solid 0.1', 'solid 0.3'], markup);
    await acts(tab, (fire) => fire.querySelectorAll('hearth-solid')[1].remove());
    assert.deepEqual(await listed(tab), ['source 0', 'solid 0.1'], markup);
  }
  await acts(tab, (fire) => {
    fire.innerHTML = '<hearth-solid></hearth-solid>'.repeat(40);
  });
  const before = await ids(tab);
  await acts(tab, async (fire) => {
    const all = [...fire.children];
    fire.prepend(all[1]);
    // A call is on its way at each moment, also when the list is sent.
    for (const { objectId } of all) {
      fire.changeObject(objectId, { y: 1 });
      await new Promise((resolve) => setTimeout(resolve));
    }
  });
  const [first, second, ...others] = before;
  const wanted = [second, first, ...others].map((id) => [id, 1]);
  assert.deepEqual(await tab.fire((fire) => fire.objects.slice(1).map(({ id, y }) => [id, y])), wanted);
  assert.deepEqual(await ids(tab), [second, first, ...others]);
  assert.deepEqual(warnings(tab), []);
});

test('refusals and misspellings are reported with the element, and names of solids are followed', async () => {
  const tab = await openChildren(
    browser,
    `<hearth-solid id="lid" x="0.1" width="0" y="0.7" materal="wood"></hearth-solid>
    <hearth-source power="3500" x="0.2" shape="solid" solid="#lid"></hearth-source>
    <hearth-solid motion="free" y="0.6" hangs-from="#hook" materal="wood"></hearth-solid><hearth-solid id="hook" y="0.9">`,
  );
  const [solid, source, ball, hook] = await owned(tab);
  assert.deepEqual([solid.x, solid.y, solid.width, source.x, source.power], [0.1, 0.7, 0.2, 0.2, 220]);
  assert.deepEqual([source.solid, ball.hangs_from], [solid.id, hook.id]);
  await acts(tab, (fire) => fire.firstElementChild.setAttribute('material', 'straw'));
  assert.equal((await owned(tab))[0].material, 'stone');
  const errors = await events(tab, 'error');
  assert.deepEqual(errors.map(({ id, value, min, max }) => [id, value, min, max]).sort(), [
    ['material', 'straw', undefined, undefined],
    ['power', '3500', 0, 3000],
    ['width', '0', 0.002, 10],
  ]);
  await tab.until('the misspelling is reported', (count) => count >= 4, warnings(tab).length);
  const all = warnings(tab).join('\n');
  assert.match(all, /<hearth-solid id="lid">: width = "0" is refused: it must be a number from 0.002 to 10 m/);
  assert.match(all, /<hearth-source>: power = "3500" is refused: it must be a number from 0 to 3000 kW\/m/);
  assert.match(all, /<hearth-solid id="lid">: material = "straw" is refused: it must be one of stone, wood/);
  assert.match(all, /<hearth-solid>: it has no attribute materal; did you mean material\?/);
  assert.equal(warnings(tab).length, 4, all);
  // Another solid takes the name.
  await acts(tab, (fire) => {
    fire.querySelector('#lid').id = 'ashes';
    fire.querySelector('#hook').id = 'lid';
  });
  assert.equal((await owned(tab))[1].solid, hook.id);
  await tab.burnt(0.5);
  const [hanging] = await tab.fire((fire) => fire.freeSolids());
  assert.ok(hanging.y < 0.6, `its hook is gone, and it is at ${hanging.y} m`);
});

test('the code is loaded with the first child, and children move between fires, also while one is off the page', async () => {
  const before = '<hearth-solid x="0.3" pwer="1"></hearth-solid>';
  const tab = await browser.open(before + fireOf('') + fireOf('', 'model="classic" warm="0.2"'));
  await tab.ready();
  const loaded = () =>
    tab.evaluate(
      () => performance.getEntriesByType('resource').filter(({ name }) => /children\.(js|wasm)$/.test(name)).length,
    );
  assert.equal(await loaded(), 0);
  await acts(tab, (fire) => {
    fire.innerHTML = `<hearth-solid x="0.1"></hearth-solid>
      <hearth-fire autoplay="false" quality="low"><hearth-solid x="0.5"></hearth-solid></hearth-fire>`;
  });
  // The first solid of the page is in no fire, and the last one in a fire inside the fire.
  assert.deepEqual(await listed(tab), ['source 0', 'solid 0.1']);
  assert.equal(await tab.evaluate(() => /** @type {any} */ (document.querySelector('hearth-solid')).objectId), null);
  const lists = () =>
    tab.evaluate(() =>
      [...document.querySelectorAll('body > hearth-fire')].map((fire) =>
        /** @type {any} */ (fire).objects.map(({ kind }) => kind).join(),
      ),
    );
  const moves = (from, to) =>
    tab.evaluate(
      (from, to) => {
        const fires = document.querySelectorAll('body > hearth-fire');
        fires[to].append(/** @type {Element} */ (fires[from].querySelector(':scope > hearth-solid')));
      },
      from,
      to,
    );
  await moves(0, 1);
  await settled(tab);
  assert.deepEqual(await lists(), ['source', 'source,solid']);
  await moves(1, 0);
  await settled(tab);
  assert.deepEqual(await lists(), ['source,solid', 'source']);
  // A fire that leaves the page keeps its children; what changes meanwhile counts when it is back.
  await tab.fire(async (fire) => {
    const { parentNode, nextSibling } = fire;
    fire.remove();
    await fire.destroy();
    fire.replaceChildren(fire.querySelector(':scope > hearth-solid'));
    fire.firstElementChild.setAttribute('x', '0.4');
    fire.append(Object.assign(document.createElement('hearth-source'), { id: 'own' }));
    fire.lastElementChild.setAttribute('power', '0');
    fire.warm = 0.5;
    parentNode.insertBefore(fire, nextSibling);
    await fire.ready;
  });
  assert.deepEqual(await listed(tab), ['source 0', 'solid 0.4']);
  // A warm fire has burnt with its children before it is shown.
  const stats = await tab.until(
    'its statistics',
    () => /** @type {any} */ (document.querySelector('hearth-fire')).stats,
  );
  assert.ok(stats.time >= 0.5 && stats.power === 0 && stats.embers === 0, JSON.stringify(stats));
  assert.deepEqual(tab.problems, []);
});

test('without the code the fire burns without its children, with a warning', async () => {
  const tab = await browser.open(recording(fireOf('<hearth-solid></hearth-solid>')), {
    without: 'element/children/children.js',
  });
  await tab.ready();
  assert.deepEqual(await listed(tab), ['source 0']);
  const [error, ...more] = await events(tab, 'error');
  assert.deepEqual([error.kind, more.length], ['load', 0]);
  assert.match(error.message, /The code for children could not be loaded/);
});
