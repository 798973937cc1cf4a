/**
 * Compares the JavaScript baselines with Hearth: after the same steps of the same block,
 * densities and velocities agree to a thousandth. Standard input is the output of `native
 * gas`.
 */
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { parse, value } from './lines.mjs';
import { ScanFire } from './scan.mjs';
import { TypedFire } from './typed.mjs';
import { PaperLoop } from '../../web/paper/bench/paper-loop.js';

const TOLERANCE = 1e-3;

/** The greatest difference, as a share of the greatest number. */
function difference(expected, given) {
  assert.equal(given.length, expected.length);
  const greatest = expected.reduce((most, x) => Math.max(most, Math.abs(x)), 0);
  const apart = expected.reduce((most, x, i) => Math.max(most, Math.abs(x - given[i])), 0);
  assert.ok(greatest > 0, 'there is nothing to compare');
  return apart / greatest;
}

const { steps, start, end } = JSON.parse(readFileSync(0, 'utf8'));
for (const Fire of [TypedFire, ScanFire, PaperLoop]) {
  const fire = new Fire(start);
  // What a round leaves behind must not change the next one.
  for (let round = 0; round < 2; round += 1) {
    fire.rewind();
    for (let step = 0; step < steps; step += 1) fire.step();
  }
  const state = fire.state();
  for (const what of ['densities', 'velocities']) {
    const apart = difference(end[what], state[what]);
    const result = `${Fire.name}: ${what} differ by ${apart.toExponential(1)} of the greatest`;
    assert.ok(apart <= TOLERANCE, `${result}, more than ${TOLERANCE}`);
    console.log(result);
  }
}

const printed =
  'Loading 3 files, N=many\nA solver,where=node,N=5000,neigh=19.40,median_ms=1.5,min_ms=1.4\n' +
  'B,N=1000,median_ms=0.25\nC,N=1000,median_ms=fast\n';
assert.deepEqual(parse(printed), [
  { name: 'A solver', where: 'node', particles: 5000, neighbours: 19.4, stepMs: 1.5 },
  { name: 'B', where: 'native', particles: 1000, neighbours: undefined, stepMs: 0.25 },
]);
assert.equal(value('x,gflops=2.5\n', 'gflops'), 2.5);
assert.equal(value('x,gflops=2.5\n', 'bytes'), undefined);
