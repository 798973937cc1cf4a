/**
 * The colour bar: it is loaded and shown only with a quantity, and follows the range of
 * the picture.
 */
import assert from 'node:assert/strict';
import path from 'node:path';
import { after, before, describe, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { Browser } from '../driver.mjs';
import { SITE } from '../site.mjs';

const load = (/** @type {string} */ name) => import(pathToFileURL(path.join(SITE, 'web', name)).href);
const { colour } = await load('element/view/scale.js');
const { QUANTITIES } = await load('parameters.js');

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

/** The accessible name and the text of the bar; null where there is none. */
const bar = (tab, selector = 'hearth-fire') =>
  tab.page.$eval(selector, (fire) => {
    const found = fire.shadowRoot.querySelector('[part="scale"]');
    if (!found?.checkVisibility()) return null;
    const { left, bottom, height } = found.getBoundingClientRect();
    const outer = fire.getBoundingClientRect();
    return {
      label: found.getAttribute('aria-label'),
      role: found.getAttribute('role'),
      marks: [...found.querySelectorAll('span')].map((mark) => mark.textContent),
      left: left - outer.left,
      below: outer.bottom - bottom,
      height,
    };
  });

/** Waits until the bar's label is so. */
const labelled = (tab, pattern) =>
  tab.until(
    `the bar's label matches ${pattern}`,
    (wanted) => {
      const found = document.querySelector('hearth-fire')?.shadowRoot?.querySelector('[part="scale"]');
      return found?.checkVisibility() && new RegExp(wanted).test(found.getAttribute('aria-label') ?? '');
    },
    pattern.source,
  );

/** Waits until there is no bar in sight. */
const gone = (tab) =>
  tab.until(
    'there is no bar',
    () => !document.querySelector('hearth-fire')?.shadowRoot?.querySelector('[part="scale"]')?.checkVisibility(),
  );

describe('the bar', () => {
  test('is loaded and shown with a quantity and its unit, and hidden without one', async () => {
    const tab = await browser.show('<hearth-fire></hearth-fire>');
    await tab.burnt(0.3);
    const loaded = () =>
      tab.evaluate(() =>
        performance.getEntriesByType('resource').some(({ name }) => /\/(scale|quantities)\.js$/.test(name)),
      );
    assert.equal(await bar(tab), null);
    assert.equal(await loaded(), false);
    assert.equal(await tab.fire((fire) => fire.stats.scale), null);

    await tab.fire((fire) => fire.set('display_mode', 'temperature'));
    await labelled(tab, /^Temperature, \d+ to \d+\u00a0K$/);
    const { role, marks, left, below } = await bar(tab);
    assert.equal(role, 'img');
    assert.ok(marks.length >= 3 && marks.length <= 5, String(marks));
    assert.ok(marks[0].endsWith('K') && marks.at(-1).endsWith('K'));
    assert.ok(left > 0 && left < 20 && below > 0 && below < 20, `${left} from the left, ${below} from below`);

    for (const [name, { unit, signed }] of Object.entries(QUANTITIES)) {
      await tab.fire((fire, mode) => fire.set('display_mode', mode), name);
      await tab.until('its range', () => /** @type {any} */ (document.querySelector('hearth-fire')).stats.scale);
      const label = { particles: 'Temperature', velocity: 'Speed' }[name] ?? name[0].toUpperCase() + name.slice(1);
      await labelled(
        tab,
        new RegExp(
          `^${label}, ${signed ? '−' : ''}[\\d.·⁻⁰-⁹\u202f]+ to [\\d.·⁻⁰-⁹\u202f]+${unit && `\u00a0${unit}`}$`,
        ),
      );
    }
    await tab.fire((fire) => fire.set('display_mode', 'paper'));
    await gone(tab);
    await tab.fire((fire) => fire.set('display_mode', 'fire'));
    await gone(tab);
    assert.equal(await loaded(), true);
    assert.deepEqual(tab.problems, []);
  });

  test('never shows the numbers of another quantity', async () => {
    const tab = await browser.show('<hearth-fire display-mode="temperature"></hearth-fire>');
    await labelled(tab, /^Temperature/);
    const { kelvin, reported } = await tab.fire(async (fire) => {
      const kelvin = fire.stats.scale[1];
      // Until all of them are made nothing is drawn: the picture stays that of the temperature.
      const made = fire.step(1500);
      await fire.set('display_mode', 'velocity');
      /** @type {unknown[]} */
      const reported = [];
      fire.addEventListener('stats', ({ detail }) => reported.push(detail.scale));
      await made;
      return { kelvin, reported };
    });
    assert.ok(kelvin > 100, `${kelvin} K could be a speed`);
    const drawn = reported.findIndex((scale) => scale !== null);
    assert.ok(drawn > 0, `the speed is reported only once it is drawn: ${JSON.stringify(reported)}`);
    for (const scale of reported.slice(drawn)) assert.ok(scale?.[1] < 100, `${scale} m/s`);
  });

  test('has the colours of the picture', async () => {
    const tab = await browser.show('<hearth-fire display-mode="temperature"></hearth-fire>', { draws: true });
    await tab.burnt(1);
    await labelled(tab, /^Temperature/);
    const pixels = await tab.fire(async (fire) => {
      const bitmap = await createImageBitmap(await fire.toBlob());
      const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
      const context = /** @type {any} */ (canvas.getContext('2d'));
      context.drawImage(bitmap, 0, 0);
      return [...context.getImageData(0, 0, bitmap.width, bitmap.height).data];
    });
    const stops = Array.from({ length: 257 }, (_, at) => colour(at / 256, false));
    let [opaque, alike] = [0, 0];
    for (let at = 0; at < pixels.length; at += 4 * 7) {
      if (pixels[at + 3] < 255) continue;
      opaque += 1;
      const near = stops.some((stop) => stop.every((x, offset) => Math.abs(x - pixels[at + offset]) <= 8));
      alike += Number(near);
    }
    assert.ok(opaque > 500, `${opaque} opaque pixels`);
    assert.ok(alike > 0.97 * opaque, `${alike} of ${opaque} have a colour of the bar`);
  });

  test('stands above the panel of its fire, and above the button that pauses it', async () => {
    const tab = await browser.open(
      '<hearth-fire controls display-mode="density" style="width: 360px; height: 600px"></hearth-fire>',
      { height: 640, reducedMotion: true },
    );
    await tab.ready();
    await tab.until('the panel', () =>
      document.querySelector('hearth-fire')?.shadowRoot?.querySelector('.hearth-panel'),
    );
    await labelled(tab, /^Density/);
    const sheet = await tab.fire(
      (fire) => fire.shadowRoot.querySelector('.hearth-panel').getBoundingClientRect().height,
    );
    const { below } = await bar(tab);
    assert.ok(below > sheet, `${below} above the edge, and the sheet is ${sheet} high`);
    await tab.fire((fire) => fire.play());
    await tab.frames(10);
    assert.ok((await bar(tab)).below > sheet + 50, 'it makes room for the button');
  });

  test('obeys a page that allows no styles but its own origin’s', async () => {
    const tab = await browser.open('<hearth-fire display-mode="pressure" style="height: 300px"></hearth-fire>', {
      headers: { 'content-security-policy': "style-src 'self'" },
    });
    await tab.burnt(0.3);
    await labelled(tab, /^Pressure, −.* to .*Pa$/);
    const { left } = await bar(tab);
    assert.ok(left > 0 && left < 20);
  });
});
