/**
 * Values that a page should not pass: none throws, each is refused in short words, and the fire
 * stays as it is.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { answers, assertRefused, hostileValues } from '../../hostile.mjs';
import { Browser } from '../driver.mjs';
import { assertBurns, events, recording } from '../assertions.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

const FIRE = '<hearth-fire quality="low" style="width: 60px; height: 80px"></hearth-fire>';

/** What a number out of a small range may be. */
const FEW = ['undefined', '-0', '-1', '1.5'];
const FIELDS = ['{}', 'an object without a prototype', 'a date', 'a throwing iterator'];

/**
 * Each argument of each method: its call with `value`, what names it in a refusal, and what it takes of the hostile
 * values.
 * @type {[call: string, named: RegExp, taken: string[]][]}
 */
const ARGUMENTS = [
  ["fire.set('wind', value)", /wind/, ['-0', '-1', '1.5', 'null']],
  ['fire.set({ wind: value })', /wind/, [...FEW, 'null']],
  ['fire.set(value, 1)', /values|there is no parameter/, FIELDS],
  ['fire.addObject(value)', /object/, []],
  ["fire.addObject({ kind: 'solid', x: value })", /x|64 solids/, [...FEW, 'null']],
  ['fire.changeObject(value, { x: 0 })', /id/, []],
  ['fire.changeObject(1, value)', /propert|values|objects|there is no/, FIELDS],
  ['fire.removeObject(value)', /id/, []],
  ['fire.restore(value)', /there is no parameter/, []],
  ['fire.to(value, { duration: 0 })', /values|there is no parameter/, FIELDS],
  [
    'fire.to({ wind: 1 }, value)',
    /options/,
    ['undefined', 'null', 'document.all', '[]', 'a long list', 'a throwing toString', 'a throwing toJSON', ...FIELDS],
  ],
  ['fire.to({ wind: 1 }, { duration: value === 1e300 ? NaN : value })', /duration/, ['undefined', '-0', '1.5']],
  ['fire.to({ wind: 1 }, { duration: 0, easing: value })', /easing/, ['undefined']],
  ['fire.step(value)', /steps/, ['undefined']],
  ['fire.advance(value)', /seconds/, ['-0', '1.5']],
  ['fire.importConfig(value)', /config|settings|values|there is no|hearth/, FIELDS],
  [
    'fire.toBlob(value)',
    /type|options/,
    [
      'undefined',
      'null',
      "''",
      "'x'",
      'a long text',
      '[]',
      'a long list',
      'a throwing toString',
      'a throwing toJSON',
      ...FIELDS,
    ],
  ],
  ["fire.toBlob('image/png', value)", /quality/, ['undefined', 'NaN', 'Infinity', '-0', '-1', '1.5', '1e300']],
  ['fire.toBlob({ width: value })', /width/, ['undefined']],
  ['fire.captureStream(value)', /fps/, ['undefined', '-0', '1.5', '1e300']],
  ['fire.stir(value, 1, 0, 0)', /x/, ['-0', '-1', '1.5']],
  ['fire.stir(0, 1, value, 0)', /u/, ['-0', '-1', '1.5']],
  ['fire.sparks(0, 1, value)', /count/, ['undefined']],
  ['fire.spray(0, value)', /y/, ['-0', '-1', '1.5']],
  ['fire.spray(0, 1, 0, -4, value)', /grams/, ['undefined', '1.5']],
  ['fire.measure(value, 1)', /x/, ['-0', '-1', '1.5']],
  ['fire.ignite(value)', /place|id|x/, []],
  ['fire.extinguish(0, 1, value)', /radius|place/, []],
  ['fire.toMetres(value, 0)', /x and y/, ['-0', '-1', '1.5', '1e300']],
  ['fire.toPixels(0, value)', /x and y/, ['-0', '-1', '1.5', '1e300']],
];

test('hostile values of every method are refused by name, and the fire stays as it is', async () => {
  const calls = ARGUMENTS.map(([call]) => `(fire, value) => ${call}`);
  const script = `window.hostile = { values: ${hostileValues}, answers: ${answers}, calls: [${calls.join(',\n')}] }`;
  const tab = await browser.show(`${recording(FIRE)}<script>${script}</script>`);
  await tab.ready();
  const state = () => tab.fire(({ params: { wind: _, ...params }, objects }) => [params, objects.length]);
  const before = await state();
  for (const [at, [call, named, taken]] of ARGUMENTS.entries()) {
    const all = await tab.fire((fire, at) => {
      const { values, answers, calls } = /** @type {any} */ (window).hostile;
      return answers((/** @type {any} */ value) => calls[at](fire, value), values());
    }, at);
    try {
      assertRefused(all, named, taken);
    } catch (error) {
      throw new Error(call, { cause: error });
    }
  }
  await tab.fire((fire) => fire.importConfig({ hearth: 2 }));
  assert.deepEqual(await state(), before);
  await assertBurns(tab);
});

test('a refusal repeats no more than the start of a long text', async () => {
  const tab = await browser.show(recording(FIRE));
  await tab.ready();
  const lengths = await tab.fire(async (fire) => {
    const long = 'x'.repeat(2_000_000);
    const message = ({ message: text }) => text.length;
    const calls = [
      fire.set('wind', long),
      fire.set(long, 1),
      fire.set({ [long]: long }),
      fire.set('background', long),
      fire.addObject({ kind: long }),
      fire.addObject({ kind: 'source', [long]: 1 }),
      fire.to({ wind: 1 }, { easing: long }),
      fire.to({ wind: 1 }, { duration: long }),
      fire.importConfig(long),
      fire.importConfig({ hearth: 2, preset: long }),
      fire.restore(long),
    ];
    const rejected = await Promise.all(calls.map((answer) => answer.then(() => Infinity, message)));
    for (const name of [
      'wind',
      'objects',
      'preset',
      'quality',
      'fit',
      'align',
      'touch-action',
      'warm',
      'fps-limit',
      'src',
    ]) {
      fire.setAttribute(name, long);
    }
    return rejected;
  });
  for (const length of lengths) assert.ok(length < 500, `${lengths}`);
  await tab.until(
    'each attribute is refused',
    () =>
      new Set(
        /** @type {any} */ (window).events.filter(({ type }) => type === 'error').map(({ detail }) => detail.message),
      ).size >= 15,
  );
  for (const { message } of await events(tab, 'error')) assert.ok(message.length < 500, message.slice(0, 500));
  const own = tab.problems.filter((problem) => problem.includes('<hearth-fire>'));
  for (const problem of own) assert.ok(problem.length < 600, problem.slice(0, 600));
});

test('300,000 sets in one task end with the last value, and every promise settles', async () => {
  const tab = await browser.show(recording(FIRE));
  await tab.ready();
  const seen = await tab.fire(async (fire) => {
    let settled = 0;
    for (let at = 1; at <= 300_000; at += 1) fire.set('exposure', at / 150_000).then(() => (settled += 1));
    await fire.set('wind', 0.25);
    await new Promise(requestAnimationFrame);
    return [settled, fire.exposure, fire.wind];
  });
  assert.deepEqual(seen, [300_000, 2, 0.25]);
  const changes = await events(tab, 'params-change');
  assert.ok(changes.length <= 1001, `${changes.length} changes`);
});

test('while the context is lost, `toBlob` rejects with the reason; then it works again', async () => {
  const tab = await browser.show(recording(FIRE));
  await tab.burnt(0.2);
  await assertBurns(tab);
  await tab.fire((fire) => {
    fire.lost = new Promise((resolve) => fire.addEventListener('error', resolve, { once: true }));
    fire.back = new Promise((resolve) => fire.addEventListener('restored', resolve, { once: true }));
  });
  await tab.loseContext(2000);
  const message = await tab.fire(async (fire) => {
    await fire.lost;
    return fire.toBlob().then(
      () => 'a picture',
      ({ message }) => message,
    );
  });
  assert.match(message, /graphics context is lost/);
  const size = await tab.fire(async (fire) => {
    await fire.back;
    return (await fire.toBlob()).size;
  });
  assert.ok(size > 100, `${size} bytes`);
});
