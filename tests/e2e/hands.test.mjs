/**
 * The toolbar: each tool with a real mouse, a finger and keys; undo; words and pictures that are refused; and
 * the toolbar inside of any element with `controls`.
 */
import assert from 'node:assert/strict';
import { Buffer } from 'node:buffer';
import { after, before, describe, test } from 'node:test';
import { Browser } from './driver.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launch();
});
after(() => browser?.close());

const WIDE = { width: 1280, height: 800 };
const PHONES = [{ width: 390, height: 844, touch: true }, { width: 844, height: 390, touch: true }];

/** A fire whose particles are all flame, and one that throws no sparks by itself. */
const CLASSIC = 'scene=default&model=classic&paused&quality=low';
const SPARKLESS = 'scene=default&paused&quality=low&ember-rate=0';

const objects = (tab) => tab.fire((fire) => fire.objects);
const said = (tab) => tab.evaluate(() => document.querySelector('.hearth-said')?.textContent ?? '');
const tool = (tab, name) => tab.page.click(`[data-tool="${name}"]`);

/** The page with its toolbar. */
async function openPage(size = WIDE, query = 'scene=default&paused') {
  const tab = await browser.open(`index.html?${query}`, size);
  await tab.ready();
  await tab.page.waitForSelector('#draw:not([hidden])');
  await tab.page.click('#draw');
  await tab.page.waitForSelector('.hearth-tools [data-tool="erase"]');
  return tab;
}

/** A point of the window at a place of the world [m]. */
async function pixel(tab, x, y) {
  const at = await tab.fire((fire, place) => {
    const { left, top } = fire.getBoundingClientRect();
    const point = fire.toPixels(...place);
    return { x: left + point.x, y: top + point.y };
  }, [x, y]);
  return at;
}

/** Waits until the objects are as `holds` requires. */
async function until(tab, what, holds) {
  let now;
  for (let patience = 200; patience > 0; patience -= 1) {
    now = await objects(tab);
    if (holds(now)) return now;
    await tab.frames();
  }
  throw new Error(`the objects should be ${what} and are ${JSON.stringify(now)}`);
}

/** Taps or clicks a place of the world [m]. */
async function tap(tab, x, y, touch = false) {
  const at = await pixel(tab, x, y);
  await (touch ? tab.page.touchscreen.tap(at.x, at.y) : tab.click(at));
  await tab.frames();
}

/** Presses a key while another one is down. */
async function chord(tab, held, key) {
  await tab.page.keyboard.down(held);
  await tab.key(key);
  await tab.page.keyboard.up(held);
}

/** Whether there is a step to undo. */
const canUndo = (tab) => tab.on('[data-tool="undo"]', (button) => button.getAttribute('aria-disabled') !== 'true');

/** Where the glow of the same fire is, as a share of its width, after each of these. */
async function glowsAfter(tab, acts) {
  const places = [];
  for (const act of acts) {
    await tab.fire((fire) => fire.reset());
    await tab.fire((fire) => fire.step(240));
    for (let round = 0; round < 3; round += 1) {
      await act();
      await tab.fire((fire) => fire.step(20));
    }
    await tab.frames();
    places.push(await glowAt(tab));
  }
  return places;
}

async function glowAt(tab) {
  // The toolbar glows too. Without visibility, it would lose the focus.
  const shows = (how) => tab.on('.hearth-hands', (host, opacity) => (host.style.opacity = opacity), how);
  await shows('0');
  const picture = await tab.firePicture();
  await shows('');
  const columns = Array.from({ length: 48 }, (_, at) => picture.part(at / 48, 0, (at + 1) / 48, 1).glowing());
  const all = columns.reduce((sum, column) => sum + column);
  return columns.reduce((sum, column, at) => sum + column * (at + 0.5), 0) / (48 * all);
}

/** Number of embers, as the fire says after a step. */
const embers = async (tab) => {
  await tab.fire((fire) => fire.step(1));
  await tab.frames(3);
  return tab.fire((fire) => fire.stats?.embers ?? 0);
};

/** Drags with the mouse, or with a finger where the page has touch. */
async function drag(tab, from, to, touch = false) {
  const [start, end] = [await pixel(tab, ...from), await pixel(tab, ...to)];
  await (touch ? tab.touchDrag(start, end) : tab.drag(start, end));
}

const close = (one, other, off = 0.02) => Math.abs(one - other) <= off;

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
        const tab = await openPage(size);
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

    test('select moves, turns and sizes; erase removes', async () => {
      const tab = await openPage(size);
      await tool(tab, 'box');
      await drag(tab, [-0.15, 1.2], [0.15, 1], touch);
      await until(tab, 'two', (all) => all.length === 2);
      await tool(tab, 'select');
      await drag(tab, [0, 1.1], [0.1, 0.9], touch);
      await until(tab, 'moved', ([, box]) => close(box.x, 0.1) && close(box.y, 0.9));
      await drag(tab, [0.25, 0.8], [0.3, 0.75], touch);
      await until(tab, 'larger', ([, box]) => close(box.width, 0.4) && close(box.height, 0.3));
      const handle = await tab.evaluate(() => {
        const { x, y, width, height } = /** @type {Element} */ (document.querySelector('.hearth-overlay .turn')).getBoundingClientRect();
        return { x: x + width / 2, y: y + height / 2 };
      });
      const right = await pixel(tab, 0.4, 0.9);
      await (touch ? tab.touchDrag(handle, right) : tab.drag(handle, right));
      await until(tab, 'turned', ([, box]) => close(box.angle, -90, 4));
      for (const step of ['angle', 'width', 'x']) {
        await tool(tab, 'undo');
        await until(tab, `${step} before`, ([, box]) => close(box[step], { angle: 0, width: 0.3, x: 0 }[step]));
      }
      await tool(tab, 'erase');
      await drag(tab, [-0.3, 1.1], [0.05, 1.1], touch);
      await until(tab, 'erased', (all) => all.length === 1);
      await tool(tab, 'undo');
      await until(tab, 'back', (all) => all.length === 2);
      assert.deepEqual(tab.problems, []);
    });

    test('a drag blows flames its way, which is no step', async () => {
      const tab = await openPage(size, CLASSIC);
      await tool(tab, 'blow');
      assert.match(await said(tab), /^Blow: Drag to blow/);
      const [right, left] = await glowsAfter(tab, [1, -1].map((way) => () => drag(tab, [-0.1 * way, 0.3], [0.1 * way, 0.3], touch)));
      assert.ok(right > left + 0.01, `blown to the right, the flames are at ${right}, to the left at ${left}`);
      assert.equal(await canUndo(tab), false);
      assert.deepEqual(tab.problems, []);
    });

    test('a drag throws sparks along its way, which is no step', async () => {
      const tab = await openPage(size, SPARKLESS);
      const before = await embers(tab);
      await tool(tab, 'sparks');
      await drag(tab, [-0.3, 1.1], [0.3, 1.1], touch);
      const thrown = await embers(tab) - before;
      assert.ok(thrown > 40, `${thrown} sparks`);
      assert.equal(await canUndo(tab), false);
      assert.equal((await objects(tab)).length, 1);
      assert.deepEqual(tab.problems, []);
    });

    test('several objects are selected, moved, aligned and removed together, each as one step', async () => {
      const tab = await openPage(size);
      for (const [from, to] of [[[-0.25, 1.25], [-0.15, 1.15]], [[0.1, 1.1], [0.2, 0.95]]]) {
        await tool(tab, 'box');
        await drag(tab, from, to, touch);
        await tab.frames();
      }
      const [, one, other] = await until(tab, 'three', (all) => all.length === 3);
      const aligns = () => tab.on('.hearth-align', (bar) => bar.checkVisibility());
      await tool(tab, 'select');
      await tap(tab, -0.2, 1.2, touch);
      assert.equal(await aligns(), false);
      if (touch) await tool(tab, 'several');
      else await tab.page.keyboard.down('Shift');
      await tap(tab, 0.15, 1.02, touch);
      if (touch) await tool(tab, 'several');
      else await tab.page.keyboard.up('Shift');
      assert.equal(await said(tab), '2 objects are selected.');
      assert.equal(await aligns(), true);

      await drag(tab, [-0.2, 1.2], [-0.1, 0.9], touch);
      await until(tab, 'moved', ([, a, b]) => close(a.x - one.x, 0.1) && close(a.y - one.y, -0.3)
        && close(b.x - other.x, a.x - one.x, 2e-3) && close(b.y - other.y, a.y - one.y, 2e-3));
      await tool(tab, 'align-left');
      await until(tab, 'aligned at the left', ([, a, b]) => close(a.x - a.width / 2, b.x - b.width / 2, 2e-3));
      await tool(tab, 'align-middle');
      await until(tab, 'aligned in the middle', ([, a, b]) => close(a.y, b.y, 2e-3));
      await tab.page.focus('.hearth-overlay');
      await tab.key('Delete');
      await until(tab, 'one', (all) => all.length === 1);
      for (const [what, holds] of [
        ['back', ([, a, b]) => a && close(a.y, b.y, 2e-3)],
        ['not in the middle', ([, a, b]) => a.y !== b.y && close(a.x - a.width / 2, b.x - b.width / 2, 2e-3)],
        ['not at the left', ([, a, b]) => close(b.x - other.x, a.x - one.x, 2e-3)],
        ['where they were', ([, a, b]) => a.x === one.x && a.y === one.y && b.x === other.x && b.y === other.y],
      ]) {
        await tool(tab, 'undo');
        await until(tab, what, holds);
      }
      assert.deepEqual(tab.problems, []);
    });

    test('the selected solid goes to the front and to the back, each as one step', async () => {
      const tab = await openPage(size);
      for (const [from, to] of [[[-0.15, 1.2], [0.05, 1]], [[-0.05, 1.15], [0.15, 0.95]]]) {
        await tool(tab, 'box');
        await drag(tab, from, to, touch);
        await tab.frames();
      }
      const order = (ids) => until(tab, `in the order ${ids}`, (all) => all.map(({ id }) => id).join() === ids);
      const first = await order('1,2,3');
      await tool(tab, 'back');
      const behind = await order('3,1,2');
      assert.deepEqual(behind, [first[2], first[0], first[1]]);
      // A press finds what is drawn before the other.
      await tool(tab, 'select');
      await tap(tab, 0, 1.08, touch);
      assert.equal(await tab.on('[aria-label="Selected object"]', (list) => list.value), '2');
      await tool(tab, 'back');
      await order('2,3,1');
      await tool(tab, 'front');
      await order('3,1,2');
      for (const before of ['2,3,1', '3,1,2', '1,2,3']) {
        await tool(tab, 'undo');
        await order(before);
      }
      await tool(tab, 'redo');
      await order('3,1,2');
      await tab.page.select('.hearth-tools select[aria-label="Selected object"]', '1');
      const disabled = (name) => tab.on(`[data-tool="${name}"]`, (button) => button.getAttribute('aria-disabled'));
      assert.deepEqual([await disabled('front'), await disabled('back')], ['true', 'true'], 'a source has no place in front');
      assert.deepEqual(tab.problems, []);
    });

    test('a polygon has the corners that are clicked, a word is a mask', async () => {
      const tab = await openPage(size);
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

test('keys draw, choose, move, turn, scale, duplicate and delete without a pointer', async () => {
  const tab = await openPage();
  await tab.page.focus('.hearth-overlay');
  await tab.key('5');
  await tab.key('Enter');
  for (const key of ['ArrowRight', 'ArrowUp']) await chord(tab, 'Shift', key);
  await tab.key('Enter');
  const [, box] = await until(tab, 'a box', (all) => all.length === 2);
  assert.deepEqual([box.shape, box.width, box.height], ['box', 0.1, 0.1]);
  await tab.key('Escape');
  await tab.key('2');
  await tab.key('ArrowLeft');
  await until(tab, 'to the left', ([, one]) => close(one.x, box.x - 0.01, 1e-4));
  await tab.key('[');
  await until(tab, 'turned', ([, one]) => one.angle === 5);
  await tab.key('+');
  await until(tab, 'larger', ([, one]) => close(one.width, 0.11, 1e-4));
  await chord(tab, 'Control', 'd');
  await until(tab, 'three', (all) => all.length === 3);
  await tab.key('Delete');
  await until(tab, 'two', (all) => all.length === 2);
  assert.match(await said(tab), /is removed/);
  await tab.page.select('.hearth-tools select[aria-label="Selected object"]', '2');
  await tab.page.focus('.hearth-overlay');
  await tab.key('Delete');
  await until(tab, 'one', (all) => all.length === 1);
  assert.deepEqual(tab.problems, []);
});

test('keys blow from the cross', async () => {
  const tab = await openPage(WIDE, CLASSIC);
  await tab.page.focus('.hearth-overlay');
  await tab.key('b');
  const cross = () => tab.on('.hearth-overlay .cross', (path) => path.getBoundingClientRect().y);
  await tab.key('Enter');
  const middle = await cross();
  for (let down = 0; down < 4; down += 1) await chord(tab, 'Shift', 'ArrowDown');
  assert.ok(await cross() > middle, 'with Shift, an arrow moves the cross');
  const at = await cross();
  const [right, left] = await glowsAfter(tab, ['ArrowRight', 'ArrowLeft'].map((key) => () => tab.key(key)));
  assert.ok(right > left + 0.01, `blown to the right, the flames are at ${right}, to the left at ${left}`);
  assert.equal(await cross(), at, 'an arrow blows and moves nothing');
  await tab.key('k');
  assert.match(await said(tab), /The classic model has none/);
  assert.deepEqual(tab.problems, []);
});

test('Enter throws sparks at the cross', async () => {
  const tab = await openPage(WIDE, SPARKLESS);
  await tab.page.focus('.hearth-overlay');
  await tab.key('k');
  const before = await embers(tab);
  await tab.key('Enter');
  await tab.key('Enter');
  assert.equal(await embers(tab) - before, 48);
  assert.equal(await canUndo(tab), false);
  const names = await tab.evaluate(() => ['blow', 'sparks'].map((name) => document.querySelector(`[data-tool="${name}"]`)?.getAttribute('aria-label')));
  assert.deepEqual(names, ['Blow (B)', 'Sparks (K)']);
  assert.deepEqual(tab.problems, []);
});

test('keys add to the selection, move and duplicate all of it, and align it', async () => {
  const tab = await openPage();
  await tab.fire((fire) => fire.set({ objects: [
    { kind: 'source', id: 1 }, { kind: 'solid', id: 2, x: 0, y: 1, width: 0.1 }, { kind: 'solid', id: 3, x: 0.3, y: 1.1, width: 0.2 },
  ] }));
  await tab.page.select('.hearth-tools select[aria-label="Selected object"]', '2');
  await tab.page.focus('.hearth-overlay');
  // Enter shows the cross at the selected object.
  await tab.key('Enter');
  for (const key of ['ArrowRight', 'ArrowRight', 'ArrowRight', 'ArrowUp']) await chord(tab, 'Shift', key);
  await chord(tab, 'Shift', 'Enter');
  assert.equal(await said(tab), '2 objects are selected.');
  await tab.key('Escape');
  await tab.key('ArrowRight');
  await until(tab, 'both to the right', ([, a, b]) => close(a.x, 0.01, 1e-4) && close(b.x, 0.31, 1e-4));
  await chord(tab, 'Control', 'd');
  await until(tab, 'five', (all) => all.length === 5);
  await tab.key('Delete');
  await until(tab, 'three', (all) => all.length === 3);
  await tool(tab, 'undo');
  await tool(tab, 'undo');
  await tool(tab, 'undo');
  await until(tab, 'as they were', ([, a, b]) => a.x === 0 && close(b.x, 0.3, 1e-6));
  // The list adds as well.
  await tool(tab, 'several');
  for (const id of ['2', '3']) await tab.page.select('.hearth-tools select[aria-label="Selected object"]', id);
  await tab.page.focus('[data-tool="align-left"]');
  for (const key of ['ArrowRight', 'ArrowRight', 'Enter']) await tab.key(key);
  await until(tab, 'aligned at the right', ([, a, b]) => close(a.x + 0.05, b.x + 0.1, 2e-3));
  const names = await tab.evaluate(() => [...document.querySelectorAll('.hearth-align button')].map((button) => button.getAttribute('aria-label')));
  assert.deepEqual(names, ['left', 'centre', 'right', 'top', 'middle', 'bottom'].map((to) => `Align: ${to}`));
  assert.deepEqual(tab.problems, []);
});

test('a moved object snaps to the edges and the middle of others with a guide, and with Alt it does not', async () => {
  const tab = await openPage();
  await tab.fire((fire) => fire.set({ objects: [
    { kind: 'source', id: 1 }, { kind: 'solid', id: 2, shape: 'box', x: 0.3, y: 0.6, width: 0.2, height: 0.1 },
    { kind: 'solid', id: 3, shape: 'box', x: -0.2, y: 1.1, width: 0.1, height: 0.1 },
  ] }));
  await tool(tab, 'select');
  const [from, to] = [await pixel(tab, -0.2, 1.1), await pixel(tab, 0.3, 1)];
  const guides = () => tab.on('.hearth-overlay .guide', (path) => path.getAttribute('d'));
  await tab.mouse('move', from);
  await tab.mouse('down', from);
  // Three pixels beside the middle of the other.
  await tab.mouse('move', { x: to.x + 3, y: to.y });
  await until(tab, 'in the middle', ([, , box]) => close(box.x, 0.3, 2e-3));
  assert.notEqual(await guides(), '');
  await tab.page.keyboard.down('Alt');
  await tab.mouse('move', { x: to.x + 4, y: to.y });
  const [, , free] = await until(tab, 'beside it', ([, , box]) => box.x > 0.302);
  await tab.page.keyboard.up('Alt');
  assert.ok(close(free.x, 0.3), `${free.x}`);
  assert.equal(await guides(), '');
  await tab.mouse('move', { x: to.x - 3, y: to.y });
  await until(tab, 'in the middle again', ([, , box]) => close(box.x, 0.3, 2e-3));
  await tab.mouse('up', { x: to.x - 3, y: to.y });
  await tab.frames();
  assert.equal(await guides(), '');
  await tool(tab, 'undo');
  await until(tab, 'back', ([, , box]) => close(box.x, -0.2, 1e-6));
  assert.deepEqual(tab.problems, []);
});

test('a solid that is drawn on fire burns at its surface, and goes with its fire in one step', async () => {
  const tab = await openPage();
  await tab.page.click('.hearth-tools input[type=checkbox]');
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

test('two hundred random actions undone give the first scene', async () => {
  const tab = await openPage(WIDE, 'scene=campfire&paused');
  const first = await tab.fire((fire) => fire.exportConfig());
  let seed = 7;
  const chance = (many) => {
    seed = (seed * 48271) % 2147483647;
    return seed % many;
  };
  await tab.page.focus('.hearth-overlay');
  const keys = ['3', '4', '5', '6', '9', '2', 'Enter', 'ArrowLeft', 'ArrowUp', 'ArrowRight', 'ArrowDown', '[', '+', '-', 'Delete', 'Escape', 'Enter', '0'];
  for (let action = 0; action < 200; action += 1) {
    await tab.key(keys[chance(keys.length)]);
    if (chance(8) === 0) await tab.frames(1);
  }
  await tab.key('Escape');
  await tab.key('Escape');
  for (let patience = 300; patience > 0; patience -= 1) {
    const left = await tab.evaluate(() => document.querySelector('[data-tool="undo"]')?.getAttribute('aria-disabled') !== 'true');
    if (!left) break;
    await tool(tab, 'undo');
    await tab.frames(1);
  }
  assert.deepEqual(await tab.fire((fire) => fire.exportConfig()), first);
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

test('a dropped picture is a mask where it is dropped; what is no picture or too large is refused in words', async () => {
  const tab = await openPage();
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
    await tab.until(`the words for ${file.name}`, (pattern) => new RegExp(pattern).test(document.querySelector('.hearth-said')?.textContent ?? ''), words.source);
    assert.equal((await objects(tab)).length, 2);
  }
  assert.deepEqual(tab.problems, []);
});

test('an absent font, a word without ink and the sixty-fifth solid are refused in words', async () => {
  const tab = await openPage();
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
  await tab.until('words', () => /at most 64 solids/.test(document.querySelector('.hearth-said')?.textContent ?? ''));
  assert.equal((await objects(tab)).length, 65);
  assert.deepEqual(tab.problems, []);
});

test('a fire with controls offers the tools inside of it, loaded on request', async () => {
  const tab = await browser.open('<hearth-fire controls style="width: 700px; height: 500px"></hearth-fire>', WIDE);
  await tab.ready();
  const loaded = () => tab.evaluate(() => performance.getEntriesByType('resource').some(({ name }) => name.endsWith('/tools.js')));
  const inside = (selector) => tab.until(`${selector} inside`, (wanted) => (
    document.querySelector('hearth-fire')?.shadowRoot?.querySelector(wanted) !== null
  ), selector);
  await inside('.hearth-draw');
  assert.equal(await loaded(), false);
  await tab.page.click('hearth-fire >>> .hearth-draw');
  await inside('[data-tool="box"]');
  assert.equal(await loaded(), true);
  await tab.page.click('hearth-fire >>> [data-tool="box"]');
  await drag(tab, [-0.1, 1.1], [0.1, 0.9]);
  await until(tab, 'two', (all) => all.length === 2);
  await tab.page.click('hearth-fire >>> [data-tool="close"]');
  await tab.until('no toolbar', () => !document.querySelector('hearth-fire')?.shadowRoot?.querySelector('.hearth-tools'));
  await tab.fire((fire) => fire.removeAttribute('controls'));
  await tab.until('no button', () => !document.querySelector('hearth-fire')?.shadowRoot?.querySelector('.hearth-draw'));
  assert.deepEqual(tab.problems, []);
});
