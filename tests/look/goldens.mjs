/**
 * The golden pictures, and the tolerance of their comparison.
 */
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { Picture } from '../e2e/picture.mjs';
import { compare } from './compare.mjs';
import { coarse, encode, sheet } from './sheet.mjs';
import { GOLDENS } from './painter.mjs';

/** @typedef {import('./painter.mjs').PictureRequest} PictureRequest */
/** @typedef {import('./painter.mjs').Painter} Painter */

/** Pixels of a picture as it is drawn, and of one that is all edges, which take most of
    a file: a disc for every particle. */
const PIXELS = { most: 100_000, discs: 24_000 };
const DISCS = ['particles', 'neighbours'];

/**
 * What two drawings of the same may differ by. Other versions of the driver round
 * elsewhere; nobody sees a difference of 2. The tests show what lies beyond.
 */
export const TOLERANCE = { colour: 1, shift: 0.4, structure: 0.985 };

/** Fires with settings that no scene has: @type {{[name: string]: PictureRequest}} */
const VARIANTS = {
  'default-gas': { lit: 'default', values: { palette: 'gas' } },
  'default-copper': { lit: 'default', values: { palette: 'copper' } },
  'default-lithium': { lit: 'default', values: { palette: 'lithium' } },
  'default-ghost': { lit: 'default', values: { palette: 'ghost' } },
  'default-custom': { lit: 'default', values: { palette: 'custom' } },
  'default-bricks': { lit: 'default', values: { backdrop: 'bricks', heat_haze: 1 } },
  'default-smoke': { lit: 'default', values: { layers: 'smoke', smoke_opacity: 1 } },
  'default-low': { lit: 'default', quality: 'low', values: { detail: 0.5, bloom: 0.4 } },
  'classic-copper': { lit: 'classic', values: { palette: 'copper' } },
  'classic-bricks': { lit: 'classic', values: { backdrop: 'bricks', heat_haze: 1 } },
};

/** The scene that is drawn in every display mode, of each model; discs of few particles can be told apart. */
const MODES = { combustion: 'default', classic: 'classic' };
const PARTICLES_OF_MODES = 1000;

/** Not drawn: a fire that the scene itself shows, and the distance from solids, which these scenes lack. */
const OTHER_MODES = ['fire', 'distance'];

/**
 * Every picture that is kept, by its name.
 * @param {Painter} painter @returns {Promise<{[name: string]: PictureRequest}>}
 */
export async function requests(painter) {
  const [presets, modes] = await Promise.all([painter.ask('presets'), painter.ask('modes')]);
  const all = Object.fromEntries(presets.map((/** @type {string} */ lit) => [lit, { lit }]));
  for (const [model, lit] of Object.entries(MODES)) {
    for (const display_mode of modes.filter((/** @type {string} */ mode) => !OTHER_MODES.includes(mode))) {
      all[`modes-${model}-${display_mode}`] = { lit, particles: PARTICLES_OF_MODES, values: { display_mode } };
    }
  }
  return { ...all, ...VARIANTS };
}

/**
 * A picture as wide as its fire, and not much wider, in the few colours that are kept: rounding shifts a picture of
 * flat colours, so both sides of a comparison are rounded.
 * @param {Painter} painter @param {PictureRequest} request
 */
export async function drawn(painter, request) {
  const { domain_width, domain_height, display_mode } = await painter.ask('values', request);
  const share = Math.min(Math.max((1.15 * Number(domain_width)) / Number(domain_height), 0.4), 1.5);
  const pixels = DISCS.includes(display_mode) ? PIXELS.discs : PIXELS.most;
  const size = [share, 1].map((side) => 2 * Math.round((side * Math.sqrt(pixels / share)) / 2));
  return coarse(sheet(await painter.still({ ...request, width: size[0], height: size[1] })));
}

/** @param {string} name */
export const file = (name) => path.join(GOLDENS, `${name}.png`);

/** The picture that is kept. @param {string} name */
export function golden(name) {
  if (!existsSync(file(name))) throw new Error(`there is no ${name}.png: \`cargo xtask goldens ${name}\` draws it`);
  return Picture.decode(readFileSync(file(name)));
}

/**
 * The differences of a picture from the golden one; an empty text within the tolerance.
 * @param {Picture} actual @param {Picture} expected
 */
export function mismatch(actual, expected) {
  const { colour, shift, structure } = compare(actual, expected);
  const differences = [];
  if (!(colour <= TOLERANCE.colour)) differences.push(`its colours differ by ${colour.toFixed(2)}`);
  if (!(shift <= TOLERANCE.shift)) differences.push(`all of them are shifted by ${shift.toFixed(2)}`);
  if (!(structure >= TOLERANCE.structure)) differences.push(`its structure agrees by ${structure.toFixed(4)}`);
  return differences.join(', ');
}

/**
 * Writes what was drawn, what was expected and the difference between them; returns
 * the paths.
 * @param {string} name @param {Picture} actual @param {Picture} expected
 */
export function show(name, actual, expected) {
  const folder = process.env.HEARTH_SHOWN ?? 'shown';
  mkdirSync(folder, { recursive: true });
  const { distances } = compare(actual, expected);
  const rgb = new Uint8Array(3 * distances.length);
  distances.forEach((value, at) => {
    rgb.fill(Math.min(255, 16 * value), 3 * at, 3 * at + 3);
  });
  const pictures = { actual, expected, difference: /** @type {Picture} */ ({ ...actual, rgb }) };
  return Object.entries(pictures).map(([what, picture]) => {
    const target = path.join(folder, `${name}-${what}.png`);
    writeFileSync(target, encode(picture));
    return target;
  });
}
