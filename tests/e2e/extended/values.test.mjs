/**
 * The rule for values of another type, and values that only a page can resolve: automatic seeds and CSS colours.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { events, recording } from '../assertions.mjs';
import { DEFAULT, REFUSED, RULE } from '../../value-rule.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

const SMALL = 'paused quality="low" style="width: 40px; height: 50px"';

/** The seeds of all fires of a page, when they are there. */
function seeds(tab) {
  return tab.evaluate(async () => {
    const fires = /** @type {any[]} */ ([...document.querySelectorAll('hearth-fire')]);
    await Promise.all(fires.map((fire) => fire.ready));
    return fires.map((fire) => fire.seed);
  });
}

test('a fire keeps its automatic seed, or one that is set, when it is moved or inserted again and with another preset', async () => {
  const tab = await browser.show(`<hearth-fire ${SMALL} seed="auto"></hearth-fire><div></div>`);
  const [own] = await seeds(tab);
  const after = await tab.fire(async (fire) => {
    const found = [];
    /** @type {any} */ (document.querySelector('div')).append(fire);
    await fire.ready;
    found.push(fire.seed);
    fire.remove();
    await fire.destroy();
    document.body.append(fire);
    await fire.ready;
    found.push(fire.seed, (await fire.exportConfig()).values.seed);
    // The second is the preset's.
    for (const seed of [7, 1]) {
      await fire.set('seed', seed);
      await fire.destroy();
      document.body.append(fire);
      await fire.ready;
      await fire.importConfig(fire.history.settings);
      fire.preset = seed === 1 ? 'default' : 'candle';
      await fire.exportConfig();
      found.push(fire.seed);
    }
    fire.setAttribute('seed', '9');
    await fire.exportConfig();
    found.push(fire.seed);
    fire.removeAttribute('seed');
    await fire.exportConfig();
    found.push(fire.seed);
    fire.seed = 'auto';
    await fire.exportConfig();
    found.push(fire.seed);
    return found;
  });
  assert.deepEqual(after, [own, own, own, 7, 1, 9, 1, own]);
});

test('replacing all values keeps an automatic seed, unless they name one', async () => {
  const tab = await browser.show(`<hearth-fire ${SMALL} seed="auto" preset="candle"></hearth-fire>`);
  const [own] = await seeds(tab);
  const found = await tab.fire(async (fire) => {
    const kept = [];
    const next = async () => {
      const config = await fire.exportConfig();
      kept.push([fire.preset, fire.seed, config.values.seed]);
    };
    fire.preset = 'torch';
    await next();
    await fire.importConfig({ hearth: 3, preset: 'seed', values: {} });
    await next();
    await fire.importConfig({ hearth: 3, values: { seed: 3 } });
    await next();
    await fire.restore();
    await next();
    return kept;
  });
  assert.deepEqual(found, [
    ['torch', own, own],
    ['seed', own, own],
    ['default', 3, 3],
    ['default', own, own],
  ]);
  assert.deepEqual(tab.problems, []);
});

const COLOURS = [
  ['rebeccapurple', '#663399'],
  ['RED', '#ff0000'],
  ['hsl(120 100% 25%)', '#008000'],
  ['rgb(16, 32, 48)', '#102030'],
  ['rgb(255 0 0 / 0.5)', '#ff000080'],
  ['hwb(0 0% 0% / 20%)', '#ff000033'],
  ['oklch(0.6279 0.2577 29.23)', '#ff0000'],
  ['color(display-p3 0 0 0)', '#000000'],
  ['#f00c', '#ff0000cc'],
  [' navy ', '#000080'],
  ['var(--ground)', '#123456'],
  ['currentcolor', '#654321'],
  ['#abcdef', '#abcdef'],
  ['transparent', 'transparent'],
  ['rgb(0 0 0 / 0)', 'transparent'],
];

test('a colour is any colour of CSS, and its settings hold it as hex', async () => {
  const tab = await browser.open(
    `<body style="--ground: #123456; color: #654321"><hearth-fire ${SMALL} background="rebeccapurple" hot-colour="teal"></hearth-fire>`,
  );
  await tab.ready();
  assert.deepEqual(await tab.fire((fire) => fire.exportConfig()), {
    hearth: 3,
    values: { background: '#663399', hot_colour: '#008080' },
  });
  const elements = () => tab.fire((fire) => fire.shadowRoot.querySelectorAll('i').length);
  const before = await elements();
  for (const [colour, hex] of COLOURS) {
    const found = await tab.fire(async (fire, value) => {
      await fire.set('background', '#010203');
      await fire.set({ background: value });
      const set = fire.background;
      await fire.set('background', '#010203');
      await fire.importConfig({ hearth: 3, values: { background: value } });
      return [set, fire.background];
    }, colour);
    assert.deepEqual(found, [hex, hex], colour);
  }
  assert.equal(await elements(), before);
  assert.deepEqual(tab.problems, []);
});

test('an invalid colour is rejected by name, and the last one stays', async () => {
  const tab = await browser.show(recording(`<hearth-fire ${SMALL} background="teal"></hearth-fire>`));
  await tab.ready();
  const nonsense = [
    'reddish',
    'inherit',
    'initial',
    '#12',
    'rgb(',
    'red; color: blue',
    'var(--none',
    'var(--none)',
    'linear-gradient(red, blue)',
    '',
    'none',
  ];
  for (const value of nonsense) {
    const outcome = await tab.fire(
      (fire, text) =>
        fire.set('background', text).then(
          () => 'taken',
          (error) => [error.name, error.id, error.value],
        ),
      value,
    );
    assert.deepEqual(outcome, ['RangeError', 'background', value]);
  }
  assert.equal(await tab.fire((fire) => fire.background), '#008080');
  const reported = await events(tab, 'error');
  assert.equal(reported.length, nonsense.length);
  for (const { id, message } of reported) {
    assert.equal(id, 'background');
    assert.match(message, /transparent.*#/);
  }
});

test('colours of a file and of an address are those of CSS too', async () => {
  const tab = await browser.open('index.html?backdrop=none&background=hsl(240%20100%25%2050%25)&seed=auto&quality=low');
  await tab.ready();
  assert.equal(await tab.fire((fire) => fire.background), '#0000ff');
  const seed = await tab.fire((fire) => fire.seed);
  assert.ok(seed > 1, `${seed}`);
  const file = `data:application/json,${encodeURIComponent('{"hearth":3,"values":{"background":"gold"}}')}`;
  const other = await browser.show(`<hearth-fire ${SMALL} src='${file}'></hearth-fire>`);
  await other.ready();
  assert.equal(await other.fire((fire) => fire.background), '#ffd700');
  assert.deepEqual([...tab.problems, ...other.problems], []);
});

test('one rule says what a value of another type is, wherever it is given', async () => {
  const tab = await browser.open(`<hearth-fire ${SMALL}></hearth-fire>`);
  await tab.ready();
  const rows = Object.entries(RULE).flatMap(([id, all]) =>
    // What the driver sends to a page is JSON.
    all.filter(([value]) => !Number.isNaN(value)).map(([value, becomes]) => ({ id, value, becomes, other: all[0][0] })),
  );
  const found = await tab.fire(async (fire, rows) => {
    const outcomes = [];
    for (const { id, value, other } of rows) {
      const property = id.replace(/_(.)/g, (_, letter) => letter.toUpperCase());
      const attribute = id.replace('_', '-');
      const initial = fire.get(id);
      /** @type {[way: string, give: () => any][]} */
      const ways = [
        ['set(id, value)', () => fire.set(id, value)],
        ['set({ id: value })', () => fire.set({ [id]: value })],
        ['property', () => void (fire[property] = value)],
      ];
      if (typeof value === 'string') ways.push(['attribute', () => fire.setAttribute(attribute, value)]);
      for (const [way, give] of ways) {
        if (value === null) await fire.set(id, other);
        const refused = await Promise.resolve(give()).then(
          () => false,
          (/** @type {any} */ error) => error.name === 'RangeError' && error.id === id,
        );
        await fire.set({});
        outcomes.push({ id, value, way, refused, got: fire.get(id), initial });
        fire.removeAttribute(attribute);
        await fire.restore(id);
      }
    }
    // Firefox's driver sends an object once.
    return JSON.stringify(outcomes);
  }, rows);
  for (const { id, value, way, refused, got, initial } of JSON.parse(found)) {
    const [, becomes] = RULE[id].find(([given]) => JSON.stringify(given) === JSON.stringify(value)) ?? [];
    const words = `${id} = ${JSON.stringify(value)} by ${way}`;
    assert.equal(got, [REFUSED, DEFAULT].includes(/** @type {any} */ (becomes)) ? initial : becomes, words);
    if (way.startsWith('set')) assert.equal(refused, becomes === REFUSED, words);
  }
  const missing = await tab.fire((fire) => Promise.all([fire.set('wind'), fire.set('wind', undefined)]).catch(String));
  assert.match(missing, /wind = "undefined" is refused: it must be a number from -3 to 3/);
});
