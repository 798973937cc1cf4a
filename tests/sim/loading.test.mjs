/**
 * Loading of the wasm, and memory of simulations.
 */
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { ARRAYS, WEB, fires, load } from './library.mjs';

const FILE = path.join(WEB, 'wasm/hearth-sim_bg.wasm');

test('a freed simulation throws, and other ones go on', async () => {
  const [sim, other] = await fires();
  sim.free();
  sim.free();
  const calls = [
    () => sim.time,
    () => sim.step(),
    () => sim.set('gravity', 5),
    () => sim.embers(),
    () => sim.setParticles({ positions: [] }),
    () => sim.addObject({ kind: 'source' }),
    ...Object.keys(ARRAYS).map((name) => () => sim[name]()),
  ];
  for (const call of calls) assert.throws(call, /this simulation was freed/);
  other.step(10);
  assert.ok(other.count > 0);
  if (Symbol.dispose) {
    other[Symbol.dispose]();
    assert.throws(() => other.step(), /this simulation was freed/);
  }
});

test('free releases memory: hundreds of simulations need no more than a few', () => {
  // A separate process, whose memory no other test uses.
  const script = `
    const { instantiate } = WebAssembly;
    let memory;
    WebAssembly.instantiate = async (...of) => {
      const made = await instantiate(...of);
      ({ memory } = made.exports);
      return made;
    };
    const { createSimulation } = await import(${JSON.stringify(pathToFileURL(path.join(WEB, 'sim.js')).href)});
    const burn = async () => {
      const sim = await createSimulation({ params: { particles: 5000 } });
      sim.step(2);
      sim.setParticles(sim.particles());
      sim.free();
    };
    for (let i = 0; i < 10; i += 1) await burn();
    const before = memory.buffer.byteLength;
    for (let i = 0; i < 300; i += 1) await burn();
    console.log(before, memory.buffer.byteLength);
  `;
  const printed = execFileSync(process.execPath, ['--input-type=module', '-e', script], { encoding: 'utf8' });
  const [before, after] = printed.trim().split(' ').map(Number);
  assert.ok(before > 0);
  assert.equal(after, before);
});

test('what there is no memory for is refused, and all simulations go on', () => {
  const script = `
    import assert from 'node:assert/strict';
    import { readFileSync } from 'node:fs';
    import { confined } from ${JSON.stringify(new URL('../confined.mjs', import.meta.url).href)};
    const { createSimulation } = await import(${JSON.stringify(pathToFileURL(path.join(WEB, 'sim.js')).href)});
    const wasm = confined(readFileSync(${JSON.stringify(FILE)}), 64 * 2 ** 20);
    const small = await createSimulation({ wasm, params: { model: 'classic', max_particles: 1000 } });
    small.step(10);
    const large = [];
    const makeMore = async () => {
      for (let i = 0; i < 100; i += 1) {
        const sim = await createSimulation({ params: { particles: 20000 } });
        large.push(sim);
        sim.step();
      }
    };
    const refused = /no memory left for so many/;
    await assert.rejects(makeMore(), refused);
    assert.ok(large.length >= 1);
    assert.throws(() => small.set('max_particles', 100000), refused);
    const many = Object.fromEntries(Object.entries(small.particles()).map(([name, values]) => (
      [name, new Float32Array(60000 * values.length / small.count).fill(values[0])]
    )));
    assert.throws(() => small.setParticles(many), refused);
    for (const sim of [small, ...large]) {
      sim.step(2);
      assert.ok(sim.temperatures().every((kelvin) => kelvin > 0));
    }
    for (const sim of large) sim.free();
    const next = await createSimulation({ params: { particles: 20000 } });
    next.step();
    console.log('done');
  `;
  const printed = execFileSync(process.execPath, ['--input-type=module', '-e', script], { encoding: 'utf8' });
  assert.equal(printed.trim(), 'done');
});

test('the wasm can be a URL, bytes or a compiled module', async () => {
  const url = pathToFileURL(FILE);
  const bytes = readFileSync(FILE);
  const buffer = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length);
  const compiled = await WebAssembly.compile(bytes);
  for (const [at, wasm] of [url, url.href, bytes, buffer, compiled].entries()) {
    // A new script, which has not loaded wasm, with the shared glue, which has.
    const { createSimulation: create } = await load('sim.js', `?${at}`);
    const sim = await create({ wasm, params: { particles: 1000 } });
    sim.step();
    assert.ok(sim.count > 0);
    sim.free();
  }
});

test('wasm that cannot be loaded is an error, and the next call can try again', () => {
  const script = `
    import assert from 'node:assert/strict';
    const { createSimulation } = await import(${JSON.stringify(pathToFileURL(path.join(WEB, 'sim.js')).href)});
    const wrong = [
      [5, /wasm must be a URL, bytes or a WebAssembly.Module, not 5/],
      [{}, /wasm must be a URL, bytes or a WebAssembly.Module, not an object/],
      ['nowhere.wasm', /could not be loaded: .*URL/],
      [new URL('nowhere.wasm', ${JSON.stringify(pathToFileURL(FILE).href)}), /could not be loaded: .*ENOENT/],
      [new Uint8Array([1, 2, 3]), /could not be loaded: CompileError/],
      [new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0]), /could not be loaded: .*something else/],
    ];
    // One after another, and all at once with a good one among them.
    for (const [wasm, words] of wrong) await assert.rejects(createSimulation({ wasm }), words);
    const all = await Promise.allSettled([...wrong.map(([wasm]) => createSimulation({ wasm })), createSimulation()]);
    assert.deepEqual(all.map(({ status }) => status), [...wrong.map(() => 'rejected'), 'fulfilled']);
    all.at(-1).value.step();
    console.log('done');
  `;
  const printed = execFileSync(process.execPath, ['--input-type=module', '-e', script], { encoding: 'utf8' });
  assert.equal(printed.trim(), 'done');
});
