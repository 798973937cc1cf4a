/** Every way in for settings takes as many as every other: 400 KB, to the depth of their nesting. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { settings } from '../../web/element/attributes/settings.js';
import { textOf as textOfFile } from '../../web/element/attributes/settings-file.js';
import { isSettings, settingsOf, textOf } from '../../web/editing/exchange.js';
import { fromFragment } from '../../web/share.js';

const LIMIT = 400_000;
/** JSON text of that many characters. */
const json = (/** @type {number} */ length) => {
  const text = '{"hearth":3}';
  return text + ' '.repeat(length - text.length);
};
const fragment = async (/** @type {string} */ text) => {
  const stream = new Blob([text]).stream().pipeThrough(new CompressionStream('deflate'));
  return `#fire=${Buffer.from(await new Response(stream).arrayBuffer()).toString('base64url')}`;
};
const download = (/** @type {string} */ text) => {
  globalThis.fetch = async () => new Response(text);
  Object.defineProperty(globalThis, 'document', { value: { baseURI: 'https://a.example/' }, configurable: true });
  return textOfFile('a.json', LIMIT, 'src', new AbortController().signal);
};

for (const [way, take] of /** @type {[string, (text: string) => unknown][]} */ ([
  [
    'the attribute `objects`, `importConfig` and pasted text',
    async (text) => JSON.parse(JSON.stringify(settings(text))),
  ],
  ['a file of `src`', async (text) => JSON.parse(await download(text))],
  ['a file that is dropped or chosen', (text) => settingsOf(new Blob([text]))],
  ['a link', async (text) => fromFragment(await fragment(text))],
])) {
  test(`settings of 390 KB pass, and of more than 400 KB are refused with the limit: ${way}`, async () => {
    for (const length of [70_000, 390_000]) assert.deepEqual(await take(json(length)), { hearth: 3 });
    await assert.rejects(async () => take(json(LIMIT + 1)), /400/);
  });
}

test('what is copied as JSON is taken, or is refused', async () => {
  const config = (/** @type {number} */ length) => /** @type {any} */ ({ hearth: 3, label: 'x'.repeat(length) });
  assert.ok(settings(await textOf('json', config(390_000), {})));
  await assert.rejects(textOf('json', config(LIMIT), {}), /400 KB/);
});

test('a file that is too large is not read', async () => {
  const text = () => assert.fail('it was read');
  await assert.rejects(settingsOf(/** @type {any} */ ({ size: LIMIT + 1, text })), /401 KB.*400 KB/);
});

test('a file of settings is one by its type or by its name', () => {
  for (const [name, type] of [
    ['a.json', ''],
    ['A.JSON', ''],
    ['a.json', 'application/octet-stream'],
    ['a.json', 'text/plain'],
    ['scene', 'application/json'],
    ['scene.txt', 'application/json;charset=utf-8'],
    ['scene', 'application/ld+json'],
  ])
    assert.ok(isSettings(/** @type {any} */ ({ name, type })), `${name} ${type}`);
  for (const [name, type] of [
    ['a.png', 'image/png'],
    ['a.json.png', 'image/png'],
    ['json', ''],
    ['a.txt', 'text/plain'],
  ])
    assert.ok(!isSettings(/** @type {any} */ ({ name, type })), `${name} ${type}`);
});
