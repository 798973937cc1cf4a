/**
 * Node without a window: every entry point can be imported, none changes global state, and
 * React renders the element.
 */
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { before, test } from 'node:test';
import { promisify } from 'node:util';
import { PACKAGE, installed } from './package.mjs';

/** @type {string} */
let root;
before(async () => {
  root = await installed('react');
});

/** What a program prints, in the project; it must end by itself without a warning. @param {string} program */
async function node(program) {
  const { stdout, stderr } = await promisify(execFile)(process.execPath, ['--input-type=module', '--eval', program], {
    cwd: root,
    timeout: 60_000,
  });
  assert.equal(stderr, '');
  return stdout;
}

/** Entries for an engine, which needs that engine and a window. */
const ENGINES = ['./three', './three/webgpu', './three/react', './pixi', './phaser'];

test('every entry point is imported without a window and touches no global', async () => {
  const manifest = JSON.parse(await readFile(path.join(PACKAGE, 'package.json'), 'utf8'));
  const scripts = Object.entries(manifest.exports)
    .filter(([entry, target]) => target.default?.endsWith('.js') && !ENGINES.includes(entry))
    .map(([entry]) => entry.replace(/^\./, manifest.name));
  assert(scripts.length > 5);
  for (const script of scripts) {
    const output = await node(`
      const describe = () => JSON.stringify(Object.entries(Object.getOwnPropertyDescriptors(globalThis))
        .map(([name, { writable, enumerable, configurable }]) => [name, writable, enumerable, configurable]));
      const before = describe();
      const module = await import('${script}');
      if (describe() !== before) console.log('globals were touched');
      if (typeof window !== 'undefined') console.log('there is a window');
      console.log(Object.keys(module).length > 0);
    `);
    assert.equal(output, 'true\n', script);
  }
});

test('React writes the element into the page of a server', async () => {
  const html = await node(`
    import { createElement } from 'react';
    import { renderToString } from 'react-dom/server';
    import 'hearth-fire/react';
    console.log(renderToString(createElement('hearth-fire', { 'source-width': 0.3, paused: true, controls: false, alt: 'A fire' })));
  `);
  assert.equal(html, '<hearth-fire source-width="0.3" paused="" alt="A fire"></hearth-fire>\n');
});
