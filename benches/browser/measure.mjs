/**
 * Measures steps of Hearth's wasm and of the paper's loop; runs in a page and
 * in Node alike.
 *
 * A machine has fast and slow phases, so each scene is measured in several
 * rounds, one scene after the other in each round; the best round and the
 * median are told, with the number of neighbours.
 */
import { PaperFire } from './paper.mjs';

/**
 * @typedef {object} Row
 * @property {string} scene
 * @property {number} particles
 * @property {number} neighbours  Of a particle within 2h, on average.
 * @property {number} substeps  Parts of the last step.
 * @property {number} stepMs  Median time of a step.
 * @property {number} bestStepMs  The best round's time of a step.
 * @property {number} [frameMs]  Median time of the steps of a 60 Hz frame.
 */

const ROUNDS = 9;
/** Time that a round of one scene takes, at least [ms]; timers tick coarsely. */
const ROUND_MS = 120;

/**
 * @param {typeof import('hearth_benches').Scene} Scene  The wasm module's class.
 * @returns {Row[]}
 */
export function measureHearth(Scene) {
  const scenes = [
    ['default', Scene.preset('default')],
    ['fine', Scene.fine()],
    ['classic', Scene.preset('classic')],
    ['seed preset', Scene.preset('seed')],
    ['block of 1,000', Scene.block(1000)],
    ['block of 5,000', Scene.block(5000)],
    ['block of 20,000', Scene.block(20_000)],
    ['block of 50,000', Scene.block(50_000)],
  ].map(([scene, fire]) => ({ scene, fire, times: [] }));
  for (let round = 0; round < ROUNDS; round += 1) {
    for (const { fire, times } of scenes) {
      fire.rewind();
      times.push(timeOf(() => fire.step(1)));
    }
  }
  return scenes.map(({ scene, fire, times }) => {
    const row = {
      scene,
      particles: fire.particles(),
      neighbours: fire.neighbours(),
      substeps: fire.substeps(),
      ...summary(times),
    };
    return { ...row, frameMs: row.stepMs * fire.stepsPerFrame() };
  });
}

/**
 * The paper's loop with as many particles: few rounds, for it is slow.
 * @returns {Row[]}
 */
export function measurePaper() {
  return [1000, 5000].map((count) => {
    const fire = new PaperFire(count);
    fire.step();
    const times = Array.from({ length: 3 }, () => timeOf(() => fire.step()));
    return {
      scene: `the paper's loop, ${count.toLocaleString('en')}`,
      particles: count,
      neighbours: fire.neighbours(),
      substeps: 1,
      ...summary(times),
    };
  });
}

/** Time of one call of `act` [ms], over as many calls as a round needs. */
function timeOf(act) {
  act();
  const start = performance.now();
  let calls = 0;
  do {
    act();
    calls += 1;
  } while (performance.now() - start < ROUND_MS);
  return (performance.now() - start) / calls;
}

function summary(times) {
  const sorted = [...times].sort((a, b) => a - b);
  return { stepMs: sorted[sorted.length >> 1], bestStepMs: sorted[0] };
}
