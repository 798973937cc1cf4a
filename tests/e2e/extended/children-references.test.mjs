/** Children that name a solid of the same fire: `solid` of a source and `hangs-from` of a free solid. */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { acts, openChildren, owned, warnings } from '../children.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

/** A page whose fire has these children, once every child has its object. */
const opened = (/** @type {string} */ children) => openChildren(browser, children);

test('`solid` names a solid of the same fire, whose id the source follows', async () => {
  const tab = await opened(`
    <hearth-source shape="solid" solid="#log"></hearth-source>
    <hearth-solid id="log" shape="box"></hearth-solid>`);
  const refers = async () =>
    (await owned(tab)).filter((object) => object?.kind === 'source').map(({ shape, solid }) => [shape, solid]);
  const idOf = (/** @type {string} */ id) => tab.fire((fire, wanted) => fire.querySelector(`#${wanted}`).objectId, id);
  assert.deepEqual(await refers(), [['solid', await idOf('log')]]);
  assert.deepEqual(warnings(tab), []);
  assert.deepEqual(await tab.fire((fire) => [fire.params.source_shape, fire.params.source_solid]), [
    'solid',
    await idOf('log'),
  ]);
  // Another solid takes the name.
  await acts(tab, (fire) => {
    fire.querySelector('#log').id = 'ashes';
    fire.append(Object.assign(document.createElement('hearth-solid'), { id: 'log' }));
  });
  assert.notEqual(await idOf('log'), await idOf('ashes'));
  assert.deepEqual(await refers(), [['solid', await idOf('log')]]);
  await acts(tab, (fire) => fire.querySelector('hearth-source').setAttribute('solid', '#ashes'));
  assert.deepEqual(await refers(), [['solid', await idOf('ashes')]]);
  // A number is an id.
  const id = await idOf('log');
  await acts(tab, (fire, solid) => fire.querySelector('hearth-source').setAttribute('solid', solid), id);
  assert.deepEqual(await refers(), [['solid', id]]);
  assert.deepEqual(warnings(tab), []);
});

test('`hangs-from` names the solid that a free one hangs from', async () => {
  const tab = await opened(`
    <hearth-source></hearth-source>
    <hearth-solid id="ball" motion="free" y="0.6" hangs-from="#hook"></hearth-solid>
    <hearth-solid id="hook" y="0.9"></hearth-solid>
    <hearth-solid motion="free" x="0.4" hangs-from="#none"></hearth-solid>`);
  const hangs = async () =>
    (await owned(tab)).filter((object) => object?.motion === 'free').map(({ hangs_from }) => hangs_from);
  const hook = await tab.fire((fire) => fire.querySelector('#hook').objectId);
  assert.deepEqual(await hangs(), [hook, 0]);
  assert.equal(warnings(tab).length, 1);
  assert.match(warnings(tab)[0], /<hearth-solid>: hangs-from = #none has no effect now/);
  await tab.burnt(0.5);
  const [ball] = await tab.fire((fire) => fire.freeSolids());
  assert.ok(Math.abs(ball.y - 0.6) < 0.01, `it hangs at ${ball.y} m`);
});

test('a source on a solid that does not exist is a line, with one warning, until the solid comes', async () => {
  const tab = await opened('<hearth-source shape="solid" solid="#log"></hearth-source><hearth-solid></hearth-solid>');
  const solid = () => tab.fire((fire) => fire.params.source_solid);
  assert.equal(await solid(), 0);
  await acts(tab, (fire) => fire.setAttribute('fuel-power', '100'));
  assert.equal(warnings(tab).length, 1);
  assert.match(warnings(tab)[0], /<hearth-source>: solid = #log has no effect now/);
  await acts(tab, (fire) => (fire.querySelector('hearth-solid').id = 'log'));
  assert.equal(await solid(), await tab.fire((fire) => fire.querySelector('hearth-solid').objectId));
  // A call counts until the solid is another.
  await acts(tab, (fire) => fire.set('source_solid', 77));
  await acts(tab, (fire) => fire.set('wind', 0.1));
  assert.equal(await solid(), 77);
  await acts(tab, (fire) => fire.querySelector('hearth-solid').remove());
  assert.equal(await solid(), 0);
  assert.equal(warnings(tab).length, 1);
});
