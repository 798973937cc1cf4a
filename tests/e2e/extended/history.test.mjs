/**
 * What is set is one value: whoever changes it, in whatever order, the engine, the element and the panel have the same.
 * Undo leads back to the first value exactly, and what the page states stays. A fire that is removed and inserted again,
 * or whose engine stops, goes on with the same settings.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { STAGE, installActors, stopAtSparks } from '../actors.mjs';
import { simulateClock } from '../clock.mjs';
import { BROWSER, Browser, STOPPED } from '../driver.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

/** The rules are of Rust and of scripts: of another browser fewer sequences show that its parts are connected. */
const SEQUENCES = BROWSER === 'chromium' ? 200 : 40;

/** How many sequences with a failure are reported. */
const REPORTED = 3;

/**
 * Runs in the page: the random sequence of a seed. Returns what was done and how it differs from the law, if it does.
 * @param {number} seed
 */
async function sequence(seed) {
  const { actions, added, controls, editing, fire, frames, listed, log, newChild, other, pick, press, ...more } =
    /** @type {any} */ (window).actors;
  const { OWN, random, restart, shown, sow } = more;
  // The order of fields is no difference.
  const sorted = (/** @type {string} */ _, /** @type {any} */ value) =>
    value?.constructor === Object ? Object.fromEntries(Object.entries(value).sort()) : value;
  const text = (/** @type {unknown} */ value) => JSON.stringify(value, sorted);
  const whole = () => text(fire.history.settings);
  /** Waits until the fire has answered what was asked of it, and what followed from the answers. */
  const settle = async () => {
    for (let round = 0; round < 4; round += 1) {
      await frames();
      await fire.exportConfig();
    }
  };
  /** @type {unknown[]} */
  const failures = [];
  const check = (/** @type {string} */ what, /** @type {unknown} */ value, /** @type {unknown} */ wanted) => {
    if (text(value) !== text(wanted)) failures.push({ what, value, wanted });
  };

  /** The engine, the element and the panel have the same value. @param {any} before  Values before an action. */
  const checkEqual = async (before) => {
    // The other fire has what the engine exports.
    await other.importConfig(await fire.exportConfig());
    check('the preset', fire.preset, other.preset);
    check('the values', fire.params, other.params);
    check('the objects', fire.objects, other.objects);
    const ids = fire.objects.map(({ id }) => id);
    const options = [...document.querySelectorAll('#host [data-action="select-object"] option')].slice(1);
    check(
      'the list of accessible controls',
      options.map(({ value }) => Number(value)),
      ids,
    );
    for (const [name, can] of Object.entries({ undo: fire.history.canUndo, redo: fire.history.canRedo })) {
      for (const button of document.querySelectorAll(`#host [data-action="${name}"], #tools [data-tool="${name}"]`))
        check(`the button ${name}`, button.getAttribute('aria-disabled') !== 'true', can);
    }
    const rows = [...controls('parameter'), ...controls('property')].map((control) => {
      const { parameter, property } = control.dataset;
      const value = property ? editing.selected[property.split(':')[1]] : fire.params[parameter];
      return { id: parameter ?? property, value, control };
    });
    for (const { id, value, control } of rows)
      check(
        `the accessible ${id}`,
        String(control.type === 'checkbox' ? control.checked : control.value),
        String(value),
      );
    // The panel's copy in wasm shows its objects, and a value for each row under a pointer. The model has no row.
    if (random(2) === 0) return check('the list of the panel', await listed(), ids);
    const [, ...others] = rows;
    const changed = others.filter(({ id, value }) => value !== before[id.split(':').pop()]);
    const { id, value, control } = pick(changed.length > 0 ? changed : others);
    const seen = await shown(id, control.labels[0].textContent);
    check(`the panel's ${id}`, typeof value === 'number' ? String(Number(seen)) : seen, String(value));
  };

  /** What the page states: values of its own, attributes of children, and objects that it has added. */
  const known = /** @type {Element[]} */ ([]);
  const stated = () => {
    const facts = new Map(OWN.map((id) => [id, fire.params[id]]));
    for (const child of fire.children) {
      if (!known.includes(child)) known.push(child);
      const object = fire.objects.find(({ id }) => id === child.objectId);
      // A call may have set another value, or have removed the object.
      for (const { name, value } of child.attributes)
        if (String(object?.[name]) === value) facts.set(`${name} of child ${known.indexOf(child)}`, value);
    }
    for (const id of added) {
      const object = fire.objects.find((present) => present.id === id);
      if (object) facts.set(`added object ${id}`, `${object.kind} at ${object.x}`);
    }
    return facts;
  };
  /** What visitors have replaced of that: an undo may restore it. */
  const replaced = new Set();
  const checkStated = (/** @type {string} */ what, /** @type {Map<string, unknown>} */ facts) => {
    const now = stated();
    for (const [name, value] of facts) if (!replaced.has(name)) check(`${name} after ${what}`, now.get(name), value);
  };
  /** Moves through the whole history. Returns the settings there. */
  const all = async (/** @type {'undo' | 'redo'} */ way) => {
    while (await fire.history[way]());
    await settle();
    return JSON.parse(whole());
  };
  const checkedMove = async (/** @type {'undo' | 'redo'} */ way) => {
    const facts = stated();
    const settings = await all(way);
    checkStated(`${way} of all`, facts);
    return settings;
  };

  sow(seed);
  fire.replaceChildren();
  await settle();
  // The last sequence has left two states to compare.
  const B = { values: { wind: -0.3, bloom: 0.4 }, objects: [{ kind: 'source', x: 0.2 }, { kind: 'solid' }] };
  for (const [letter, config] of Object.entries({ B, A: {} })) {
    await editing.compare(letter);
    await fire.importConfig(config);
  }
  await all('undo');
  editing.letter = 'A';
  // What a fire starts from is no step.
  fire.history.begun = false;
  await fire.importConfig({});
  fire.history.begun = true;
  fire.append(...Array.from({ length: random(3) }, () => newChild()));
  await settle();
  const isPageQuiet = random(3) === 0;
  log.length = added.length = 0;
  log.push(isPageQuiet ? 'the page is quiet' : 'the page acts', fire.innerHTML);
  const first = whole();
  // After a new step there is nothing to redo.
  await fire.history.step(() => fire.set('wind', (1 + random(9)) / 10));
  const visitors = ['panel', 'panel', 'tools', 'steps', 'scenes', 'history'];
  const actors = isPageQuiet ? visitors : [...visitors, 'page', 'page', 'children', 'children', 'children'];
  for (let count = 4 + random(3); count > 0 && failures.length === 0; count -= 1) {
    const actor = random(40) === 0 ? 'restart' : pick(actors);
    const [facts, settings] = [stated(), whole()];
    const values = { ...fire.params, ...editing.selected };
    press();
    const act = Promise.resolve(pick(actions[actor])());
    if (actor !== 'restart' && random(40) === 0) {
      await frames(random(5));
      await restart();
    }
    await act.catch(({ message }) => log.push(`  refused: ${message}`));
    await settle();
    if (actor === 'restart') check('the settings after a restart', fire.history.settings, JSON.parse(settings));
    if (actor === 'history' || actor === 'restart') checkStated(actor, facts);
    if (['panel', 'tools', 'steps', 'scenes'].includes(actor)) {
      const now = stated();
      for (const [name, value] of facts) if (now.get(name) !== value) replaced.add(name);
    }
    await checkEqual(values);
  }
  const [last, begin] = [await checkedMove('redo'), await checkedMove('undo')];
  if (isPageQuiet) check('the settings after undo of all', begin, JSON.parse(first));
  await checkEqual({});
  // Redo does again what a step did, although the page may have undone a part of it since.
  const done = await all('redo');
  if (isPageQuiet) check('the settings after redo of all', done, last);
  check('the settings after undo of all again', await all('undo'), begin);
  check('the settings after redo of all again', await all('redo'), done);
  return { seed, log: [...log], failures };
}

test('engine, element and panel have one value, and undo leads back exactly', async () => {
  const options = { width: 680, height: 800, before: simulateClock, beforeWorker: stopAtSparks };
  const tab = await browser.open(STAGE, options);
  await tab.evaluate(installActors);
  const failed = [];
  for (let seed = 1; seed <= SEQUENCES && failed.length < REPORTED; seed += 1) {
    const done = await tab.evaluate(sequence, seed);
    const problems = tab.problems.splice(0).filter((problem) => !/is refused|a test stops it/.test(problem));
    if (done.failures.length + problems.length > 0) failed.push({ ...done, problems });
  }
  assert.ok(failed.length === 0, JSON.stringify(failed, null, 1));
});

/** Runs in the worker of the engine: once sparks are thrown, the next undo or redo stops it. */
function stopAtUndo() {
  let isArmed = false;
  addEventListener('message', (event) => {
    isArmed ||= event.data[2] === 'sparks';
    if (!isArmed || event.data[2] !== 'restore') return;
    event.stopImmediatePropagation();
    postMessage({ type: 'stopped', why: 'a test stops it' });
    globalThis.close();
  });
}

test('an undo and a redo that an engine does not survive can be repeated', STOPPED, async () => {
  const tab = await browser.open('<hearth-fire paused></hearth-fire>', { beforeWorker: stopAtUndo });
  await tab.ready();
  const seen = await tab.fire(async (fire) => {
    await fire.history.step(() => fire.set('wind', 0.5));
    const seen = [];
    for (const way of ['undo', 'redo']) {
      const restored = new Promise((resolve) => fire.addEventListener('restored', resolve, { once: true }));
      await fire.sparks(0, 1);
      const refused = await fire.history[way]().catch(({ kind }) => kind);
      if (refused === 'stopped') await restored;
      seen.push([refused, await fire.history[way](), fire.params.wind]);
    }
    return seen;
  });
  assert.deepEqual(seen, [
    ['stopped', true, 0],
    ['stopped', true, 0.5],
  ]);
});

/**
 * Runs in the page: steps of a seed, most of them scenes, then undo and redo of all. Returns where a picture is not that
 * of before.
 * @param {number} seed
 */
async function pictures(seed) {
  const fire = /** @type {any} */ (document.querySelector('hearth-fire'));
  let state = seed * 7919 + 17;
  const random = (/** @type {number} */ below) => {
    state = (state * 16807) % 2147483647;
    return state % below;
  };
  const scene = () => ['candle', 'campfire', 'torch', 'fireplace', 'gas-burner'][random(5)];
  const drag = () => {
    const { left, top } = fire.getBoundingClientRect();
    const { x, y } = fire.toPixels(fire.params.source_x, fire.params.source_height);
    const points = [0, 20, 20 + random(40)].map((aside) => ({ clientX: left + x + aside, clientY: top + y }));
    ['pointerdown', 'pointermove', 'pointermove', 'pointerup'].forEach((name, at) => {
      const point = points[Math.min(at, 2)];
      fire.dispatchEvent(new PointerEvent(name, { ...point, button: 0, buttons: 1, pointerId: 7, bubbles: true }));
    });
  };
  const acts = [
    drag,
    drag,
    () => /** @type {HTMLElement} */ (document.querySelector(`#strip [data-starts="${scene()}"]`)).click(),
    () => fire.setAttribute('preset', scene()),
    () => fire.importConfig({ preset: scene(), values: { exposure: 1 } }),
    () => fire.history.step(() => fire.addObject({ kind: 'solid', x: random(9) / 20, y: 0.6 })),
    () => fire.history.step(() => fire.removeObject(fire.objects[random(fire.objects.length)]?.id)),
  ];
  const picture = async () => {
    await fire.exportConfig();
    const bytes = await (await fire.toBlob({ width: 96 })).arrayBuffer();
    return String.fromCharCode(...new Uint8Array(await crypto.subtle.digest('SHA-256', bytes)));
  };
  const shown = [await picture()];
  const log = [];
  for (let count = 0; count < 6; count += 1) {
    const before = JSON.stringify(fire.history.settings);
    const act = acts[random(acts.length)];
    await Promise.resolve(act()).catch(() => {});
    const now = await picture();
    log.push(`${act} ${fire.preset}`);
    if (JSON.stringify(fire.history.settings) !== before) shown.push(now);
  }
  const wrong = [];
  for (const way of /** @type {const} */ (['undo', 'redo'])) {
    for (const wanted of [...shown].reverse().slice(1)) {
      await fire.history[way]();
      if ((await picture()) !== wanted) wrong.push(`${way} to ${fire.preset}`);
    }
    shown.reverse();
  }
  while (await fire.history.undo());
  return wrong.length > 0 && { seed, log, wrong };
}

test('undo and redo of scenes, drags and objects show the pictures of before', async (context) => {
  const drawing = await Browser.launch();
  context.after(() => drawing.close());
  const tab = await drawing.open(`<hearth-fire preset="fireside" paused interactive quality="low"
    style="width: 240px; height: 300px"></hearth-fire><div id="strip"
    style="position: fixed; top: 310px; height: 90px; overflow: auto"></div>`);
  await tab.ready();
  await tab.evaluate(async () => {
    const path = '/web/pages/scenes.js';
    const { showStrip } = await import(path);
    showStrip(document.getElementById('strip'), document.querySelector('hearth-fire'), 'default', console.error);
  });
  const failed = [];
  for (let seed = 1; seed <= 8; seed += 1) failed.push(await tab.evaluate(pictures, seed));
  assert.deepEqual(failed.filter(Boolean), []);
});
