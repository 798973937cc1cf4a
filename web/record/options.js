/**
 * What a film is: its options, checked, and what it will take.
 *
 * @typedef {'webp' | 'apng' | 'gif' | 'webm' | 'mp4' | 'zip' | 'png' | 'wav' | 'sheet'} Format
 *
 * @typedef {object} Film
 * @property {Format | 'auto'} format
 * @property {number} width
 * @property {number} height
 * @property {number} fps
 * @property {number} count number of pictures
 * @property {number} from seconds before the first one
 * @property {boolean} loop
 * @property {boolean} sound
 * @property {boolean} alpha whether what is behind the fire is seen
 * @property {boolean} stackedAlpha whether an MP4 has alpha as a grey below each picture
 * @property {boolean} premultiplied whether colours of a sheet are multiplied by alpha
 * @property {boolean} describe whether the file has a text about the scene
 * @property {string} [text] that text
 * @property {string} [background] in place of that of the scene
 */

import { cut } from '../quoted.js';

/**
 * The formats: their media types, their endings, whether they have alpha, and the usual bytes of a pixel of a picture.
 * @type {{[format in Format]: {type: string, ending: string, alpha: boolean, bytes: number}}}
 */
export const FORMATS = {
  webp: { type: 'image/webp', ending: 'webp', alpha: true, bytes: 0.24 },
  apng: { type: 'image/apng', ending: 'png', alpha: true, bytes: 0.46 },
  gif: { type: 'image/gif', ending: 'gif', alpha: true, bytes: 0.24 },
  webm: { type: 'video/webm', ending: 'webm', alpha: true, bytes: 0.5 },
  mp4: { type: 'video/mp4', ending: 'mp4', alpha: false, bytes: 0.04 },
  zip: { type: 'application/zip', ending: 'zip', alpha: true, bytes: 0.46 },
  png: { type: 'image/png', ending: 'png', alpha: true, bytes: 0.46 },
  sheet: { type: 'application/zip', ending: 'zip', alpha: true, bytes: 0.46 },
  wav: { type: 'audio/wav', ending: 'wav', alpha: false, bytes: 0 },
};

/** Pictures in a second: of a GIF, whose times are hundredths of one, and of other films. */
export const RATES = { gif: [20, 25, 100 / 3, 50], others: [24, 25, 30, 50, 60] };

/** Limits of a side [pixels], of the length and of a loop's [s], and of a file in memory [bytes]. */
export const MIN_SIDE = 16;
export const MAX_SIDE = 4096;
const MAX_SECONDS = 600;
export const LOOP_SECONDS = [1, 10];
export const MAX_BYTES = 500_000_000;

/** Bytes of a second of sound. */
const SOUND_BYTES = 192_000;

const OPTIONS = [
  ...['format', 'seconds', 'fps', 'width', 'height', 'from', 'loop', 'background', 'sound', 'stackedAlpha'],
  ...['premultiplied', 'describe', 'stream', 'signal', 'onprogress'],
];

/** A value in a message. @param {unknown} value */
const shown = (value) => (typeof value === 'string' ? `“${cut(value)}”` : cut(String(value)));

/**
 * A number among the options.
 * @type {(options: any, name: string, range: [number, number], otherwise: number, whole?: boolean) => number}
 * @throws {RangeError}
 */
function number(options, name, [least, most], otherwise, whole = false) {
  const value = options[name] ?? otherwise;
  if (typeof value === 'number' && value >= least && value <= most && (!whole || Number.isInteger(value))) return value;
  throw new RangeError(`${name} ${shown(value)}: it is a ${whole ? 'whole ' : ''}number from ${least} to ${most}`);
}

/**
 * The film of options.
 * @param {any} given
 * @param {{width: number, height: number, params: import('../hearth-fire.js').HearthParameters}} fire the size of its picture, and its values
 * @returns {Film}
 * @throws {RangeError} an option is refused
 */
export function filmOf(given, { width: across, height: up, params }) {
  const options = given ?? {};
  const other = Object.keys(options).find((name) => !OPTIONS.includes(name));
  if (other !== undefined)
    throw new RangeError(`${shown(other)} is no option of a film: they are ${OPTIONS.join(', ')}`);
  const format = options.format ?? 'auto';
  if (format !== 'auto' && !Object.hasOwn(FORMATS, format))
    throw new RangeError(`format ${shown(format)}: it is one of ${Object.keys(FORMATS).join(', ')}`);
  const loop = Boolean(options.loop);
  const seconds = number(options, 'seconds', loop ? [LOOP_SECONDS[0], LOOP_SECONDS[1]] : [0.02, MAX_SECONDS], 5);
  const [width, height] = sidesOf(options, across, up);
  const fps = rateOf(options.fps, format);
  const film = { format, width, height, fps, from: number(options, 'from', [0, MAX_SECONDS], 0), loop };
  const count = format === 'png' ? 1 : Math.max(1, Math.round(seconds * fps));
  const background = backgroundOf(options.background);
  const behind = background ?? params.background;
  const isOpaque = /^#[\da-f]{6}(ff)?$/i.test(String(behind)) || (!background && params.backdrop !== 'none');
  const whether = (/** @type {string} */ name) => Boolean(options[name]);
  const about = {
    ...{ ...film, count, alpha: !isOpaque, sound: whether('sound') || format === 'wav' },
    ...{
      stackedAlpha: whether('stackedAlpha'),
      premultiplied: whether('premultiplied'),
      describe: whether('describe'),
    },
  };
  check(about);
  return background === undefined ? about : { ...about, background };
}

/** @param {Film} film */
function check({ format, loop, sound, alpha, stackedAlpha, premultiplied, describe, width, height }) {
  const names = (/** @type {(name: string) => boolean} */ has) => Object.keys(FORMATS).filter(has).join(', ');
  const withAlpha = names((name) => FORMATS[/** @type {Format} */ (name)].alpha);
  if (stackedAlpha && format !== 'mp4')
    throw new RangeError(`stackedAlpha is for mp4: ${withAlpha} have alpha of their own`);
  if (premultiplied && format !== 'sheet') throw new RangeError('premultiplied is for a sheet');
  if (describe && format === 'wav')
    throw new RangeError(`WAV has no place for a text: ${names((name) => name !== 'wav')} have one`);
  if (format === 'mp4' && alpha && !stackedAlpha)
    throw new RangeError(
      `MP4 has no alpha: state a background as “#000000”, stackedAlpha, or a format that has: ${withAlpha}`,
    );
  if (loop && (format === 'wav' || format === 'png')) throw new RangeError(`format “${format}” has no loop`);
  if (sound && !['wav', 'webm', 'mp4'].includes(format))
    throw new RangeError(`format “${format}” has no sound: webm, mp4 and wav have it`);
  if (sound && loop) throw new RangeError('a loop has no sound');
  if (['webm', 'mp4'].includes(format) && (width % 2 || height % 2))
    throw new RangeError(`width ${width}, height ${height}: both are even in ${format}`);
}

/** Width and height: without one it follows from the other, without both they are the picture's. @type {(options: any, across: number, up: number) => number[]} */
function sidesOf(options, across, up) {
  const even = (/** @type {number} */ side) => Math.max(MIN_SIDE, Math.min(MAX_SIDE, 2 * Math.round(side / 2)));
  const { width, height } = options;
  const range = /** @type {[number, number]} */ ([MIN_SIDE, MAX_SIDE]);
  return [
    number(options, 'width', range, even(height === undefined ? across : (height * across) / up), true),
    number(options, 'height', range, even(width === undefined ? up : (width * up) / across), true),
  ];
}

/** Pictures in a second. @type {(given: unknown, format: string) => number} */
function rateOf(given, format) {
  const rates = format === 'gif' ? RATES.gif : RATES.others;
  const wanted = given ?? (format === 'gif' ? 25 : 30);
  const rate = rates.find((known) => typeof wanted === 'number' && Math.abs(known - wanted) < 0.01);
  if (rate) return rate;
  const names = rates.map((known) => (known % 1 ? '33.33' : known)).join(', ');
  throw new RangeError(`fps ${shown(wanted)}: ${format === 'gif' ? 'a GIF' : 'a film'} has one of ${names}`);
}

/** @param {unknown} given @returns {string | undefined} */
function backgroundOf(given) {
  if (given === undefined || given === 'scene') return undefined;
  if (typeof given === 'string' && /^(transparent|#[\da-f]{6})$/i.test(given)) return given.toLowerCase();
  throw new RangeError(`background ${shown(given)}: it is “scene”, “transparent” or a colour as “#101018”`);
}

/**
 * What a film takes: the bytes of its file, as films of fires usually have, and of memory until its end.
 * @param {Film} film
 * @param {boolean} isStreamed
 */
export function estimate({ format, width, height, fps, count, loop, sound }, isStreamed = false) {
  const pixels = width * height;
  const seconds = count / fps;
  const { bytes } = FORMATS[format === 'auto' ? 'webp' : format];
  const file = Math.ceil(pixels * count * bytes + (sound ? seconds * SOUND_BYTES : 0));
  // A GIF keeps its pictures for the palette, a sheet its tiles, a loop those that it mixes. Half floats of the light, of fields and of bloom
  // are some forty bytes of a pixel; three pictures are under way.
  const kept =
    ({ gif: 2, sheet: 8 }[String(format)] ?? 0) * pixels * count + (loop ? 4 * pixels * Math.round(0.3 * fps) : 0);
  const drawing = format === 'wav' ? 0 : pixels * (40 + 12);
  return { bytes: file, memory: Math.ceil((isStreamed ? 0 : file) + kept + drawing), drawing };
}

/** Megabytes in a message. @param {number} bytes */
export const megabytes = (bytes) => (bytes < 1e6 ? '1 MB' : `${Math.round(bytes / 1e6)} MB`);

/**
 * @type {(film: Film, isStreamed: boolean) => void}
 * @throws {RangeError} the film needs more memory than it may have
 */
export function checkMemory(film, isStreamed) {
  const { memory, drawing } = estimate(film, isStreamed);
  if (memory - drawing <= MAX_BYTES) return;
  throw new RangeError(
    `the film would take about ${megabytes(memory - drawing)} of memory, and ${megabytes(drawing)} to draw; at most ${megabytes(MAX_BYTES)} are kept: make it smaller or shorter, or give a \`stream\`${['gif', 'sheet'].includes(film.format) ? ' and another format, which does not keep its pictures' : ''}`,
  );
}
