/**
 * Whether the visitor has muted the fires of this origin. It is kept for the next visit, unless the browser forbids that.
 */

/** The key in the local storage, and the event of the window when it changes. */
export const MUTED = 'hearth-muted';

let muted = false;
try {
  muted = localStorage.getItem(MUTED) === 'true';
} catch {
  // There is no storage.
}

export const isMuted = () => muted;

/** @param {boolean} on */
export function mute(on) {
  muted = on;
  try {
    localStorage.setItem(MUTED, String(on));
  } catch {
    // It lasts as long as the page.
  }
  dispatchEvent(new Event(MUTED));
}
