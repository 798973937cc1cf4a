/**
 * The panel and the button of the toolbar inside their fire. This code is loaded when a fire with the attribute
 * `controls` burns.
 */

import { DEFAULTS } from '../../generated/defaults.js';
import { offerTools } from '../../tools/tools-button.js';
import { iconButton } from './icon-button.js';

/** Values of `controls` that mean all parameters. */
const ALL = ['', 'true', 'controls'];

/** A pencil. */
const ICON = 'M4 20l1-5L16 4l4 4L9 19zM13 7l4 4';

/**
 * Mounts the panel.
 * @param {import('../session/session.js').FireSession} session
 * @param {string} list the ids of the parameters to show, or one of `ALL`
 * @param {AbortSignal} signal removes the panel
 */
export async function mountControls({ fire, reports }, list, signal) {
  const names = list.split(/[\s,]+/).filter((name) => !ALL.includes(name));
  const isKnown = (/** @type {string} */ name) => Object.hasOwn(DEFAULTS, idOf(name));
  for (const name of names.filter((name) => !isKnown(name))) misspelt(name, reports);
  const only = names.filter(isKnown).map(idOf);

  const host = document.createElement('div');
  host.className = 'panel';
  host.setAttribute('part', 'panel');
  fire.shadowRoot?.append(host);
  signal.addEventListener('abort', () => host.remove());
  try {
    const { mountPanel } = await import('../../panel.js');
    if (signal.aborted) return;
    const panel = await mountPanel({ host, fire, only: only.length > 0 ? only : undefined });
    if (signal.aborted) {
      panel.destroy();
      return;
    }
    signal.addEventListener('abort', () => panel.destroy());
    // A list of parameters is all that the page shows.
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

/** @type {(name: string, reports: import('../session/reports.js').Reports) => Promise<void>} */
async function misspelt(name, reports) {
  const { suggestion } = await import('../attributes/spelling.js').catch(() => ({ suggestion: () => '' }));
  reports.refuse('controls', name, `a list of parameters${suggestion(name, Object.keys(DEFAULTS))}`);
}

/**
 * Offers the toolbar inside a fire.
 * @param {import('../../hearth-fire.js').HearthFire} fire
 * @param {(why: unknown) => void} failed
 * @returns {() => void} removes the button and the toolbar
 */
function offerInside(fire, failed) {
  const host = document.createElement('div');
  host.className = 'tools';
  const button = iconButton(ICON, {
    class: 'hearth-fold hearth-draw',
    'aria-label': 'Tools',
    'aria-expanded': 'false',
    title: 'Draw, move and erase things',
  });
  fire.shadowRoot?.append(host, button);
  const close = offerTools({ button, host, fire, failed });
  return () => {
    close();
    host.remove();
    button.remove();
  };
}
