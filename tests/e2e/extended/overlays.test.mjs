/**
 * What lies over a fire, in the element and on the page, from 320 × 240 to 3840 × 2160: nothing lies under another, and
 * each tool can be reached.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

const SIZES = [
  [320, 240],
  [320, 400],
  [360, 640],
  [568, 320],
  [600, 640],
  [720, 480],
  [844, 390],
  [900, 640],
  [1100, 600],
  [1280, 800],
  [3840, 2160],
];

/** Runs in the page: what lies under another, or outside of the window. */
const overlaps = () => {
  const inside = /** @type {any} */ (document.querySelector('hearth-fire')).shadowRoot;
  const names =
    '.play, .speaker, .scale, .hearth-fold, .hearth-toolbar, .hearth-status, .hearth-inside:not(.hearth-folded), #panel, #head > :not(.hearth-sound), #hint, #scenes';
  const all = [inside, document].flatMap((root) => [...root.querySelectorAll(names)]);
  const shown = all.filter(
    (part) => part.checkVisibility({ opacityProperty: true, visibilityProperty: true }) && part.innerHTML,
  );
  const boxes = shown.map((part) => {
    const { left, right, top, bottom } = part.getBoundingClientRect();
    return { name: part.id || part.className || part.localName, left, right, top, bottom };
  });
  const out = boxes.filter(
    ({ left, right, top, bottom }) =>
      left < -0.5 || top < -0.5 || right > innerWidth + 0.5 || bottom > innerHeight + 0.5,
  );
  const under = boxes.flatMap((one, at) =>
    boxes.slice(at + 1).flatMap((other) => {
      const across = Math.min(one.right, other.right) - Math.max(one.left, other.left);
      const up = Math.min(one.bottom, other.bottom) - Math.max(one.top, other.top);
      return across > 0.5 && up > 0.5 ? `${one.name} and ${other.name}` : [];
    }),
  );
  return [...out.map(({ name }) => `${name} outside`), ...under];
};

/** Runs in the page: the tools that are under something else where they are scrolled to. */
const unreachable = () => {
  const inside = /** @type {any} */ (document.querySelector('hearth-fire')).shadowRoot;
  const root = inside.querySelector('.hearth-toolbar') ? inside : document;
  return [...root.querySelectorAll('.hearth-toolbar :is(button, select)')].flatMap((tool) => {
    tool.scrollIntoView({ block: 'nearest', inline: 'nearest' });
    const { left, top, width, height } = tool.getBoundingClientRect();
    const found = root.elementFromPoint(left + width / 2, top + height / 2);
    return tool.contains(found) ? [] : tool.ariaLabel;
  });
};

/** Presses a button of the page or of the element. */
const press = (tab, selector) =>
  tab.evaluate((wanted) => {
    const inside = /** @type {any} */ (document.querySelector('hearth-fire')).shadowRoot;
    (inside.querySelector(wanted) ?? document.querySelector(wanted)).click();
  }, selector);

for (const [where, open, tools, panel] of /** @type {const} */ ([
  [
    'in the element',
    '<style>body { margin: 0 } hearth-fire { width: 100vw; height: 100vh }</style><hearth-fire controls sound="0.5" display-mode="temperature" max-pixels="10000"></hearth-fire>',
    '.hearth-draw',
    '[aria-label=Controls]',
  ],
  ['on the page', 'index.html?scene=default&display_mode=temperature&sound=0.5', '#draw', '#toggle'],
])) {
  for (const motion of ['paused for reduced motion', 'played']) {
    test(`nothing over a fire lies under another ${where}, ${motion}, and each tool can be reached`, async () => {
      const tab = await browser.open(open, { width: 1280, height: 800, reducedMotion: true });
      await tab.ready();
      await tab.until(
        'buttons',
        (wanted) => {
          const inside = document.querySelector('hearth-fire')?.shadowRoot;
          return inside?.querySelector('.play') && (inside.querySelector(wanted) ?? document.querySelector(wanted));
        },
        `${tools}:not([hidden])`,
      );
      if (motion === 'played') await press(tab, '.play');
      await tab.until('the scale', () =>
        document.querySelector('hearth-fire')?.shadowRoot?.querySelector('.scale:not([hidden])'),
      );
      const found = [];
      for (const state of ['panel', 'folded', 'tools', 'tools and panel']) {
        if (state === 'tools') await press(tab, tools);
        if (state !== 'tools' && state !== 'panel') await press(tab, panel);
        if (state.startsWith('tools'))
          await tab.until('tools', () =>
            [document, document.querySelector('hearth-fire')?.shadowRoot].some((root) =>
              root?.querySelector('.hearth-toolbar'),
            ),
          );
        for (const [width, height] of SIZES) {
          await tab.page.setViewport({ width, height });
          await tab.frames(3);
          const all = await tab.evaluate(overlaps);
          if (state.startsWith('tools')) all.push(...(await tab.evaluate(unreachable)));
          found.push(...all.map((what) => `${width} × ${height}, ${state}: ${what}`));
        }
      }
      assert.deepEqual(found, []);
    });
  }
}
