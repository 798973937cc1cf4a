/**
 * The page for iframes, which shows nothing but a fire:
 * `embed.html?scene=seed&viscosity=0.02&allow=https://example.org`.
 *
 * The URL parameters or the fragment set the fire, as on the full page. The embedding page can control the fire by messages
 * (message-bridge.js) if `allow` names its origin.
 */

import { applyFragment } from '../pages/fragment.js';
import { applyUrlParameters, readUrlParameters } from '../pages/url-parameters.js';
import { cut } from '../quoted.js';
import { allowedOrigins, answer } from './message-bridge.js';
import '../hearth-fire.js';

const fire = /** @type {import('../hearth-fire.js').HearthFire} */ (document.querySelector('hearth-fire'));
const scheme = /** @type {HTMLMetaElement} */ (document.querySelector('meta[name=color-scheme]'));

/**
 * @type {{[name: string]: string}}
 * The colour schemes of the page. Its background is transparent only if its scheme is that of the iframe.
 * `auto` follows the embedding page, or the visitor's preference if that page declares none.
 */
const SCHEMES = { light: 'light', dark: 'dark', auto: 'light dark' };

const parameters = readUrlParameters(location.search, ['allow', 'color-scheme']);
const { origins, refused } = allowedOrigins(parameters.others.getAll('allow'));
for (const name of parameters.others.getAll('color-scheme')) {
  if (Object.hasOwn(SCHEMES, name)) scheme.content = SCHEMES[name];
  else refused.push(`“color-scheme” must be light, dark or auto, not “${cut(name)}”.`);
}
const warn = (/** @type {string} */ message) => console.warn(`Hearth: ${message}`);
[...parameters.refused, ...refused].forEach(warn);

applyUrlParameters(fire, parameters);
applyFragment(fire, warn);
if (origins.length > 0) answer(fire, origins);
