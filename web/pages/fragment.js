/**
 * The fragment of a page's URL, which has the settings of a fire that is too long for URL parameters. What is too long
 * for a fragment stays in the tab: in the state of its history and in the storage of its session.
 *
 * @typedef {import('../hearth-fire.js').HearthFire} HearthFire
 * @typedef {import('../hearth-fire.js').HearthConfig} HearthConfig
 */

import { fromFragment } from '../share.js';

/** The fragment of a fire that only its tab has, and the key of its settings. */
export const KEPT = '#fire-of-this-tab';
const KEY = 'hearth-fire';

/** The key of the last settings, which the URL does not have. */
const LAST = 'hearth-fire-last';

/** Whether the URL names a fire of this tab; other programs may have added to it. */
const isOfTab = () => location.hash.startsWith(KEPT);

/** Whether the URL names a fire by its fragment. */
export const hasFragment = () => isOfTab() || /^#fire[=%]/.test(location.hash);

/**
 * Applies the fragment of the URL to a fire, now and whenever it changes. Returns whether
 * settings that the URL does not have follow it.
 * @param {HearthFire} fire
 * @param {(message: string) => void} refuse  Reports why it is refused.
 */
export function applyFragment(fire, refuse) {
  const apply = async () => {
    if (!hasFragment()) return;
    try {
      const config = isOfTab() ? kept() : await fromFragment(location.hash);
      // The fire reports what it refuses.
      if (config) fire.importConfig(/** @type {HearthConfig} */ (config)).catch(() => {});
      else if (isOfTab())
        refuse('The fire of this address was too long for it: only the tab in which it was made has it.');
    } catch (error) {
      refuse(/** @type {Error} */ (error).message);
    }
  };
  const last = takeLast();
  apply().then(() => last && fire.importConfig(last).catch(() => {}));
  // Another address in the same tab loads nothing.
  addEventListener('hashchange', apply);
  // A page that the browser has kept goes on with its fire, and writes the URL itself.
  addEventListener('pageshow', ({ persisted }) => persisted && takeLast());
  return last !== undefined;
}

/** The settings that the tab has. @returns {HearthConfig | undefined} */
function kept() {
  try {
    return history.state?.[KEY] ?? JSON.parse(sessionStorage.getItem(KEY) ?? 'null') ?? undefined;
  } catch {
    return undefined;
  }
}

/**
 * Keeps settings in the tab, or forgets those that it has.
 * @param {URL} url  The new URL of the page.
 * @param {HearthConfig} [config]
 */
export function keep(url, config) {
  const { [KEY]: _, ...others } = history.state ?? {};
  const state = config ? { ...others, [KEY]: config } : others;
  try {
    history.replaceState(state, '', url);
  } catch {
    // The state of a history has a limit in some browsers.
    history.replaceState(others, '', url);
  }
  try {
    if (config) sessionStorage.setItem(KEY, JSON.stringify(config));
    else sessionStorage.removeItem(KEY);
  } catch {
    // A page without storage still has its history.
  }
}

/**
 * Keeps settings for a reload before the URL has them. While a page ends, its history takes no other URL.
 * @param {HearthConfig} config
 */
export function keepLast(config) {
  try {
    sessionStorage.setItem(LAST, JSON.stringify({ href: location.href, config }));
  } catch {
    // Without storage, the URL is of the settings before.
  }
}

/** What `keepLast` has kept of a page with this URL, once. @returns {HearthConfig | undefined} */
function takeLast() {
  try {
    const { href, config } = JSON.parse(sessionStorage.getItem(LAST) ?? '{}');
    sessionStorage.removeItem(LAST);
    return href === location.href ? config : undefined;
  } catch {
    return undefined;
  }
}
