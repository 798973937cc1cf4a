/**
 * Settings as URL parameters and as HTML: reading them returns what was written, and no
 * character escapes its context.
 */
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { PARAMETERS, PRESETS } from '../../web/parameters.js';
import { elementCode, fromQuery, iframeCode, pageLink, toQuery } from '../../web/share.js';

const SCRIPT = 'https://fire.example/web/hearth-fire.js';
const EMBED = 'https://fire.example/web/embed.html';

/** Every value of the table that differs from its default, of each kind. */
const OTHERS = {
  number: ({ min, max }) => (min + max) / 3,
  integer: ({ min }) => min,
  choice: ({ choices }) => choices.at(-1),
  flag: () => true,
  colour: () => '#204060',
  seed: () => 4711,
};

/** Settings that a fire might export, and hostile ones. */
const CONFIGS = [
  { hearth: 2, values: {} },
  ...PRESETS.map(({ name }) => ({ hearth: 2, preset: name, values: {} })),
  { hearth: 2, preset: 'seed', values: { model: 'combustion', max_particles: 3000 } },
  { hearth: 2, values: Object.fromEntries(PARAMETERS.map((entry) => [entry.id, OTHERS[entry.kind](entry)])) },
];
const HOSTILE = '"\'><script>alert(1)</script>&amp;\u{1f525} \n=#?%00';

/** As they are after an address: every value a text. */
const asTexts = (config) => ({
  ...config,
  values: Object.fromEntries(Object.entries(config.values).map(([id, value]) => [id, String(value)])),
});

/** The element and its attributes, as a browser reads them out of such simple HTML. */
function attributesOf(html, name) {
  const [, inside] = new RegExp(`<${name} ([^>]*)></${name}>`).exec(html);
  const found = inside.matchAll(/([a-z-]+)(?:="([^"]*)")?/g);
  const unescaped = (text) =>
    text
      .replaceAll('&lt;', '<')
      .replaceAll('&gt;', '>')
      .replaceAll('&quot;', '"')
      .replaceAll('&#39;', "'")
      .replaceAll('&amp;', '&');
  return Object.fromEntries([...found].map(([, key, value = '']) => [key, unescaped(value)]));
}

describe('an address', () => {
  test('returns the settings that it was made of', () => {
    for (const config of CONFIGS) {
      const { config: back, others } = fromQuery(toQuery(config));
      assert.deepEqual(back, asTexts(config));
      assert.equal(`${others}`, '');
    }
  });

  test('holds the scene and changed values by attribute names, and nothing else', () => {
    assert.equal(toQuery({ hearth: 2, values: {} }), '');
    const config = { hearth: 2, preset: 'seed', values: { viscosity: 0.02, max_particles: 400 } };
    assert.equal(toQuery(config), 'scene=seed&viscosity=0.02&max-particles=400');
    assert.equal(
      pageLink(config, 'https://fire.example/a/?viscosity=9&paused&lang=de#there'),
      'https://fire.example/a/?scene=seed&viscosity=0.02&max-particles=400',
    );
  });

  test('is read with question mark or without, by ids too, and by the preset’s other name', () => {
    const expected = { hearth: 2, preset: 'seed', values: { source_width: '0.3' } };
    for (const search of [
      '?scene=seed&source-width=0.3',
      'preset=seed&source_width=0.3',
      new URLSearchParams('scene=seed&source-width=0.3'),
    ]) {
      assert.deepEqual(fromQuery(search).config, expected);
    }
  });

  test('leaves the element’s own attributes and the page’s own names aside', () => {
    const { config, others } = fromQuery(
      '?paused&quality=low&alt=A+fire&origin=https%3A%2F%2Fa.example&model=classic&viscosity=1',
      ['origin'],
    );
    assert.deepEqual(config.values, { model: 'classic', viscosity: '1' });
    assert.deepEqual(Object.fromEntries(others), {
      paused: '',
      quality: 'low',
      alt: 'A fire',
      origin: 'https://a.example',
    });
  });

  test('keeps unknown names, which the fire rejects', () => {
    const { values } = fromQuery('?viscosty=0.02&__proto__=1&constructor=2').config;
    assert.deepEqual(Object.entries(values), [
      ['viscosty', '0.02'],
      ['__proto__', '1'],
      ['constructor', '2'],
    ]);
    assert.equal(Object.getPrototypeOf(values), Object.prototype);
  });

  test('escapes every character', () => {
    const config = { hearth: 2, preset: HOSTILE, values: { background: HOSTILE, 'a&b=c': HOSTILE } };
    const link = pageLink(config, EMBED);
    assert.match(link, /^[\w:/.?=&%+-]*$/);
    assert.deepEqual(fromQuery(new URL(link).search).config, config);
  });
});

describe('code to paste', () => {
  test('holds the script, and of each value its attribute', () => {
    const values = { model: 'classic', max_particles: 400, printed_kernel: true, printed_euler: false };
    const code = elementCode({ hearth: 2, preset: 'seed', values }, SCRIPT);
    assert.ok(code.startsWith(`<script type="module" src="${SCRIPT}"></script>\n`));
    const { style, ...attributes } = attributesOf(code, 'hearth-fire');
    assert.match(style, /width.*height/);
    const element = elementCode({ hearth: 2, preset: 'seed', values });
    assert.ok(element.startsWith('<hearth-fire ') && code.endsWith(`\n${element}`));
    assert.deepEqual(attributes, {
      preset: 'seed',
      model: 'classic',
      'max-particles': '400',
      'printed-kernel': '',
      'printed-euler': 'false',
    });
  });

  test('of an iframe holds the whole address', () => {
    const config = { hearth: 2, preset: 'seed', values: { background: '#204060' } };
    const { src, width, height } = attributesOf(iframeCode(config, EMBED), 'iframe');
    assert.equal(src, pageLink(config, EMBED));
    assert.ok(Number(width) > 0 && Number(height) > 0);
  });

  test('escapes every character of a value', () => {
    const config = { hearth: 2, preset: HOSTILE, values: { background: HOSTILE } };
    const code = elementCode(config, `${SCRIPT}?${HOSTILE}`);
    const { preset, background } = attributesOf(code, 'hearth-fire');
    assert.deepEqual([preset, background], [HOSTILE, HOSTILE]);
    assert.equal(code.match(/<script/g).length, 1);
    assert.ok(!/alert\(1\)<\/script/.test(code));
    assert.equal(
      fromQuery(new URL(attributesOf(iframeCode(config, EMBED), 'iframe').src).search).config.preset,
      HOSTILE,
    );
  });

  test('does not write unknown parameters into a page', () => {
    for (const name of ['onclick', 'viscosty', 'a b', 'style', '__proto__', 'constructor', '"><script>']) {
      const values = Object.fromEntries([[name, 'alert(1)']]);
      const write = () => elementCode({ hearth: 2, values }, SCRIPT);
      assert.throws(write, (error) => error instanceof RangeError && /not a parameter/.test(error.message));
    }
  });
});

test('objects are JSON in an address and in HTML', () => {
  const objects = [{ kind: 'source' }, { kind: 'source', id: 7, x: 0.3 }];
  const query = toQuery({ hearth: 2, values: {}, objects });
  assert.deepEqual(JSON.parse(new URLSearchParams(query).get('objects')), objects);
  assert.deepEqual(JSON.parse(fromQuery(query).others.get('objects')), objects);
  assert.match(elementCode({ objects }), /objects="\[\{&quot;kind&quot;:&quot;source&quot;\}/);
  assert.equal(toQuery({ hearth: 2, values: {}, objects: [] }), 'objects=%5B%5D');
});
