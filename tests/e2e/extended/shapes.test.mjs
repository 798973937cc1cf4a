/**
 * Polygons, strokes and masks: drawn, sent and stored with the settings, refused with a message.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { decoded } from '../masks.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launch();
});
after(() => browser?.close());

const STAR = [
  [0, 0.3],
  [-0.18, -0.24],
  [0.285, 0.09],
  [-0.285, 0.09],
  [0.18, -0.24],
];
const STAR_TEXT = '0,0.3 -0.18,-0.24 0.285,0.09 -0.285,0.09 0.18,-0.24';

const FIRE = `<hearth-fire autoplay="false" max-pixels="90000" fuel-power="0" ember-rate="0"
  style="width: 300px; height: 300px"></hearth-fire>`;

/** The opacity of the picture at these places [m]. */
function opacities(tab, places) {
  return tab.fire(async (fire, places) => {
    await fire.step(2);
    const bitmap = await createImageBitmap(await fire.toBlob());
    const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
    const context = canvas.getContext('2d');
    context.drawImage(bitmap, 0, 0);
    const scale = bitmap.width / fire.clientWidth;
    return places.map(([x, y]) => {
      const at = fire.toPixels(x, y);
      return context.getImageData(Math.round(at.x * scale), Math.round(at.y * scale), 1, 1).data[3];
    });
  }, places);
}

/** The error of a refused function of the page's masks. */
function refusal(tab, act) {
  return tab.fire(async (fire, source) => {
    try {
      await new Function('fire', 'masks', `return (${source})(fire, masks)`)(fire, await import('./web/mask.js'));
      return '';
    } catch ({ name, message }) {
      return `${name}: ${message}`;
    }
  }, String(act));
}

test('a star is opaque inside and transparent outside, and travels with the settings', async () => {
  const tab = await browser.show(FIRE);
  await tab.ready();
  const id = await tab.fire(
    (fire, points) => fire.addObject({ kind: 'solid', shape: 'polygon', points, y: 0.6 }),
    STAR,
  );
  const inside = [
    [0, 0.6],
    [0, 0.84],
    [0.2, 0.67],
    [-0.13, 0.42],
  ];
  const outside = [
    [0, 0.4],
    [0.2, 0.8],
    [-0.2, 0.8],
    [-0.25, 0.5],
  ];
  assert.deepEqual(
    await opacities(tab, inside),
    inside.map(() => 255),
  );
  assert.deepEqual(
    await opacities(tab, outside),
    outside.map(() => 0),
  );
  const config = await tab.fire((fire) => fire.exportConfig());
  assert.deepEqual(config.objects.at(-1), { kind: 'solid', shape: 'polygon', y: 0.6, points: STAR_TEXT });
  await tab.fire((fire, id) => fire.changeObject(id, { shape: 'stroke', height: 0.04, angle: 180 }), id);
  assert.deepEqual(
    await opacities(tab, [
      [0, 0.3],
      [0, 0.6],
      [0, 0.66],
    ]),
    [255, 0, 0],
  );
  await tab.fire((fire, config) => fire.importConfig(JSON.stringify(config)), config);
  assert.deepEqual(await tab.fire((fire) => fire.exportConfig()), config);
});

test('a word is a mask that is drawn and stored', async () => {
  const tab = await browser.show(FIRE);
  await tab.ready();
  const solid = await tab.fire(async (fire) => {
    const { maskOfText } = await import('./web/mask.js');
    const solid = { kind: 'solid', ...maskOfText('LI', '700 1em monospace', 0.6), y: 0.6 };
    await fire.addObject(solid);
    return solid;
  });
  assert.match(solid.mask, /^\d+x\d+:[\w-]+$/);
  assert.ok(solid.mask.length < 4000 && solid.height > 0.1, JSON.stringify(solid).slice(0, 200));
  const pixels = decoded(solid.mask);
  const places = Array.from({ length: 40 }, (_, at) => (at + 0.5) / 40);
  const middle = places.map((along) => pixels.at(along, 0.5));
  const letters = middle.map((opacity) => (opacity === 15 ? '#' : '.')).join('');
  assert.match(letters, /^\.*#+\.+#+\.*$/, 'the upright strokes of both letters');
  // Edges are left out: the picture has fewer pixels than the mask.
  const sure = places.filter(
    (_, at) => at > 0 && at < 39 && middle[at - 1] === middle[at] && middle[at] === middle[at + 1],
  );
  const drawn = await opacities(
    tab,
    sure.map((along) => [(along - 0.5) * solid.width, 0.6]),
  );
  assert.deepEqual(
    drawn,
    sure.map((along) => 17 * pixels.at(along, 0.5)),
  );
  assert.ok(drawn.includes(0) && drawn.includes(255), `${drawn}`);
  const [first, second] = await tab.fire(async (fire) => {
    const kept = await fire.exportConfig();
    await fire.importConfig(kept);
    return [kept, await fire.exportConfig()];
  });
  assert.deepEqual(first, second);
  assert.equal(first.objects.at(-1).mask, solid.mask);
});

test('what makes no mask is refused with a message', async () => {
  const tab = await browser.show(FIRE);
  await tab.ready();
  for (const [act, words] of [
    [(fire) => fire.addObject({ kind: 'solid', points: [[0, 0], [1]] }), /objects\[1\]\.points = .*2 to 256 pairs/],
    [(_, masks) => masks.maskOfText(' ', '700 1em serif'), /text = " " is refused/],
    [(_, masks) => masks.maskOfText('FIRE', 'big'), /font = "big" is refused: it must be a CSS font/],
    [(_, masks) => masks.maskOfPath('M0 0', [0, 0, 1, 1]), /path = "M0 0" is refused: .* opaque/],
    [(_, masks) => masks.maskOfImage(new Image()), /an image/],
    [(_, masks) => masks.maskOfImage(new OffscreenCanvas(8, 8)), /opaque pixels/],
  ]) {
    assert.match(await refusal(tab, act), words, String(act));
  }
  assert.equal(await tab.fire((fire) => fire.objects.length), 1);
});
