/**
 * The page that is only a fire, for iframes:
 * `embed.html?scene=seed&viscosity=0.02&allow=https://example.org`.
 *
 * What it burns with stands in its address, as on the full page. The page around
 * it can steer the fire by messages (message-bridge.js) if `allow` names its origin;
 * without `allow` it answers nobody.
 */

import { applyAddress, readAddress } from '../pages/url-parameters.js';
import { allowedOrigins, answer } from './message-bridge.js';
import '../hearth-fire.js';

const fire = /** @type {import('../hearth-fire.js').HearthFire} */ (document.querySelector('hearth-fire'));
const scheme = /** @type {HTMLMetaElement} */ (document.querySelector('meta[name=color-scheme]'));

/**
 * @type {{[name: string]: string}}
 * The colour schemes that the page may have. It shows none of its own, but one that
 * is not the iframe's costs it its transparency; `auto` is what the iframe has if its
 * page says which ones it has, and what the visitor prefers if not.
 */
const SCHEMES = { light: 'light', dark: 'dark', auto: 'light dark' };

const address = readAddress(location.search, ['allow', 'color-scheme']);
const { origins, refused } = allowedOrigins(address.others.getAll('allow'));
for (const wanted of address.others.getAll('color-scheme')) {
  if (Object.hasOwn(SCHEMES, wanted)) scheme.content = SCHEMES[wanted];
  else refused.push(`“color-scheme” is light, dark or auto, not “${wanted.slice(0, 40)}”.`);
}
for (const words of [...address.refused, ...refused]) console.warn(`Hearth: ${words}`);

applyAddress(fire, address);
if (origins.length > 0) answer(fire, origins);
