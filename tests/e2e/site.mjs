/**
 * The site under test, and the parameter table that it ships: tests ask the
 * table for names, ranges and defaults, and state none of them twice.
 */
import { accessSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const HERE = path.dirname(fileURLToPath(import.meta.url));

/** The folder that holds the site: `HEARTH_SITE`, else `dist/site`. */
export const SITE = path.resolve(process.env.HEARTH_SITE ?? path.join(HERE, '../../dist/site'));

/**
 * The parameter table and the presets, as the site ships them, the table by id
 * as well, every value of a new fire, and of one whose model somebody chose.
 */
export async function table() {
  const file = path.join(SITE, 'web/parameters.js');
  accessSync(file);
  const { PARAMETERS, PRESETS } = await import(pathToFileURL(file).href);
  const entry = Object.fromEntries(PARAMETERS.map((one) => [one.id, one]));
  const DEFAULTS = Object.fromEntries(PARAMETERS.map((one) => [one.id, one.default]));
  const defaultsOf = (/** @type {string} */ model) => {
    const values = PARAMETERS.map((one) => [one.id, domainOf(one, model).default]);
    return { ...Object.fromEntries(values), model };
  };
  return { PARAMETERS, PRESETS, DEFAULTS, defaultsOf, entry };
}

/**
 * Default and range of a parameter in a model or, where that does not use it,
 * in the model that it belongs to: its value waits there.
 * @param {any} one @param {string} model
 */
export function domainOf(one, model) {
  return one.domains[model] ?? Object.values(one.domains)[0];
}

/** The scene that the page opens with, as its HTML names it. */
export async function landingScene() {
  const html = await readFile(path.join(SITE, 'index.html'), 'utf8');
  const scene = /<hearth-fire id="fire" [^>]*?preset="([^"]+)"/.exec(html)?.[1];
  if (!scene) throw new Error('the page names no scene');
  return scene;
}
