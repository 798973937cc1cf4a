/**
 * The results as tables, Markdown, CSV and JSON.
 *
 * @typedef {object} SpeedRow
 * @property {import('./rows.js').Model} model
 * @property {number} count
 * @property {number} [alive]  Mean number of particles of the fire whose steps are measured.
 * @property {number} [stepMs]
 * @property {number} [shown]  Number of particles of the fire whose pictures are measured.
 * @property {number} [pictureMs]
 * @property {number} [uploadMs]
 * @property {number} [fps]
 * @property {number} [wasm]  [bytes]
 * @property {number} [gpu]  [bytes]
 * @property {number} [paperMs]  Of the paper's loop on this machine.
 * @property {string} [failed]  Why figures are missing.
 *
 * @typedef {object} SizeRow
 * @property {number} size  In the paper's pixels.
 * @property {number} wasm  [bytes]
 * @property {number} gpu  [bytes]
 * @property {number} pictureMs
 *
 * @typedef {object} Report
 * @property {{browser: string, processors: number, gpu: string}} machine
 * @property {SpeedRow[]} speeds
 * @property {SizeRow[]} sizes
 *
 * @typedef {{title: string, cells: string[][]}} Table  The first row names the columns.
 */

import { PIXEL, TABLE_1, TABLE_2 } from './rows.js';

/** A number with three digits; empty for none. @param {number | undefined} value */
function digits(value) {
  if (value === undefined || !Number.isFinite(value)) return '';
  return String(value >= 100 ? Math.round(value) : Number(value.toPrecision(3)));
}

/** @param {number | undefined} bytes */
const megabytes = (bytes) => digits(bytes === undefined ? undefined : bytes / 1e6);

/** @param {[number, number] | undefined} range */
const between = (range) => (range ? range.join('–') : '');

/** @type {[string, (row: SpeedRow) => string][]} */
const SPEEDS = [
  ['particles', ({ count }) => String(count)],
  ['model', ({ model }) => model],
  ['mean number', ({ alive }) => digits(alive)],
  ['step, ms', ({ stepMs }) => digits(stepMs)],
  ['steps a second', ({ stepMs }) => digits(stepMs && 1000 / stepMs)],
  ['alive', ({ shown }) => digits(shown)],
  ['picture, ms', ({ pictureMs }) => digits(pictureMs)],
  ['upload, ms', ({ uploadMs }) => digits(uploadMs)],
  ['FPS', ({ fps }) => digits(fps)],
  ['wasm, MB', ({ wasm }) => megabytes(wasm)],
  ['GPU, MB', ({ gpu }) => megabytes(gpu)],
  ['paper’s loop, ms', ({ paperMs }) => digits(paperMs)],
  ['ratio', ({ paperMs, stepMs }) => digits(paperMs && stepMs && paperMs / stepMs)],
  ['the paper: FPS', ({ count }) => digits(TABLE_1[count]?.fps)],
  ['the paper: MB', ({ count }) => between(TABLE_1[count]?.memory)],
  ['the paper: ms', ({ count }) => (TABLE_1[count] ? String(TABLE_1[count].ms) : '')],
];

/** @type {[string, (row: SizeRow) => string][]} */
const SIZES = [
  ['size, px', ({ size }) => String(size)],
  ['size, m', ({ size }) => String(size * PIXEL)],
  ['wasm, MB', ({ wasm }) => megabytes(wasm)],
  ['GPU, MB', ({ gpu }) => megabytes(gpu)],
  ['picture, ms', ({ pictureMs }) => digits(pictureMs)],
  ['the paper: MB', ({ size }) => between(TABLE_2[size])],
];

/**
 * @template Row
 * @param {string} title
 * @param {[string, (row: Row) => string][]} columns
 * @param {Row[]} rows
 * @returns {Table}
 */
function table(title, columns, rows) {
  return { title, cells: [columns.map(([name]) => name), ...rows.map((row) => columns.map(([, cell]) => cell(row)))] };
}

/** @param {Report} report */
export function tablesOf({ speeds, sizes }) {
  return {
    speeds: table('Speed and memory over the number of particles', SPEEDS, speeds),
    sizes: table('Memory over the size of a particle', SIZES, sizes),
  };
}

/** @param {Report['machine']} machine */
export function machineOf({ browser, processors, gpu }) {
  return `${browser}, ${processors} logical ${processors === 1 ? 'processor' : 'processors'}, ${gpu}`;
}

/** The tables that have rows. @param {Report} report */
function filled(report) {
  return Object.values(tablesOf(report)).filter(({ cells }) => cells.length > 1);
}

/** @param {Report} report */
export function toMarkdown(report) {
  const line = (/** @type {string[]} */ cells) => `| ${cells.join(' | ')} |`;
  const tables = filled(report).map(({ title, cells: [names, ...rows] }) =>
    [`**${title}**`, '', line(names), `|${'--:|'.repeat(names.length)}`, ...rows.map(line)].join('\n'),
  );
  const failed = report.speeds.flatMap(({ count, model, failed: why }) =>
    why ? [`- ${count}, ${model}: ${why}`] : [],
  );
  return [
    `Measured with ${machineOf(report.machine)}.`,
    ...tables,
    ...(failed.length > 0 ? [failed.join('\n')] : []),
    '',
  ]
    .join('\n\n')
    .trimEnd()
    .concat('\n');
}

/** @param {Report} report */
export function toCsv(report) {
  const cell = (/** @type {string} */ text) => (/[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
  return filled(report)
    .map(({ cells }) => cells.map((row) => row.map(cell).join(',')).join('\n'))
    .join('\n\n')
    .concat('\n');
}

/** @param {Report} report */
export function toJson(report) {
  return `${JSON.stringify({ paper: { table1: TABLE_1, table2: TABLE_2 }, ...report }, null, 2)}\n`;
}

/** Replaces the content of a table element. @param {HTMLElement} element @param {Table} table */
export function showTable(element, { cells: [names, ...rows] }) {
  const row = (/** @type {string[]} */ cells, /** @type {(at: number) => 'th' | 'td'} */ kind) => {
    const made = document.createElement('tr');
    made.append(
      ...cells.map((text, at) => {
        const cell = document.createElement(kind(at));
        if (kind(at) === 'th') cell.setAttribute('scope', kind(1) === 'th' ? 'col' : 'row');
        cell.textContent = text;
        return cell;
      }),
    );
    return made;
  };
  const head = document.createElement('thead');
  head.append(row(names, () => 'th'));
  const body = document.createElement('tbody');
  body.append(...rows.map((cells) => row(cells, (at) => (at === 0 ? 'th' : 'td'))));
  element.replaceChildren(head, body);
}
