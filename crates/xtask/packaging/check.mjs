/**
 * Checks the package: `node check.mjs PACKAGE SCRATCH`. Every entry point exists, npm packs
 * exactly the files that they reach, without a warning, no file names a folder of this
 * machine, and a strict compiler accepts the types.
 */
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { cp, readFile, rm, stat, symlink, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { machinePaths } from './bytes.mjs';
import { pictures, reached, typesReached } from './graph.mjs';
import { DOCS, beginningsOf, entries, typesOf } from './manifest.mjs';

const HERE = path.dirname(fileURLToPath(import.meta.url));
const run = promisify(execFile);

/** The files that are not code. */
const DOCUMENTS = [
  'LICENSE-APACHE',
  'LICENSE-FONT',
  'LICENSE-MIT',
  'README.md',
  'THIRD-PARTY.txt',
  'custom-elements.json',
  'hearth-fire.cdx.json',
  'package.json',
  ...DOCS,
];

const [folder, scratch] = process.argv.slice(2).map((name) => path.resolve(name));
if (!scratch) throw new Error('usage: node check.mjs PACKAGE SCRATCH');
const manifest = JSON.parse(await readFile(path.join(folder, 'package.json'), 'utf8'));

await entryPointsAreThere();
await packsExactly();
await linksEnd();
assert.deepEqual(await machinePaths(folder), []);
await typesCompile();
console.log('The package is whole: entry points, files, links and types.');

async function entryPointsAreThere() {
  assert.equal(manifest.private, undefined, 'package.json is private');
  assert.equal(manifest.dependencies, undefined, 'the package has dependencies');
  for (const { entry, target, types } of entries(manifest)) {
    for (const file of [target, types].filter((name) => name !== undefined)) {
      const about = await stat(path.join(folder, file)).catch(() => undefined);
      assert(about?.isFile(), `exports["${entry}"] names ${file}, which is not there`);
    }
    assert(!target.endsWith('.js') || types, `exports["${entry}"] has no types`);
  }
  await worksWithoutExports();
  for (const name of manifest.sideEffects) await stat(path.join(folder, name));
}

/** Tools that read no `exports` find the same files: by `main`, by the address, or by a folder's own package.json. */
async function worksWithoutExports() {
  for (const { entry, target, types } of entries(manifest)) {
    const beside = await json(path.join(folder, entry, 'package.json'));
    const found = beside
      ? { target: path.posix.join(entry, beside.main), types: path.posix.join(entry, beside.types) }
      : { target: types ? `${entry}.js` : entry, types: types && `${entry}.d.ts` };
    assert.deepEqual(
      [found.target, found.types].map((file) => file && path.posix.normalize(file)),
      [target, types].map((file) => file && path.posix.normalize(file)),
      `exports["${entry}"] is another file for tools that read no exports`,
    );
  }
}

/** The package.json at that place, if there is one. @param {string} file @returns {Promise<any>} */
async function json(file) {
  return JSON.parse(await readFile(file, 'utf8').catch(() => 'null'));
}

/** npm's own list of what it would publish, and its warnings. */
async function packsExactly() {
  const { stdout, stderr } = await run(npm(), ['pack', '--dry-run', '--json'], {
    cwd: folder,
    shell: process.platform === 'win32',
  });
  // Warnings about the settings of this user or this environment are not the package's.
  const warnings = stderr
    .split('\n')
    .filter((line) => /^npm (warn|error)/i.test(line) && !/Unknown \w+ config/.test(line));
  assert.deepEqual(warnings, []);
  const packed = JSON.parse(stdout)[0]
    .files.map((file) => file.path)
    .sort();
  const wanted = [
    ...DOCUMENTS,
    'hearth-fire.inline.js',
    'inline/package.json',
    ...(await reached(folder, beginningsOf(manifest))),
    ...(await typesReached(folder, typesOf(manifest))),
    ...(await pictures(folder)),
  ];
  assert.deepEqual(packed, [...new Set(wanted)].sort());
}

/** Every relative link of the documents leads to a file of the package. */
async function linksEnd() {
  for (const document of DOCUMENTS.filter((name) => name.endsWith('.md'))) {
    const text = await readFile(path.join(folder, document), 'utf8');
    for (const [, link] of text.matchAll(/\]\(([^)#:]+)(?:#[^)]*)?\)/g)) {
      const file = path.join(folder, path.dirname(document), link);
      await stat(file).catch(() => assert.fail(`${document} links to ${link}, which is not in the package`));
    }
  }
}

/** Compiles programs as users write them, and the element's manifest, in the strictest mode. */
async function typesCompile() {
  const modules = path.join(scratch, 'node_modules');
  await rm(scratch, { recursive: true, force: true });
  await cp(folder, path.join(modules, manifest.name), { recursive: true });
  await cp(path.join(HERE, 'types'), scratch, { recursive: true });
  await cp(path.join(HERE, '../scripts/peers.d.ts'), path.join(scratch, 'peers.d.ts'));
  await symlink(path.join(HERE, 'node_modules/@types'), path.join(modules, '@types'), 'junction');
  await symlink(
    path.join(HERE, 'node_modules/custom-elements-manifest'),
    path.join(modules, 'custom-elements-manifest'),
    'junction',
  );
  const elements = await readFile(path.join(folder, manifest.customElements), 'utf8');
  await writeFile(path.join(scratch, 'manifest.ts'), manifestProgram(elements));
  const shipped = await typesReached(folder, typesOf(manifest));
  for (const resolution of ['bundler', 'nodenext']) {
    const config = {
      compilerOptions: {
        strict: true,
        exactOptionalPropertyTypes: true,
        noUncheckedIndexedAccess: true,
        noEmit: true,
        target: 'es2022',
        module: resolution === 'bundler' ? 'esnext' : 'nodenext',
        moduleResolution: resolution,
        lib: ['es2022', 'dom', 'dom.iterable'],
        jsx: 'react-jsx',
        types: [],
      },
      // The declarations themselves too: what an import pulls in, some compilers skip.
      files: [
        'use.ts',
        'react.tsx',
        'manifest.ts',
        'peers.d.ts',
        ...shipped.map((file) => `node_modules/${manifest.name}/${file}`),
      ],
    };
    const name = path.join(scratch, `tsconfig.${resolution}.json`);
    await writeFile(name, JSON.stringify(config));
    const compiler = path.join(HERE, '../scripts/node_modules/typescript/bin/tsc');
    await run(process.execPath, [compiler, '--project', name], { cwd: scratch }).catch(({ stdout }) => {
      assert.fail(`the types do not compile (${resolution}):\n${stdout}`);
    });
  }
}

/**
 * A program that compiles only where custom-elements.json has the form that its
 * format asks for, and names exactly the members and events of the types.
 * @param {string} elements
 */
function manifestProgram(elements) {
  const whole = JSON.parse(elements);
  const [declaration] = whole.modules[0].declarations;
  const { members, events } = declaration;
  // The types of the format give a custom element the members of a plain class.
  declaration.members = [];
  const table = (/** @type {{name: string}[]} */ list) => `{ ${list.map(({ name }) => `'${name}': true`).join(', ')} }`;
  return `
    import type { ClassMethod, CustomElementField, Package } from 'custom-elements-manifest';
    import type { HearthFire, HearthFireEvents } from 'hearth-fire';
    export const manifest: Package = ${JSON.stringify(whole)};
    export const declared: (CustomElementField | ClassMethod)[] = ${JSON.stringify(members)};
    type Own<All, Inherited> = Record<Exclude<keyof All, keyof Inherited>, true>;
    export const members: Own<HearthFire, HTMLElement> = ${table(members.filter((member) => !member.static))};
    export const ofClass: Own<typeof HearthFire, typeof HTMLElement> = ${table(members.filter((member) => member.static))};
    export const events: Record<keyof HearthFireEvents, true> = ${table(events)};
  `;
}

function npm() {
  return process.platform === 'win32' ? 'npm.cmd' : 'npm';
}
