/**
 * Draws the picture that a link to Hearth shows, and the page until its fire burns: the
 * scene that the page opens with, always the same moment, 1200 × 630. `cargo xtask poster`
 * runs this with the path of the picture: `node poster.mjs file.jpg`.
 */
import { writeFileSync } from 'node:fs';
import { landingScene } from '../e2e/scene-mark.mjs';
import { jpegOf, rendered } from './jpeg.mjs';

const [file] = process.argv.slice(2);
if (file === undefined) throw new Error('usage: node poster.mjs file.jpg');

/** Most of the file [bytes]: some readers of links take no more time for it. */
const LARGEST = 60_000;

/** The qualities of a JPEG that are tried for it. */
const QUALITIES = [88, 84, 80, 75, 70];

const BLACK = [0, 0, 0];
const OPTIONS = '--at 3.5 --size 1200x630 --quality high'.split(' ');

const scene = await landingScene();
const picture = rendered(scene, BLACK, OPTIONS);
const glow = picture.crop(0.35, 0.2, 0.65, 0.9).glowing();
if (glow < 0.1) throw new Error(`only ${glow} of the picture's middle glows`);
const jpeg = await jpegOf(picture, scene, LARGEST, QUALITIES);
writeFileSync(file, jpeg);
console.log(`${file}: ${scene}, ${(jpeg.length / 1000).toFixed(1)} KB`);
