/**
 * `to`: transitions of values, and what interrupts them. Tests control the clock of the
 * page's animations.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { events, recording } from '../assertions.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

const FIRE = '<hearth-fire paused quality="low" style="width: 40px; height: 50px"></hearth-fire>';

/**
 * A fire whose page's animations stand at the share of their time that `clock(share)` sets.
 * @param {string} [html]
 */
async function open(html = FIRE) {
  const tab = await browser.show(`<script>
    if (!window.clock) {
      const moves = (window.moves = new Set());
      let share = 0;
      const { play, cancel } = Animation.prototype;
      Animation.prototype.play = function () {
        play.call(this);
        this.pause();
        moves.add(this);
        this.currentTime = share * this.effect.getTiming().duration;
      };
      Animation.prototype.cancel = function () { moves.delete(this); cancel.call(this); };
      window.clock = (now) => {
        share = now;
        for (const move of moves) move.currentTime = now * move.effect.getTiming().duration;
      };
    }
    window.ended = {};
    window.moves.clear();
    window.clock(0);
  </script>${recording(html)}`);
  await tab.ready();
  return tab;
}

/** Puts the clock, and waits until the fire has these values, or nearly. */
async function at(tab, share, wanted) {
  await tab.evaluate((now) => /** @type {any} */ (window).clock(now), share);
  await tab.until(
    `${JSON.stringify(wanted)} at ${share}`,
    (values) => {
      const { params } = /** @type {any} */ (document.querySelector('hearth-fire'));
      return Object.entries(values).every(([id, value]) =>
        typeof value === 'number'
          ? Math.abs(params[id] - value) < 1e-4 * Math.max(1, Math.abs(value))
          : params[id] === value,
      );
    },
    wanted,
  );
}

/** Begins, and keeps what becomes of it in `window.ended` by name. */
function begin(tab, name, values, how) {
  return tab.fire(
    (fire, key, to, options) => {
      const page = /** @type {any} */ (window);
      page.ended ??= {};
      const ended = page.ended;
      fire.to(to, options).then(
        (whole) => (ended[key] = whole),
        (error) => (ended[key] = [error.name, error.id, error.value]),
      );
    },
    name,
    values,
    how,
  );
}

/** What has become of it. */
function end(tab, name) {
  return tab
    .until(
      `${name} ends`,
      (key) => {
        const { ended } = /** @type {any} */ (window);
        return key in ended && [ended[key]];
      },
      name,
    )
    .then(([value]) => value);
}

test('numbers go evenly, or by equal ratios, and arrive exactly', async () => {
  const tab = await open();
  await tab.fire((fire) => fire.set({ wind: -1, time_scale: 0.25 }));
  await begin(tab, 'one', { wind: 1, time_scale: 1, exposure: '0.3' }, { duration: 1000, easing: 'linear' });
  await at(tab, 0.25, { wind: -0.5, time_scale: 0.25 * 4 ** 0.25, exposure: 0.075 });
  await at(tab, 0.5, { wind: 0, time_scale: 0.5, exposure: 0.15 });
  await at(tab, 1, { wind: 1, time_scale: 1, exposure: 0.3 });
  assert.equal(await end(tab, 'one'), true);
  assert.deepEqual((await tab.fire((fire) => fire.exportConfig())).values, { wind: 1, exposure: 0.3 });
  const changes = await events(tab, 'params-change');
  assert.ok(changes.filter(({ source }) => source === 'to').length >= 9);
  assert.equal(await tab.evaluate(() => /** @type {any} */ (window).moves.size), 0);
  assert.deepEqual(tab.problems, []);
});

test('an easing of CSS bends the way, 600 ms of ease-in-out without one', async () => {
  const tab = await open();
  await begin(tab, 'one', { wind: 1 }, { duration: 100, easing: 'cubic-bezier(0, 0, 0, 1)' });
  const eased = await tab.evaluate(() => {
    const effect = new KeyframeEffect(null, null, { duration: 100, easing: 'cubic-bezier(0, 0, 0, 1)', fill: 'both' });
    const animation = new Animation(effect);
    animation.currentTime = 50;
    return effect.getComputedTiming().progress;
  });
  await at(tab, 0.5, { wind: eased });
  assert.ok(eased > 0.6);
  await at(tab, 1, { wind: 1 });
  await tab.evaluate(() => /** @type {any} */ (window).clock(0));
  await begin(tab, 'two', { exposure: 1 });
  await at(tab, 0.5, { exposure: 0.5 });
  const timing = await tab.evaluate(() => {
    const all = [];
    for (const animation of /** @type {any} */ (window).moves) all.push(animation.effect.getTiming());
    return all.map(({ duration, easing }) => [duration, easing]);
  });
  assert.deepEqual(timing, [[600, 'ease-in-out']]);
  // One that goes beyond its ends keeps to the values that are allowed.
  await tab.evaluate(() => /** @type {any} */ (window).clock(1));
  assert.equal(await end(tab, 'two'), true);
  await tab.evaluate(() => /** @type {any} */ (window).clock(0));
  await begin(tab, 'three', { smoke_opacity: 2 }, { easing: 'cubic-bezier(0.5, 0, 0.5, 3)' });
  await at(tab, 0.6, { smoke_opacity: 2 });
  await tab.evaluate(() => /** @type {any} */ (window).clock(1));
  assert.equal(await end(tab, 'three'), true);
  assert.deepEqual(tab.problems, []);
});

test('colours are interpolated, and choices change at once', async () => {
  const tab = await open();
  await tab.fire((fire) => fire.set({ background: '#000000', hot_colour: '#ff0000' }));
  await begin(
    tab,
    'one',
    { background: 'white', hot_colour: 'blue', palette: 'custom', printed_kernel: true, seed: 7 },
    { easing: 'linear' },
  );
  await at(tab, 0, { palette: 'custom', printed_kernel: true, seed: 7, background: '#000000' });
  await tab.evaluate(() => /** @type {any} */ (window).clock(0.5));
  const between = await tab.until('a grey', () => {
    const { params } = /** @type {any} */ (document.querySelector('hearth-fire'));
    return params.background !== '#000000' && [params.background, params.hot_colour];
  });
  // The middle of OkLab: a grey of 0.5, which is darker than half of sRGB, and a bright violet.
  assert.match(between[0], /^#(6[0-9a-f])\1\1$/);
  const [red, , blue] = between[1].match(/\w\w/g).map((hex) => parseInt(hex, 16));
  assert.ok(red > 110 && blue > 110, between[1]);
  await at(tab, 1, { background: '#ffffff', hot_colour: '#0000ff' });
  assert.equal(await end(tab, 'one'), true);
  assert.deepEqual(tab.problems, []);
});

test('another model is set at once, and its values move from its current ones', async () => {
  const tab = await open();
  await begin(tab, 'one', { model: 'classic', viscosity: 0.05 }, { easing: 'linear' });
  await at(tab, 0, { model: 'classic', viscosity: 0.005 });
  await at(tab, 0.5, { viscosity: 0.0275 });
  await at(tab, 1, { viscosity: 0.05 });
  assert.equal(await end(tab, 'one'), true);
});

test('setting a value ends its transition, and the others continue', async () => {
  const tab = await open();
  await begin(tab, 'one', { wind: 1, exposure: 1 }, { easing: 'linear' });
  await at(tab, 0.5, { wind: 0.5, exposure: 0.5 });
  await tab.fire((fire) => fire.set('wind', -1));
  await at(tab, 0.75, { wind: -1, exposure: 0.75 });
  await at(tab, 1, { wind: -1, exposure: 1 });
  assert.equal(await end(tab, 'one'), false);
  // A younger one goes on from where it is; the older one has lost.
  await tab.evaluate(() => /** @type {any} */ (window).clock(0));
  await begin(tab, 'two', { wind: 1 }, { easing: 'linear' });
  await at(tab, 0.5, { wind: 0 });
  await tab.evaluate(() => /** @type {any} */ (window).clock(0));
  await at(tab, 0, { wind: -1 });
  await begin(tab, 'three', { wind: -2 }, { easing: 'linear' });
  assert.equal(await end(tab, 'two'), false);
  await at(tab, 0.5, { wind: -1.5 });
  // What is refused takes nothing over.
  await tab.fire((fire) => fire.set('wind', 'much').catch(() => {}));
  await at(tab, 0.75, { wind: -1.75 });
  await tab.fire((fire) => fire.restore('wind'));
  assert.equal(await end(tab, 'three'), false);
  assert.equal(await tab.fire((fire) => fire.wind), 0);
  // One that is set at once after it was asked to move is later, too.
  await tab.evaluate(() => /** @type {any} */ (window).clock(0.5));
  await tab.fire((fire) => {
    const ended = /** @type {any} */ (window).ended;
    fire.to({ wind: 1, exposure: 0 }, { easing: 'linear' }).then((whole) => (ended.four = whole));
    return fire.set('wind', -0.5);
  });
  await at(tab, 0.5, { wind: -0.5, exposure: 0.5 });
  await tab.fire((fire) => fire.importConfig({ hearth: 2, values: { exposure: 2 } }));
  assert.equal(await end(tab, 'four'), false);
  assert.equal(await tab.fire((fire) => fire.exposure), 2);
});

test('undo ends the transitions of the values that it changes, and the others continue', async () => {
  const tab = await open();
  await begin(tab, 'page', { exposure: 1 }, { easing: 'linear' });
  await tab.fire((fire) => {
    const { ended } = /** @type {any} */ (window);
    fire.history.step(() => fire.to({ wind: 1 }, { easing: 'linear' })).then((whole) => (ended.step = whole));
  });
  await at(tab, 0.5, { wind: 0.5, exposure: 0.5 });
  await tab.fire((fire) => fire.history.undo());
  await at(tab, 0.75, { wind: 0, exposure: 0.75 });
  assert.equal(await end(tab, 'step'), false);
  await at(tab, 1, { wind: 0, exposure: 1 });
  assert.equal(await end(tab, 'page'), true);
  assert.deepEqual(await tab.fire(({ history }) => [history.canUndo, history.canRedo]), [false, true]);
});

test('values arrive at once while the fire is out of sight', async () => {
  const tab = await open();
  await begin(tab, 'gone', { wind: 1 }, { easing: 'linear' });
  await at(tab, 0.25, { wind: 0.25 });
  await tab.fire((fire) => {
    /** @type {any} */ (window).kept = fire;
    fire.remove();
  });
  assert.equal(await end(tab, 'gone'), true);
  const back = await tab.evaluate(async () => {
    const { kept } = /** @type {any} */ (window);
    document.body.append(kept);
    await kept.ready;
    return kept.wind;
  });
  assert.equal(back, 1);

  await begin(tab, 'hidden', { wind: 2 }, { easing: 'linear' });
  await at(tab, 0.25, { wind: 1.25 });
  await tab.evaluate(() => {
    Object.defineProperty(document, 'hidden', { configurable: true, get: () => true });
    document.dispatchEvent(new Event('visibilitychange'));
  });
  assert.equal(await end(tab, 'hidden'), true);
  assert.equal(await tab.fire((fire) => fire.wind), 2);

  const calm = await browser.open(FIRE, { reducedMotion: true });
  await calm.ready();
  const whole = await calm.fire((fire) => fire.to({ wind: 1 }, { duration: 1e9 }));
  assert.deepEqual([whole, await calm.fire((fire) => fire.wind)], [true, 1]);
  assert.deepEqual(await calm.problemsAfterFrame(), []);
});

test('a transition that is requested before the fire is ready starts with it, by the real clock', async () => {
  const tab = await browser.show('<p></p>');
  const found = await tab.evaluate(async () => {
    await import('./web/hearth-fire.js');
    const fire = /** @type {any} */ (document.createElement('hearth-fire'));
    fire.style.cssText = 'width: 40px; height: 50px';
    fire.setAttribute('paused', '');
    const values = [];
    fire.addEventListener('params-change', ({ detail }) => values.push(detail.value));
    const done = fire.to({ wind: 1 }, { duration: 200 });
    document.body.append(fire);
    return [await done, fire.wind, values.every((value, index) => index === 0 || value > values[index - 1])];
  });
  assert.deepEqual(found, [true, 1, true]);
  assert.deepEqual(await tab.problemsAfterFrame(), []);
});
