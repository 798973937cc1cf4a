/**
 * The page's local storage. A private window or a policy may forbid it; every visit then is the first.
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
    // Storage is forbidden.
  }
}
