/**
 * Draws the small picture of each scene, 120 × 160, always the same ones.
 * `cargo xtask thumbnails` runs this with their folder:
 * `node thumbnails.mjs folder [scene…]`; without a name, all of them.
 */
import { mkdirSync, readdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { WHOLE } from '../../web/pages/framing.js';
import { ROOT } from '../e2e/scene-mark.mjs';
import { jpegOf, rendered } from './jpeg.mjs';

const [folder, ...names] = process.argv.slice(2);
if (folder === undefined) throw new Error('usage: node thumbnails.mjs folder [scene…]');

/** The colour of the strip that has them. */
const BEHIND = [0x0c, 0x0a, 0x09];

/** Most of a file [bytes], and the qualities that are tried for it. */
const LARGEST = 6000;
const QUALITIES = [90, 85, 80, 70, 60];

/** A flame's edge is finer than a pixel. */
const OPTIONS = '--at 3 --size 120x160 --supersample 2 --quality medium --fit'.split(' ');

const scenes = readdirSync(path.join(ROOT, 'scenes')).map((file) => path.parse(file).name);
for (const name of names) {
  if (!scenes.includes(name)) throw new Error(`there is no scene "${name}"`);
}

mkdirSync(folder, { recursive: true });
for (const name of names.length > 0 ? names : scenes) {
  const picture = rendered(name, BEHIND, [...OPTIONS, WHOLE.includes(name) ? 'contain' : 'height']);
  const jpeg = await jpegOf(picture, name, LARGEST, QUALITIES);
  const file = path.join(folder, `${name}.jpg`);
  writeFileSync(file, jpeg);
  console.log(`${file}: ${(jpeg.length / 1000).toFixed(1)} KB`);
}
