/**
 * The panel's local storage: it survives a visit and is shared by all pages of an origin. Browsers may
 * forbid it; then nothing is kept.
 *
 * @typedef {object} Kept
 * @property {string[]} [folded]  The folded groups.
 * @property {boolean} [times]  Whether the panel shows the time of each part of a frame.
 * @property {boolean} [hidden]  Whether the panel is hidden.
 * @property {number} [sheet]  The height of the sheet as a share of its container.
 * @property {string} [quality]
 * @property {{scale: string, background: string}} [picture]  The last choices of a saved picture.
 * @property {boolean} [silent]  Whether single-key shortcuts are off.
 */

const KEY = 'hearth-panel';

/** @returns {Kept} */
export function remembered() {
  try {
    const kept = JSON.parse(localStorage.getItem(KEY) ?? '');
    return typeof kept === 'object' && kept ? kept : {};
  } catch {
    return {};
  }
}

/** @param {Kept} changes */
export function remember(changes) {
  try {
    localStorage.setItem(KEY, JSON.stringify({ ...remembered(), ...changes }));
  } catch {
    // The browser forbids it.
  }
}
