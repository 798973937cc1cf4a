/**
 * What a panel keeps from one visit to the next: what is folded and hidden, the
 * height of the sheet, the quality that somebody chose, and whether single keys act.
 * It is kept for all pages of an origin, and not at all where the browser forbids it.
 *
 * @typedef {object} Kept
 * @property {string[]} [folded]  The groups that are folded.
 * @property {boolean} [times]  Whether it is shown what takes how long.
 * @property {boolean} [hidden]  Whether the panel is hidden.
 * @property {number} [sheet]  The height of the sheet, as a share of what it lies in.
 * @property {string} [quality]
 * @property {boolean} [silent]  Whether single keys do nothing.
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
    // Then it is forgotten.
  }
}
