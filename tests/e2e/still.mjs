/**
 * Fires of the documentation's pictures: paused and burnt by steps, so that they are always
 * the same.
 */

/** How many of the last steps are also drawn: fine structure develops from picture to
    picture. */
const DRAWN = 200;

/**
 * Restarts the first fire of the page, and draws its last steps.
 * @param {import('./driver.mjs').Tab} tab
 * @param {number} steps in all
 */
export async function burnSteps(tab, steps) {
  await tab.fire(
    async (fire, quick, drawn) => {
      await fire.reset();
      for (let left = quick; left > 0; left -= 50) await fire.step(Math.min(left, 50));
      for (let left = drawn; left > 0; left -= 4) {
        await fire.step(4);
        await new Promise(requestAnimationFrame);
      }
    },
    steps - DRAWN,
    DRAWN,
  );
  await tab.frames(4);
}
