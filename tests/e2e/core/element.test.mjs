/**
 * `<hearth-fire>` in a page: sizes, attributes, properties, presets, events, removal and
 * insertion. What all browsers share is in `browsers.test.mjs`.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { assertBurns, assertStands, events, recording } from '../assertions.mjs';
import { domainOf, table } from '../site.mjs';

const { PARAMETERS, PRESETS, DEFAULTS, defaultsOf } = await table();

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

const FIRE = '<hearth-fire id="fire"></hearth-fire>';

for (const [about, style] of [
  ['of no size', 'width: 0; height: 0'],
  ['that is not displayed', 'display: none'],
]) {
  test(`a fire ${about} breaks nothing and burns once it is shown`, async () => {
    const tab = await browser.show(`<hearth-fire style="${style}"></hearth-fire>`);
    await tab.ready();
    await tab.frames(5);
    await tab.fire((fire) => fire.removeAttribute('style'));
    await tab.burnt(1);
    await assertBurns(tab);
    assert.deepEqual(tab.problems, []);
  });
}

test('a fire longer than any canvas may be burns all the same', async () => {
  const tab = await browser.show('<hearth-fire style="width: 20000px; height: 40px"></hearth-fire>');
  await tab.burnt(0.2);
  assert.deepEqual(tab.problems, []);
});

test('calls to a removed fire take effect when it is inserted again', async () => {
  const tab = await browser.show(FIRE);
  await tab.ready();
  const seen = await tab.fire(async (fire) => {
    const wait = async () => {
      for (let left = 5; left > 0; left -= 1) await new Promise(requestAnimationFrame);
    };
    const { ready: before } = fire;
    fire.remove();
    while (fire.ready === before) await wait();
    let ready = false;
    fire.ready.then(() => (ready = true));
    const set = fire.set('wind', 0.5);
    await wait();
    const early = ready;
    document.body.append(fire);
    await fire.ready;
    await set;
    return { early, wind: fire.params.wind };
  });
  assert.deepEqual(seen, { early: false, wind: 0.5 });
});

/** Delays all messages of a worker by half a second, in their order. */
const beforeWorker = () => {
  const post = globalThis.postMessage.bind(globalThis);
  globalThis.postMessage = (/** @type {any} */ ...message) => void setTimeout(() => post(...message), 500);
};

test('a fire that is removed twice in a row keeps values that were set before', async () => {
  const tab = await browser.open(FIRE, { beforeWorker });
  await tab.ready();
  const wind = await tab.fire(async (fire) => {
    const parent = fire.parentElement;
    const set = fire.set('wind', 0.5);
    for (let round = 0; round < 2; round += 1) {
      fire.remove();
      await undefined;
      parent.append(fire);
      await undefined;
    }
    await set;
    return fire.params.wind;
  });
  assert.equal(wind, 0.5);
  assert.deepEqual(tab.problems, []);
});

test('a fire that is removed and inserted again some tasks later goes on', async () => {
  const tab = await browser.show(FIRE);
  await tab.ready();
  await tab.burnt(0.5);
  for (const pause of ['microtask', 'task', 'frame', 'message', 'fragment', 'twice']) {
    const [same, before, after] = await tab.fire(async (fire, how) => {
      const { ready, parentElement: parent } = fire;
      const { time } = fire.stats;
      fire.remove();
      if (how === 'microtask') await null;
      if (how === 'task') await new Promise((next) => setTimeout(next));
      if (how === 'frame') await new Promise((next) => requestAnimationFrame(() => requestAnimationFrame(next)));
      if (how === 'message')
        await new Promise((next) => {
          const { port1, port2 } = new MessageChannel();
          port1.onmessage = next;
          port2.postMessage(0);
        });
      if (how === 'fragment') new DocumentFragment().append(fire);
      if (how === 'twice') {
        document.head.after(fire);
        fire.remove();
        await null;
      }
      parent.append(fire);
      await fire.step();
      return [fire.ready === ready, time, fire.stats.time];
    }, pause);
    assert.ok(same && after >= before, `${pause}: ${before} s, then ${after} s`);
  }
  assert.deepEqual(tab.problems, []);
});

test('frames of a paused fire stand at exactly the time that a script asks for', async () => {
  const tab = await browser.show('<hearth-fire paused></hearth-fire>');
  await tab.ready();
  const [start, ...times] = await tab.fire(async (fire) => {
    await fire.reset();
    const times = [];
    for (let frame = 0; frame <= 6; frame += 1) {
      await fire.advance(frame === 0 ? 0.01 : 1 / 30);
      times.push(fire.stats.time);
    }
    return times;
  });
  let exact = start;
  for (const time of times) assert.equal(time, (exact += 1 / 30));
  assert.deepEqual(tab.problems, []);
});

test('a fire that is destroyed while it reconnects is destroyed with its predecessor', async () => {
  const tab = await browser.open(FIRE, { beforeWorker });
  await tab.ready();
  const answered = await tab.fire(async (fire) => {
    let answered = false;
    // Its answer comes before the worker frees that fire.
    fire.set('wind', 0.5).then(() => (answered = true));
    fire.remove();
    await undefined;
    document.body.append(fire);
    await fire.destroy();
    return answered;
  });
  assert.equal(answered, true);
  assert.deepEqual(tab.problems, []);
});

test('the drawing follows the size of the element', async () => {
  const tab = await browser.open(FIRE, { ratio: 2 });
  await tab.burnt(0.2);
  for (const [width, height] of [
    [240, 240],
    [400, 120],
    [100, 300],
  ]) {
    await tab.fire(
      (fire, size) => {
        fire.style.cssText = `width: ${size[0]}px; height: ${size[1]}px`;
      },
      [width, height],
    );
    await tab.until(
      `${2 * width} × ${2 * height} pixels`,
      (size) => {
        const canvas = /** @type {any} */ (document.querySelector('hearth-fire')?.shadowRoot?.querySelector('canvas'));
        return canvas.width === 2 * size[0] && canvas.height === 2 * size[1];
      },
      [width, height],
    );
  }
  assert.deepEqual(tab.problems, []);
});

for (const model of ['classic', 'combustion']) {
  test(`in the ${model} model every attribute sets its value, and without it the default is back`, async () => {
    const tab = await browser.show(`<hearth-fire paused model="${model}"></hearth-fire>`);
    await tab.ready();
    // The number of particles follows the spacing.
    const used = PARAMETERS.filter(({ models }) => models.includes(/** @type {any} */ (model)));
    const wanted = used
      .filter(({ id }) => id !== 'model' && id !== 'particles')
      .map((parameter) => anotherValue(parameter, model));
    await tab.fire((fire, changes) => {
      for (const { attribute, value } of changes) fire.setAttribute(attribute, String(value));
    }, wanted);
    await tab.until(
      'every attribute is taken',
      (changes) => {
        const { params } = /** @type {any} */ (document.querySelector('hearth-fire'));
        return changes.every(({ id, value }) => params[id] === value);
      },
      wanted,
    );
    await tab.fire((fire, changes) => {
      for (const { attribute } of changes) fire.removeAttribute(attribute);
    }, wanted);
    await tab.until(
      'every default is back',
      (defaults) => {
        const { params } = /** @type {any} */ (document.querySelector('hearth-fire'));
        return defaults.every(([id, value]) => params[id] === value);
      },
      Object.entries(defaultsOf(model)),
    );
    assert.deepEqual(tab.problems, []);
  });
}

/** An allowed value of a parameter in a model that is not its default there. */
function anotherValue(parameter, model) {
  const { id, attribute, kind } = parameter;
  const domain = domainOf(parameter, model);
  const value = {
    number: () => (domain.default === domain.max ? domain.min : domain.max),
    integer: () => domain.min,
    seed: () => 4_294_967_295,
    choice: () => parameter.choices.find((name) => name !== domain.default),
    flag: () => !domain.default,
    colour: () => '#204060',
  }[kind]();
  return { id, attribute, value };
}

test('a preset brings its values, and the defaults for all others', async () => {
  const tab = await browser.show('<hearth-fire preset="seed"></hearth-fire>');
  await tab.ready();
  const seed = PRESETS.find(({ name }) => name === 'seed').values;
  assert.deepEqual(await tab.fire((fire) => fire.params), { ...defaultsOf(seed.model), ...seed });
  await tab.fire((fire) => fire.setAttribute('viscosity', '0.03'));
  await tab.until(
    'an attribute goes before the preset',
    () => /** @type {any} */ (document.querySelector('hearth-fire')).params.viscosity === 0.03,
  );
  await tab.fire((fire) => fire.removeAttribute('viscosity'));
  await tab.fire((fire) => {
    fire.preset = 'default';
  });
  await tab.until(
    'the defaults',
    (all) => {
      const { params } = /** @type {any} */ (document.querySelector('hearth-fire'));
      return Object.entries(all).every(([id, value]) => params[id] === value);
    },
    DEFAULTS,
  );
});

test('pause and reset are reported by events and statistics', async () => {
  const tab = await browser.show(recording('<hearth-fire model="classic"></hearth-fire>'));
  await tab.burnt(0.3);
  await tab.fire((fire) => fire.pause());
  assert.equal(await tab.fire((fire) => fire.paused), true);
  const stands = await assertStands(tab);
  await tab.fire((fire) => fire.reset());
  await tab.until(
    'the fire starts again',
    (time) => /** @type {any} */ (document.querySelector('hearth-fire')).stats.time < time,
    stands,
  );
  assert.equal((await events(tab, 'pause')).length, 1);
  assert.deepEqual(tab.problems, []);
});

test('with reduced motion a still picture of the fire has a play button', async () => {
  const tab = await browser.open(FIRE, { draws: true, reducedMotion: true });
  await tab.ready();
  await tab.frames(10);
  const still = await tab.firePicture();
  await tab.frames(10);
  assert.equal(still.difference(await tab.firePicture()), 0);
  assert.ok(still.crop(0.3, 0.4, 0.7, 1).glowing() > 0.02, 'the still shows a fire');
  const button = await tab.fire((fire) => {
    const found = [...fire.shadowRoot.querySelectorAll('button')].find((button) => button.checkVisibility());
    const { x, y, width, height } = found.getBoundingClientRect();
    return { x: x + width / 2, y: y + height / 2, label: found.ariaLabel || found.textContent };
  });
  assert.match(button.label, /play/i);
  await tab.click(button);
  await tab.frames(20);
  await assertBurns(tab);
});

test('the accessibility tree has the text alternative', async () => {
  const tab = await browser.show('<hearth-fire alt="A camp fire"></hearth-fire>');
  await tab.ready();
  const client = await tab.page.createCDPSession();
  const tree = await client.send('Accessibility.getFullAXTree');
  assert.match(JSON.stringify(tree), /"A camp fire"/);
});
