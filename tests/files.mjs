/**
 * Runs test files, `NAME.test.mjs`: those of some folders, or only those whose names begin with the words on the
 * command line. A word that is a folder's name stands for all of its files.
 */
import { readdirSync } from 'node:fs';
import path from 'node:path';
import { run } from 'node:test';
import { spec as Spec } from 'node:test/reporters';

/** The longest that a file may take [min], several times what the longest takes. */
const FILE_MINUTES = 10;

/**
 * How a test ended.
 * @typedef {object} Outcome
 * @property {string} file  Its name without `.test.mjs`.
 * @property {string} name
 * @property {'passed' | 'failed' | 'left out'} end
 * @property {string} reason  Why it is left out.
 * @property {number} seconds
 */

/**
 * Runs the files, and returns how each test ended.
 * @param {string[]} folders  Absolute paths.
 * @param {number} [concurrency]  Files that run at a time.
 * @returns {Promise<Outcome[]>}
 */
export async function runTests(folders, concurrency = 2) {
  const words = process.argv.slice(2).filter((argument) => !argument.startsWith('-'));
  const chosen = (/** @type {string} */ file) =>
    words.some((word) => path.basename(file).startsWith(word) || path.basename(path.dirname(file)) === word);
  const files = folders
    .flatMap((folder) => readdirSync(folder).map((name) => path.join(folder, name)))
    .filter((file) => file.endsWith('.test.mjs') && (words.length === 0 || chosen(file)));
  // Without files, Node would run every test that it finds.
  if (files.length === 0) throw new Error(`no test file begins with ${words.join(' or ')}`);
  const events = run({ files, concurrency, timeout: FILE_MINUTES * 60_000 });
  /** @type {Outcome[]} */
  const outcomes = [];
  /** @type {any} */
  const read = events.compose((/** @type {AsyncIterable<any>} */ source) => judged(source, outcomes));
  read.compose(new Spec()).pipe(process.stdout, { end: false });
  await new Promise((resolve) => {
    events.on('end', resolve);
  });
  console.log(`Seconds of tests: ${durations(outcomes)}.`);
  if (outcomes.some(({ end }) => end === 'failed')) process.exitCode = 1;
  return outcomes;
}

/** How long the tests of each file took, the longest first. @param {Outcome[]} outcomes */
function durations(outcomes) {
  /** @type {Map<string, number>} */
  const files = new Map();
  for (const { file, seconds } of outcomes) files.set(file, (files.get(file) ?? 0) + seconds);
  const sorted = [...files].sort(([, one], [, other]) => other - one);
  return sorted.map(([file, seconds]) => `${file} ${Math.round(seconds)}`).join(', ');
}

/** Why a file failed as a whole. @param {string | undefined} type  Of the failure, in Node's words. */
const failureOf = (type) =>
  type === 'testTimeoutFailure' ? `does not end within ${FILE_MINUTES} minutes` : 'ends before its tests';

/**
 * Reads the outcomes, and hands on the events: a test that throws `left out: …` becomes one that is skipped, with the
 * group around it unless another one of the file failed.
 * @param {AsyncIterable<any>} source @param {Outcome[]} outcomes
 */
async function* judged(source, outcomes) {
  for await (const { type, data } of source) {
    if (type !== 'test:pass' && type !== 'test:fail') {
      yield { type, data };
      continue;
    }
    const { details } = data;
    const { failureType, cause } = details.error ?? {};
    const file = path.basename(data.file ?? data.name, '.test.mjs');
    const name = data.name.endsWith('.test.mjs') ? failureOf(failureType) : data.name;
    const [, leftOut] = String(cause?.message ?? cause).match(/^left out: (.*)/) ?? [];
    const isGroup = details.type === 'suite' || failureType === 'subtestsFailed';
    const failed = isGroup
      ? outcomes.some((outcome) => outcome.file === file && outcome.end === 'failed')
      : leftOut === undefined;
    const reason = leftOut ?? data.skip;
    const end = type === 'test:fail' && failed ? 'failed' : reason ? 'left out' : 'passed';
    const seconds = details.duration_ms / 1000;
    if (!isGroup) outcomes.push({ file, name, end, reason: String(reason ?? ''), seconds });
    yield end === 'failed'
      ? { type, data }
      : { type: 'test:pass', data: { ...data, skip: reason, details: { ...details, error: undefined } } };
  }
}
