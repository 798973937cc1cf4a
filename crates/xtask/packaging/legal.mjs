/**
 * `node legal.mjs FOLDER` writes into a folder of the site `THIRD-PARTY.txt`, the notices of other people's
 * code in the wasm modules, and `hearth-fire.cdx.json`, their bill of materials. `node legal.mjs --command
 * FOLDER` writes the notices of the command `hearth`. Without a folder, it is that of Trunk's hook, or the
 * crate of the command. All follow from `Cargo.lock`: the same on every machine.
 */
import { readFileSync, readdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { COMMAND, WASM, compiled, order } from './crates.mjs';

const ROOT = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../../..');
const APACHE = text('LICENSE-APACHE');
const FONT = { name: 'Ubuntu Light derivative Hearth', licence: 'LicenseRef-UFL-1.0' };

/**
 * The parts of the Rust standard library that wasm contains. Their versions are those of the
 * compiler, and they have no files: their licence is the Apache License.
 */
const STANDARD = [
  { name: 'Rust standard library', licence: 'MIT OR Apache-2.0', authors: ['The Rust Project contributors'] },
  {
    name: 'compiler_builtins',
    licence: 'MIT AND Apache-2.0 WITH LLVM-exception',
    authors: ['The Rust Project contributors'],
  },
  { name: 'cfg-if', licence: 'MIT OR Apache-2.0', authors: ['Alex Crichton'] },
  { name: 'dlmalloc', licence: 'MIT OR Apache-2.0', authors: ['Alex Crichton'] },
  { name: 'hashbrown', licence: 'MIT OR Apache-2.0', authors: ["Amanieu d'Antras"] },
];

/** The parts of the standard library that a native program contains besides those of wasm. */
const NATIVE_STANDARD = [
  { name: 'addr2line', licence: 'Apache-2.0 OR MIT', authors: ['the gimli project contributors'] },
  { name: 'adler2', licence: '0BSD OR MIT OR Apache-2.0', authors: ['Jonas Schievink', 'oyvindln'] },
  { name: 'gimli', licence: 'MIT OR Apache-2.0', authors: ['the gimli project contributors'] },
  { name: 'libc', licence: 'MIT OR Apache-2.0', authors: ['The Rust Project contributors'] },
  { name: 'miniz_oxide', licence: 'MIT OR Zlib OR Apache-2.0', authors: ['Frommi', 'oyvindln'] },
  { name: 'object', licence: 'Apache-2.0 OR MIT', authors: ['the gimli project contributors'] },
  { name: 'rustc-demangle', licence: 'MIT OR Apache-2.0', authors: ['Alex Crichton'] },
];

/** @typedef {import('./crates.mjs').Crate} Crate */

const [first, second] = process.argv.slice(2);
if (first === '--command') {
  const standard = [...STANDARD.filter(({ name }) => name !== 'dlmalloc'), ...NATIVE_STANDARD];
  const content = notices('The command hearth contains', compiled(ROOT, COMMAND), standard, []);
  writeFileSync(path.join(second ?? path.join(ROOT, 'crates/hearth-cli'), 'THIRD-PARTY.txt'), content);
} else {
  const folder = first ?? path.join(process.env.TRUNK_STAGING_DIR ?? '', 'web');
  const crates = compiled(ROOT, WASM);
  const font = {
    licence: text('crates/hearth-panel/font/LICENCE.txt'),
    name: `${FONT.name}, the font of the panel, a part of Ubuntu Light`,
  };
  writeFileSync(path.join(folder, 'THIRD-PARTY.txt'), notices('Its wasm modules contain', crates, STANDARD, [font]));
  writeFileSync(path.join(folder, 'hearth-fire.cdx.json'), materials(crates));
}

/**
 * Each text once, below the names of those whose text it is.
 * @param {string} what  What contains the code.
 * @param {Crate[]} contained
 * @param {typeof STANDARD} standard
 * @param {{licence: string, name: string}[]} others
 */
function notices(what, contained, standard, others) {
  /** @type {Map<string, {licence: string, names: string[]}>} */
  const owners = new Map();
  const add = (/** @type {string} */ licence, /** @type {string} */ name) => {
    // Copies differ in their line breaks.
    const flat = licence.replace(/\s+/g, ' ').trim();
    owners.set(flat, { licence, names: [...(owners.get(flat)?.names ?? []), name] });
  };
  for (const { name, licence, authors } of standard) add(APACHE, `${name}, ${licence}, by ${authors.join(', ')}`);
  for (const crate of contained) {
    const by = crate.authors.length ? `, by ${crate.authors.join(', ')}` : '';
    for (const licence of textsOf(crate)) add(licence, `${crate.name} ${crate.version}, ${crate.licence}${by}`);
  }
  for (const { licence, name } of others) add(licence, name);
  const parts = [...owners.values()].map(
    ({ licence, names }) => `${names.sort(order).join('\n')}\n\n${licence.replace(/^\n+/, '').trimEnd()}\n`,
  );
  const rule = `\n${'='.repeat(80)}\n\n`;
  return [
    'Third-party notices of Hearth\n\n' +
      `Hearth is licensed under MIT or Apache-2.0, at your option. ${what}\n` +
      'the code below. Each licence follows the names of what it covers.\n',
    ...parts.sort(order),
  ].join(rule);
}

/**
 * The texts that a crate's licence requires in copies. Where it is a choice, MIT's is
 * enough, because it names the owners of the copyright.
 * @param {Crate} crate
 */
function textsOf({ name, licence, folder }) {
  const files = readdirSync(folder).filter((file) => /^(LICEN[CS]E|COPYING|COPYRIGHT|NOTICE|UNLICENSE)/i.test(file));
  const choice = / OR /.test(licence);
  const mit = choice && files.some((file) => /MIT/i.test(file));
  const unneeded = mit ? /APACHE|GPL|UNLICENSE|0BSD|ZLIB|BSD/i : /GPL/i;
  const texts = files
    .filter((file) => !choice || !unneeded.test(file))
    .sort(order)
    .map((file) => tidy(readFileSync(path.join(folder, file), 'utf8')));
  if (texts.length) return texts;
  if (!/Apache-2\.0/.test(licence)) throw new Error(`${name}: no file with its licence, ${licence}`);
  return [APACHE];
}

/** CycloneDX 1.6, without a time or a number of its own. @param {Crate[]} crates */
function materials(crates) {
  const { name, license } = JSON.parse(text('web/package.json'));
  const [, version] = /^version = "(.*)"/m.exec(text('Cargo.toml')) ?? [];
  const licences = (/** @type {string} */ expression) => [{ expression }];
  const content = {
    bomFormat: 'CycloneDX',
    specVersion: '1.6',
    version: 1,
    metadata: {
      component: {
        type: 'library',
        'bom-ref': `pkg:npm/${name}@${version}`,
        name,
        version,
        licenses: licences(license),
        purl: `pkg:npm/${name}@${version}`,
      },
    },
    components: [
      ...crates.map(({ name: crate, version: released, licence, checksum }) => {
        const purl = `pkg:cargo/${crate}@${released}`;
        const hashes = [{ alg: 'SHA-256', content: checksum }];
        return {
          type: 'library',
          'bom-ref': purl,
          name: crate,
          version: released,
          hashes,
          licenses: licences(licence),
          purl,
        };
      }),
      ...STANDARD.map(({ name: part, licence }) => ({
        type: 'library',
        'bom-ref': `rust:${part}`,
        name: part,
        group: 'rust',
        licenses: licences(licence),
      })),
      {
        type: 'data',
        'bom-ref': 'font',
        name: FONT.name,
        licenses: [{ license: { name: 'Ubuntu Font Licence 1.0' } }],
      },
    ],
  };
  return `${JSON.stringify(content, null, 1)}\n`;
}

/** @param {string} file */
function text(file) {
  return tidy(readFileSync(path.join(ROOT, file), 'utf8'));
}

/** The same line ends and no blanks at them, so that equal texts are equal. @param {string} content */
function tidy(content) {
  return content.replace(/[^\S\n]+$/gm, '').replace(/^\uFEFF/, '');
}
