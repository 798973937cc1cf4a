/**
 * What the pictures of documentation have in common: fires that stand still and are
 * burnt step by step, so that they are always the same ones.
 */

/** How many of the last steps are also drawn: the gas carries the fine structure from
    picture to picture. */
const DRAWN = 200;

/**
 * Burns the first fire of the page anew, and has its last steps drawn.
 * @param {import('./driver.mjs').Tab} tab
 * @param {number} steps in all
 */
export async function burnAnew(tab, steps) {
  await tab.fire(async (fire, quick, drawn) => {
    await fire.reset();
    for (let left = quick; left > 0; left -= 50) await fire.step(Math.min(left, 50));
    for (let left = drawn; left > 0; left -= 4) {
      await fire.step(4);
      await new Promise(requestAnimationFrame);
    }
  }, steps - DRAWN, DRAWN);
  await tab.frames(4);
}
