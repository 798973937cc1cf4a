/**
 * Runs every end-to-end test in each browser, and writes the table of browsers into the evaluation:
 * `cargo xtask browsers`. A test that fails is named there, and fails the command. With names of files or in some
 * browsers, `HEARTH_BROWSERS=firefox cargo xtask browsers keys`, it runs these again, and keeps what the table says of
 * all others.
 */
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { BROWSERS, Browser } from './driver.mjs';
import { runInBrowsers } from './run.mjs';

/** @typedef {import('./run.mjs').Kind} Kind */
/** @typedef {import('./run.mjs').Outcome & {browser: Kind, commit: string}} Outcome */

/** What the last runs have come to. */
const KEPT = fileURLToPath(new URL('../../dist/browsers.json', import.meta.url));
const PAGE = fileURLToPath(new URL('../../docs/evaluation.md', import.meta.url));
const NAMES = { chromium: 'Chromium', firefox: 'Firefox', webkit: 'WebKitGTK' };

/** What a row of the table is about, and how the names of its files begin; the last row has all others. */
const SUBJECTS = /** @type {[string, RegExp][]} */ ([
  ['life, attributes, refusals', /^(life|element\b|settings|values|error|restart|hidden|warm|hostile|input|model)/],
  ['panel, keys, undo', /^(panel|element-panel|controls|keys|undo|history|own|accessible)/],
  ['tools', /^tools/],
  ['objects, children of the element', /^(objects|children|shapes|burning)/],
  ['pointer, fingers, screens', /^(pointer|phone|screens|camera|scale|viewport|quality)/],
  ['links, iframes, policies', /^(share|embed|page-policies|framing)/],
  ['lost contexts, slow and broken networks', /^(recovery|slow|time-limits|preload|wasm-parts)/],
  ['sound, films', /^(sound|record)/],
  ['the library without a canvas', /^sim/],
  ['pages of the site', /./],
]);

/** @param {Outcome[]} outcomes */
function cell(outcomes) {
  const count = (/** @type {Outcome['end']} */ wanted) => outcomes.filter(({ end }) => end === wanted).length;
  const [passed, failed, leftOut] = [count('passed'), count('failed'), count('left out')];
  if (outcomes.length === 0) return 'not run';
  return [
    failed > 0 ? `✗ ${failed} of ${passed + failed} fail` : passed > 0 ? `✓ ${passed}` : '–',
    ...(leftOut > 0 ? [`${leftOut} left out`] : []),
  ].join(', ');
}

/**
 * The table, why tests are left out, and which ones fail.
 * @param {Outcome[]} all @param {Partial<Record<Kind, string>>} versions  Of the browsers that have run.
 */
function tableOf(all, versions) {
  const kinds = /** @type {Kind[]} */ (Object.keys(NAMES)).filter((kind) => versions[kind] !== undefined);
  const subjectOf = (/** @type {Outcome} */ { file }) => SUBJECTS.find(([, files]) => files.test(file))?.[0];
  const row = (/** @type {string[]} */ cells) => `| ${cells.join(' | ')} |`;
  const rows = SUBJECTS.map(([subject]) =>
    row([subject, ...kinds.map((kind) => cell(all.filter((it) => it.browser === kind && subjectOf(it) === subject)))]),
  );
  /** @param {Outcome['end']} end @param {(outcome: Outcome) => string} about */
  const counted = (end, about) => {
    const found = new Map();
    for (const outcome of all.filter((it) => it.end === end)) {
      const line = `${NAMES[outcome.browser]}: ${about(outcome)}`;
      found.set(line, (found.get(line) ?? 0) + 1);
    }
    return [...found].map(([line, count]) => `- ${line}${count > 1 ? ` (${count})` : ''}`);
  };
  const commits = [...new Set(all.map(({ commit }) => commit))];
  const day = new Date().toISOString().slice(0, 10);
  const leftOut = counted('left out', ({ reason }) => reason);
  const failing = counted('failed', ({ file, name }) => `${file}: ${name}`);
  return [
    row(['tests that pass', ...kinds.map((kind) => `${NAMES[kind]} ${versions[kind]}`)]),
    row(['---', ...kinds.map(() => '---')]),
    ...rows,
    '',
    `Run on ${day} at ${commits.join(', ')}.`,
    ...(leftOut.length > 0 ? ['', 'Left out, and why:', '', ...leftOut] : []),
    ...(failing.length > 0 ? ['', 'Failing:', '', ...failing] : []),
  ].join('\n');
}

/** Writes the table into the evaluation. @param {string} table */
function publish(table) {
  const page = readFileSync(PAGE, 'utf8');
  const marks = /(<!-- browsers: begin -->)[\s\S]*(<!-- browsers: end -->)/;
  if (!marks.test(page)) throw new Error('docs/evaluation.md has no marks for browsers');
  writeFileSync(
    PAGE,
    page.replace(marks, (_, begin, end) => `${begin}\n\n${table}\n\n${end}`),
  );
}

const isWhole = process.argv.length === 2 && BROWSERS.length === Object.keys(NAMES).length;
/** @type {{versions: Partial<Record<Kind, string>>, all: Outcome[]}} */
const { versions, all } =
  isWhole || !existsSync(KEPT) ? { versions: {}, all: [] } : JSON.parse(readFileSync(KEPT, 'utf8'));
for (const kind of BROWSERS) {
  const browser = await Browser.start({ kind });
  versions[kind] = await browser.engine.version();
  await browser.close();
}
const commit = execFileSync('git', ['rev-parse', '--short', 'HEAD'], { encoding: 'utf8' }).trim();
/** @type {Outcome[]} */
let kept = all;
// A run that is interrupted has the table of what ended before.
await runInBrowsers((browser, outcomes) => {
  const files = new Set(outcomes.map(({ file }) => file));
  const others = kept.filter((it) => it.browser !== browser || !files.has(it.file));
  kept = [...others, ...outcomes.map((outcome) => ({ ...outcome, browser, commit }))];
  writeFileSync(KEPT, JSON.stringify({ versions, all: kept }));
  publish(tableOf(kept, versions));
});
console.log(tableOf(kept, versions));
