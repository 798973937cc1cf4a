/**
 * The tools that draw: shapes, words and pictures, with a real mouse, a finger and keys; and what they reject.
 */
import assert from 'node:assert/strict';
import { Buffer } from 'node:buffer';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { Panel } from '../panel.mjs';
import { chord, close, drag, openTools, PHONES, pixel, tap, tool, WIDE } from '../tools.mjs';
import { objects, objectsUntil as until } from '../waits.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

for (const size of [WIDE, ...PHONES]) {
  const touch = 'touch' in size;
  const each = 'a box, a polygon and a word are drawn, moved and erased, each as one step';
  test(`at ${size.width} × ${size.height}, ${each}`, async () => {
    const tab = await openTools(browser, size);
    await tool(tab, 'box');
    await drag(tab, [-0.15, 1.2], [0.15, 1], touch);
    const [, box] = await until(tab, 'two', (all) => all.length === 2);
    assert.ok(
      box.shape === 'box' && close(box.x, 0) && close(box.y, 1.1) && close(box.width, 0.3) && close(box.height, 0.2),
      JSON.stringify(box),
    );
    await tool(tab, 'select');
    await drag(tab, [0, 1.1], [0.1, 0.9], touch);
    await until(tab, 'moved', ([, moved]) => close(moved.x, 0.1) && close(moved.y, 0.9));
    await drag(tab, [0.25, 0.8], [0.3, 0.75], touch);
    await until(tab, 'larger', ([, larger]) => close(larger.width, 0.4) && close(larger.height, 0.3));
    const handle = await tab.evaluate(() => {
      const { x, y, width, height } = /** @type {Element} */ (
        document.querySelector('.hearth-overlay .turn')
      ).getBoundingClientRect();
      return { x: x + width / 2, y: y + height / 2 };
    });
    const right = await pixel(tab, 0.4, 0.9);
    await (touch ? tab.touchDrag(handle, right) : tab.drag(handle, right));
    await until(tab, 'turned', ([, turned]) => close(turned.angle, -90, 4));
    await tool(tab, 'polygon');
    for (const place of [
      [-0.1, 1],
      [0.1, 1],
      [0, 1.2],
      [-0.1, 1],
    ])
      await tap(tab, ...place, touch);
    const [, , polygon] = await until(tab, 'a polygon', (all) => all.length === 3);
    assert.deepEqual([polygon.shape, polygon.points.split(' ').length], ['polygon', 3]);
    await tool(tab, 'text');
    await tap(tab, 0, 0.8, touch);
    await tab.page.waitForSelector('.hearth-text');
    await tab.page.keyboard.type('OK');
    await tab.key('Enter');
    const [, , , word] = await until(tab, 'a word that burns', (all) => all.length === 5);
    assert.deepEqual([word.shape, word.material, word.plane], ['mask', 'coal', 'before']);
    assert.ok(close(word.x, 0) && close(word.y, 0.8));
    await tool(tab, 'erase');
    await drag(tab, [-0.3, 1.05], [0.05, 1.05], touch);
    await until(tab, 'fewer', (all) => all.length < 5 && !all.some(({ id }) => id === polygon.id));
    for (const [what, holds] of [
      ['all again', (all) => all.length === 5],
      ['no word', (all) => all.length === 3],
      ['no polygon', (all) => all.length === 2],
      ['not turned', ([, before]) => before.angle === 0],
      ['smaller', ([, before]) => close(before.width, 0.3)],
      ['where it was', ([, before]) => close(before.x, 0)],
      ['the first scene', (all) => all.length === 1],
    ]) {
      await tool(tab, 'undo');
      await until(tab, what, holds);
    }
    await tool(tab, 'redo');
    await until(tab, 'the box again', (all) => all.length === 2 && all[1].shape === 'box');
    assert.deepEqual(tab.problems, []);
  });
}

/** Drops a file on the fire. */
const drop = (tab, { name, type, bytes }) =>
  tab.evaluate(
    (file) => {
      const data = new DataTransfer();
      data.items.add(new File([Uint8Array.from(file.bytes)], file.name, { type: file.type }));
      const { x, y, width, height } = /** @type {Element} */ (
        document.querySelector('.hearth-overlay')
      ).getBoundingClientRect();
      document.querySelector('.hearth-overlay')?.dispatchEvent(
        new DragEvent('drop', {
          dataTransfer: data,
          clientX: x + width / 2,
          clientY: y + height / 2,
          bubbles: true,
          composed: true,
          cancelable: true,
        }),
      );
    },
    { name, type, bytes: [...bytes] },
  );

const SVG = (size) =>
  Buffer.from(
    `<svg xmlns="http://www.w3.org/2000/svg" width="${size}" height="${size}"><circle cx="50%" cy="50%" r="40%"/></svg>`,
  );

test('a dropped picture is a mask; no picture, a too large one, an absent font and a word without ink are rejected with a message', async () => {
  const tab = await openTools(browser);
  await drop(tab, { name: 'disc.svg', type: 'image/svg+xml', bytes: SVG(100) });
  const [, mask] = await until(tab, 'a mask', (all) => all.length === 2);
  assert.equal(mask.shape, 'mask');
  assert.ok(!JSON.stringify(mask).includes('svg'));
  for (const [file, words] of [
    [{ name: 'notes.txt', type: 'text/plain', bytes: [65] }, /“notes.txt” is no image/],
    [{ name: 'broken.png', type: 'image/png', bytes: [1, 2, 3] }, /“broken.png” cannot be read as an image/],
    [
      {
        name: 'empty.svg',
        type: 'image/svg+xml',
        bytes: Buffer.from('<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"/>'),
      },
      /opaque/,
    ],
    [{ name: 'huge.svg', type: 'image/svg+xml', bytes: SVG(9000) }, /81 megapixels; an image has at most 40/],
  ]) {
    await drop(tab, file);
    await tab.until(
      `the words for ${file.name}`,
      (pattern) => new RegExp(pattern).test(document.querySelector('.hearth-status')?.textContent ?? ''),
      words.source,
    );
    assert.equal((await objects(tab)).length, 2);
  }
  await tool(tab, 'text');
  await tab.click(await pixel(tab, 0, 1));
  await tab.page.waitForSelector('.hearth-text');
  const fill = async (word, family) => {
    await tab.evaluate(
      (values) => {
        const inputs = /** @type {NodeListOf<HTMLInputElement>} */ (document.querySelectorAll('.hearth-text input'));
        for (const [at, input] of inputs.entries()) input.value = values[at];
      },
      [word, family],
    );
    await tab.page.click('.hearth-text [type=submit]');
    return tab.evaluate(() => document.querySelector('.hearth-text [role=alert]')?.textContent);
  };
  assert.equal(await fill('OK', 'No Such Font'), 'This computer has no font “No Such Font”.');
  assert.equal(await fill(' ', 'serif'), 'A word has at least one letter.');
  await tab.key('Escape');
  assert.equal((await objects(tab)).length, 2);
  assert.deepEqual(tab.problems, []);
});

test('Ctrl Z while a shape is drawn cancels that shape, with the panel, too', async () => {
  const tab = await openTools(browser);
  await new Panel(tab).mounted();
  await tool(tab, 'box');
  await drag(tab, [-0.15, 1.2], [0.15, 1]);
  const drawn = await until(tab, 'two', (all) => all.length === 2);
  const [from, to] = [await pixel(tab, -0.3, 0.8), await pixel(tab, 0.3, 0.6)];
  await tab.page.mouse.move(from.x, from.y);
  await tab.page.mouse.down();
  await tab.page.mouse.move(to.x, to.y);
  await chord(tab, 'Control', 'z');
  await tab.page.mouse.up();
  await tab.fire((fire) => fire.exportConfig());
  assert.deepEqual(await objects(tab), drawn);
  await chord(tab, 'Control', 'z');
  await until(tab, 'the first scene', (all) => all.length === 1);
  await chord(tab, 'Control', 'y');
  assert.deepEqual(await until(tab, 'the box again', (all) => all.length === 2), drawn);
  assert.deepEqual(tab.problems, []);
});
