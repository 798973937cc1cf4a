/**
 * Hooks for the page's style sheets: the state `burning`, brightness and colour of a fire.
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

const FIRE = '<hearth-fire quality="low" style="width: 120px; height: 150px"></hearth-fire>';

/** Waits until the first fire is in that state, or no more. */
function burning(tab, wanted) {
  return tab.until(
    `burning: ${wanted}`,
    (state) => /** @type {any} */ (document.querySelector('hearth-fire, #gone')).matches(':state(burning)') === state,
    wanted,
  );
}

test(':state(burning) holds while the fire plays and its picture is shown', async () => {
  const tab = await browser.show(`<style>hearth-fire:state(burning) { outline: 3px solid red }</style>${FIRE}`);
  // Not before there is a picture.
  const early = await tab.fire((fire) => {
    const shown = fire.shadowRoot.querySelector('.root').matches('[data-state=shown][data-drawn]');
    return shown || !fire.matches(':state(burning)');
  });
  assert.ok(early);
  await burning(tab, true);
  assert.ok(await tab.fire((fire) => fire.shadowRoot.querySelector('.root').matches('[data-state=shown][data-drawn]')));
  assert.equal(await tab.fire((fire) => getComputedStyle(fire).outlineWidth), '3px');
  await tab.fire((fire) => fire.pause());
  await burning(tab, false);
  await tab.fire((fire) => fire.play());
  await burning(tab, true);
  await tab.loseContext();
  await burning(tab, false);
  assert.deepEqual(
    tab.problems.filter((problem) => problem.startsWith('uncaught')),
    [],
  );

  const other = await browser.show(FIRE);
  await burning(other, true);
  const states = await other.fire(async (fire) => {
    await fire.destroy();
    const gone = fire.matches(':state(burning)');
    fire.remove();
    await Promise.resolve();
    document.body.append(fire);
    return [gone, fire.matches(':state(burning)')];
  });
  assert.deepEqual(states, [false, false]);
  await burning(other, true);
  assert.deepEqual(other.problems, []);
});

test(':state(burning) does not hold for a paused fire or without an engine', async () => {
  const still = await browser.show(FIRE.replace('<hearth-fire', '<hearth-fire paused'));
  await still.fire((fire) => fire.toBlob());
  assert.equal(await still.fire((fire) => fire.matches(':state(burning)')), false);
  const none = await browser.open(FIRE, {
    before: () => {
      delete (/** @type {any} */ (window).WebAssembly);
    },
  });
  await none.fire((fire) => fire.ready.catch(() => {}));
  assert.equal(await none.fire((fire) => fire.matches(':state(burning)')), false);
});

test('a fire has its state in a browser whose states begin with two hyphens', async () => {
  const before = () => {
    const { prototype } = CustomStateSet;
    for (const name of ['add', 'delete']) {
      const original = prototype[name];
      prototype[name] = function (state) {
        if (!state.startsWith('--')) throw new SyntaxError(state);
        return original.call(this, state);
      };
    }
  };
  const tab = await browser.open(FIRE, { before });
  await tab.until('its state', () => document.querySelector('hearth-fire')?.matches(':state(--burning)'));
  assert.deepEqual(tab.problems, []);
});

/** The light and the glow of the first fire. */
function reported(tab) {
  return tab.fire((fire) => {
    const style = getComputedStyle(fire);
    return [style.getPropertyValue('--hearth-light'), style.getPropertyValue('--hearth-glow')].map((property) =>
      property.trim(),
    );
  });
}

test('a fire reports its brightness and colour, and none while it does not burn', async () => {
  const tab = await browser.show(FIRE);
  assert.deepEqual(await reported(tab), ['', '']);
  await tab.burnt(1);
  const [light, glow] = await reported(tab);
  assert.ok(Number(light) > 0 && Number(light) <= 1, light);
  assert.match(glow, /^#[0-9a-f]{6}$/);
  // Nothing of it stands in the element's own style, which is its page's.
  assert.equal(await tab.fire((fire) => fire.getAttribute('style')), 'width: 120px; height: 150px');
  await tab.fire((fire) => fire.set({ palette: 'custom', hot_colour: '#12ab34' }));
  await tab.until(
    'the custom colour',
    () =>
      getComputedStyle(/** @type {any} */ (document.querySelector('hearth-fire')))
        .getPropertyValue('--hearth-glow')
        .trim() === '#12ab34',
  );
  await tab.fire((fire) => fire.set('display_mode', 'temperature'));
  const nothing = () =>
    getComputedStyle(/** @type {any} */ (document.querySelector('hearth-fire'))).getPropertyValue('--hearth-light') ===
    '';
  await tab.until('no light of a chart', nothing);
  await tab.fire((fire) => fire.set('display_mode', 'fire'));
  await tab.until(
    'light',
    () =>
      getComputedStyle(/** @type {any} */ (document.querySelector('hearth-fire'))).getPropertyValue(
        '--hearth-light',
      ) !== '',
  );
  await tab.fire((fire) => fire.set('model', 'classic'));
  await tab.until('no light without power', nothing);
  await tab.fire((fire) => fire.destroy());
  assert.deepEqual(await reported(tab), ['', '']);
  assert.deepEqual(tab.problems, []);
});

/** Hue of a colour, in turns. @param {number[]} colour */
function hue([red, green, blue]) {
  return Math.atan2(Math.sqrt(3) * (green - blue), 2 * red - green - blue) / (2 * Math.PI);
}

test('the reported colour is that of the picture', async () => {
  const tab = await browser.show(FIRE, { draws: true });
  await tab.burnt(2.5);
  for (const palette of ['blackbody', 'gas', 'copper', 'lithium', 'ghost']) {
    const { glow, mean } = await tab.fire(async (fire, name) => {
      await fire.set('palette', name);
      await new Promise((resolve) => fire.addEventListener('stats', resolve, { once: true }));
      await new Promise((resolve) => fire.addEventListener('stats', resolve, { once: true }));
      const image = await createImageBitmap(await fire.toBlob());
      const canvas = new OffscreenCanvas(image.width, image.height);
      const context = /** @type {any} */ (canvas.getContext('2d'));
      context.drawImage(image, 0, 0);
      const { data } = context.getImageData(0, 0, image.width, image.height);
      const sum = [0, 0, 0];
      for (let at = 0; at < data.length; at += 4) {
        for (let channel = 0; channel < 3; channel += 1) sum[channel] += data[at + channel] * data[at + 3];
      }
      const most = Math.max(...sum);
      return {
        glow: getComputedStyle(fire).getPropertyValue('--hearth-glow').trim(),
        mean: sum.map((channel) => Math.round((255 * channel) / most)),
      };
    }, palette);
    const colour = glow.match(/\w\w/g).map((hex) => parseInt(hex, 16));
    const apart = Math.abs(hue(colour) - hue(mean));
    assert.ok(Math.min(apart, 1 - apart) < 0.03, `${palette}: ${glow} and ${mean}`);
  }
});
