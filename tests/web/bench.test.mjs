/** The page of measurements without a browser: its choice of rows, its texts, and the tables of the documents. */
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { describe, test } from 'node:test';
import { PaperLoop } from '../../web/paper/bench/paper-loop.js';
import { machineOf, tablesOf, toCsv, toJson, toMarkdown } from '../../web/paper/bench/report.js';
import { ALL, TABLE_1, TABLE_2, choiceOf, queryOf } from '../../web/paper/bench/rows.js';

/** @type {import('../../web/paper/bench/report.js').Report} */
const REPORT = {
  machine: { browser: 'Chrome 1.2', processors: 8, gpu: 'A "GPU", quick' },
  speeds: [
    {
      model: 'classic',
      count: 300,
      alive: 300,
      stepMs: 0.0201,
      paperMs: 4.02,
      shown: 299,
      pictureMs: 1.5,
      fps: 59.94,
      wasm: 2e6,
      gpu: 3.25e6,
    },
    { model: 'combustion', count: 30_000, alive: 29_876.4, stepMs: 5, failed: 'there is no memory' },
  ],
  sizes: [{ size: 30, wasm: 2e6, gpu: 3e6, pictureMs: 1 }],
};

describe('a link', () => {
  test('without parameters chooses all rows, and all rows need none', () => {
    assert.deepEqual(choiceOf(''), ALL);
    assert.equal(queryOf(ALL), '');
  });

  test('names a choice that is read back, in the order of the page', () => {
    for (const search of ['?n=300', '?n=500,100000&models=combustion', '?sizes=', '?n=&models=classic&sizes=1,30']) {
      assert.equal(queryOf(choiceOf(search)), search);
    }
    assert.equal(queryOf(choiceOf('?n=500,300')), '?n=300,500');
  });

  test('with unknown rows chooses the known ones', () => {
    assert.deepEqual(choiceOf('?n=300,301,1e9,__proto__&models=other&x=1'), {
      counts: [300],
      models: [],
      sizes: ALL.sizes,
    });
  });
});

describe('the results', () => {
  test('are a row of numbers each, beside the paper’s', () => {
    const {
      cells: [names, classic, combustion],
    } = tablesOf(REPORT).speeds;
    const row = Object.fromEntries(names.map((name, at) => [name, classic[at]]));
    assert.deepEqual(
      [row['step, ms'], row['steps a second'], row.FPS, row['GPU, MB'], row.ratio, row['the paper: MB']],
      ['0.0201', '49751', '59.9', '3.25', '200', '9.8–12.3'],
    );
    assert.equal(combustion[names.indexOf('mean number')], '29876');
    assert.equal(combustion[names.indexOf('the paper: ms')], '', 'the paper has no such row');
  });

  test('are Markdown with as many cells in each line', () => {
    const text = toMarkdown(REPORT);
    assert.ok(text.startsWith(`Measured with ${machineOf(REPORT.machine)}.\n\n`));
    assert.ok(text.endsWith('- 30000, combustion: there is no memory\n'));
    for (const table of text.split('\n\n').filter((block) => block.startsWith('|'))) {
      const widths = table.split('\n').map((line) => line.split('|').length);
      assert.equal(new Set(widths).size, 1, table);
    }
  });

  test('are CSV whose names with commas are quoted, and JSON with all figures', () => {
    assert.ok(toCsv(REPORT).startsWith('particles,model,mean number,"step, ms",'));
    const { speeds, paper } = JSON.parse(toJson(REPORT));
    assert.deepEqual(speeds, REPORT.speeds);
    assert.equal(paper.table1[5000].ms, 615.52);
  });
});

test('the paper’s loop keeps gas at rest with even density, and expands compressed gas', () => {
  const spread = (/** @type {number} */ spacing) => {
    const positions = Array.from(
      { length: 200 },
      (_, at) => spacing * (at % 2 === 0 ? (at >> 1) % 10 : Math.floor((at >> 1) / 10)),
    );
    const loop = new PaperLoop({ positions });
    for (let left = 20; left > 0; left -= 1) loop.step();
    const xs = loop.particles.map(({ x }) => x);
    return (Math.max(...xs) - Math.min(...xs)) / (9 * spacing);
  };
  assert.ok(Math.abs(spread(0.0105) - 1) < 1e-6, 'sparse gas has no pressure');
  assert.ok(spread(0.007) > 1.02, 'dense gas expands');
});

test('tables in the documents have every row and column that the page measures', () => {
  const text = readFileSync(new URL('../../docs/evaluation.md', import.meta.url), 'utf8');
  const [, section = ''] = /<!-- paper: begin -->([\s\S]*?)<!-- paper: end -->/.exec(text) ?? [];
  const lines = section
    .split('\n')
    .filter((line) => line.startsWith('|'))
    .map((line) => line.slice(2, -2).split(' | '));
  const { speeds, sizes } = tablesOf({ ...REPORT, speeds: [], sizes: [] });
  const heads = lines.flatMap((cells, at) =>
    cells[1] === speeds.cells[0][1] || cells[0] === sizes.cells[0][0] ? [at] : [],
  );
  assert.deepEqual(
    heads.map((at) => lines[at]),
    [speeds.cells[0], sizes.cells[0]],
  );
  const rows = lines.slice(heads[0] + 2, heads[1]);
  assert.deepEqual(
    rows.map(([count, model]) => [Number(count), model]),
    ALL.counts.flatMap((count) => ALL.models.map((model) => [count, model])),
  );
  for (const [count, , ...cells] of rows)
    assert.equal(cells.at(-1)?.trim() ?? '', TABLE_1[Number(count)] ? String(TABLE_1[Number(count)].ms) : '');
  assert.deepEqual(
    lines.slice(heads[1] + 2).map(([size]) => size),
    Object.keys(TABLE_2),
  );
});
