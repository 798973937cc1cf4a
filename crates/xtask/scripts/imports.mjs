/**
 * Shorter names between wasm and its script. wasm-bindgen ends each in a hash, so
 * that several versions of one crate may stand in one module; here the rest says
 * enough, and sixteen random letters, once in each file, cannot be compressed.
 */
import { readFile, writeFile } from 'node:fs/promises';

/** wasm's number of the section of imports, and of a function in it. */
const IMPORTS = 2;
const FUNCTION = 0;

/**
 * Renames what `script` gives to `wasm`, in both files.
 * @param {string} script @param {string} wasm
 */
export async function shortenImports(script, wasm) {
  const bytes = await readFile(wasm);
  const { start, end, imports } = importsOf(bytes);
  const names = shortNames(imports.map(({ name }) => name));
  const parts = imports.map(({ module, name, type }) => (
    [text(module), text(names.get(name) ?? name), [FUNCTION], number(type)]
  ));
  const section = [number(imports.length), ...parts.flat()].flatMap((part) => [...part]);
  await writeFile(wasm, Buffer.concat([
    bytes.subarray(0, start), Buffer.from([IMPORTS, ...number(section.length), ...section]), bytes.subarray(end),
  ]));
  const code = await readFile(script, 'utf8');
  await writeFile(script, code.replace(/\b__wb(?:g|indgen)_\w+/g, (name) => names.get(name) ?? name));
}

/**
 * @param {string[]} names
 * @returns {Map<string, string>}
 */
function shortNames(names) {
  const found = new Map();
  const taken = new Set();
  for (const name of names) {
    const plain = name.replace(/_[0-9a-f]{16}$/, '');
    let short = plain;
    for (let at = 1; taken.has(short); at += 1) short = `${plain}${at}`;
    taken.add(short);
    found.set(name, short);
  }
  return found;
}

/** The imports of a module, all of them functions, and where they stand in it. @param {Buffer} bytes */
function importsOf(bytes) {
  let at = 8;
  const read = () => {
    let [value, shift] = [0, 0];
    for (;;) {
      const byte = bytes[at++];
      value += (byte & 0x7f) * 2 ** shift;
      if (byte < 0x80) return value;
      shift += 7;
    }
  };
  const readText = () => {
    const length = read();
    at += length;
    return bytes.toString('utf8', at - length, at);
  };
  while (at < bytes.length) {
    const start = at;
    const id = bytes[at++];
    const length = read();
    const end = at + length;
    if (id !== IMPORTS) {
      at = end;
      continue;
    }
    const imports = Array.from({ length: read() }, () => {
      const [module, name] = [readText(), readText()];
      if (bytes[at++] !== FUNCTION) throw new Error(`${name} is imported and no function`);
      return { module, name, type: read() };
    });
    return { start, end, imports };
  }
  throw new Error('there is no wasm that imports anything');
}

/** A number as wasm writes it. @param {number} value */
function number(value) {
  const bytes = [];
  for (let rest = value; ; rest = Math.floor(rest / 128)) {
    if (rest < 128) return [...bytes, rest];
    bytes.push((rest % 128) + 128);
  }
}

/** A text as wasm writes it. @param {string} words */
function text(words) {
  const bytes = Buffer.from(words);
  return [...number(bytes.length), ...bytes];
}
