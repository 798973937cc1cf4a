/**
 * The site under test, and the parameter table that it ships: tests ask the
 * table for names, ranges and defaults, and state none of them twice.
 */
import { accessSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const HERE = path.dirname(fileURLToPath(import.meta.url));

/** The folder that holds the site: `HEARTH_SITE`, else `dist/site`. */
export const SITE = path.resolve(process.env.HEARTH_SITE ?? path.join(HERE, '../../dist/site'));

/**
 * The parameter table and the presets, as the site ships them, the table by id
 * as well, and every default.
 */
export async function table() {
  const file = path.join(SITE, 'web/parameters.js');
  accessSync(file);
  const { PARAMETERS, PRESETS } = await import(pathToFileURL(file).href);
  const entry = Object.fromEntries(PARAMETERS.map((one) => [one.id, one]));
  const DEFAULTS = Object.fromEntries(PARAMETERS.map((one) => [one.id, one.default]));
  return { PARAMETERS, PRESETS, DEFAULTS, entry };
}
