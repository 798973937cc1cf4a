/** The code of the embed dialog: its forms, and links of every scene. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { FORMS, codeOf, valuesOn } from '../../web/pages/embed/codes.js';
import { readUrlParameters } from '../../web/pages/url-parameters.js';
import { PRESETS } from '../../web/parameters.js';
import { fromFragment, pageLink } from '../../web/share.js';

const CONFIG = { hearth: /** @type {const} */ (3), preset: 'candle', values: { exposure: 0.3 } };
const SHOWN = { width: 640, height: 480, attributes: { warm: '', fit: 'contain', alt: 'A "small" & {hot} flame' } };
const ADDRESSES = { script: 'https://fire.example/hearth-fire.js', embed: 'https://fire.example/embed.html' };

test('every form names the scene, its value, its size and how it is shown, one to a line', async () => {
  for (const [name] of FORMS) {
    const code = await codeOf(name, CONFIG, SHOWN, ADDRESSES);
    for (const part of [/candle/, /exposure="?=?0\.3/, /640/, /480/, /\bwarm\b/, /fit="?=?contain/])
      assert.match(code, part, name);
    if (name !== 'iframe')
      assert.ok(
        code.split('\n').every((line) => line.length <= 100),
        code,
      );
  }
});

test('on a white page things are lit and no wall is a dark box; another page shows through if it is chosen', () => {
  const lit = { exposure: 0.3, ambient_light: 1, smoke_opacity: 0 };
  const own = { exposure: 0.3, smoke_opacity: 0.4 };
  const room = { backdrop: 'bricks', ground: 'stone' };
  const none = { backdrop: 'none', ground: 'none' };
  assert.deepEqual(valuesOn('white', false, own, room), { ...lit, ...none });
  assert.deepEqual(valuesOn('white', true, own, none), lit);
  assert.deepEqual(valuesOn('brick', false, own, room), own);
  assert.deepEqual(valuesOn('brick', true, own, room), { ...own, ...none });
  assert.deepEqual(valuesOn('black', true, own, none), own);
});

test('HTML and JSX keep every letter of a value', async () => {
  assert.match(await codeOf('html', CONFIG, SHOWN, ADDRESSES), /alt="A &quot;small&quot; &amp; \{hot\} flame"/);
  const react = await codeOf('react', CONFIG, SHOWN, ADDRESSES);
  const [, text] = /alt=\{(".*")\}/.exec(react) ?? [];
  assert.equal(JSON.parse(String(text)), SHOWN.attributes.alt);
  assert.match(react, /style=\{\{ width: 640, maxWidth: '100%', height: 480 \}\}/);
});

test('a link of every scene, as it is and changed, leads back to it', async () => {
  for (const { name, objects } of PRESETS) {
    for (const config of [
      { hearth: 3, preset: name, values: {} },
      { hearth: 3, preset: name, values: { exposure: 0.5 }, objects },
    ]) {
      const link = new URL(await pageLink(/** @type {any} */ (config), 'https://fire.example/'));
      const read = await fromFragment(link.hash);
      if (read) {
        assert.deepEqual(read, JSON.parse(JSON.stringify(config)), name);
        continue;
      }
      const { scene = 'default', values, options, refused } = readUrlParameters(link.search);
      const [[, list] = []] = options.filter(([option]) => option === 'objects');
      assert.deepEqual(refused, [], name);
      assert.deepEqual([scene, Object.fromEntries(values).exposure], [name, config.values.exposure?.toString()]);
      assert.deepEqual(list && JSON.parse(list), config.objects, name);
    }
  }
});
