/** Fires with children: `<hearth-source>` and `<hearth-solid>`, their objects and the warnings about them. */
import { recording } from './assertions.mjs';

/** @typedef {import('./driver.mjs').Tab} Tab */

/** A fire with these children. */
export const fireOf = (/** @type {string} */ children, attributes = '') =>
  `<hearth-fire autoplay="false" quality="low" max-pixels="10000" ${attributes} style="width: 200px; height: 300px">${children}</hearth-fire>`;

/**
 * A page whose fire has these children, once every child has its object.
 * @param {import('./driver.mjs').Browser} browser @param {string} children @param {string} attributes
 * @param {string} before  Elements before the fire.
 */
export async function openChildren(browser, children, attributes = '', before = '') {
  const tab = await browser.show(recording(before + fireOf(children, attributes)));
  await tab.ready();
  await settled(tab);
  return tab;
}

/**
 * Waits until the fire has answered all calls of its children. It sends those of a mutation before the next frame.
 * @param {Tab} tab
 */
export async function settled(tab) {
  await tab.evaluate(async () => {
    for (let round = 0; round < 4; round += 1) {
      await new Promise(requestAnimationFrame);
      await Promise.all(
        [...document.querySelectorAll('hearth-fire')].map((fire) => /** @type {any} */ (fire).exportConfig()),
      );
    }
  });
}

/**
 * Runs `act` with the fire and waits until its children are settled.
 * @param {Tab} tab @param {(fire: any, ...args: any[]) => any} act @param {...any} args
 */
export async function acts(tab, act, ...args) {
  const value = await tab.fire(act, ...args);
  await settled(tab);
  return value;
}

/** The objects of the children, in the order of the document; null for one without. @param {Tab} tab */
export const owned = (tab) =>
  tab.fire((fire) =>
    [...fire.children].map(
      ({ objectId }) => fire.objects.find((/** @type {{id: number}} */ { id }) => id === objectId) ?? null,
    ),
  );

/** The warnings about children. @param {Tab} tab */
export const warnings = (tab) => tab.problems.filter((words) => /hearth-(source|solid)/.test(words));
