/**
 * The panel inside its fire. This code is loaded when a fire with the attribute `controls` burns.
 */

import { DEFAULTS } from '../generated/defaults.js';
import { offerInside } from '../tools/offer.js';

/** Values of `controls` that mean all parameters. */
const ALL = ['', 'true', 'controls'];

/**
 * Mounts the panel.
 * @param {import('./session.js').FireSession} session
 * @param {string} list the ids of the parameters to show, or one of `ALL`
 * @param {AbortSignal} signal removes the panel
 */
export async function mountControls({ fire, reports }, list, signal) {
  const names = list.split(/[\s,]+/).filter((name) => !ALL.includes(name));
  const isKnown = (/** @type {string} */ name) => Object.hasOwn(DEFAULTS, idOf(name));
  for (const name of names.filter((one) => !isKnown(one))) misspelt(name, reports);
  const only = names.filter(isKnown).map(idOf);

  const host = document.createElement('div');
  host.className = 'panel';
  host.setAttribute('part', 'panel');
  fire.shadowRoot?.append(host);
  signal.addEventListener('abort', () => host.remove());
  try {
    const { mountPanel } = await import('../panel.js');
    if (signal.aborted) return;
    const panel = await mountPanel({ host, fire, only: only.length > 0 ? only : undefined });
    if (signal.aborted) {
      panel.destroy();
      return;
    }
    signal.addEventListener('abort', () => panel.destroy());
    // A list of parameters is all that the page wants to show.
    if (only.length > 0) return;
    const failed = (/** @type {unknown} */ why) => reports.warn('load', `The tools could not be loaded: ${why}`);
    signal.addEventListener('abort', offerInside(fire, failed));
  } catch (why) {
    host.remove();
    if (!signal.aborted) reports.warn('load', `The panel could not be loaded: ${why}`);
  }
}

/** @param {string} name */
const idOf = (name) => name.replaceAll('-', '_');

/** @type {(name: string, reports: import('./reports.js').Reports) => Promise<void>} */
async function misspelt(name, reports) {
  const { suggestion } = await import('./spelling.js').catch(() => ({ suggestion: () => '' }));
  reports.refuse('controls', name, `a list of parameters${suggestion(name, Object.keys(DEFAULTS))}`);
}
