/**
 * Faults of browser, graphics, network and engine, one after another: `cargo measure faults`, or
 * `cargo measure faults losses gpu` for some sections. After each fault, the fire burns again or its
 * visitor reads why not. The command fails if one fire does neither.
 *
 * The first argument is the file of the table, in which rows of other sections stay; the others are sections.
 */
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { callsOf, memory } from './faults/calls.mjs';
import { command } from './faults/command.mjs';
import { elements } from './faults/elements.mjs';
import { gpu } from './faults/gpu.mjs';
import { graphics } from './faults/graphics.mjs';
import { losses } from './faults/losses.mjs';
import { network } from './faults/network.mjs';
import { patience } from './faults/patience.mjs';

/** @type {{[section: string]: {find: () => AsyncGenerator<import('./faults/outcome.mjs').Finding>, what: string}}} */
const SECTIONS = {
  losses: { find: losses, what: 'lost contexts: 100 on each thread of each browser' },
  gpu: { find: gpu, what: 'crashes of the process for graphics (Chromium)' },
  elements: { find: elements, what: 'groups of 20 elements that come and go (Chromium)' },
  network: { find: network, what: 'files that fail, each in seven ways (Chromium)' },
  graphics: { find: graphics, what: 'WebGL2 functions that fail, in worker and page (Chromium)' },
  patience: {
    find: patience,
    what: 'breakpoint, hidden tab, suspended computer, 20 times slower processor (Chromium)',
  },
  webgl: { find: callsOf('webgl'), what: 'one call of WebGL2 that throws (Chromium)' },
  fetch: { find: callsOf('fetch'), what: 'one fetch that fails (Chromium)' },
  message: { find: callsOf('message'), what: 'one message that is not posted (Chromium)' },
  allocation: { find: callsOf('allocation'), what: 'one array, buffer or blob without memory (Chromium)' },
  canvas: { find: callsOf('canvas'), what: 'one canvas, context or bitmap that is not made (Chromium)' },
  memory: { find: memory, what: 'wasm that grows no more (Chromium)' },
  command: { find: command, what: 'one system call of `hearth film` that fails' },
};

const [file, ...names] = process.argv.slice(2);
const unknown = names.filter((name) => !(name in SECTIONS));
if (!file || unknown.length > 0) {
  throw new Error(
    `the arguments are a file and sections (${Object.keys(SECTIONS).join(', ')}), not ${[file, ...unknown].join(', ')}`,
  );
}
const before = existsSync(file) ? readFileSync(file, 'utf8').split('\n') : [];
const head = ['| fault | number | burns again | reason shown | silent | commit |', '|---|---:|---:|---:|---:|---|'];
const rows = new Map(
  Object.entries(SECTIONS).map(([section, { what }]) => [section, before.find((row) => row.startsWith(`| ${what} |`))]),
);
for (const [section, { find, what }] of Object.entries(SECTIONS)) {
  if (names.length > 0 && !names.includes(section)) continue;
  const counts = { burns: 0, reported: 0, silent: 0 };
  for await (const { fault, outcome, detail } of find()) {
    counts[outcome] += 1;
    if (outcome === 'silent') process.exitCode = 1;
    console.log(`${section}: ${fault}: ${outcome}${detail ? ` (${detail})` : ''}`);
  }
  const { burns, reported, silent } = counts;
  const { HEARTH_COMMIT: commit = '' } = process.env;
  rows.set(section, `| ${what} | ${burns + reported + silent} | ${burns} | ${reported} | ${silent} | ${commit} |`);
  console.log(rows.get(section));
  // A section that ends with an error, hours later, leaves the rows before.
  writeFileSync(file, `${[...head, ...rows.values()].filter(Boolean).join('\n')}\n`);
}
