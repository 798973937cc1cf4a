/** What examples of the documentation may contain. That nothing of the rest runs in a page is tested in `docs-pages`. */
import assert from 'node:assert/strict';
import { readFileSync, readdirSync, statSync } from 'node:fs';
import { test } from 'node:test';
import { editOf } from '../../web/docs/examples.js';
import { markupOf } from '../../web/docs/markup.js';
import { HOSTILE } from '../hostile-examples.mjs';

const DOCS = new URL('../../docs/', import.meta.url);
const BEGINNING = '<!doctype html>\n<script type="module" src="./web/hearth-fire.js"></script>\n';
/** Each document with the code of its live examples. */
const LIVE = readdirSync(DOCS)
  .filter((name) => name.endsWith('.md'))
  .map((name) => {
    const text = readFileSync(new URL(name, DOCS), 'utf8');
    return { name, codes: [...text.matchAll(/```html live\n([\s\S]*?)```/g)].map(([, code]) => code) };
  });

test('each live example of the documents is a page of what is allowed, which burns', () => {
  for (const { name, codes } of LIVE) {
    for (const code of codes) {
      assert.ok(code.startsWith(BEGINNING), `${name}: ${code}`);
      assert.doesNotThrow(() => markupOf(code.slice(BEGINNING.length)), `${name}: ${code}`);
    }
  }
  assert.ok(LIVE.flatMap(({ codes }) => codes).length >= 12);
});

test('each recipe has an example, and a picture of at most 40 KB above it', () => {
  const [, ...recipes] = readFileSync(new URL('recipes.md', DOCS), 'utf8').split('\n## ');
  assert.ok(recipes.length >= 9);
  for (const recipe of recipes) {
    const [, picture = ''] = recipe.match(/^.*\n\n!\[.+\]\(([\w/]+\.jpg)\)\n[\s\S]*```html/) ?? [];
    assert.ok(picture && statSync(new URL(picture, DOCS)).size <= 40_000, recipe.slice(0, 200));
  }
});

test('an example becomes the elements that it says, with styles apart', () => {
  const text =
    '<p id="a">1 &lt; 2</p>\n<hearth-fire warm poster="./web/poster.jpg" style="inset: 0; width: calc((1px + 2px) * 2)"><hearth-solid of="#a"></hearth-solid></hearth-fire>';
  const tag = (name, attributes, children = [], styles = []) => ({ name, attributes, styles, children });
  assert.deepEqual(markupOf(text), [
    tag('p', [['id', 'a']], ['1 < 2']),
    '\n',
    tag(
      'hearth-fire',
      [
        ['warm', ''],
        ['poster', '../web/poster.jpg'],
      ],
      [tag('hearth-solid', [['of', '#a']])],
      [
        ['inset', '0'],
        ['width', 'calc((1px + 2px) * 2)'],
      ],
    ),
  ]);
});

test('what runs, leaves the site or is not whole is refused with its name, wherever it stands', () => {
  assert.ok(HOSTILE.length >= 50);
  for (const [text, named] of HOSTILE) {
    assert.throws(
      () => markupOf(text),
      (error) => error instanceof RangeError && error.message.includes(named),
      `${text.slice(0, 200)} does not name ${named}`,
    );
    if (text.startsWith('<hearth-fire>'))
      assert.throws(() => markupOf(`<header><p>${text}</p></header>`), RangeError, text);
  }
});

test('a fragment names an example and its text, and no other fragment does', () => {
  const text = '<hearth-fire alt="ä #%&">\n</hearth-fire>';
  assert.deepEqual(editOf(`#edit-3=${encodeURIComponent(text)}`), { number: 3, text });
  for (const hash of ['', '#edit', '#edit-=x', '#edit-1', '#edit-1=%', '#size', `#edit-1=${'x'.repeat(80_000)}`]) {
    assert.equal(editOf(hash), undefined, hash.slice(0, 20));
  }
});
