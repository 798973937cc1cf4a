/** Random values stay near those of the scene and within their ranges, for every scene. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { PARAMETERS, PRESETS } from '../../web/parameters.js';
import { STRENGTHS, otherScene, randomValues } from '../../web/editing/random-values.js';

/** The largest ratio of the power to that of the scene, by strength. */
const FAR = { mild: 3, bold: 3.4, wild: 3.4 };

/** A fire that shows a scene. */
function fireOf({ name, values }) {
  const model = values.model ?? 'combustion';
  const entries = PARAMETERS.map(({ id, domains }) => [id, values[id] ?? domains[model]?.default]);
  return { preset: name, params: { ...Object.fromEntries(entries), model }, objects: [] };
}

/** Numbers of 0 to 1 that come again with the same seed. */
function numbers(seed) {
  let state = seed;
  return () => {
    state = (state * 1_664_525 + 1_013_904_223) % 2 ** 32;
    return state / 2 ** 32;
  };
}

for (const [preset, strength] of PRESETS.flatMap((of) => STRENGTHS.map((by) => /** @type {const} */ ([of, by])))) {
  test(`${strength} ones of ${preset.name}: in range, of its character, and never the same twice`, () => {
    const fire = fireOf(preset);
    const seen = new Set();
    for (let seed = 1; seed <= 50; seed += 1) {
      const values = randomValues(fire, strength, numbers(seed * 7_919));
      seen.add(JSON.stringify(values));
      for (const [id, value] of Object.entries(values)) {
        const { min, max } = PARAMETERS.find((entry) => entry.id === id).domains[fire.params.model] ?? {};
        if (typeof value === 'number') assert.ok(value >= min && value <= max, `${id} = ${value}`);
      }
      const power = fire.params.fuel_power;
      if (values.fuel_power)
        assert.ok(
          Math.abs(Math.log(values.fuel_power / power)) <= Math.log(FAR[strength]),
          `${values.fuel_power} kW/m`,
        );
      if (values.hot_colour) assert.match(`${values.hot_colour}${values.cool_colour}`, /^(#[0-9a-f]{6}){2}$/);
      assert.ok(Object.keys(values).length > 5);
    }
    assert.equal(seen.size, 50);
  });
}

test('the lowest and the highest number are values, too', () => {
  const fire = fireOf(PRESETS[0]);
  for (const number of [0, 1 - 2 ** -53]) {
    const values = Object.values(randomValues(fire, 'mild', () => number));
    assert.ok(values.every((value) => typeof value === 'string' || Number.isFinite(value)));
  }
});

test('another scene is never the present one, nor one of the paper', () => {
  for (const { name } of PRESETS)
    for (let at = 0; at < 1; at += 0.02)
      assert.doesNotMatch(
        otherScene(PRESETS, name, () => at),
        RegExp(`^(${name}|classic|paper-.*)$`),
      );
});
