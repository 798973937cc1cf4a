/**
 * A fire rests while its page hides it in any way, and plays again when it is shown. Its picture follows the density of
 * the screen.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { BROWSER, Browser, except } from '../driver.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

/** Runs in the page: whether the age of the fire stays the same, or grows, for twenty frames. */
async function rests() {
  const fire = /** @type {any} */ (document.querySelector('hearth-fire'));
  const time = fire.stats?.time;
  for (let frame = 0; frame < 20; frame += 1) await new Promise((next) => requestAnimationFrame(next));
  return new Promise((resolve) => setTimeout(() => resolve(time !== undefined && fire.stats?.time === time), 600));
}

for (const [about, outer, inner] of [
  ['visibility', '', 'visibility: hidden'],
  ['visibility of an ancestor', 'visibility: hidden', ''],
  ['opacity', '', 'opacity: 0'],
  ['opacity of an ancestor', 'opacity: 0', ''],
  ['content-visibility of an ancestor', 'content-visibility: hidden', ''],
  ['display', '', 'display: none'],
  ['display of an ancestor', 'display: none', ''],
  ['a transform without an area', '', 'transform: scale(0)'],
  ['a transform of an ancestor', 'scale: 1 0', ''],
  ['an edge in place of a face', '', 'transform: rotateY(90deg)'],
  ['an ancestor without a height', 'overflow: hidden; height: 0', ''],
  [
    'an ancestor that is scrolled',
    'overflow: hidden; height: 50px; position: relative',
    'position: absolute; top: 80px',
  ],
  // Other browsers count what a clip path hides as seen.
  ...(BROWSER === 'chromium' ? [['a clip path', 'clip-path: inset(100%)', '']] : []),
  ['a size of zero', '', 'height: 0'],
]) {
  test(`a fire rests while it is hidden, and plays again: ${about}`, async () => {
    const tab = await browser.show(
      '<div><hearth-fire preset="candle" style="width: 60px; height: 60px"></hearth-fire></div>',
    );
    await tab.ready();
    await tab.until('measurements', () => Boolean(/** @type {any} */ (document.querySelector('hearth-fire')).stats));
    await tab.fire(
      (fire, [ofParent, own]) => {
        fire.style.cssText += own;
        fire.parentElement.style.cssText = ofParent;
      },
      [outer, inner],
    );
    await tab.until('it rests', rests);
    await tab.fire((fire) => {
      fire.style.cssText = 'width: 60px; height: 60px';
      fire.parentElement.style.cssText = '';
    });
    await tab.until('it plays', async () => {
      const fire = /** @type {any} */ (document.querySelector('hearth-fire'));
      const before = fire.stats?.time;
      await new Promise((resolve) => setTimeout(resolve, 300));
      return fire.stats?.time > before;
    });
    assert.deepEqual(tab.problems, []);
  });
}

const DENSITY = except({ webkit: "WebKitGTK's driver changes no density of an open page" });

test('the picture follows the density of the screen, with and without a count of device pixels', DENSITY, async () => {
  for (const counts of [true, false]) {
    const tab = await browser.open(
      '<!doctype html><script type="module" src="./web/hearth-fire.js"></script><hearth-fire style="width: 100px; height: 100px"></hearth-fire>',
      {
        before: counts
          ? undefined
          : () => {
              const { observe } = ResizeObserver.prototype;
              ResizeObserver.prototype.observe = function (element, options) {
                if (options?.box === 'device-pixel-content-box') throw new TypeError();
                return observe.call(this, element, options);
              };
            },
      },
    );
    await tab.ready();
    for (const density of [2, 1.5, 1]) {
      await tab.page.setViewport({ width: 400, height: 300, deviceScaleFactor: density });
      await tab.until(
        `${100 * density} pixels`,
        (side) => document.querySelector('hearth-fire')?.shadowRoot?.querySelector('canvas')?.width === side,
        100 * density,
      );
    }
  }
});
