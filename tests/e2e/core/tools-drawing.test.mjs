/**
 * The tools that draw: shapes, words, pictures and sources, with a real mouse, a finger and keys; and what is
 * rejected with a message.
 */
import assert from 'node:assert/strict';
import { Buffer } from 'node:buffer';
import { after, before, describe, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { close, drag, openTools, PHONES, pixel, tap, tool, WIDE } from '../tools.mjs';
import { objects, objectsUntil as until } from '../waits.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

for (const size of [WIDE, ...PHONES]) {
  const touch = 'touch' in size;
  describe(`at ${size.width} × ${size.height}`, () => {
    for (const [name, check] of Object.entries({
      box: (one) => one.shape === 'box' && close(one.x, 0) && close(one.y, 1.1) && close(one.width, 0.3) && close(one.height, 0.2),
      circle: (one) => one.shape === 'circle' && close(one.x, -0.15) && close(one.y, 1.2) && close(one.width, 2 * Math.hypot(0.3, 0.2), 0.03),
      line: (one) => one.shape === 'line' && close(one.width, Math.hypot(0.3, 0.2)) && close(one.angle, -33.7, 4),
      brush: (one) => ['stroke', 'line'].includes(one.shape) && one.points.split(' ').length >= 2,
      source: (one) => one.kind === 'source' && close(one.width, Math.hypot(0.3, 0.2)) && close(one.x, 0) && close(one.y, 1.1),
    })) {
      test(`${name} draws between a press and a release, as one step`, async () => {
        const tab = await openTools(browser, size);
        await tool(tab, name);
        await drag(tab, [-0.15, 1.2], [0.15, 1], touch);
        const now = await until(tab, 'two', (all) => all.length === 2);
        assert.ok(check(now[1]), JSON.stringify(now[1]));
        await tool(tab, 'undo');
        await until(tab, 'one', (all) => all.length === 1);
        await tool(tab, 'redo');
        await until(tab, 'two again', (all) => all.length === 2 && all[1].kind === now[1].kind);
        assert.deepEqual(tab.problems, []);
      });
    }

    test('a polygon has the corners that are clicked, a word is a mask', async () => {
      const tab = await openTools(browser, size);
      await tool(tab, 'polygon');
      for (const place of [[-0.1, 1], [0.1, 1], [0, 1.2], [-0.1, 1]]) {
        await tap(tab, ...place, touch);
      }
      const [, polygon] = await until(tab, 'a polygon', (all) => all.length === 2);
      assert.deepEqual([polygon.shape, polygon.points.split(' ').length], ['polygon', 3]);
      await tool(tab, 'text');
      await tap(tab, 0, 0.8, touch);
      await tab.page.waitForSelector('.hearth-text');
      await tab.page.keyboard.type('OK');
      await tab.key('Enter');
      const [, , word] = await until(tab, 'a word', (all) => all.length === 3);
      assert.equal(word.shape, 'mask');
      assert.ok(close(word.x, 0) && close(word.y, 0.8));
      assert.deepEqual(tab.problems, []);
    });
  });
}

test('a solid that is drawn on fire burns at its surface, and goes with its fire in one step', async () => {
  const tab = await openTools(browser);
  await tab.page.click('.hearth-toolbar input[type=checkbox]');
  await tool(tab, 'circle');
  await drag(tab, [0, 1.1], [0.1, 1.1]);
  const [, disc, fire] = await until(tab, 'a disc and its fire', (all) => all.length === 3);
  assert.deepEqual([fire.kind, fire.shape, fire.solid], ['source', 'solid', disc.id]);
  // Some 150 kW/m for each metre around it.
  assert.ok(close(fire.power, 150 * Math.PI * disc.width, 5), `${fire.power} kW/m`);
  await tool(tab, 'erase');
  await drag(tab, [-0.3, 1.1], [0, 1.1]);
  await until(tab, 'both gone', (all) => all.length === 1);
  await tool(tab, 'undo');
  await until(tab, 'both back', (all) => all.length === 3);
  await tool(tab, 'undo');
  await until(tab, 'the first scene', (all) => all.length === 1);
  assert.deepEqual(tab.problems, []);
});

/** Drops a file on the fire. */
const drop = (tab, { name, type, bytes }) => tab.evaluate((file) => {
  const data = new DataTransfer();
  data.items.add(new File([Uint8Array.from(file.bytes)], file.name, { type: file.type }));
  const { x, y, width, height } = /** @type {Element} */ (document.querySelector('.hearth-overlay')).getBoundingClientRect();
  document.querySelector('.hearth-overlay')?.dispatchEvent(new DragEvent('drop', {
    dataTransfer: data, clientX: x + width / 2, clientY: y + height / 2, bubbles: true, composed: true, cancelable: true,
  }));
}, { name, type, bytes: [...bytes] });

const SVG = (size) => Buffer.from(`<svg xmlns="http://www.w3.org/2000/svg" width="${size}" height="${size}"><circle cx="50%" cy="50%" r="40%"/></svg>`);

test('a dropped picture is a mask where it is dropped; what is no picture or too large is rejected with a message', async () => {
  const tab = await openTools(browser);
  await drop(tab, { name: 'disc.svg', type: 'image/svg+xml', bytes: SVG(100) });
  const [, mask] = await until(tab, 'a mask', (all) => all.length === 2);
  assert.equal(mask.shape, 'mask');
  assert.ok(!JSON.stringify(mask).includes('svg'));
  for (const [file, words] of [
    [{ name: 'notes.txt', type: 'text/plain', bytes: [65] }, /“notes.txt” is no image/],
    [{ name: 'broken.png', type: 'image/png', bytes: [1, 2, 3] }, /“broken.png” cannot be read as an image/],
    [{ name: 'empty.svg', type: 'image/svg+xml', bytes: Buffer.from('<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"/>') }, /opaque/],
    [{ name: 'huge.svg', type: 'image/svg+xml', bytes: SVG(9000) }, /81 megapixels; an image has at most 40/],
  ]) {
    await drop(tab, file);
    await tab.until(`the words for ${file.name}`, (pattern) => new RegExp(pattern).test(document.querySelector('.hearth-status')?.textContent ?? ''), words.source);
    assert.equal((await objects(tab)).length, 2);
  }
  assert.deepEqual(tab.problems, []);
});

test('an absent font, a word without ink and the sixty-fifth solid are rejected with messages', async () => {
  const tab = await openTools(browser);
  await tool(tab, 'text');
  await tab.click(await pixel(tab, 0, 1));
  await tab.page.waitForSelector('.hearth-text');
  const fill = async (word, family) => {
    await tab.evaluate((values) => {
      for (const [at, input] of document.querySelectorAll('.hearth-text input').entries()) /** @type {HTMLInputElement} */ (input).value = values[at];
    }, [word, family]);
    await tab.page.click('.hearth-text [type=submit]');
    return tab.evaluate(() => document.querySelector('.hearth-text [role=alert]')?.textContent);
  };
  assert.equal(await fill('OK', 'No Such Font'), 'This computer has no font “No Such Font”.');
  assert.equal(await fill(' ', 'serif'), 'A word has at least one letter.');
  await tab.key('Escape');
  await tab.fire((fire) => fire.set({
    objects: [{ kind: 'source' }, ...Array.from({ length: 64 }, (_, at) => ({ kind: 'solid', x: at / 8 - 4, y: 1.7, width: 0.05 }))],
  }));
  await tool(tab, 'circle');
  await drag(tab, [0, 1], [0.1, 1]);
  await tab.until('words', () => /at most 64 solids/.test(document.querySelector('.hearth-status')?.textContent ?? ''));
  assert.equal((await objects(tab)).length, 65);
  assert.deepEqual(tab.problems, []);
});
