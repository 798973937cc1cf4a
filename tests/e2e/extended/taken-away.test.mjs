/**
 * A fire burns on when the page takes away what it is shown with: its document, its canvas, the canvas's context, or
 * all of its shadow tree.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launch();
});
after(() => browser?.close());

/** Runs in the page: waits for a picture with light in the canvas that is shown. */
function shown() {
  const canvas = document.querySelector('hearth-fire')?.shadowRoot?.querySelector('canvas');
  if (!canvas?.width || !canvas.getClientRects().length) return false;
  const copy = Object.assign(document.createElement('canvas'), { width: 40, height: 40 });
  const context = /** @type {CanvasRenderingContext2D} */ (copy.getContext('2d'));
  context.drawImage(canvas, 0, 0, 40, 40);
  return context.getImageData(0, 0, 40, 40).data.some((value, at) => at % 4 === 3 && value > 60);
}

for (const [what, take] of /** @type {[string, (fire: any) => unknown][]} */ ([
  [
    'the document of an iframe, which is removed',
    async (fire) => {
      const frame = document.body.appendChild(document.createElement('iframe'));
      frame.contentDocument?.body.append(fire);
      await new Promise((resolve) => setTimeout(resolve, 300));
      frame.remove();
      await new Promise((resolve) => setTimeout(resolve, 100));
      document.body.append(fire);
    },
  ],
  [
    'a document without a window',
    (fire) => {
      document.implementation.createHTMLDocument('').body.append(fire);
      document.body.append(fire);
    },
  ],
  ['the canvas', (fire) => fire.shadowRoot.querySelector('canvas').remove()],
  [
    'the canvas, for another one',
    (fire) => fire.shadowRoot.querySelector('canvas').replaceWith(document.createElement('p')),
  ],
  ['all around the canvas', (fire) => fire.shadowRoot.querySelector('.root').replaceChildren()],
  ['the shadow tree', (fire) => fire.shadowRoot.replaceChildren()],
  [
    'the styles and the canvas',
    (fire) => {
      fire.shadowRoot.adoptedStyleSheets = [];
      fire.shadowRoot.querySelector('canvas').remove();
    },
  ],
  [
    'the canvas, while the element is in no page',
    (fire) => {
      fire.shadowRoot.querySelector('canvas').remove();
      fire.remove();
      document.body.append(fire);
    },
  ],
])) {
  for (const paused of [false, true]) {
    test(`a ${paused ? 'paused' : 'burning'} fire is shown again, as old as before, without ${what}`, async () => {
      const tab = await browser.show('<hearth-fire preset="campfire" warm></hearth-fire>');
      await tab.ready();
      await tab.until('a picture', shown);
      if (paused) await tab.fire((fire) => fire.pause());
      const time = await tab.fire((fire) => fire.step().then(() => fire.stats?.time ?? 0));
      await tab.fire(take);
      await tab.until('another picture', shown);
      await tab.fire((fire) => fire.step());
      assert.ok((await tab.fire((fire) => fire.stats.time)) >= time);
      assert.ok(await tab.fire(async (fire) => (await fire.toBlob()).size > 1000));
      assert.deepEqual(tab.problems, []);
    });
  }
}

test('the context of a canvas that the page has taken before the first picture is not needed', async () => {
  const tab = await browser.show('<hearth-fire preset="campfire"></hearth-fire>');
  await tab.fire((fire) => void fire.shadowRoot.querySelector('canvas').getContext('webgl'));
  await tab.ready();
  await tab.until('a picture', shown);
  assert.deepEqual(tab.problems, []);
});
