/**
 * The stored pictures of scenes are of the present scenes: the one that links show, and those of the strip.
 */
import assert from 'node:assert/strict';
import { readFile, readdir } from 'node:fs/promises';
import path from 'node:path';
import { test } from 'node:test';
import { ROOT, commentOf, landingScene, markOf, marked } from '../e2e/scene-mark.mjs';

const stored = async (/** @type {string} */ file) => commentOf(await readFile(path.join(ROOT, 'web', file)));

test('the picture that links show is of the values of the scene that the page opens with', async () => {
  assert.equal(await stored('poster.jpg'), await markOf(await landingScene()), 'run `cargo xtask poster`');
});

test('every picture of a scene is of its values', async () => {
  const given = (await readdir(path.join(ROOT, 'scenes/community'))).filter((file) => file.endsWith('.jpg'));
  for (const file of given) {
    const name = `community/${path.parse(file).name}`;
    assert.equal(await stored(`../scenes/${name}.jpg`), await markOf(name), `run \`cargo xtask thumbnails ${name}\``);
  }
  for (const file of await readdir(path.join(ROOT, 'web/scenes'))) {
    const name = path.parse(file).name;
    assert.equal(await stored(`scenes/${file}`), await markOf(name), `run \`cargo xtask thumbnails ${name}\``);
  }
});

test('a mark is read from a JPEG as it is written, and a JPEG without one has none', () => {
  const jpeg = Uint8Array.from([0xff, 0xd8, 0xff, 0xe0, 0, 4, 1, 2, 0xff, 0xda, 0, 2, 0xff, 0xd9]);
  assert.equal(commentOf(jpeg), '');
  assert.equal(commentOf(marked(jpeg, 'Hearth: seed 01')), 'Hearth: seed 01');
});
