/**
 * Measures the pixels of every scene as the page shows it, and writes a table: `node
 * flash-scan.mjs table.md`, or `node flash-scan.mjs table.md default classic` for scenes by the
 * beginnings of their names. The rows of the other scenes are kept if the file has them.
 * `cargo measure look` runs this; `HEARTH_SECONDS` sets the duration.
 */
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { BARS, traits } from './measurements.mjs';
import { Film } from './figures/film.mjs';
import { Painter, named } from './painter.mjs';

const SECONDS = Number(process.env.HEARTH_SECONDS ?? 60);
/** How long a fire has burnt before [s]: until it fills its height. */
const BURNT = 5;

const [file, ...begins] = process.argv.slice(2);
if (file === undefined) throw new Error('usage: node flash-scan.mjs table.md [SCENE...]');

const head = [
  `Each scene for ${SECONDS} s as the page shows it at 1024 × 768, 30 pictures a second. What is bold misses its bar. ` +
    'Behind the number of flashes: the most of a field of 10° that flashed together more than three times in a second; 25 % are allowed.',
  '',
  `| scene | ${BARS.map(({ words }) => words).join(' | ')} | what flickers often, anywhere: general, red |`,
  `|---${'|---'.repeat(BARS.length + 1)}|`,
  `| bar | ${BARS.map(({ bar }) => bar).join(' | ')} | |`,
].join('\n');
const rows = keptRows(existsSync(file) ? readFileSync(file, 'utf8') : '');

const painter = new Painter();
let missed = 0;
try {
  const scenes = await painter.ask('scenes');
  for (const lit of named(scenes, begins, 'scene')) {
    const has = traits(await painter.ask('values', { lit }));
    const film = await Film.of(painter, { lit, burnt: BURNT });
    await film.until(SECONDS);
    const found = film.found();
    const cells = BARS.map(({ figure, holds, show, needs = [] }) => {
      const value = figure(found);
      if (!needs.every((trait) => has.includes(trait))) return '–';
      if (holds(value)) return show(value);
      missed += 1;
      return `**${show(value)}**`;
    });
    const share = (/** @type {number} */ of) => `${(100 * of).toFixed(0)} %`;
    const { general, red } = found.flashes;
    const row = `| ${lit} | ${cells.join(' | ')} | ${share(general.flickers)}, ${share(red.flickers)} |`;
    rows.set(lit, row);
    console.log(row);
  }
  const present = scenes.flatMap((/** @type {string} */ scene) => rows.get(scene) ?? []);
  writeFileSync(file, `${[head, ...present].join('\n')}\n`);
} finally {
  await painter.close();
}
if (missed > 0) {
  console.log(`${missed} figures miss their bars`);
  process.exitCode = 1;
}

/**
 * The rows of an earlier table by their scenes.
 * @param {string} table
 * @returns {Map<string, string>}
 * @throws {Error} they were measured in another way: rows of a table are comparable
 */
function keptRows(table) {
  if (begins.length === 0 || table.trim() === '') return new Map();
  if (!table.startsWith(head)) throw new Error(`${file} was measured in another way: name no scene, or another file`);
  const all = table
    .slice(head.length)
    .split('\n')
    .filter((line) => line.startsWith('| '));
  return new Map(all.map((row) => [row.split(' ')[1], row]));
}
