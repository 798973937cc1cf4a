/**
 * What more than one test file asserts.
 */
import assert from 'node:assert/strict';

/** @typedef {import('./driver.mjs').Tab} Tab */

/**
 * The first fire of the page burns: there is light in its lower middle, and
 * the light moves.
 * @param {Tab} tab
 */
export async function assertBurns(tab) {
  await tab.ready();
  const first = (await tab.firePicture()).part(0.3, 0.4, 0.7, 1);
  // The page may have many frames while a busy engine makes one picture.
  const time = await tab.fire((fire) => fire.stats?.time ?? 0);
  await tab.plays(time + 0.15);
  const second = (await tab.firePicture()).part(0.3, 0.4, 0.7, 1);
  assert.ok(first.glowing() > 0.02, `${first.glowing()} of the lower middle glows`);
  assert.ok(first.difference(second) > 0.2, `the picture moved by ${first.difference(second)}`);
}

/**
 * The first fire of the page shows flames in its lower middle.
 * @param {Tab} tab
 */
export async function assertGlows(tab) {
  const share = (await tab.firePicture()).part(0.3, 0.4, 0.7, 1).glowing();
  assert.ok(share > 0.02, `${share} of the lower middle glows`);
}

/**
 * A page's HTML whose script keeps every event of every fire in
 * `window.events` as `{type, fire, detail}`, from before the element exists.
 * @param {string} body
 */
export function recording(body) {
  return `${body}<script>
    window.events = [];
    document.querySelectorAll('hearth-fire').forEach((element, fire) => {
      for (const type of ['ready', 'play', 'pause', 'params-change', 'objects-change', 'quality-change', 'error']) {
        element.addEventListener(type, ({ detail }) => events.push({ type, fire, detail }));
      }
    });
  </script>`;
}

/**
 * The recorded events of a type.
 * @param {Tab} tab @param {string} type
 */
export function events(tab, type) {
  return tab.evaluate(
    (wanted) => {
      const all = /** @type {any} */ (window).events;
      return all.filter((event) => event.type === wanted).map((event) => event.detail);
    },
    type,
  );
}

/**
 * The age of a fire that makes no steps; a fire that makes some fails.
 * @param {Tab} tab
 */
export async function assertStands(tab) {
  // A message that is on its way comes within these frames.
  await tab.frames(20);
  const age = () => tab.fire((fire) => fire.stats?.time ?? 0);
  const first = await age();
  await tab.frames(20);
  assert.equal(await age(), first, 'the fire makes no steps');
  return first;
}
