/**
 * The site under test and its parameter table, from which tests read names, ranges and
 * defaults.
 */
import { accessSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const HERE = path.dirname(fileURLToPath(import.meta.url));

/** The folder of the site: `HEARTH_SITE`, or `dist/site`. */
export const SITE = path.resolve(process.env.HEARTH_SITE ?? path.join(HERE, '../../dist/site'));

/**
 * The parameters (as a list and by id), the presets, the values of a new fire, and those of
 * a new fire of a model.
 */
export async function table() {
  const file = path.join(SITE, 'web/parameters.js');
  accessSync(file);
  const { PARAMETERS, PRESETS } = await import(pathToFileURL(file).href);
  const entry = Object.fromEntries(PARAMETERS.map((parameter) => [parameter.id, parameter]));
  const defaultsOf = (/** @type {string} */ model) => {
    const used = PARAMETERS.filter(({ models }) => models.includes(model));
    const values = used.map((parameter) => [parameter.id, parameter.domains[model].default]);
    return { ...Object.fromEntries(values), model };
  };
  const DEFAULTS = defaultsOf(entry.model.default);
  return { PARAMETERS, PRESETS, DEFAULTS, defaultsOf, entry };
}

/**
 * Default and range of a parameter in a model, or in the model that uses it.
 * @param {any} parameter @param {string} model
 */
export function domainOf(parameter, model) {
  return parameter.domains[model] ?? Object.values(parameter.domains)[0];
}
