/**
 * Engines that end, hang, or lose their graphics for good: another engine continues the fire
 * without a visitor's help, and no promise stays pending.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser, except } from '../driver.mjs';
import { assertBurns, events, recording } from '../assertions.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

const FIRE = '<hearth-fire style="width: 240px; height: 300px"><p slot="poster">A poster</p></hearth-fire>';
const BODY = `${recording(FIRE)}<script>
  window.restored = 0;
  document.querySelector('hearth-fire').addEventListener('restored', () => (window.restored += 1));
</script>`;

/**
 * Runs in the page before its scripts: the seconds of its time limits pass when a test calls
 * `count(seconds)`, however long that really takes.
 */
function countManually() {
  const scope = /** @type {any} */ (window);
  const { setInterval, clearInterval, setTimeout } = window;
  let now = 0;
  const counts = new Set();
  scope.setInterval = (act, time, ...rest) => {
    if (time !== 1000) return setInterval(act, time, ...rest);
    counts.add(act);
    return act;
  };
  // A worker is pinged more often.
  scope.setTimeout = (act, time, ...rest) => setTimeout(act, time === 2000 ? 20 : time, ...rest);
  scope.clearInterval = (timer) => counts.delete(timer) || clearInterval(timer);
  performance.now = () => now;
  scope.counting = () => counts.size > 0;
  scope.count = (seconds) => {
    for (; seconds > 0; seconds -= 1) {
      now += 1000;
      for (const act of [...counts]) act();
    }
  };
}

/** Runs in the worker: a call of `reset` ends it, a call of `sparks` hangs it. */
function mortal() {
  addEventListener('message', (event) => {
    if (event.data[2] === 'reset') {
      event.stopImmediatePropagation();
      globalThis.close();
    }
    if (event.data[2] === 'sparks') for (;;);
  });
}

/** Lets time limits pass until that many errors are reported: the next question to a worker takes a while. */
const reported = (tab, number) =>
  tab.until(
    `${number} errors are reported`,
    (wanted) => {
      const scope = /** @type {any} */ (window);
      const enough = () => scope.events.filter(({ type }) => type === 'error').length >= wanted;
      if (!enough()) scope.count(1);
      return enough();
    },
    number,
  );
const count = (tab, seconds) => tab.evaluate((time) => /** @type {any} */ (window).count(time), seconds);

/** Waits until the page has heard of `number` restorations, and asserts that it heard of no failure. */
async function assertReturns(tab, number = 1) {
  await tab.until('the fire is back', (wanted) => /** @type {any} */ (window).restored >= wanted, number);
  const kinds = (await events(tab, 'error')).map(({ kind }) => kind);
  assert.deepEqual(kinds, Array(number).fill('stopped'));
  assert.equal((await events(tab, 'ready')).length, 1);
  await tab.ready();
  await assertBurns(tab);
}

const HELD = except({ webkit: 'its engine runs on the page’s thread, whose clock these tests hold' });

for (const [what, call] of /** @type {[string, 'reset' | 'sparks'][]} */ ([
  ['ends', 'reset'],
  ['hangs', 'sparks'],
])) {
  test(`an engine that ${what} is followed by another, which continues the fire`, HELD, async () => {
    const tab = await browser.open(BODY, { before: countManually, beforeWorker: mortal });
    await tab.burnt(0.5);
    await tab.fire((fire) => fire.set({ exposure: 0.7, seed: 4 }));
    const before = await tab.fire((fire) => fire.params);
    await tab.fire((fire, method) => {
      const { shadowRoot } = fire;
      Object.assign(window, {
        answers: [fire[method](0, 1), fire.step(3)].map((answer) =>
          answer.then(
            () => 'done',
            ({ kind }) => kind,
          ),
        ),
      });
      return shadowRoot.querySelector('canvas').width;
    }, call);
    await reported(tab, 1);
    // Nothing that was asked of the old engine stays pending.
    assert.deepEqual(await tab.evaluate(() => Promise.all(/** @type {any} */ (window).answers)), [
      'stopped',
      'stopped',
    ]);
    await assertReturns(tab);
    assert.deepEqual(await tab.fire((fire) => fire.params), before);
    const [error] = await events(tab, 'error');
    assert.match(error.message, /engine has stopped: it has not answered for 10 seconds/);
    assert.equal((await tab.living()).workers, 1);
    assert.equal(error.version, await tab.fire((fire) => fire.constructor.version));
    assert.equal(error.seed, 4);
    const same = await browser.open(`index.html${error.settings}`);
    await same.ready();
    assert.deepEqual(await same.fire((fire) => fire.params), before);
  });
}

test('the picture of a stopped fire stays until the next one', HELD, async () => {
  const tab = await browser.open(BODY, { before: countManually, beforeWorker: mortal });
  await tab.burnt(0.5);
  await tab.fire((fire) => void fire.reset());
  const shown = await tab.fire(async (fire) => {
    let shown = true;
    const look = () => {
      shown &&= fire.shadowRoot.querySelector('.root').matches('[data-state=shown][data-drawn]');
      requestAnimationFrame(look);
    };
    look();
    while (/** @type {any} */ (window).restored === 0) {
      if (/** @type {any} */ (window).events.at(-1).type !== 'error') /** @type {any} */ (window).count(1);
      await new Promise(requestAnimationFrame);
    }
    return shown;
  });
  assert.ok(shown);
});

test('an engine that answers each question after nine seconds goes on', HELD, async () => {
  const tab = await browser.open(BODY, { before: countManually });
  await tab.burnt(0.2);
  for (let times = 20; times > 0; times -= 1) {
    // No answer arrives meanwhile, because the page's script runs.
    await count(tab, 9);
    // Workers answer in order.
    await tab.fire((fire) => fire.set('exposure', 1));
    await tab.until('the next question', () => /** @type {any} */ (window).counting());
  }
  assert.deepEqual(await events(tab, 'error'), []);
});

test('a worker is asked one question at a time, whatever fires come and go', HELD, async () => {
  const tab = await browser.open(BODY, {
    before: () => {
      const scope = /** @type {any} */ (window);
      const { setTimeout } = window;
      scope.setTimeout = (act, time, ...rest) => setTimeout(act, time === 2000 ? 20 : time, ...rest);
      let unanswered = 0;
      scope.most = scope.questions = 0;
      const heard = new WeakSet();
      const { postMessage } = Worker.prototype;
      Worker.prototype.postMessage = function counted(message, ...rest) {
        if (!heard.has(this)) {
          this.addEventListener('message', ({ data }) => (unanswered -= Number(data.type === 'answer')));
          heard.add(this);
        }
        if (message === 0) {
          unanswered += 1;
          scope.questions += 1;
          scope.most = Math.max(scope.most, unanswered);
        }
        return postMessage.call(this, message, ...rest);
      };
    },
  });
  await tab.burnt(0.2);
  const most = await tab.evaluate(async () => {
    for (let round = 0; round < 10; round += 1) {
      const fires = Array.from({ length: 8 }, () => /** @type {any} */ (document.createElement('hearth-fire')));
      document.body.append(...fires);
      await Promise.all(fires.map((fire) => fire.ready));
      for (const fire of fires) fire.remove();
    }
    const scope = /** @type {any} */ (window);
    const asked = scope.questions;
    while (scope.questions < asked + 5) await new Promise(requestAnimationFrame);
    return scope.most;
  });
  assert.equal(most, 1);
});

test('an engine that stops three times in a minute leaves a poster, words and a button', HELD, async () => {
  const tab = await browser.open(BODY, { before: countManually, beforeWorker: mortal });
  await tab.burnt(0.3);
  for (const times of [1, 2]) {
    await tab.fire((fire) => void fire.reset());
    await reported(tab, times);
    await assertReturns(tab, times);
  }
  await tab.fire((fire) => void fire.reset());
  await reported(tab, 3);
  assert.equal(
    await tab.fire((fire) =>
      fire.ready.then(
        () => '',
        ({ kind }) => kind,
      ),
    ),
    'stopped',
  );
  const seen = await tab.fire((fire) => ({
    words: fire.shadowRoot.querySelector('[role=status]').textContent,
    poster: document.querySelector('[slot=poster]')?.checkVisibility(),
  }));
  assert.match(seen.words, /stopped 3 times in a minute.*not answered/);
  assert.equal(seen.poster, true);
  const { x, y, width, height } = await tab.fire((fire) => {
    const box = fire.shadowRoot.querySelector('[part=retry]').getBoundingClientRect();
    return { x: box.x, y: box.y, width: box.width, height: box.height };
  });
  await tab.click({ x: x + width / 2, y: y + height / 2 });
  await tab.ready();
  await assertBurns(tab);
});

test('a context that never comes back is followed by another', HELD, async () => {
  const tab = await browser.open(BODY, { before: countManually });
  await tab.burnt(0.5);
  await tab.loseContext();
  await tab.until('the loss is reported', () =>
    /** @type {any} */ (window).events.some(({ type }) => type === 'error'),
  );
  await count(tab, 5);
  await tab.until('the fire is back', () => /** @type {any} */ (window).restored === 1);
  const errors = await events(tab, 'error');
  assert.deepEqual(
    errors.map(({ kind }) => kind),
    ['context-lost', 'stopped'],
  );
  assert.match(errors[1].message, /has not restored its graphics context/);
  await assertBurns(tab);
});

test('a fire that is added while the context is lost is ready when it can be seen', HELD, async () => {
  const tab = await browser.open(BODY, { before: countManually });
  await tab.burnt(0.3);
  await tab.loseContext();
  await tab.until('the loss is reported', () =>
    /** @type {any} */ (window).events.some(({ type }) => type === 'error'),
  );
  const [early, late] = await tab.evaluate(async () => {
    const fire = /** @type {any} */ (document.createElement('hearth-fire'));
    fire.style.cssText = 'width: 120px; height: 150px';
    document.body.append(fire);
    const drawn = () => fire.shadowRoot.querySelector('.root').matches('[data-state=shown][data-drawn]');
    const ready = fire.ready.then(drawn);
    await new Promise((resolve) => fire.addEventListener('error', resolve));
    const early = await Promise.race([ready, fire.set('exposure', 0.5).then(() => 'waits')]);
    /** @type {any} */ (window).count(5);
    return [early, await ready];
  });
  assert.equal(early, 'waits');
  assert.equal(late, true);
});

test('a fire out of sight is ready without a picture, and a picture of it is refused', HELD, async () => {
  const tab = await browser.open(`<div style="height: 4000px"></div>${FIRE}`, { before: countManually });
  const [drawn, refused] = await tab.fire(async (fire) => {
    fire.loading = 'eager';
    await fire.ready;
    let waits = true;
    const picture = fire
      .toBlob()
      .then(
        () => 'a picture',
        ({ message }) => message,
      )
      .finally(() => (waits = false));
    while (waits) {
      /** @type {any} */ (window).count(1);
      await new Promise(requestAnimationFrame);
    }
    return [fire.shadowRoot.querySelector('.root').hasAttribute('data-drawn'), await picture];
  });
  assert.equal(drawn, false);
  assert.match(refused, /no frame was drawn in 10 s, because the fire is not visible/);
});

test('a fire of a main thread whose engine throws is continued, and no listener runs in a frame of the engine', async () => {
  const tab = await browser.open(
    `${BODY}<script type="module">
    import { HearthFire } from '/web/hearth-fire.js';
    HearthFire.engine = 'main';
  </script>`,
    {
      before: () => {
        const scope = /** @type {any} */ (window);
        Error.stackTraceLimit = 50;
        scope.stacks = [];
        for (const name of ['ready', 'restored'])
          addEventListener(name, () => scope.stacks.push(new Error().stack), true);
        const { prototype } = WebGL2RenderingContext;
        const original = prototype.drawArraysInstanced;
        prototype.drawArraysInstanced = function drawArraysInstanced(...call) {
          if (scope.defect) {
            scope.defect = false;
            throw new Error('a defect');
          }
          return original.apply(this, call);
        };
      },
    },
  );
  await tab.burnt(0.3);
  await tab.evaluate(() => void Object.assign(window, { defect: true }));
  await tab.until('the fire is back', () => /** @type {any} */ (window).restored === 1);
  assert.match((await events(tab, 'error'))[0].message, /engine has stopped: .*a defect/);
  const stacks = await tab.evaluate(() => /** @type {any} */ (window).stacks);
  assert.equal(stacks.length, 2);
  // Firefox names the callers of an earlier task, too, after a star.
  for (const stack of stacks) assert.doesNotMatch(stack.split('*')[0], /wasm-function/);
  await assertBurns(tab);
});
