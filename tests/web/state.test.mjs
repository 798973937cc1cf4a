/** The state of a fire without a browser: what `fire.params` lists, and what it keeps. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { FireState } from '../../web/element/session/state.js';
import { PARAMETERS } from '../../web/parameters.js';

test('the values of a fire are those of its model', () => {
  const state = new FireState();
  for (const model of ['combustion', 'classic']) {
    state.take(/** @type {any} */ ({ type: 'ready', values: { model, emission_rate: 900, fuel_power: 90 } }));
    const used = PARAMETERS.filter(({ domains }) => domains[model]).map(({ id }) => id);
    assert.deepEqual(Object.keys(state.paramsOfModel).sort(), used.sort(), model);
    assert.deepEqual([state.params.emission_rate, state.params.fuel_power], [900, 90]);
  }
});
