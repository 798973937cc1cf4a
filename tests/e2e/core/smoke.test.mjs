/**
 * The minimum for any build of the site: the page loads, burns, shows its panel and
 * reports no problem. It also runs against another folder, `HEARTH_SITE=… node --test
 * smoke.test.mjs`, or another server, `HEARTH_PAGE=http://…`.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { assertBurns } from '../assertions.mjs';
import { Panel } from '../panel.mjs';

const PAGE = process.env.HEARTH_PAGE ?? 'index.html';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launch();
});
after(() => browser?.close());

test('the site loads, burns and shows its panel without a problem', async () => {
  const tab = await browser.open(PAGE, { width: 1000, height: 600 });
  await tab.ready();
  await tab.burnt(1.5);
  await assertBurns(tab);
  await new Panel(tab).mounted();
  assert.deepEqual(tab.problems, []);
});

test('the modules and the page that other sites name keep their addresses', async () => {
  const tab = await browser.open('<p>A page without a fire.</p>');
  const found = await tab.evaluate(async () => {
    const { HearthFire } = await import(/** @type {any} */ ('/web/hearth-fire.js'));
    const { createSimulation } = await import(/** @type {any} */ ('/web/sim.js'));
    const { connectFire } = await import(/** @type {any} */ ('/web/embed-client.js'));
    const simulation = await createSimulation();
    simulation.step();
    const iframe = document.createElement('iframe');
    iframe.src = `/web/embed.html?allow=${location.origin}`;
    document.body.append(iframe);
    await connectFire(iframe).ready();
    return { defined: customElements.get('hearth-fire') === HearthFire, particles: simulation.count > 0 };
  });
  assert.deepEqual(found, { defined: true, particles: true });
  assert.deepEqual(tab.problems, []);
});
