/**
 * What more than one test file waits for.
 */

import { eventually } from './driver.mjs';

/** @typedef {import('./driver.mjs').Tab} Tab */

/** The objects of the first fire. @param {Tab} tab */
export const objects = (tab) => tab.fire((fire) => fire.objects);

/**
 * Waits until the objects of the first fire are as `holds` requires, and returns them.
 * @param {Tab} tab @param {string} what @param {(all: any[]) => unknown} holds
 */
export function objectsUntil(tab, what, holds) {
  return eventually(
    `the objects are ${what}`,
    () => objects(tab),
    holds,
    () => tab.frames(),
  );
}

/**
 * Waits until the object of the fire's first child, or null without one, is as `holds` requires; returns it
 * with its box in pixels of the fire, or 'none'.
 * @param {Tab} tab @param {string} what @param {Function | string} holds runs in the page
 * @param {any[]} args of `holds`
 */
export function childUntil(tab, what, holds, ...args) {
  return tab.until(
    what,
    new Function(
      '...args',
      `
    const fire = document.querySelector('hearth-fire');
    const object = fire.objects.find(({ id }) => id === fire.firstElementChild.objectId);
    if (!(${holds})(object ?? null, ...args)) return false;
    if (!object) return 'none';
    const { x, y, width, height = 0 } = object;
    const [from, to] = [fire.toPixels(x - width / 2, y + height / 2), fire.toPixels(x + width / 2, y - height / 2)];
    return { ...object, box: [from.x, from.y, to.x, to.y] };
  `,
    ),
    ...args,
  );
}

/** Waits until the strip of scenes is there. @param {Tab} tab */
export const strip = (tab) =>
  tab.until('the strip of scenes', () => document.querySelector('#scenes [aria-current="true"]') !== null);

/** Destroys the first fire and inserts it again. @param {Tab} tab */
export const destroyedAndBack = (tab) =>
  tab.fire(async (fire) => {
    const { parentNode } = fire;
    fire.remove();
    await fire.destroy();
    parentNode.append(fire);
    await fire.ready;
  });

/** Runs in the page: `window.saved` is the file that a link saved last. The page's policy lets no script fetch it. */
export function keepSaved() {
  const page = /** @type {any} */ (window);
  delete page.saved;
  const files = new Map();
  const { createObjectURL } = URL;
  URL.createObjectURL = (file) => {
    const url = createObjectURL(file);
    files.set(url, file);
    return url;
  };
  HTMLAnchorElement.prototype.click = async function click() {
    const file = files.get(this.href);
    const bytes = new Uint8Array(await file.arrayBuffer());
    page.saved = {
      name: this.download,
      type: file.type,
      size: bytes.length,
      start: [...bytes.slice(0, 8)],
      text: await file.text(),
    };
  };
}

/** Runs in the page: waits until the browser has hidden it, or shows it. @param {DocumentVisibilityState} state */
export async function becomes(state) {
  while (document.visibilityState !== state)
    await new Promise((resolve) => document.addEventListener('visibilitychange', resolve, { once: true }));
}
