/**
 * What the page remembers between visits, where the browser lets it: a private window
 * or a policy may forbid storage, and then every visit is the first.
 */

/** @type {(key: string) => string | null} */
export function recall(key) {
  try {
    return localStorage.getItem(`hearth-page-${key}`);
  } catch {
    return null;
  }
}

/** @type {(key: string, value: string) => void} */
export function remember(key, value) {
  try {
    localStorage.setItem(`hearth-page-${key}`, value);
  } catch {
    // The next visit begins as this one did.
  }
}
