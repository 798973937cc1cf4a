/**
 * Draws the small picture of each scene, always the same ones: 120 × 160, and 240 × 320 beside a scene of the community,
 * whose name begins with `community/`. `cargo xtask thumbnails` runs this with their folder:
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

/** The qualities that are tried for a file. */
const QUALITIES = [90, 85, 80, 70, 60];

/** A flame's edge is finer than a pixel. */
const OPTIONS = '--supersample 2 --quality medium'.split(' ');

const COMMUNITY = 'community/';
const filesOf = (/** @type {string} */ below) =>
  readdirSync(path.join(ROOT, 'scenes', below))
    .filter((file) => file.endsWith('.json'))
    .map((file) => below + path.parse(file).name);
const scenes = [...filesOf(''), ...filesOf(COMMUNITY)];
for (const name of names) {
  if (!scenes.includes(name)) throw new Error(`there is no scene "${name}"`);
}

mkdirSync(folder, { recursive: true });
for (const name of names.length > 0 ? names : scenes) {
  const isGiven = name.startsWith(COMMUNITY);
  const json = path.join(ROOT, 'scenes', `${name}.json`);
  const fit = isGiven || WHOLE.includes(name) ? 'contain' : 'height';
  // What burns down is in full fire later.
  const [at, size, largest] = isGiven ? ['6', '240x320', 20_000] : ['3', '120x160', 6000];
  const options = [...OPTIONS, '--at', at, '--size', size, '--fit', fit];
  const picture = rendered(isGiven ? json : name, BEHIND, options);
  const jpeg = await jpegOf(picture, name, largest, QUALITIES);
  const file = isGiven ? json.replace(/json$/, 'jpg') : path.join(folder, `${name}.jpg`);
  writeFileSync(file, jpeg);
  console.log(`${file}: ${(jpeg.length / 1000).toFixed(1)} KB`);
}
