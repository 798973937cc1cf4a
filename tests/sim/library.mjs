/**
 * The library under test, as the site ships it: `HEARTH_SITE` names the folder of
 * the site, else it is `dist/site`.
 */
import path from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const HERE = path.dirname(fileURLToPath(import.meta.url));

/** The checkout. */
export const ROOT = path.resolve(HERE, '../..');

/** The folder that holds the library. */
export const WEB = path.join(process.env.HEARTH_SITE ?? path.join(ROOT, 'dist/site'), 'web');

/** A module of the library by its file's name; anew with a `query` of its own. */
export function load(name, query = '') {
  return import(pathToFileURL(path.join(WEB, name)).href + query);
}

export const { createSimulation } = await load('sim.js');
export const { PARAMETERS, PRESETS } = await load('parameters.js');

/** Every array that can be read from a simulation, and how many numbers each particle has in it. */
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
 * Everything that can be read from a simulation, to be compared bit by bit.
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
 * A quick fire of each model, made with these values on top.
 * @param {object} [params]
 */
export function fires(params = {}) {
  const models = ['combustion', 'classic'];
  return Promise.all(
    models.map((model) => createSimulation({ params: { model, max_particles: 1000, ...params } })),
  );
}
