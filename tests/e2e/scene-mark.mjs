/**
 * The mark of a stored picture: a comment of the JPEG that names the scene and its values, by which a test knows a
 * picture that is older than its scene.
 */
import { createHash } from 'node:crypto';
import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

export const ROOT = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');

/** The marker of a comment, and that of the data after which there is none. */
const COMMENT = 0xfe;
const SCAN = 0xda;

/**
 * What a picture of this scene is marked with. A label changes no picture.
 * @param {string} name  Of its file below `scenes/`, without the end.
 */
export async function markOf(name) {
  const { values, objects } = JSON.parse(await readFile(path.join(ROOT, 'scenes', `${name}.json`), 'utf8'));
  const digest = createHash('sha256').update(JSON.stringify({ values, objects })).digest('hex');
  return `Hearth: ${name} ${digest.slice(0, 12)}`;
}

/** The scene in the HTML of the landing page. */
export async function landingScene() {
  const html = await readFile(path.join(ROOT, 'index.html'), 'utf8');
  const scene = /<hearth-fire id="fire" [^>]*?preset="([^"]+)"/.exec(html)?.[1];
  if (!scene) throw new Error('the landing page names no scene');
  return scene;
}

/** A JPEG with a comment. @param {Uint8Array} jpeg @param {string} words */
export function marked(jpeg, words) {
  const comment = Buffer.from(words);
  const head = Buffer.from([0xff, COMMENT, 0, comment.length + 2]);
  return Buffer.concat([jpeg.subarray(0, 2), head, comment, jpeg.subarray(2)]);
}

/** The first comment of a JPEG; empty without one. @param {Uint8Array} jpeg */
export function commentOf(jpeg) {
  const bytes = Buffer.from(jpeg);
  for (let at = 2; at + 4 <= bytes.length && bytes[at + 1] !== SCAN; at += 2 + bytes.readUInt16BE(at + 2)) {
    if (bytes[at + 1] === COMMENT) return bytes.toString('utf8', at + 4, at + 2 + bytes.readUInt16BE(at + 2));
  }
  return '';
}
