/**
 * The panel inside an element (attribute `controls`): layout, mouse, touch and keys; the
 * page keeps its focus, wheel and keys; removal leaves nothing behind.
 */
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { isDeepStrictEqual } from 'node:util';
import { BACKWARDS, Browser, eventually } from '../driver.mjs';
import { Panel, actionOf, along, controlOf } from '../panel.mjs';
import { table } from '../site.mjs';

const { DEFAULTS } = await table();

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

const sized = (width, height) => `style="width: ${width}px; height: ${height}px"`;

/**
 * A page that is longer than its window, with a fire that has its panel inside.
 * @param {number} width @param {number} height @param {object} [options]
 */
async function openFire(width, height, options = {}) {
  const tab = await browser.show(
    `<input id="before"><hearth-fire controls max-pixels="30000" ${sized(width, height)}></hearth-fire>
    <input id="after"><div style="height: 2000px"></div>`,
    { width: width + 40, height: height + 80, ...options },
  );
  await tab.ready();
  return { tab, panel: await new Panel(tab, { inside: true }).mounted() };
}

/** Where the parts stand, in pixels of the element. */
const layout = (panel) =>
  panel.in((root) => {
    const of = (element) => {
      const { x, y, width, height } = element.getBoundingClientRect();
      const outer = root.host.getBoundingClientRect();
      return { x: x - outer.x, y: y - outer.y, width, height };
    };
    return {
      panel: of(root.querySelector('.hearth-panel')),
      fire: of(root.querySelector('canvas')),
      button: of(root.querySelector('.hearth-fold')),
    };
  });

const pressFold = async (tab, panel) => {
  const { button } = await layout(panel);
  const { x, y } = await tab.rectangle('hearth-fire');
  await tab.click({ x: x + button.x + 20, y: y + button.y + 20 });
};

describe('its position', () => {
  test('in 360 × 640 is a sheet below the fire', async () => {
    const { tab, panel } = await openFire(360, 640);
    const { panel: sheet, fire, button } = await layout(panel);
    assert.ok(sheet.height <= 0.45 * 640 + 0.5 && sheet.height > 0.3 * 640);
    assert.deepEqual([sheet.x, sheet.width, sheet.y + sheet.height], [0, 360, 640]);
    assert.deepEqual([fire.x, fire.y, fire.width], [0, 0, 360]);
    assert.ok(Math.abs(fire.height - sheet.y) < 1, 'the fire stands on the sheet');
    assert.ok(button.y >= 0 && button.y + button.height <= sheet.y, 'its button is in sight');
    assert.deepEqual(tab.problems, []);
  });

  test('in 900 × 500 is a column beside the fire', async () => {
    const { panel } = await openFire(900, 500);
    const { panel: column, fire, button } = await layout(panel);
    assert.deepEqual([column.y, column.height, column.x + column.width], [0, 500, 900]);
    assert.ok(column.width <= 340 && column.width > 300);
    assert.ok(Math.abs(fire.width - column.x) < 1 && fire.height === 500);
    assert.ok(button.x >= 0 && button.x + button.width <= column.x);
  });

  test('folds to its button, and unfolds as before', async () => {
    const { tab, panel } = await openFire(400, 500);
    const before = await layout(panel);
    await pressFold(tab, panel);
    const folded = await layout(panel);
    assert.equal(folded.panel.height, 0);
    assert.equal(folded.fire.height, 500);
    assert.ok(folded.button.y + folded.button.height <= 500);
    assert.equal(
      await panel.in(
        (root) =>
          root.querySelector('canvas[aria-hidden]').checkVisibility() &&
          root.querySelector('.hearth-controls').checkVisibility(),
      ),
      false,
    );
    await pressFold(tab, panel);
    assert.deepEqual(await layout(panel), before);
    await panel.dragSlider('buoyancy', 0.3, 0.7);
    await panel.value('buoyancy', 'another', (value) => value !== DEFAULTS.buoyancy);
  });

  test('is folded away from the start where there is hardly room', async () => {
    const tab = await browser.show(`<hearth-fire controls ${sized(200, 200)}></hearth-fire>`);
    const panel = new Panel(tab, { inside: true });
    await panel.until('the button', (root) => root.querySelector('.hearth-fold'));
    assert.equal((await layout(panel)).fire.height, 200);
    assert.equal(await panel.in((root) => root.querySelector('.hearth-fold').ariaExpanded), 'false');
  });
});

/** Layouts of the panel and of the picture: their styles, and what is done. @type {[string, string, string][]} */
const LAYOUTS = [
  ['beside a column', 'width: 900px; height: 500px', ''],
  ['above a sheet', 'width: 400px; height: 600px', ''],
  ['above a resized sheet', 'width: 400px; height: 600px', 'resize'],
  ['with a folded panel', 'width: 900px; height: 500px', 'fold'],
  ['beside a column from right to left', 'width: 900px; height: 500px; direction: rtl', 'fold'],
  ['in a page that moves the picture', 'width: 900px; height: 500px', 'move'],
];

test('points of a fire are those of its picture, whatever the panel and the page do with that', async () => {
  const tab = await browser.show(
    `<style>body { margin: 0 } .move::part(canvas) { inset: 40px 20px 90px 30px; scale: 0.8 }</style>
    <div id="box" style="position: absolute; left: 180px; top: 100px; width: 60px; height: 40px"></div>
    <hearth-fire controls interactive paused max-pixels="30000" ${sized(900, 500)}><hearth-solid of="#box"></hearth-solid></hearth-fire>`,
    { width: 920, height: 640 },
  );
  await tab.ready();
  const panel = await new Panel(tab, { inside: true }).mounted();
  await tab.page.click('hearth-fire >>> .hearth-draw');
  await panel.until('the tools', (root) => root.querySelector('[data-tool="select"]'));
  for (const [about, style, does] of LAYOUTS) {
    await tab.fire(
      (fire, css, act) => {
        fire.set('source_x', 0);
        fire.style.cssText = css;
        fire.className = act;
        if (act === 'fold') fire.shadowRoot.querySelector('[aria-label=Controls]').click();
        const grip = fire.shadowRoot.querySelector('.hearth-grip');
        if (act === 'resize') grip.dispatchEvent(new KeyboardEvent('keydown', { key: 'PageUp' }));
      },
      style,
      does,
    );
    await tab.frames(4);
    await tab.fire((fire) => fire.scrollTo(99, 99));
    assert.equal(await tab.fire((fire) => fire.scrollTop + fire.scrollLeft), 0, about);
    await tab.page.click('hearth-fire >>> [data-tool="stir"]');
    // Where the picture shows the middle of a source and a box of the page, by the box of the picture alone.
    const seen = () =>
      tab.fire((fire) => {
        const { left, width, bottom, height } = fire.shadowRoot.querySelector('canvas').getBoundingClientRect();
        const { domain_height: up, source_x: x, source_height: y } = fire.params;
        const scale = height / up;
        const box = document.getElementById('box').getBoundingClientRect();
        const [solid] = fire.objects.filter(({ kind }) => kind === 'solid');
        const outer = fire.getBoundingClientRect();
        const said = fire.toPixels(x, y);
        return {
          scale,
          source: [left + width / 2 + x * scale, bottom - y * scale],
          said: [outer.left + said.x, outer.top + said.y],
          solid: solid && [left + width / 2 + solid.x * scale, bottom - solid.y * scale],
          box: [box.left + box.width / 2, box.top + box.height / 2],
        };
      });
    const isNear = ([x, y], [across, down]) => Math.hypot(x - across, y - down) < 1.5;
    await eventually(`the solid is where the box is, ${about}`, seen, ({ solid, box }) => solid && isNear(solid, box));
    const { source, said, scale } = await seen();
    assert.ok(isNear(said, source), `${about}: ${said} for ${source}`);
    const at = { x: source[0], y: source[1] - 4 };
    await tab.drag(at, { x: at.x + 30, y: at.y });
    await tab.until(
      `a drag moves the source, ${about}`,
      (wanted) => Math.abs(/** @type {any} */ (document.querySelector('hearth-fire')).params.source_x - wanted) < 0.01,
      30 / scale,
    );
    // A click with the tool selects it, and its outline is there.
    const [x, y] = (await seen()).source;
    await tab.page.click('hearth-fire >>> [data-tool="select"]');
    await tab.click({ x, y });
    const outline = () =>
      tab.fire((fire) => {
        const { left, width, top, height } = fire.shadowRoot.querySelector('.outline').getBoundingClientRect();
        return [left + width / 2, top + height / 2];
      });
    await eventually(`its outline, ${about}`, outline, (found) => isNear(found, [x, y]));
  }
  assert.deepEqual(tab.problems, []);
});

for (const scheme of ['light', 'dark'])
  test(`with ${scheme} forced colours the plain controls fill the panel, and icons differ from their buttons`, async () => {
    const tab = await browser.open(`<hearth-fire controls sound="0.5" ${sized(300, 400)}></hearth-fire>`, {
      width: 700,
      height: 500,
      reducedMotion: true,
      forcedColors: true,
      scheme,
    });
    await tab.ready();
    const panel = new Panel(tab, { inside: true });
    for (const [width, height] of [
      [300, 400],
      [560, 640],
      [640, 500],
    ]) {
      await tab.fire((fire, w, h) => (fire.style.cssText = `width: ${w}px; height: ${h}px`), width, height);
      await panel.until(
        `the controls fill the panel of ${width} × ${height}, and its buttons are over the fire`,
        (root) => {
          const box = (name) => root.querySelector(name)?.getBoundingClientRect();
          const [list, sheet, outer] = [
            box('.hearth-controls.alone'),
            box('.hearth-inside'),
            root.host.getBoundingClientRect(),
          ];
          const buttons = [...root.querySelectorAll('.hearth-fold')].map((button) => button.getBoundingClientRect());
          return (
            list?.height > 0.85 * sheet?.height &&
            buttons.length === 3 &&
            buttons.every(({ left, right, top }) => left >= outer.left && right <= outer.right && top >= outer.top)
          );
        },
      );
    }
    const icons = await panel.in((root) =>
      [...root.querySelectorAll('.play, .hearth-fold')].map((button) => {
        const channels = (colour) => colour.match(/\d+/g).slice(0, 3).map(Number);
        const icon = getComputedStyle(button.querySelector('svg'));
        const [ink, ground] = [
          icon.fill === 'none' ? icon.stroke : icon.fill,
          getComputedStyle(button).backgroundColor,
        ];
        return Math.abs(channels(ink)[1] - channels(ground)[1]);
      }),
    );
    assert.ok(icons.length === 4 && icons.every((contrast) => contrast > 100), `${icons}`);
  });

describe('under pointer and keys', () => {
  test('the wheel scrolls the panel over the panel, and the page elsewhere', async () => {
    const { tab, panel } = await openFire(400, 500);
    const { x, y } = await tab.rectangle('hearth-fire');
    const wheel = async (at, deltaY) => {
      await tab.page.mouse.move(at.x, at.y);
      await tab.frames(4);
      await tab.page.mouse.wheel({ deltaY });
      await tab.frames(20);
    };
    const over = { x: x + 200, y: y + 420 };
    await panel.reveal('gravity');
    const before = await panel.rectangleOf('label:gravity');
    await wheel(over, 20);
    assert.equal(await tab.evaluate(() => window.scrollY), 0);
    assert.ok((await panel.rectangleOf('label:gravity')).y < before.y - 5, 'the panel has scrolled');
    await wheel({ x: x + 200, y: y + 100 }, 60);
    await tab.until('the page has scrolled', () => window.scrollY === 60);
    // A panel that is at its upper end leaves the wheel to the page.
    await panel.reveal('fuel_power');
    await wheel(over, -1000);
    await wheel(over, -60);
    await tab.until('the page is back', () => window.scrollY === 0);
  });

  /** A page with fields before and after a fire whose panel has been loaded while the first one had the focus. */
  const openBetween = async () => {
    const tab = await browser.show(
      `<input id="before"><hearth-fire ${sized(400, 500)}></hearth-fire><input id="after">`,
      { width: 440, height: 580 },
    );
    await tab.ready();
    await tab.page.focus('#before');
    await tab.fire((fire) => fire.toggleAttribute('controls', true));
    const panel = await new Panel(tab, { inside: true }).mounted();
    await tab.frames(10);
    const focused = () => tab.evaluate(() => document.activeElement?.id || document.activeElement?.tagName);
    return { tab, panel, focused };
  };

  test('the focus does not move when the panel loads', async () => {
    const { tab, focused } = await openBetween();
    assert.equal(await focused(), 'before');
    assert.equal(await tab.evaluate(() => window.scrollY), 0);
  });

  for (const [keys, end, options] of /** @type {[string[], string, object][]} */ ([
    [['Tab'], 'after', {}],
    [['Shift', 'Tab'], 'before', BACKWARDS],
  ]))
    test(`${keys.join(' ')} passes through it`, options, async () => {
      const { tab, panel, focused } = await openBetween();
      await tab.click(along(await panel.reveal('buoyancy'), 0.5));
      assert.equal(await focused(), 'HEARTH-FIRE');
      const [held, key] = keys.length > 1 ? keys : [undefined, ...keys];
      if (held) await tab.page.keyboard.down(held);
      let presses = 0;
      do {
        await tab.page.keyboard.press(key);
        presses += 1;
      } while (presses < 250 && (await focused()) === 'HEARTH-FIRE');
      if (held) await tab.page.keyboard.up(held);
      assert.equal(await focused(), end);
      assert.ok(held || presses > 40, `${presses} stops`);
    });

  test('shortcuts act only while the panel or its fire has the focus, and then the page does not receive the keys', async () => {
    const { tab, panel } = await openFire(400, 500, {
      before: () => {
        /** @type {any} */ (window).received = [];
        window.addEventListener('DOMContentLoaded', () =>
          document.addEventListener('keydown', (event) => /** @type {any} */ (window).received.push(event.key)),
        );
      },
    });
    const received = () => tab.evaluate(() => /** @type {any} */ (window).received.splice(0));
    const paused = () => tab.fire((fire) => fire.paused);
    for (const key of ['Space', 'h', 'r', '?']) await tab.key(key);
    assert.equal(await paused(), false);
    assert.deepEqual(await received(), [' ', 'h', 'r', '?']);
    // The page's own use of that key.
    await tab.until('the page has scrolled', () => window.scrollY > 0);
    await tab.evaluate(() => window.scrollTo(0, 0));
    await tab.page.focus('#before');
    await tab.key('Space');
    assert.equal(await paused(), false);
    await received();

    await tab.click(along(await panel.reveal('buoyancy'), 0.5));
    await tab.key('Space');
    assert.equal(await paused(), true);
    await tab.key('Space');
    assert.equal(await paused(), false);
    await tab.key('x');
    assert.deepEqual(await received(), ['x']);
    // A button that has the focus is what space presses.
    await tab.page.focus(panel.find(actionOf('reset')));
    await tab.key('Space');
    assert.equal(await paused(), false);
    assert.deepEqual(await received(), [' ']);

    await tab.page.focus(panel.find(controlOf('buoyancy')));
    await tab.key('h');
    assert.equal((await layout(panel)).panel.height, 0);
    await tab.key('h');
    assert.ok((await layout(panel)).panel.height > 100);
    await tab.key('?');
    await panel.until('the keys are listed', (root) => root.querySelector('[data-card="help"] kbd'));
    await tab.key('Escape');
    assert.equal(await panel.in((root) => root.querySelector('.hearth-card')), null);
    assert.deepEqual(await received(), []);
  });
});

describe('on a page', () => {
  test('two panels move each its own fire and undo each its own steps', async () => {
    const fire = `<hearth-fire controls particles="1000" ${sized(340, 420)}></hearth-fire>`;
    const tab = await browser.show(`<div style="display: flex; gap: 10px">${fire}${fire}</div>`, {
      width: 720,
      height: 440,
    });
    const values = () =>
      tab.evaluate(() =>
        [...document.querySelectorAll('hearth-fire')].map((fire) => /** @type {any} */ (fire).params.buoyancy),
      );
    await tab.until('both panels', () =>
      [...document.querySelectorAll('hearth-fire')].every((fire) =>
        fire.shadowRoot?.querySelector('[data-action="pause"][data-rect]'),
      ),
    );
    await tab.evaluate((control) => {
      const fires = /** @type {any} */ (document.querySelectorAll('hearth-fire'));
      fires[1].shadowRoot.querySelector(control).focus();
    }, controlOf('buoyancy'));
    await tab.key('ArrowRight');
    await tab.until(
      'the second fire alone has another value',
      (old) => {
        const [first, second] = [...document.querySelectorAll('hearth-fire')].map(
          (fire) => /** @type {any} */ (fire).params.buoyancy,
        );
        return first === old && second !== old;
      },
      DEFAULTS.buoyancy,
    );
    const undo = (at) =>
      tab.evaluate(
        (which) =>
          /** @type {any} */ (document.querySelectorAll('hearth-fire')[which].shadowRoot)
            .querySelector('[data-action="undo"]')
            .click(),
        at,
      );
    const [, changed] = await values();
    await undo(0);
    await tab.frames(10);
    assert.deepEqual(await values(), [DEFAULTS.buoyancy, changed]);
    await undo(1);
    await tab.until(
      'it is back',
      (old) => /** @type {any} */ (document.querySelectorAll('hearth-fire')[1]).params.buoyancy === old,
      DEFAULTS.buoyancy,
    );
    assert.deepEqual(tab.problems, []);
  });

  test('leaves nothing behind when it is removed', async () => {
    const tab = await browser.open(`<hearth-fire ${sized(400, 500)}></hearth-fire>`, {
      width: 420,
      height: 520,
      before: countListeners,
    });
    await tab.ready();
    await tab.burnt(0.5);
    const left = async () => ({
      contexts: (await tab.living()).contexts,
      listeners: await tab.evaluate(() => /** @type {any} */ (window).listeners()),
      inside: await tab.fire((fire) => fire.shadowRoot.querySelectorAll('*').length),
      styles: await tab.evaluate(() => document.head.querySelectorAll('link').length),
    });
    const first = await left();
    const same = () =>
      eventually(
        `as before: ${JSON.stringify(first)}`,
        left,
        (now) => isDeepStrictEqual(now, first),
        () => tab.frames(1),
      );
    for (let round = 0; round < 3; round += 1) {
      await tab.fire((fire) => fire.toggleAttribute('controls', true));
      await new Panel(tab, { inside: true }).mounted();
      assert.ok((await left()).listeners > first.listeners);
      await tab.fire((fire) => fire.toggleAttribute('controls', false));
      await same();
    }
    // And where it goes before it has come.
    await tab.fire(async (fire) => {
      for (let round = 0; round < 4; round += 1) {
        fire.toggleAttribute('controls');
        await new Promise((resolve) => {
          setTimeout(resolve, 30 * round);
        });
      }
    });
    await tab.frames(60);
    await same();
    assert.deepEqual(tab.problems, []);
  });

  test('works with a strict policy for scripts and styles', async () => {
    const policy =
      "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'; " +
      "connect-src 'self'; style-src 'self'; img-src 'self' data: blob:";
    const tab = await browser.open(`<hearth-fire width="400"></hearth-fire>`, {
      width: 500,
      height: 700,
      headers: { 'content-security-policy': policy },
      before: () => {
        const violations = [];
        /** @type {any} */ (window).violations = violations;
        document.addEventListener('securitypolicyviolation', (event) =>
          violations.push(`${event.violatedDirective} ${event.sourceFile} ${event.sample}`),
        );
      },
    });
    await tab.ready();
    // The test's own page has styles in it, which the policy forbids.
    await tab.evaluate(() => {
      /** @type {any} */ (window).violations.length = 0;
    });
    await tab.fire((fire) => {
      fire.style.blockSize = '600px';
      fire.toggleAttribute('controls', true);
    });
    const panel = await new Panel(tab, { inside: true }).mounted();
    const { panel: sheet } = await layout(panel);
    assert.ok(Math.abs(sheet.height - 270) < 1, `the sheet is ${sheet.height} high`);
    await panel.dragSlider('buoyancy', 0.2, 0.8);
    await panel.value('buoyancy', 'another', (value) => value !== DEFAULTS.buoyancy);
    await panel.share('paste');
    await tab.frames(6);
    assert.deepEqual(await tab.evaluate(() => /** @type {any} */ (window).violations), []);
  });
});

/** Runs in the page: `listeners()` is how many listeners window, document and fires have. */
function countListeners() {
  const kept = new Set();
  const number = new WeakMap();
  let next = 0;
  const of = (object) => {
    if (!number.has(object)) number.set(object, (next += 1));
    return number.get(object);
  };
  const watched = (target) => target === window || target === document || target?.tagName === 'HEARTH-FIRE';
  const key = (target, name, listener, options) =>
    `${of(target)} ${name} ${of(listener)} ${typeof options === 'object' ? Boolean(options?.capture) : Boolean(options)}`;
  const { addEventListener, removeEventListener } = EventTarget.prototype;
  EventTarget.prototype.addEventListener = function add(name, listener, options) {
    const once = typeof options === 'object' && options?.once;
    if (listener && !once && watched(this ?? window)) {
      const listening = key(this ?? window, name, listener, options);
      kept.add(listening);
      if (typeof options === 'object') options?.signal?.addEventListener('abort', () => kept.delete(listening));
    }
    return addEventListener.call(this, name, listener, options);
  };
  EventTarget.prototype.removeEventListener = function remove(name, listener, options) {
    if (listener && watched(this ?? window)) kept.delete(key(this ?? window, name, listener, options));
    return removeEventListener.call(this, name, listener, options);
  };
  /** @type {any} */ (window).listeners = () => kept.size;
}
