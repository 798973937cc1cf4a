/**
 * The layout of a page does not shift when the element is defined, becomes ready and
 * draws.
 */
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { Browser, except } from '../driver.mjs';

const DOC = readFileSync(new URL('../../../docs/embedding.md', import.meta.url), 'utf8');
const SECTION = DOC.slice(DOC.indexOf('### No layout shift'));
const [, EXAMPLE] = /** @type {RegExpMatchArray} */ (SECTION.match(/```html\n([\s\S]*?)```/));
const [RULE] = /** @type {RegExpMatchArray} */ (EXAMPLE.match(/<style>[\s\S]*?<\/style>/));
const SCRIPT = '<script type="module" src="./web/hearth-fire.js"></script>\n';

/** Options of these tests. */
const REPORTED = except({ firefox: 'it reports no shift', webkit: 'it reports no shift' });

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

/**
 * Opens a page whose script comes when the page has been painted without it; gives the layout
 * shift of all until the fire is seen.
 * @param {string} html
 */
async function shift(html, height = 900) {
  assert.ok(html.includes(SCRIPT));
  const tab = await browser.open(
    `<!doctype html><script>
    window.shift = 0;
    window.add = (entries) => entries.forEach(({ value }) => (window.shift += value));
    window.watch = new PerformanceObserver((list) => add(list.getEntries()));
    window.watch.observe({ type: 'layout-shift', buffered: true });
  </script>${html.replace(SCRIPT, '').replace('<!doctype html>', '')}`,
    { width: 600, height },
  );
  await tab.frames(3);
  await tab.frames(3);
  await tab.evaluate(() => import(new URL('./web/hearth-fire.js', location.href).href).then(() => undefined));
  await tab.evaluate(() =>
    Promise.all([...document.querySelectorAll('hearth-fire')].map((fire) => /** @type {any} */ (fire).toBlob())).then(
      () => undefined,
    ),
  );
  await tab.frames(5);
  return tab.evaluate(() => {
    const { add, watch } = /** @type {any} */ (window);
    add(watch.takeRecords());
    return /** @type {any} */ (window).shift;
  });
}

const page = (/** @type {string} */ fire, rule = RULE) =>
  `<!doctype html>\n${rule}\n${SCRIPT}<h1>Above</h1>${fire}<p>Below it.<br>Two lines.</p>`;
const PIXEL = 'data:image/gif;base64,R0lGODlhAQABAIAAAAAAAP///yH5BAEAAAAALAAAAAABAAEAAAIBRAA7';

test('without the rule the page shifts, so that this would be seen', REPORTED, async () => {
  assert.ok((await shift(page('<hearth-fire paused></hearth-fire>', ''))) > 0.01);
});

for (const [about, html] of [
  ['the example', EXAMPLE],
  [
    'a size of the style sheet',
    page('<style>hearth-fire { width: 50%; height: 30vh; margin: 1em auto }</style><hearth-fire paused></hearth-fire>'),
  ],
  [
    'a place of its own',
    page('<style>hearth-fire { position: fixed; inset: 0 }</style><hearth-fire paused></hearth-fire>'),
  ],
]) {
  test(`nothing moves: ${about}`, REPORTED, async () => {
    assert.equal(await shift(html), 0);
  });
}

test('nothing moves: given sizes, a cell of a grid and posters', REPORTED, async () => {
  const fires = [
    '<hearth-fire paused style="width: 320px; height: 400px"></hearth-fire>',
    '<hearth-fire paused style="width: 200px"></hearth-fire>',
    '<hearth-fire paused style="height: 200px"></hearth-fire>',
    '<div style="display: grid; grid-template-columns: 1fr 2fr"><hearth-fire paused></hearth-fire><p>Beside it.</p></div>',
    `<hearth-fire paused style="width: 300px"><img slot="poster" alt="" src="${PIXEL}" width="100" height="80"></hearth-fire>`,
    '<hearth-fire paused style="width: 300px; height: 120px"><div slot="poster" style="font-size: 60px">Fire</div></hearth-fire>',
    '<div style="display: flex; justify-content: center"><hearth-fire paused></hearth-fire></div>',
  ];
  // A shift out of sight does not count.
  assert.equal(await shift(page(fires.join('<p>Between them.</p>')), 3100), 0);
});
