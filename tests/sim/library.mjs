/**
 * The library under test, from the site in the folder `HEARTH_SITE` or `dist/site`.
 */
import path from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const HERE = path.dirname(fileURLToPath(import.meta.url));

/** The checkout. */
export const ROOT = path.resolve(HERE, '../..');

/** The folder that holds the library. */
export const WEB = path.join(process.env.HEARTH_SITE ?? path.join(ROOT, 'dist/site'), 'web');

/** A module of the library by its file name; a new instance for each `query`. */
export function load(name, query = '') {
  return import(pathToFileURL(path.join(WEB, name)).href + query);
}

export const { createSimulation } = await load('sim.js');
export const { PARAMETERS, PRESETS } = await load('parameters.js');

/** Every array of a simulation, with the count of numbers per particle. */
export const ARRAYS = {
  positions: 2,
  velocities: 2,
  temperatures: 1,
  ages: 1,
  lifetimes: 1,
  densities: 1,
  pressures: 1,
  fuel: 1,
  oxygen: 1,
  soot: 1,
  burnRates: 1,
};

/**
 * All state that can be read from a simulation, for exact comparison.
 * @param {any} sim
 */
export function everything(sim) {
  return {
    time: sim.time,
    count: sim.count,
    power: sim.power,
    stepLength: sim.stepLength,
    params: sim.params,
    embers: sim.embers(),
    ids: sim.ids(),
    ...Object.fromEntries(Object.keys(ARRAYS).map((name) => [name, sim[name]()])),
  };
}

/**
 * A small fire of each model with these values.
 * @param {object} [params]
 */
export function fires(params = {}) {
  const models = ['combustion', 'classic'];
  return Promise.all(
    models.map((model) =>
      createSimulation({ params: { model, [model === 'classic' ? 'max_particles' : 'particles']: 1000, ...params } }),
    ),
  );
}
