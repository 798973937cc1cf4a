/** What the parts of the landing page look like: apart from each other, and readable. */
import assert from 'node:assert/strict';

/** Words over a white stage have a contrast of 4.5:1 or more. */
export async function assertReadable(tab) {
  const words = await tab.evaluate(() => {
    const stage = /** @type {HTMLElement} */ (document.getElementById('stage'));
    const fire = /** @type {any} */ (document.getElementById('fire'));
    stage.style.background = '#fff';
    for (const part of fire.shadowRoot.querySelectorAll('.root, canvas')) part.style.visibility = 'hidden';
    const all = [...document.querySelectorAll('#head h1, #head p, #head nav > *')].filter((part) =>
      part.checkVisibility(),
    );
    const found = all.map((part) => {
      const range = document.createRange();
      range.selectNodeContents(part);
      const { x, y, width, height } = range.getBoundingClientRect();
      const colour = /** @type {number[]} */ (getComputedStyle(part).color.match(/\d+/g)?.map(Number));
      return { name: part.textContent, rectangle: { x, y, width, height }, colour };
    });
    for (const part of all) /** @type {HTMLElement} */ (part).style.visibility = 'hidden';
    return found;
  });
  const linear = (byte) => (byte <= 10 ? byte / 3295 : ((byte / 255 + 0.055) / 1.055) ** 2.4);
  const luminance = (r, g, b) => 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);
  for (const { name, rectangle, colour } of words) {
    const ground = await tab.picture(rectangle);
    const light = luminance(...colour) + 0.05;
    assert.equal(
      ground.share((...rgb) => light / (luminance(...rgb) + 0.05) >= 4.5),
      1,
      name,
    );
  }
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
