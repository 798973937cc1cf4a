/**
 * `fit` and `align` select the part of a fire's world in its picture. `toPixels` agrees
 * with CSS and with the picture.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

test('the picture shows each place where `toPixels` has it, for every fit and alignment', async () => {
  for (const [width, height, fit, align] of [
    [400, 150, 'height', 'left top'],
    [150, 400, 'width', 'center right'],
    [150, 400, 'contain', ''],
    [400, 150, 'cover', ''],
    [400, 150, 'cover', 'left top'],
  ]) {
    // Particles that stand still.
    const tab = await browser.show(
      `<hearth-fire paused model="classic" display-mode="paper" source-width="0.05" fit="${fit}" align="${align}"
      source-height="0.7" emission-speed="0" particle-size="0.03" lifetime-min="3" lifetime-max="3"
      style="width: ${width}px; height: ${height}px"></hearth-fire>`,
      { draws: true },
    );
    await tab.ready();
    const [{ x, y }, reach] = await tab.fire(async (fire) => {
      await fire.step(8);
      const [source, beside] = [0, 0.08].map((x) => fire.toPixels(x, 0.7));
      return [source, beside.x - source.x + 3];
    });
    await tab.frames(3);
    const picture = await tab.firePicture();
    const lit = (crop) => Math.round((1 - crop.dark()) * crop.width * crop.height);
    const share = (at, side) => Math.max(0, Math.min(1, at / side));
    const [left, right] = [x - reach, x + reach].map((at) => share(at, width));
    const [top, bottom] = [y - reach, y + reach].map((at) => share(at, height));
    const around = right > left && bottom > top ? lit(picture.crop(left, top, right, bottom)) : 0;
    const isInside = x > 4 && x < width - 4 && y > 4 && y < height - 4;
    const what = `${fit} “${align}” of ${width} × ${height}`;
    assert.ok(!isInside || around > 4, `${what}: ${around} pixels are lit around the source`);
    assert.equal(lit(picture), around, `${what}: nothing is lit elsewhere`);
    assert.deepEqual(tab.problems, []);
  }
});

/** Two points that are the same up to rounding. */
function near(found, expected, what) {
  const same = Math.abs(found.x - expected.x) < 2e-3 && Math.abs(found.y - expected.y) < 2e-3;
  assert.ok(same, `${what} is ${JSON.stringify(found)}, not ${JSON.stringify(expected)}`);
}

/** Waits until a wheel with Ctrl reaches the fire, whose code for pointers is loaded on request. */
const listened = (tab) =>
  tab.until('the pointer is listened to', () => {
    const how = { deltaY: -1, ctrlKey: true, cancelable: true, bubbles: true, clientX: 90, clientY: 60 };
    const event = new WheelEvent('wheel', how);
    document.querySelector('hearth-fire').dispatchEvent(event);
    return event.defaultPrevented;
  });

test('a wheel with Ctrl enlarges what is under the pointer, a double click shows all again', async () => {
  const tab = await browser.show(`<style>body { height: 3000px; margin: 0 }</style><hearth-fire paused interactive
    style="width: 300px; height: 200px"></hearth-fire>`);
  await tab.ready();
  await listened(tab);
  const at = () => tab.fire((fire) => fire.toMetres(90, 60));
  const before = await at();
  const wheel = (deltaY, ctrlKey) =>
    tab.fire(
      (fire, how) => {
        const event = new WheelEvent('wheel', { ...how, cancelable: true, bubbles: true, clientX: 90, clientY: 60 });
        fire.dispatchEvent(event);
        return event.defaultPrevented;
      },
      { deltaY, ctrlKey },
    );
  assert.equal(await wheel(-200, true), true);
  const zoom = await tab.fire((fire) => fire.zoom);
  assert.ok(zoom > 2 && zoom < 4, `zoom ${zoom}`);
  near(await at(), before, 'the place under the pointer');
  assert.equal(await wheel(-200, false), false, 'a wheel scrolls the page');
  assert.equal(await wheel(9000, true), true);
  assert.equal(await tab.fire((fire) => fire.zoom), 1);
  assert.equal(await wheel(100, true), false, 'the page gets the rest');
  await wheel(-100, true);
  await tab.fire((fire) => fire.dispatchEvent(new MouseEvent('dblclick', { bubbles: true })));
  assert.deepEqual(await tab.fire((fire) => [fire.hasAttribute('zoom'), fire.hasAttribute('pan')]), [false, false]);
});

test('two fingers enlarge and move the picture', async () => {
  const tab = await browser.show(`<hearth-fire paused interactive style="width: 300px; height: 200px"></hearth-fire>`);
  await tab.ready();
  await listened(tab);
  const [zoom, held] = await tab.fire((fire) => {
    const { left, top } = fire.getBoundingClientRect();
    const touch = (type, pointerId, x, y) =>
      fire.dispatchEvent(
        new PointerEvent(type, {
          pointerId,
          pointerType: 'touch',
          bubbles: true,
          clientX: left + x,
          clientY: top + y,
        }),
      );
    touch('pointerdown', 2, 100, 100);
    touch('pointerdown', 3, 200, 100);
    const middle = fire.toMetres(150, 100);
    touch('pointermove', 2, 50, 120);
    touch('pointermove', 3, 250, 120);
    const now = fire.toMetres(150, 120);
    const zoom = fire.zoom;
    touch('pointerup', 2, 50, 120);
    touch('pointermove', 3, 100, 20);
    touch('pointerup', 3, 100, 20);
    return [
      [zoom, fire.zoom],
      [middle, now],
    ];
  });
  assert.ok(zoom[0] > 1.9 && zoom[0] < 2.2, `zoom ${zoom[0]}`);
  assert.equal(zoom[1], zoom[0], 'one finger enlarges nothing');
  near(held[1], held[0], 'the place between the fingers');
});
