/**
 * Starts a worker on pages that require trusted types.
 */

/** @type {{createScriptURL: (url: string) => any} | undefined} */
let policy;

/**
 * Starts a worker by `start`, whose URLs are trusted. A page that requires trusted types allows them by
 * the name of the policy.
 *
 * Bundlers recognise a worker by the text `new Worker(new URL(…))`, which leaves no room for a trusted
 * type. So the constructor of that name adds it during the call.
 * @param {() => Worker} start
 */
export function trustedWorker(start) {
  const scope = /** @type {any} */ (globalThis);
  const { Worker, trustedTypes } = scope;
  try {
    policy ??= trustedTypes?.createPolicy('hearth-fire', { createScriptURL: (/** @type {string} */ url) => url });
    if (policy) {
      scope.Worker = class extends Worker {
        /** @param {string | URL} url @param {WorkerOptions} options */
        constructor(url, options) {
          super(policy?.createScriptURL(`${url}`), options);
        }
      };
    }
  } catch {
    // The page allows no such policy.
  }
  try {
    return start();
  } finally {
    if (scope.Worker !== Worker) scope.Worker = Worker;
  }
}
