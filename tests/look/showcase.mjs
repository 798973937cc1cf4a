/**
 * Draws the animation that shows in documentation what Hearth draws. `cargo xtask showcase`
 * runs this: `node showcase.mjs frames-folder frames-a-second`. Into the folder go the frames:
 * five seconds of the scene that the page opens with.
 */
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { Picture } from '../e2e/picture.mjs';
import { landingScene } from '../e2e/scene-mark.mjs';
import { Painter } from './painter.mjs';
import { encode } from './sheet.mjs';

const [folder, rate] = process.argv.slice(2);
if (!(Number(rate) > 0)) throw new Error('usage: node showcase.mjs frames-folder frames-a-second');

/** How long the animation is [s], and its size. */
const SECONDS = 5;
const SIZE = { width: 480, height: 480 };

/** When the fire is first shown [s]: it burns as it always will. */
const BURNT = 4;

/** Pictures of each frame: the gas carries the fine structure from picture to picture. */
const DRAWN = 3;

const painter = new Painter();
try {
  const fire = { lit: await landingScene(), burnt: BURNT - 0.5, values: { particles: 6700 }, quality: 'high' };
  await painter.ask('film', { ...fire, ...SIZE });
  for (let frame = -0.5 * Number(rate); frame < SECONDS * Number(rate); frame += 1) {
    /** @type {Buffer[]} */
    const pictures = [];
    for (let picture = 1 - DRAWN; picture <= 0; picture += 1) {
      const time = BURNT + (frame + picture / DRAWN) / Number(rate);
      pictures.push((await painter.call('picture', { time })).bytes);
    }
    if (frame < 0) continue;
    // The page is black.
    const rgb = pictures[DRAWN - 1].filter((_, at) => at % 4 !== 3);
    const png = encode(new Picture(SIZE.width, SIZE.height, rgb));
    writeFileSync(join(folder, `${String(frame).padStart(3, '0')}.png`), png);
  }
} finally {
  await painter.close();
}
