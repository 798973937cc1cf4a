/**
 * The panel's local storage: it survives a visit and is shared by all pages of an origin. Browsers may
 * forbid it; then nothing is stored.
 *
 * @typedef {object} Memory
 * @property {string[]} [folded]  The folded groups.
 * @property {boolean} [times]  Whether the panel shows the time of each step and pass.
 * @property {boolean} [hidden]  Whether the panel is hidden.
 * @property {number} [sheet]  The height of the sheet as a share of its container.
 * @property {string} [quality]
 * @property {{kind: string, format: string, size: string, background: string, seconds?: number}} [film]  The last choices of what is saved.
 * @property {boolean} [shortcutsOff]  Whether single-key shortcuts are off.
 */

const KEY = 'hearth-panel';

/** @returns {Memory} */
export function remembered() {
  try {
    const kept = JSON.parse(localStorage.getItem(KEY) ?? '');
    return typeof kept === 'object' && kept ? kept : {};
  } catch {
    return {};
  }
}

/** @param {Memory} changes */
export function remember(changes) {
  try {
    localStorage.setItem(KEY, JSON.stringify({ ...remembered(), ...changes }));
  } catch {
    // The browser forbids it.
  }
}
