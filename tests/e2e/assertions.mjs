/**
 * Assertions that more than one test file makes.
 */
import assert from 'node:assert/strict';

/** @typedef {import('./driver.mjs').Tab} Tab */

/**
 * The first fire of the page plays: its lower middle glows, and its picture changes. Where the page draws
 * nothing: its time goes on and it has particles.
 * @param {Tab} tab
 */
export async function assertBurns(tab) {
  await tab.ready();
  const first = tab.draws ? lowerMiddle(await assertGlows(tab)) : undefined;
  // A page may paint many frames before a busy engine draws one picture.
  const time = await tab.fire((fire) => fire.stats?.time ?? 0);
  await tab.plays(time + 0.15);
  if (first) {
    await tab.pictureUntil('the picture moves', (picture) => first.difference(lowerMiddle(picture)) > 0.2);
  } else {
    await tab.until(
      'the fire has particles',
      () => /** @type {any} */ (document.querySelector('hearth-fire')).stats.particles > 0,
    );
  }
}

/**
 * The lower middle of the first fire glows.
 * @param {Tab} tab
 * @returns its picture
 */
export function assertGlows(tab) {
  return tab.pictureUntil('the lower middle glows', (picture) => lowerMiddle(picture).glowing() > 0.02);
}

/** @param {import('./picture.mjs').Picture} picture */
function lowerMiddle(picture) {
  return picture.crop(0.3, 0.4, 0.7, 1);
}

/**
 * HTML whose script records every event of every fire in `window.events` as
 * `{type, fire, detail}`, from before the element is defined.
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
  return tab.evaluate((wanted) => {
    const all = /** @type {any} */ (window).events;
    return all.filter((event) => event.type === wanted).map((event) => event.detail);
  }, type);
}

/**
 * The first fire makes no steps. Returns its age [s].
 * @param {Tab} tab
 */
export async function assertStands(tab) {
  // Statistics that were posted before arrive within these frames.
  await tab.frames(20);
  const age = () => tab.fire((fire) => fire.stats?.time ?? 0);
  const first = await age();
  await tab.frames(20);
  assert.equal(await age(), first, 'the fire makes no steps');
  return first;
}
