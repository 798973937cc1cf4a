/**
 * What the page keeps between visits. A private window or a policy may forbid storage; every visit is
 * then the first.
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
