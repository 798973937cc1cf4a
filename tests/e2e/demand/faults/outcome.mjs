/** What a visitor sees after a fault. */

/** @typedef {import('../../driver.mjs').Tab} Tab */
/**
 * @typedef {object} Finding
 * @property {string} fault
 * @property {'burns' | 'reported' | 'silent'} outcome  The fire burns, its visitor reads why not or sees
 *   its poster, or neither.
 * @property {string} [detail]
 */

/** Maximum real time until a visitor sees one or the other [ms]. */
const LIMIT_MS = 90_000;

/** Simulated time that shows that a fire burns [s]. */
const BURNT_S = 0.2;

/** Real time in which the element's script arrives, if it does [ms]. */
const SCRIPT_MS = 10_000;

const PAUSE_MS = 50;

/** A body with one fire that has a poster. */
export const FIRE = '<hearth-fire style="width: 120px; height: 150px"><p slot="poster">A poster</p></hearth-fire>';

/** Waits that many milliseconds. */
export const sleep = (/** @type {number} */ time) => new Promise((resolve) => setTimeout(resolve, time));

/** Runs in the page: what is seen of its first fire. */
function look() {
  const fire = /** @type {any} */ (document.querySelector('hearth-fire'));
  const root = fire.shadowRoot?.querySelector('.root');
  const poster = fire.querySelector('[slot=poster]');
  return {
    defined: Boolean(root),
    shown: Boolean(root?.matches('[data-state=shown][data-drawn]')),
    failed: Boolean(root?.matches('[data-state=failed]')),
    words: fire.shadowRoot?.querySelector('[role=status]')?.textContent.trim() ?? '',
    poster: Boolean(poster?.checkVisibility()),
    time: fire.stats?.time ?? 0,
  };
}

/** Presses the button of a fire that failed, as its visitor may. @param {Tab} tab */
export function retry(tab) {
  return tab.fire((fire) => fire.shadowRoot.querySelector('.root[data-state=failed] [part=retry]')?.click());
}

/** Whether the first fire is seen on its black page. @param {Tab} tab */
async function glows(tab) {
  return (await tab.firePicture()).crop(0.3, 0.4, 0.7, 1).glowing() > 0.02;
}

/**
 * Waits until the first fire of a page burns, or its visitor reads why not.
 * @param {Tab} tab
 * @param {string} fault
 * @returns {Promise<Finding>}
 */
export async function outcome(tab, fault) {
  const start = Date.now();
  let [burnt, last] = [0, Infinity];
  for (;;) {
    const seen = await tab.evaluate(look);
    burnt += Math.max(seen.time - last, 0);
    last = seen.time;
    if (seen.shown && burnt > BURNT_S && (await glows(tab))) return { fault, outcome: 'burns' };
    if (seen.failed && seen.words && seen.poster) return { fault, outcome: 'reported', detail: seen.words };
    // Without its script the element shows its poster, and only the browser can report why.
    const decided = tab.problems.length > 0 || Date.now() > start + SCRIPT_MS;
    if (!seen.defined && seen.poster && decided) {
      return { fault, outcome: 'reported', detail: `the poster; ${tab.problems[0] ?? 'no script'}` };
    }
    if (Date.now() > start + LIMIT_MS) {
      return { fault, outcome: 'silent', detail: `${JSON.stringify(seen)}; ${tab.problems.slice(-3).join('; ')}` };
    }
    await sleep(PAUSE_MS);
  }
}
