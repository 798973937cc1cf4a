/**
 * Pointers on an interactive fire: movement stirs the gas, a click throws sparks, a drag
 * moves the source. Methods do the same.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser, except } from '../driver.mjs';
import { events, recording } from '../assertions.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

const CALM = 'paused interactive ember-rate="0" ember-size="0.02"';

/** Where the middle of the source's foot is on the screen, or a place above it, in widths of the source. */
const source = (tab, above = 0) =>
  tab.fire(async (fire, up) => {
    // The engine answers in order: every earlier drag counts.
    await fire.exportConfig();
    const { left, top } = fire.getBoundingClientRect();
    const { source_x, source_height, source_width } = fire.params;
    const { x, y } = fire.toPixels(source_x, source_height + up * source_width);
    return { x: left + x, y: top + y };
  }, above);

/** Waits until the fire is ready, and listens to pointers. */
const listens = async (tab) => {
  await tab.ready();
  await tab.evaluate(() => import(/** @type {any} */ ('/web/element/pointer/pointer.js')).then(() => undefined));
};

/** The number of embers, which the fire reports when it changes. */
const embers = (tab, count) =>
  tab.until(
    `${count} embers`,
    (wanted) => /** @type {any} */ (document.querySelector('hearth-fire')).stats?.embers === wanted,
    count,
  );

test('a pointer stirs only an interactive fire, and more while it is pressed', async () => {
  const tab = await browser.show('<hearth-fire paused model="classic" quality="low" seed="3"></hearth-fire>', {
    draws: true,
  });
  await tab.ready();
  // Each way of the pointer takes 50 ms and is followed by as much fire.
  const swept = async (buttons) => {
    await tab.fire((fire) => fire.reset());
    await tab.fire((fire) => fire.step(240));
    for (let round = 0; round < 3; round += 1) {
      await tab.fire((fire, pressed) => {
        const { left, top } = fire.getBoundingClientRect();
        for (const [at, x] of [110, 122].entries()) {
          const event = new PointerEvent('pointermove', {
            bubbles: true,
            composed: true,
            pointerId: 7,
            pointerType: 'mouse',
            buttons: pressed,
            clientX: left + x,
            clientY: top + 190,
          });
          Object.defineProperty(event, 'timeStamp', { value: 1000 + 50 * at });
          fire.dispatchEvent(event);
        }
        fire.dispatchEvent(new PointerEvent('pointerleave', { pointerId: 7 }));
        return fire.step(12);
      }, buttons);
    }
    await tab.frames(2);
    const picture = await tab.firePicture();
    const columns = Array.from({ length: 48 }, (_, at) => picture.crop(at / 48, 0.5, (at + 1) / 48, 1).glowing());
    const all = columns.reduce((sum, column) => sum + column);
    return columns.reduce((sum, column, at) => sum + column * (at + 0.5), 0) / (48 * all);
  };
  const still = await swept(0);
  assert.notEqual(
    await tab.evaluate(() => document.elementFromPoint(120, 120)?.tagName),
    'HEARTH-FIRE',
    'a decorative fire lets clicks through',
  );
  await tab.fire((fire) => (fire.interactive = true));
  await listens(tab);
  assert.equal(await tab.evaluate(() => document.elementFromPoint(120, 120)?.tagName), 'HEARTH-FIRE');
  const blown = await swept(0);
  assert.ok(blown > still + 0.004, `the glow stands at ${blown} of the width, at ${still} unstirred`);
  const pressed = await swept(1);
  assert.ok(
    pressed > blown + 0.004,
    `the glow stands at ${pressed} of the width, at ${blown} with a pointer that hovers`,
  );
  assert.deepEqual(tab.problems, []);
});

test('a click throws sparks at its place, and a drag throws none', async () => {
  const tab = await browser.show(`<hearth-fire ${CALM} fuel-power="0"></hearth-fire>`, { draws: true });
  await listens(tab);
  await tab.fire((fire) => fire.step(4));
  const before = (await tab.firePicture()).glowing();
  await tab.click({ x: 90, y: 80 });
  await embers(tab, 24);
  await tab.fire((fire) => fire.step(30));
  await tab.frames(2);
  const picture = await tab.firePicture();
  const { x, y, width, height } = await tab.rectangle('hearth-fire');
  const near = picture.crop(
    (90 - x - 40) / width,
    (80 - y - 40) / height,
    (90 - x + 40) / width,
    (80 - y + 40) / height,
  );
  assert.ok(before === 0 && near.glowing() > 0.002, `${near.glowing()} glows, ${before} before`);
  await tab.drag({ x: 60, y: 60 }, { x: 160, y: 60 });
  await tab.fire((fire) => fire.step(1));
  await embers(tab, 24);
  assert.deepEqual(tab.problems, []);
});

test('a drag on the lower flame moves its source', async () => {
  const tab = await browser.show(recording(`<hearth-fire ${CALM}></hearth-fire>`));
  await listens(tab);
  await tab.fire((fire) => fire.step(4));
  const cursor = () => tab.fire((fire) => getComputedStyle(fire.shadowRoot.querySelector('canvas')).cursor);
  const from = await source(tab, 0.8);
  const above = await source(tab, 1.6);
  await tab.move(above);
  await tab.frames();
  assert.equal(await cursor(), 'auto');
  await tab.move(from);
  await tab.frames();
  assert.equal(await cursor(), 'grab');
  await tab.drag(from, { x: from.x + 20, y: from.y - 20 });
  await tab.until(
    'the source is there',
    (x) => {
      const fire = /** @type {any} */ (document.querySelector('hearth-fire'));
      const { params } = fire;
      return Math.abs(fire.getBoundingClientRect().left + fire.toPixels(params.source_x, 0).x - x) < 1;
    },
    from.x + 20,
  );
  const to = await source(tab);
  const changes = await events(tab, 'params-change');
  assert.ok(changes.length > 2);
  assert.deepEqual([...new Set(changes.map(({ id, source: by }) => `${id} ${by}`))], ['source_x pointer']);
  // Beyond the domain it stays inside. No driver but Chromium's leaves the window.
  await tab.drag(to, { x: 470, y: to.y });
  const { set, width } = await tab.fire((fire) => ({ set: fire.params.source_x, width: fire.params.domain_width }));
  assert.ok(set > 0.2 && set < width / 2, `${set} m`);
  assert.equal(await cursor(), 'auto');
  await tab.fire((fire) => fire.step(1));
  assert.equal(await tab.fire((fire) => fire.stats.embers), 0, 'a drag throws no sparks');
  assert.deepEqual(tab.problems, []);
});

test('a fire takes drags and has its panel after its document is gone', async () => {
  const tab = await browser.show(`<iframe srcdoc="<!doctype html><body>" style="width: 90px; height: 60px"></iframe>
    <hearth-fire ${CALM} controls style="width: 300px; height: 300px"></hearth-fire>`);
  await listens(tab);
  await tab.evaluate(async () => {
    const [fire, frame] = [document.querySelector('hearth-fire'), document.querySelector('iframe')];
    const loaded = () => new Promise((resolve) => frame.addEventListener('load', resolve, { once: true }));
    frame.contentDocument.body.append(fire);
    frame.remove();
    document.body.append(frame);
    await loaded();
    document.body.append(fire);
  });
  await tab.frames(4);
  await tab.until('its panel', () => document.querySelector('hearth-fire')?.shadowRoot?.querySelector('.hearth-fold'));
  const at = await source(tab);
  await tab.drag(at, { x: at.x + 30, y: at.y });
  await tab.until(
    'it has moved',
    () => /** @type {any} */ (document.querySelector('hearth-fire')).params.source_x > 0.02,
  );
});

test('a drag of a campfire moves its logs and stones with it, and nothing else', async () => {
  const tab = await browser.show(
    recording('<hearth-fire preset="fireside" warm interactive ember-rate="0" style="width: 400px"></hearth-fire>'),
  );
  await listens(tab);
  await tab.fire(async (fire) => {
    await fire.addObject({ kind: 'solid', shape: 'box', x: 0.3, y: 0.9, width: 0.1, height: 0.1 });
    await fire.addObject({ kind: 'solid', shape: 'box', x: 0.05, y: 0.2, width: 0.05, height: 0.05, fuel: 'wood' });
    await fire.addObject({ kind: 'solid', shape: 'box', x: -0.05, y: 0.2, width: 0.05, height: 0.05, motion: 'sway' });
  });
  const places = () =>
    tab.fire(async (fire) => {
      await fire.exportConfig();
      return fire.objects.map(({ x, y }) => [x, y]);
    });
  const before = await places();
  /** The drag of a place of the fire to the left [m]. */
  const drag = async (x, y) => {
    const [from, to] = await tab.fire(
      (fire, at, up) => {
        const { left, top } = fire.getBoundingClientRect();
        return [at, at - 0.2].map((place) => {
          const point = fire.toPixels(place, up);
          return { x: left + point.x, y: top + point.y };
        });
      },
      x,
      y,
    );
    await tab.drag(from, to);
    await tab.until(
      'the things are there',
      (wanted) => Math.abs(/** @type {any} */ (document.querySelector('hearth-fire')).params.source_x - wanted) < 0.02,
      x < 0.1 ? -0.2 : -0.4,
    );
    return places();
  };
  // By the fire itself, then by a stone.
  const first = await drag(0, 0.03);
  const by = first[0][0];
  first.forEach(([x, y], at) => {
    const moved = at < 6 ? by : 0;
    assert.ok(
      Math.abs(x - before[at][0] - moved) < 2e-3 && y === before[at][1],
      `object ${at}: from ${before[at]} to ${x}, ${y}`,
    );
  });
  const second = await drag(first[5][0], first[5][1]);
  assert.ok(Math.abs(second[5][0] - first[5][0] - second[0][0] + first[0][0]) < 2e-3, 'a stone takes the fire along');
  // The moved solids push the gas aside and crush none.
  const { removed, particles } = await tab.fire(
    (fire) =>
      new Promise((resolve) => {
        fire.addEventListener('stats', ({ detail }) => resolve(detail), { once: true });
      }),
  );
  assert.ok(removed < 0.01 * particles, `${removed} of ${particles} particles are removed`);
  assert.deepEqual(await tab.problemsAfterFrame(), []);
});

test('a drag on a source that is on a solid moves the solid', async () => {
  const tab = await browser.show(recording(`<hearth-fire ${CALM}></hearth-fire>`));
  await listens(tab);
  const id = await tab.fire(async (fire) => {
    const solid = await fire.addObject({
      kind: 'solid',
      shape: 'box',
      x: 0.1,
      y: 0.8,
      width: 0.5,
      height: 0.05,
      angle: 90,
    });
    await fire.set({ source_shape: 'solid', source_solid: solid });
    return solid;
  });
  const solid = () =>
    tab.fire(async (fire, wanted) => {
      await fire.exportConfig();
      const { left, top } = fire.getBoundingClientRect();
      const { x, y } = fire.objects.find((object) => object.id === wanted);
      const at = fire.toPixels(x, y);
      return { x: left + at.x, y: top + at.y };
    }, id);
  const from = await solid();
  // Its upper end, which a box that is not turned would not reach.
  const end = { x: from.x, y: from.y - 30 };
  await tab.drag(end, { x: end.x - 40, y: end.y + 24 });
  const to = await solid();
  assert.ok(
    Math.abs(to.x - from.x + 40) < 1 && Math.abs(to.y - from.y - 24) < 1,
    `${JSON.stringify(from)} to ${JSON.stringify(to)}`,
  );
  const changes = await events(tab, 'objects-change');
  assert.ok(changes.some(({ source: by }) => by === 'pointer'));
  assert.equal(await tab.fire((fire) => fire.params.source_x), 0);
  // Beside it, nothing is held.
  await tab.drag({ x: to.x + 40, y: to.y }, { x: to.x + 80, y: to.y });
  assert.deepEqual(await solid(), to);
  assert.deepEqual(tab.problems, []);
});

/** A page to scroll with a fire whose source a finger has moved, and where that is. */
async function movedByFinger() {
  const tab = await browser.open(`<hearth-fire ${CALM}></hearth-fire><div style="height: 3000px"></div>`, {
    touch: true,
  });
  await listens(tab);
  await tab.fire((fire) => fire.step(4));
  const from = await source(tab);
  await tab.touchDrag(from, { x: from.x + 40, y: from.y - 10 });
  assert.equal(await tab.evaluate(() => window.scrollY), 0);
  const moved = await source(tab);
  assert.ok(moved.x > from.x + 30);
  return { tab, moved };
}

test('a finger moves the source across', async () => {
  const { tab } = await movedByFinger();
  assert.deepEqual(tab.problems, []);
});

const NO_SCROLL = except({ firefox: "a finger of Firefox's driver scrolls no page" });

test('a finger scrolls the page up and down from the source and from anywhere else', NO_SCROLL, async () => {
  const { tab, moved } = await movedByFinger();
  for (const begin of [moved, { x: 120, y: 180 }]) {
    await tab.evaluate(() => window.scrollTo(0, 0));
    await tab.touchDrag(begin, { x: begin.x, y: begin.y - 160 });
    await tab.until('the page has scrolled', () => window.scrollY > 50);
  }
  await tab.evaluate(() => window.scrollTo(0, 0));
  assert.equal((await source(tab)).x, moved.x);
});

test('a mouse drag from the fire selects text, and one from its source does not', async () => {
  const tab = await browser.show(
    `<hearth-fire ${CALM}></hearth-fire><p style="margin: 0">These words may be selected.</p>`,
  );
  await listens(tab);
  await tab.fire((fire) => fire.step(4));
  const words = await tab.rectangle('p');
  const end = { x: words.x + 150, y: words.y + 8 };
  const selected = () => tab.evaluate(() => `${getSelection()}`);
  await tab.drag(await source(tab), end);
  assert.equal(await selected(), '');
  await tab.drag({ x: words.x + 2, y: words.y + 8 }, end);
  assert.match(await selected(), /^These words/);
});
