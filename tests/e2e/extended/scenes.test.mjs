/** The scene chooser of the panel: pictures that keys and fingers select. `history.test.mjs` undoes a choice. */
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { Browser, except } from '../driver.mjs';
import { Panel, actionOf } from '../panel.mjs';
import { table } from '../site.mjs';

const { PRESETS } = await table();

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

async function openPage(query = 'scene=default', options = {}) {
  const tab = await browser.open(`index.html?${query}&paused`, { width: 900, height: 700, ...options });
  await tab.ready();
  return { tab, panel: await new Panel(tab).mounted() };
}

const PHONE = { width: 360, height: 640, ratio: 3, touch: true, pixels: 30_000 };

/** The name of the scene that has the focus. */
const focused = (panel) => panel.in((root) => root.activeElement?.dataset.scene);

const heading = (panel) => panel.in((root, button) => root.querySelector(button).textContent, actionOf('scenes'));

/** Waits until the fire started from that scene. */
const isScene = (tab, name) =>
  tab.until(
    `the scene ${name}`,
    (wanted) => /** @type {any} */ (document.querySelector('hearth-fire')).preset === wanted,
    name,
  );

describe('the scenes', () => {
  test('are complete, each with a picture and a description', async () => {
    const { tab, panel } = await openPage();
    await panel.openScenes();
    const tiles = await panel.in((root) =>
      [...root.querySelectorAll('[data-scene]')].map((tile) => ({
        name: tile.dataset.scene,
        text: tile.textContent,
        alt: tile.querySelector('img').alt,
        lazy: tile.querySelector('img').loading,
      })),
    );
    assert.deepEqual(
      tiles,
      PRESETS.map(({ name, label, description }) => ({
        name,
        text: label,
        alt: description,
        lazy: 'lazy',
      })),
    );
    // Those in sight come, and the others when they are about to be.
    for (const { name } of PRESETS) {
      await tab.page.$eval(`[data-scene="${name}"]`, (tile) => tile.scrollIntoView({ block: 'nearest' }));
      await tab.until(
        `the picture of ${name}`,
        (wanted) => {
          const image = /** @type {any} */ (document.querySelector(`[data-scene="${wanted}"] img`));
          return image.complete && image.naturalWidth > 0;
        },
        name,
      );
    }
    assert.deepEqual(tab.problems, []);
  });

  test('are gone through by keys: one stop for Tab, arrows, Enter, Escape', async () => {
    const { tab, panel } = await openPage();
    await tab.page.focus(actionOf('scenes'));
    await tab.key('Enter');
    assert.equal(await focused(panel), 'default');
    await tab.key('ArrowRight');
    assert.equal(await focused(panel), PRESETS[1].name);
    await tab.key('ArrowLeft');
    await tab.key('ArrowLeft');
    assert.equal(await focused(panel), 'default', 'the first is the first');
    await tab.key('End');
    assert.equal(await focused(panel), PRESETS.at(-1).name);
    await tab.key('ArrowRight');
    assert.equal(await focused(panel), PRESETS.at(-1).name, 'and the last is the last');
    await tab.key('Home');
    const row = await panel.in((root) => {
      const tops = [...root.querySelectorAll('[data-scene]')].map((tile) => tile.offsetTop);
      return tops.filter((top) => top === tops[0]).length;
    });
    if (row < PRESETS.length) {
      await tab.key('ArrowDown');
      assert.equal(await focused(panel), PRESETS[row].name);
      await tab.key('ArrowUp');
    }
    await tab.key('ArrowRight');
    await tab.key('Enter');
    await isScene(tab, PRESETS[1].name);
    await tab.key('Tab');
    assert.equal(await focused(panel), undefined);
    await tab.key('Escape');
    assert.equal(await panel.in((root) => root.querySelector('.hearth-card')), null);
    const back = await panel.in((root) => root.activeElement?.dataset.action);
    assert.equal(back, 'scenes', 'the focus is where it was');
    assert.equal(await heading(panel), `Scene: ${PRESETS[1].label}`);
  });

  test('nothing moves when a picture loads, and a missing picture leaves its description', async () => {
    const missing = PRESETS[1].name;
    const { tab, panel } = await openPage('scene=default', { files: { [`scenes/${missing}.jpg`]: { drop: true } } });
    await panel.openScenes();
    const places = () =>
      panel.in((root) =>
        [...root.querySelectorAll('[data-scene]')].map((tile) => {
          const { x, y, width, height } = tile.getBoundingClientRect();
          return [x, y, width, height];
        }),
      );
    const before = await places();
    await tab.until(
      'it is known that it does not come',
      (name) => document.querySelector(`[data-scene="${name}"]`)?.classList.contains('bare'),
      missing,
    );
    await tab.frames(10);
    assert.deepEqual(await places(), before);
    const shown = await panel.in((root, name) => {
      const image = root.querySelector(`[data-scene="${name}"] img`);
      return { seen: image.checkVisibility({ opacityProperty: true }), alt: image.alt };
    }, missing);
    assert.deepEqual(shown, { seen: false, alt: PRESETS[1].description });
    await tab.page.click(`[data-scene="${missing}"]`);
    await isScene(tab, missing);
  });
});

test(
  'a finger pushes and taps the scenes in the sheet of a phone',
  except({ firefox: "touches of Firefox's driver scroll nothing" }),
  async () => {
    const tab = await browser.open('index.html?scene=default', PHONE);
    await tab.ready();
    const panel = await new Panel(tab).mounted();
    await panel.openScenes();
    const rowBox = (name) =>
      panel.in((root, wanted) => {
        const { x, y, width, height } = root.querySelector(`[data-scene="${wanted}"]`).getBoundingClientRect();
        return { x: x + width / 2, y: y + height / 2, top: y, bottom: y + height };
      }, name);
    const { top, bottom } = await rowBox('default');
    assert.ok(top >= 0.55 * PHONE.height && bottom <= PHONE.height, 'the fire stays in sight');
    const cut = await panel.in((root) =>
      [...root.querySelectorAll('[data-scene] > span')]
        .filter((name) => name.scrollHeight > name.clientHeight + 1 || name.scrollWidth > name.clientWidth + 1)
        .map((name) => name.textContent),
    );
    assert.deepEqual(cut, [], 'names are read to their ends');
    for (const name of [PRESETS[1].name, PRESETS[5].name]) {
      for (let pushes = 0; (await rowBox(name)).x > PHONE.width - 20 && pushes < 20; pushes += 1) {
        const { y } = await rowBox('default');
        await tab.touchDrag({ x: 300, y }, { x: 60, y });
        await tab.frames(20);
      }
      const { x, y } = await rowBox(name);
      await (await tab.page.touchscreen.touchStart(x, y)).end();
      await isScene(tab, name);
    }
    assert.deepEqual(tab.problems, []);
  },
);
