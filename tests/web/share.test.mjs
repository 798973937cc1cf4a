/**
 * Settings as URL parameters and as HTML: reading them returns what was written, and no
 * character escapes its context.
 */
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { PARAMETERS, PRESETS } from '../../web/parameters.js';
import { readUrlParameters } from '../../web/pages/url-parameters.js';
import { MAX_QUERY, elementCode, fromFragment, fromQuery, iframeCode, pageLink, toQuery } from '../../web/share.js';
import { parametersOf } from '../../web/share/strangers.js';

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
  { hearth: 3, values: {} },
  ...PRESETS.map(({ name }) => ({ hearth: 3, preset: name, values: {} })),
  { hearth: 3, preset: 'seed', values: { model: 'combustion', max_particles: 3000 } },
  { hearth: 3, values: Object.fromEntries(PARAMETERS.map((entry) => [entry.id, OTHERS[entry.kind](entry)])) },
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

  test('holds the scene and changed values by attribute names, and nothing else', async () => {
    assert.equal(toQuery({ hearth: 3, values: {} }), '');
    const config = { hearth: 3, preset: 'seed', values: { viscosity: 0.02, max_particles: 400 } };
    assert.equal(toQuery(config), 'scene=seed&viscosity=0.02&max-particles=400');
    assert.equal(
      await pageLink(config, 'https://fire.example/a/?viscosity=9&paused&lang=de#there'),
      'https://fire.example/a/?scene=seed&viscosity=0.02&max-particles=400',
    );
  });

  test('is read with question mark or without, by ids too, and by the preset’s other name', () => {
    const expected = { hearth: 3, preset: 'seed', values: { source_width: '0.3' } };
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

  test('escapes every character', async () => {
    const config = { hearth: 3, preset: HOSTILE, values: { background: HOSTILE, 'a&b=c': HOSTILE } };
    const link = await pageLink(config, EMBED);
    assert.match(link, /^[\w:/.?=&%+-]*$/);
    assert.deepEqual(fromQuery(new URL(link).search).config, config);
  });
});

describe('code to paste', () => {
  test('holds the script, and of each value its attribute', () => {
    const values = { model: 'classic', max_particles: 400, printed_kernel: true, printed_euler: false };
    const code = elementCode({ hearth: 3, preset: 'seed', values }, SCRIPT);
    assert.ok(code.startsWith(`<script type="module" src="${SCRIPT}"></script>\n`));
    const { style, ...attributes } = attributesOf(code, 'hearth-fire');
    assert.match(style, /width.*height/);
    const element = elementCode({ hearth: 3, preset: 'seed', values });
    assert.ok(element.startsWith('<hearth-fire ') && code.endsWith(`\n${element}`));
    assert.deepEqual(attributes, {
      preset: 'seed',
      model: 'classic',
      'max-particles': '400',
      'printed-kernel': '',
      'printed-euler': 'false',
    });
  });

  test('of an iframe holds the whole address', async () => {
    const config = { hearth: 3, preset: 'seed', values: { background: '#204060' } };
    const { src, width, height } = attributesOf(await iframeCode(config, EMBED), 'iframe');
    assert.equal(src, await pageLink(config, EMBED));
    assert.ok(Number(width) > 0 && Number(height) > 0);
  });

  test('shows the fire as its page does: its size and its own attributes', async () => {
    const shown = { width: 940, height: 800, attributes: { warm: '', interactive: '', fit: 'contain', align: '"<' } };
    const config = { hearth: 3, preset: 'seed', values: {} };
    const { preset, style, ...attributes } = attributesOf(elementCode(config, undefined, shown), 'hearth-fire');
    assert.deepEqual(
      [preset, style, attributes],
      ['seed', 'width: 940px; max-width: 100%; height: 800px', shown.attributes],
    );
    const { src, width, height } = attributesOf(await iframeCode(config, EMBED, shown), 'iframe');
    assert.deepEqual([width, height], ['940', '800']);
    assert.equal(src, `${EMBED}?scene=seed&warm&interactive&fit=contain&align=%22%3C`);
    for (const wrong of [{ width: 0 }, { height: NaN }, { width: '9px' }, { attributes: { onclick: 'x' } }]) {
      assert.throws(() => elementCode(config, undefined, wrong), RangeError);
      await assert.rejects(iframeCode(config, EMBED, wrong), RangeError);
    }
  });

  test('escapes every character of a value', async () => {
    const config = { hearth: 3, preset: HOSTILE, values: { background: HOSTILE } };
    const code = elementCode(config, `${SCRIPT}?${HOSTILE}`);
    const { preset, background } = attributesOf(code, 'hearth-fire');
    assert.deepEqual([preset, background], [HOSTILE, HOSTILE]);
    assert.equal(code.match(/<script/g).length, 1);
    assert.ok(!/alert\(1\)<\/script/.test(code));
    assert.equal(
      fromQuery(new URL(attributesOf(await iframeCode(config, EMBED), 'iframe').src).search).config.preset,
      HOSTILE,
    );
  });

  test('does not write unknown parameters into a page', () => {
    for (const name of ['onclick', 'viscosty', 'a b', 'style', '__proto__', 'constructor', '"><script>']) {
      const values = Object.fromEntries([[name, 'alert(1)']]);
      const write = () => elementCode({ hearth: 3, values }, SCRIPT);
      assert.throws(write, (error) => error instanceof RangeError && /not a parameter/.test(error.message));
    }
  });
});

test('objects are JSON in an address and in HTML', () => {
  const objects = [{ kind: 'source' }, { kind: 'source', id: 7, x: 0.3 }];
  const query = toQuery({ hearth: 3, values: {}, objects });
  assert.deepEqual(JSON.parse(new URLSearchParams(query).get('objects')), objects);
  assert.deepEqual(JSON.parse(fromQuery(query).others.get('objects')), objects);
  assert.match(elementCode({ objects }), /objects="\[\{&quot;kind&quot;:&quot;source&quot;\}/);
  assert.equal(toQuery({ hearth: 3, values: {}, objects: [] }), 'objects=%5B%5D');
});

test('what follows an address is no part of its last value, and brackets that the value closes are', () => {
  for (const [query, background] of [
    ['?background=rgb(1%2C2%2C3)', 'rgb(1,2,3)'],
    ['?background=rgb(1%2C2%2C3)).', 'rgb(1,2,3)'],
    ['?background=gold).', 'gold'],
    ['?background=gold%3E', 'gold'],
  ])
    assert.equal(parametersOf(query).get('background'), background, query);
});

/** A stroke of a brush, as a drawing has it. */
const stroke = (/** @type {number} */ seed) => ({
  kind: 'solid',
  shape: 'stroke',
  y: 0.5,
  points: Array.from({ length: 60 }, (_, at) =>
    [Math.sin(at * seed) * 0.3, Math.cos(at * (seed + 1)) * 0.3].map((x) => x.toFixed(3)).join(),
  ).join(' '),
});
const drawing = (/** @type {number} */ strokes) => ({
  hearth: 3,
  preset: 'campfire',
  values: { wind: 0.3 },
  objects: Array.from({ length: strokes }, (_, at) => stroke(at + 1)),
});
const text = (/** @type {string} */ word) => ({ hearth: 3, values: {}, objects: [{ kind: 'solid', name: word }] });

describe('a fire that is too long for a query', () => {
  for (const [about, config] of /** @type {[string, any][]} */ ([
    ['three strokes', drawing(3)],
    ['twelve strokes', drawing(12)],
    ['twenty strokes', drawing(20)],
    ['names in every script', text('Ünïcødé 火 🔥 نار '.repeat(200))],
    ['a name that URLs escape', text('"&?#%'.repeat(900))],
    [
      'hundreds of values',
      { hearth: 3, values: Object.fromEntries(PARAMETERS.map(({ id }, at) => [id, 1 / (at + 3)])) },
    ],
    ['one character more than a query', text('x'.repeat(MAX_QUERY))],
  ])) {
    test(`is a shorter link that returns it: ${about}`, async () => {
      const { length } = toQuery(config);
      assert.ok(length > MAX_QUERY, `${length}`);
      for (const made of [
        await pageLink(config, 'https://fire.example/a/?viscosity=9#there'),
        attributesOf(await iframeCode(config, EMBED), 'iframe').src,
      ]) {
        const { search, hash, href } = new URL(made);
        assert.match(href, /^[\w:/.#=-]*$/);
        assert.equal(search, '');
        assert.ok(hash.length < length, `${hash.length} of ${length}`);
        assert.deepEqual(await fromFragment(hash), config);
      }
    });
  }

  test('is refused by name where it is too long for a fragment', async () => {
    const noise = text(Array.from({ length: 40_000 }, (_, at) => Math.sin(at)).join());
    for (const make of [pageLink, iframeCode])
      await assert.rejects(make(noise, EMBED), { name: 'RangeError', message: /too long for a link.*32000/ });
  });

  test('is refused where nothing compresses', async () => {
    const { CompressionStream: kept } = globalThis;
    try {
      Reflect.deleteProperty(globalThis, 'CompressionStream');
      await assert.rejects(pageLink(drawing(12), EMBED), /cannot compress/);
      assert.ok((await pageLink(drawing(0), EMBED)).includes('scene=campfire'));
    } finally {
      globalThis.CompressionStream = kept;
    }
  });
});

test('a damaged fragment is refused with a reason, and those of others are none of a fire', async () => {
  const { hash } = new URL(await pageLink(drawing(12), EMBED));
  const deflated = async (/** @type {Uint8Array<ArrayBuffer>} */ bytes) => {
    const stream = new Blob([bytes]).stream().pipeThrough(new CompressionStream('deflate'));
    return `#fire=${Buffer.from(await new Response(stream).arrayBuffer()).toString('base64url')}`;
  };
  const bytes = (/** @type {string} */ words) => new TextEncoder().encode(words);
  for (const [damaged, words] of /** @type {[string, RegExp][]} */ ([
    [hash.slice(0, -9), /damaged/],
    [hash.slice(0, 40), /damaged/],
    [`${hash.slice(0, 60)}AAAA${hash.slice(64)}`, /damaged/],
    ['#fire=', /damaged/],
    ['#fire=%%%', /damaged/],
    [await deflated(bytes('{"hearth": 3,')), /damaged/],
    [await deflated(new Uint8Array([0xff, 0xfe])), /damaged/],
    // A bomb: 40 MB within a link.
    [await deflated(new Uint8Array(40e6)), /more than 400 KB/],
  ])) {
    await assert.rejects(fromFragment(damaged), { name: 'RangeError', message: words });
  }
  for (const other of ['', '#', '#about', '#fires', '#fire-of-this-tab'])
    assert.equal(await fromFragment(other), undefined);
});

test('an address that other programs have changed shows its fire', async () => {
  const objects = Array.from({ length: 60 }, (_, at) => ({ kind: 'solid', x: at / 100, name: `${(at * 7919) % 997}` }));
  const config = /** @type {any} */ ({ hearth: 3, preset: 'candle', objects });
  const { hash } = new URL(await pageLink(config, 'https://fire.example/'));
  const encoded = hash.replaceAll('-', '%2D').replaceAll('_', '%5F').replace('=', '%3D');
  const [start, end] = [hash.slice(0, 76), hash.slice(76)];
  for (const changed of [
    ...[hash.replace('=', '%3D'), encoded, encoded.replaceAll('%', '%25'), hash.replace('#fire=', '#fire%3d')],
    ...[
      ')',
      '.',
      '>',
      '>,',
      '%29.',
      ' ',
      '%20',
      '%E2%80%8B',
      '\u200b',
      '&fbclid=x1',
      '?utm_source=x',
      '==',
      ' (a fire)',
    ].map((after) => hash + after),
    ...['\n', '%0A', '%0D%0A%20', '\u200b', '\ufeff', '\u00ad', ' '].map((between) => start + between + end),
  ])
    assert.deepEqual(await fromFragment(changed), config, changed.replace(end, '…'));
  for (const search of [
    ...[
      '?scene=candle&amp;wind=1',
      '?scene=candle&amp;amp;wind=1',
      '?scene=can%E2%80%8Bdle&wind=1',
      '?scene=can%0Adle&wind=1',
    ],
    ...[')', '.', '%29.', '%3E', '>', '%20', '%E2%80%8B', '%0A', '"', '”', '),'].map(
      (after) => `?scene=candle&wind=1${after}`,
    ),
  ]) {
    const { scene, values, refused } = readUrlParameters(search);
    assert.deepEqual([scene, values, refused], ['candle', [['wind', '1']], []], search);
  }
  assert.deepEqual(fromQuery('?scene=candle&amp;wind=1').config.values, { wind: '1' });
  const [text, drawn] = ['A fire (at night).', '[{"kind":"solid"}]'];
  assert.deepEqual(readUrlParameters(`?alt=${text}`).options, [['alt', text]]);
  assert.deepEqual(readUrlParameters(`?objects=${drawn}`).options, [['objects', drawn]]);
});
