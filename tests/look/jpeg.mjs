/**
 * Pictures of scenes as `hearth render` draws them, and as small JPEGs.
 */
import { execFileSync } from 'node:child_process';
import { Picture } from '../e2e/picture.mjs';
import { marked, markOf } from '../e2e/scene-mark.mjs';

/** Most bytes of what a program returns. */
const OUTPUT = { maxBuffer: 64_000_000 };

/** The program in a variable of `cargo xtask`. @param {string} variable */
function program(variable) {
  const named = process.env[variable];
  if (!named) throw new Error(`${variable} names no program: \`cargo xtask thumbnails\` and \`poster\` set it`);
  return named;
}

/**
 * A picture of a scene in front of a colour.
 * @param {string} scene @param {number[]} behind @param {string[]} options of `hearth render`
 */
export function rendered(scene, behind, options) {
  const png = execFileSync(program('HEARTH_COMMAND'), ['render', scene, '--out', '-', ...options], OUTPUT);
  return Picture.decode(png, behind);
}

/**
 * A picture as JPEG with its scene's mark, of the first quality that makes it so small.
 * @param {Picture} picture @param {string} scene @param {number} largest  Most bytes.
 * @param {number[]} qualities
 * @throws {Error} none does
 */
export async function jpegOf({ width, height, rgb }, scene, largest, qualities) {
  const input = Buffer.concat([Buffer.from(`P6 ${width} ${height} 255\n`), rgb]);
  for (const quality of qualities) {
    const options = ['-quality', String(quality), '-optimize'];
    const jpeg = marked(execFileSync(program('HEARTH_CJPEG'), options, { ...OUTPUT, input }), await markOf(scene));
    if (jpeg.length <= largest) return jpeg;
  }
  throw new Error(`${scene}: the picture takes more than ${largest} bytes`);
}
