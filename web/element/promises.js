/**
 * Promises whose rejection needs no handler: a fire is decoration, and a refusal is also an event and a warning.
 *
 * @typedef {{promise: Promise<any>, resolve: (value?: unknown) => void, reject: (error: Error) => void, failed:
 *   boolean}} Deferred
 */

/**
 * A promise with its handles, whose rejection needs no handler.
 * @returns {Deferred}
 */
export function deferred() {
  /** @type {any} */
  const made = { failed: false };
  made.promise = quiet(
    new Promise((resolve, reject) => {
      made.resolve = resolve;
      made.reject = (/** @type {Error} */ error) => {
        made.failed = true;
        reject(error);
      };
    }),
  );
  return made;
}

/**
 * The same promise, whose rejection needs no handler.
 * @template T
 * @param {Promise<T>} promise
 */
export function quiet(promise) {
  promise.catch(() => {});
  return promise;
}
