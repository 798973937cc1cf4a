/**
 * Settings as data: exported, imported whole or not at all, and read from a file.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { events, recording } from '../assertions.mjs';
import { table } from '../site.mjs';

const { DEFAULTS, PRESETS, defaultsOf } = await table();

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

const JSON_TYPE = 'application/json';
const SEED = { ...defaultsOf('classic'), ...PRESETS.find(({ name }) => name === 'seed').values };

/** The fire's values, its preset and its settings. */
function state(tab) {
  return tab.fire(async (fire) => ({
    params: fire.params,
    preset: fire.preset,
    config: await fire.exportConfig(),
  }));
}

/** The error of settings that the fire refuses; fails if it accepts them. */
function refusal(tab, config) {
  return tab.fire(async (fire, text) => {
    // A function can only be made here.
    const given = text === 'function' ? () => 1 : text;
    try {
      await fire.importConfig(given);
      return null;
    } catch (error) {
      const { name, message, id } = error;
      return { name, message, id };
    }
  }, config);
}

test('one fire imports the export of another, as data or as text', async () => {
  const tab = await browser.show(
    '<hearth-fire paused preset="seed" viscosity="0.02" seed="7"></hearth-fire><hearth-fire paused exposure="2"></hearth-fire>',
  );
  await tab.ready();
  const { exported, asData, asText, preset } = await tab.evaluate(async () => {
    const [first, second] = /** @type {any} */ ([...document.querySelectorAll('hearth-fire')]);
    await second.ready;
    const config = await first.exportConfig();
    await second.importConfig(config);
    const data = second.params;
    await second.restore();
    await second.importConfig(JSON.stringify(config));
    return { exported: first.params, asData: data, asText: second.params, preset: second.preset };
  });
  assert.equal(exported.viscosity, 0.02);
  assert.deepEqual(asData, exported);
  assert.deepEqual(asText, exported);
  assert.equal(preset, 'seed');
});

test('settings that are wrong anywhere are refused whole, by name', async () => {
  const tab = await browser.show(recording('<hearth-fire paused exposure="0.5"></hearth-fire>'));
  await tab.ready();
  const before = await state(tab);
  const deep = `${'['.repeat(5000)}${']'.repeat(5000)}`;
  for (const [config, named] of [
    ['{"values": {', 'JSON'],
    [`{"values": {"exposure": ${deep}}}`, 'exposure'],
    ['{"__proto__": {"exposure": 1}}', '__proto__'],
    ['{"values": {"exposurr": 1}}', 'did you mean "exposure"'],
    ['{"values": {"bloom": 0.1, "exposure": 99}}', 'from -4 to 4'],
    ['function', 'config'],
    [{ values: { exposure: Number.NaN } }, 'exposure'],
  ]) {
    const error = await refusal(tab, config);
    const about = JSON.stringify(config)?.slice(0, 60);
    assert.equal(error?.name, 'RangeError', `${about} is refused`);
    assert.ok(error.message.includes(named), `${about}: ${error.message}`);
  }
  assert.deepEqual(await state(tab), before);
  const errors = await events(tab, 'error');
  assert.ok(errors.every(({ kind, id, message }) => kind === 'bad-parameter' && id !== undefined && message));
  const uncaught = tab.problems.filter((problem) => problem.startsWith('uncaught'));
  assert.deepEqual(uncaught, []);
});

test('a fire starts from a settings file, and attributes override it', async () => {
  const body = JSON.stringify({ hearth: 3, preset: 'seed', values: { viscosity: 0.02 } });
  const files = {
    'mine.json': { body, type: JSON_TYPE },
    'other.json': { body: '{"values": {"bloom": 0.5}}', type: JSON_TYPE },
  };
  const tab = await browser.show('<hearth-fire paused src="/mine.json" exposure="0.5"></hearth-fire>', { files });
  await tab.ready();
  assert.deepEqual((await state(tab)).params, { ...SEED, viscosity: 0.02, exposure: 0.5 });
  await tab.fire((fire) => (fire.src = '/other.json'));
  await tab.until(
    'the other file',
    () => /** @type {any} */ (document.querySelector('hearth-fire')).params.bloom === 0.5,
  );
  const { params, preset } = await state(tab);
  assert.deepEqual({ params, preset }, { params: { ...DEFAULTS, bloom: 0.5 }, preset: 'default' });
});

for (const [what, instead, named] of [
  ['is not there', { status: 404, body: 'no', type: 'text/html' }, '404'],
  ['never comes', { drop: true }, 'mine.json'],
  ['is too long', { body: ' '.repeat(400_001), type: JSON_TYPE }, '400 KB'],
  ['has a bad value', { body: '{"values": {"exposure": 99}}', type: JSON_TYPE }, 'from -4 to 4'],
]) {
  test(`a settings file that ${what} causes an error event, and the fire burns`, async () => {
    const tab = await browser.show(recording('<hearth-fire src="/mine.json"></hearth-fire>'), {
      files: { 'mine.json': instead },
    });
    await tab.burnt(0.3);
    assert.deepEqual((await state(tab)).params, DEFAULTS);
    const errors = await events(tab, 'error');
    assert.equal(errors.length, 1);
    assert.ok(errors[0].message.includes(named), errors[0].message);
    assert.deepEqual(
      tab.problems.filter((problem) => problem.startsWith('uncaught')),
      [],
    );
  });
}

test('a fire that is removed while its file loads starts from it when it is inserted again', async () => {
  const body = JSON.stringify({ values: { model: 'classic', viscosity: 0.02 } });
  const tab = await browser.show('<p>Nothing yet</p>', {
    files: {
      'mine.json': { body, type: JSON_TYPE },
      'other.json': { body: '{"values": {"bloom": 0.5}}', type: JSON_TYPE },
    },
  });
  const params = await tab.evaluate(async () => {
    const make = () => {
      const fire = /** @type {any} */ (document.createElement('hearth-fire'));
      fire.src = '/mine.json';
      fire.paused = true;
      document.body.append(fire);
      return fire;
    };
    const wait = (time) => new Promise((resolve) => setTimeout(resolve, time));
    const gone = make();
    // Between two turns of the page, wherever its start has come to.
    for (let round = 0; round < 20; round += 1) {
      await wait(round);
      gone.remove();
      await wait(0);
      document.body.append(gone);
    }
    await gone.ready;
    const renamed = make();
    await wait(2);
    renamed.src = '/other.json';
    await renamed.ready;
    for (let left = 5; left > 0; left -= 1) await new Promise(requestAnimationFrame);
    return [gone.params, renamed.params];
  });
  assert.deepEqual(params[0], { ...defaultsOf('classic'), viscosity: 0.02 });
  assert.equal(params[1].bloom, 0.5);
  assert.equal(params[1].model, DEFAULTS.model);
});
