/** What the parts of the landing page look like: apart from each other, and readable. */
import assert from 'node:assert/strict';

/** @typedef {{name: string, rectangle: import('./picture.mjs').Rectangle, colour: number[]}} Word */

/** The words of the page over the fire. @param {import('./driver.mjs').Tab} tab @returns {Promise<Word[]>} */
export function wordsOf(tab) {
  return tab.evaluate(() => {
    const all = [...document.querySelectorAll('#head *, #hint, #stage > button, #zoom > *, #word > *')].filter(
      (part) =>
        part.checkVisibility({ visibilityProperty: true }) && part.textContent?.trim() && !part.firstElementChild,
    );
    return all.map((part) => {
      const range = document.createRange();
      range.selectNodeContents(part);
      const { x, y, width, height } = range.getBoundingClientRect();
      const colour = /** @type {number[]} */ (getComputedStyle(part).color.match(/\d+/g)?.map(Number));
      return { name: part.textContent ?? '', rectangle: { x, y, width, height }, colour };
    });
  });
}

/** Hides the letters of the page, and neither what is behind them nor where they are. @param {import('./driver.mjs').Tab} tab */
export const hideWords = (tab) =>
  tab.evaluate(() => {
    const style = new CSSStyleSheet();
    style.replaceSync(
      '#head *, #stage > *, #stage button { color: transparent !important; text-shadow: none !important; text-decoration: none !important }',
    );
    document.adoptedStyleSheets.push(style);
  });

/**
 * The least contrast of each word over a picture of the page without its letters.
 * @param {import('./picture.mjs').Picture} picture @param {Word[]} words @returns {[string, number][]}
 */
export function contrasts(picture, words) {
  const linear = (/** @type {number} */ byte) => (byte <= 10 ? byte / 3295 : ((byte / 255 + 0.055) / 1.055) ** 2.4);
  const luminance = (/** @type {number} */ r, /** @type {number} */ g, /** @type {number} */ b) =>
    0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);
  return words.map(({ name, rectangle: { x, y, width, height }, colour: [r, g, b] }) => {
    const ground = picture.crop(
      x / picture.width,
      y / picture.height,
      (x + width) / picture.width,
      (y + height) / picture.height,
    );
    const light = luminance(r, g, b) + 0.05;
    let least = Infinity;
    ground.share((...rgb) => {
      least = Math.min(least, light / (luminance(...rgb) + 0.05));
      return true;
    });
    return [name, least];
  });
}

/** Words over a white stage have a contrast of 4.5:1 or more. */
export async function assertReadable(tab) {
  await tab.evaluate(() => {
    const stage = /** @type {HTMLElement} */ (document.getElementById('stage'));
    const fire = /** @type {any} */ (document.getElementById('fire'));
    stage.style.background = '#fff';
    for (const part of fire.shadowRoot.querySelectorAll('.root, canvas')) part.style.visibility = 'hidden';
  });
  const words = await wordsOf(tab);
  await hideWords(tab);
  for (const [name, contrast] of contrasts(await tab.picture(), words))
    assert.ok(contrast >= 4.5, `${name}: ${contrast}`);
}

/** The controls on the stage overlap neither each other nor the middle of the fire. */
export async function assertApart(tab, width, size) {
  const parts = await tab.evaluate(() =>
    ['#head h1', '#head p', '#head nav', '#hint', '#speaker', '#draw', '#toggle', '#scenes .tiles']
      .map((selector) => ({ selector, element: document.querySelector(selector) }))
      .filter(({ element }) => element?.checkVisibility())
      .map(({ selector, element }) => {
        // A heading is wider than its words.
        const words = document.createRange();
        words.selectNodeContents(/** @type {Element} */ (element));
        const { left, top, right, bottom } = (
          selector.startsWith('#head') ? words : /** @type {Element} */ (element)
        ).getBoundingClientRect();
        return { selector, left, top, right, bottom };
      }),
  );
  assert.ok(parts.length >= 6, parts.map(({ selector }) => selector).join());
  for (const [at, part] of parts.entries()) {
    for (const other of parts.slice(at + 1)) {
      const apart =
        part.right <= other.left || other.right <= part.left || part.bottom <= other.top || other.bottom <= part.top;
      assert.ok(apart, `at ${size} ${part.selector} lies over ${other.selector}`);
    }
  }
  // What stands under the flame is in sight, and so is the middle of the stage.
  const tiles = parts.find(({ selector }) => selector.endsWith('.tiles'));
  const stage = await tab.rectangle('#stage');
  const middle = stage.x + stage.width / 2;
  const things = await tab.fire((fire) => {
    const [least, most] = [Math.min, Math.max].map((of) => of(...fire.objects.map(({ x }) => x)));
    return {
      left: fire.toPixels(least - 0.08, 0).x,
      right: fire.toPixels(most + 0.08, 0).x,
      top: fire.toPixels(0, 0.12).y,
    };
  });
  const clear = tiles.bottom <= things.top || tiles.left >= things.right || tiles.right <= things.left;
  // A stage between the two is narrower than what stands there.
  assert.ok(clear || width === 768, `${size}: ${JSON.stringify({ tiles, things })}`);
  const room = width >= 720 ? stage.width / 4 : 80;
  assert.ok(tiles.left > middle + room || tiles.right < middle - room, size);
}
