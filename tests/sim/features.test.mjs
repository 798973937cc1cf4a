/**
 * Every feature of the platform that the library needs besides the language is checked: without it, `createSimulation`
 * rejects with the kind `unsupported`. Without any other one, a simulation gives the same bits.
 */
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { promisify } from 'node:util';
import { WEB } from './library.mjs';

const { NEEDED } = await import('../../web/sim/loading.js');

/** What all of the library gives, as text. It runs in a process of its own. */
const PROGRAM = `
  const before = { exit: process.exit, write: console.log };
  const { readFileSync } = await import('node:fs');
  const wasm = readFileSync(new URL('./wasm/hearth-sim_bg.wasm', FOLDER));
  REMOVE
  let told;
  try {
    const { createSimulation } = await import(FOLDER + 'sim.js');
    const { createSynthesis } = await import(FOLDER + 'sound.js');
    const { toQuery, fromQuery } = await import(FOLDER + 'share.js');
    const sim = await createSimulation({ preset: 'burning-logs', seed: 3, GIVEN });
    sim.set({ wind: 0.2 });
    sim.step(20);
    const series = sim.series();
    const sound = await createSynthesis();
    sound.push(series);
    const samples = [new Float32Array(64), new Float32Array(64)];
    sound.render(...samples);
    let refused;
    try { sim.set('wind', 1e9); } catch ({ message }) { refused = message; }
    const particles = sim.particles();
    sim.setParticles(particles);
    sim.addObject({ kind: 'solid', motion: 'free' });
    sim.spray(0, 1);
    sim.step();
    told = [sim.time, sim.count, sim.get('wind'), sim.objects.length, refused, fromQuery(toQuery({ values: { wind: 1 } })).config,
      ...[...particles.positions, ...sim.embers().positions, ...samples[0], sim.freeSolids().length, sim.fuels().length].map(String)];
    sim.free();
    const classic = await createSimulation({ model: 'classic' });
    classic.step(3);
    told.push(classic.time);
  } catch (error) {
    told = \`\${error.kind}: \${error.message}\`;
  }
  before.write(JSON.stringify(told));
  before.exit();
`;

/** What the program gives without a feature. @param {string} feature @param {string} [given]  Options. */
async function without(feature, given = 'wasm') {
  const [owner, name] = feature.includes('.') ? feature.split(/\.(?=[^.]*$)/) : ['globalThis', feature];
  const remove =
    feature &&
    `Reflect.deleteProperty(${owner}, '${name}')
    || Object.defineProperty(${owner}, '${name}', { value: undefined });`;
  const folder = JSON.stringify(`${pathToFileURL(WEB)}/`);
  const program = PROGRAM.replace('REMOVE', remove).replaceAll('FOLDER', folder).replace('GIVEN', given);
  const { stdout } = await promisify(execFile)(process.execPath, ['--input-type=module', '--eval', program], {
    timeout: 60_000,
  });
  return JSON.parse(stdout);
}

const whole = await without('');
assert.ok(whole.length > 1000, whole);

for (const feature of NEEDED) {
  test(`without ${feature} no simulation begins, with the reason`, async () => {
    assert.match(await without(feature), RegExp(`^unsupported: This program has no ${feature.replace('.', '\\.')},`));
  });
}

for (const feature of [
  'AbortSignal',
  'Array.prototype.at',
  'Blob',
  'fetch',
  'process',
  'setTimeout',
  'structuredClone',
]) {
  test(`without ${feature} a simulation is the same`, async () => {
    assert.deepEqual(await without(feature), whole);
  });
}

test('without a way to read files a simulation begins with the bytes of its wasm, or names the file', async () => {
  assert.match(await without('fetch', 'wasm: "https://a.example/sim.wasm"'), /could not be loaded: .*fetch/);
});

test('without SIMD the error names it', async () => {
  // The first four bytes are those of any module.
  const given = 'wasm: Uint8Array.from([0, 97, 115, 109, 1, 0, 0, 0, 255])';
  assert.match(await without('', given), /could not be loaded: CompileError.*it needs SIMD/);
});
