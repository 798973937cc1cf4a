/** The documents for embedding: `docs/element.md` names exactly the members of the element, and every example runs. */
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { BROWSER, Browser } from '../driver.mjs';
import { table } from '../site.mjs';

const { PARAMETERS } = await table();
const read = (/** @type {string} */ file) => readFileSync(new URL(`../../../${file}`, import.meta.url), 'utf8');

/** Every example of a document that is a whole page, by the heading above it. */
const examples = (/** @type {string} */ file) => {
  const text = read(file);
  return [...text.matchAll(/```html(?: live)?\n([\s\S]*?)```/g)]
    .filter(([, html]) => html.startsWith('<!doctype'))
    .map((found) => ({
      file,
      html: found[1],
      heading:
        text
          .slice(0, found.index)
          .match(/^#+ .*$/gm)
          ?.at(-1) ?? '',
    }));
};

const GUIDES = ['docs/embedding.md', 'docs/element.md'];
const DOC = read('docs/element.md');
const OTHERS = ['recipes', 'hosts', 'iframe', 'package', 'simulation'].map((name) => `docs/${name}.md`);
// The process of a page ends when WebKitGTK encodes a WebM.
const EXAMPLES = [...GUIDES, ...OTHERS]
  .flatMap(examples)
  .filter(({ html }) => BROWSER !== 'webkit' || !/\brecord\(|MediaRecorder/.test(html));

/** The names in the first column of the tables of a section. */
function named(heading) {
  const section = DOC.slice(DOC.indexOf(`\n## ${heading}\n`) + 1).split(/\n## /)[0];
  const cells = [...section.matchAll(/^\| (`[^|]*) \|/gm)].map(([, cell]) => cell);
  return cells.flatMap((cell) => [...cell.matchAll(/`([\w-]+)/g)].map(([, name]) => name));
}

/** @type {Browser} */
let browser;
/** What the element has, as JavaScript sees it. */
let has;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
  const tab = await browser.open('<hearth-fire></hearth-fire>');
  await tab.burnt(0.3);
  has = await tab.fire((fire) => {
    const Fire = customElements.get('hearth-fire');
    const own = [];
    for (let type = Fire.prototype; type !== HTMLElement.prototype; type = Object.getPrototypeOf(type)) {
      own.push(...Object.entries(Object.getOwnPropertyDescriptors(type)));
    }
    const lifecycle = /Callback$|^constructor$/;
    const members = own.filter(([name]) => !lifecycle.test(name));
    return {
      attributes: Fire.observedAttributes,
      methods: [...members, ...Object.entries(Object.getOwnPropertyDescriptors(Fire))]
        .filter(([, { value }]) => typeof value === 'function')
        .map(([name]) => name),
      properties: members.filter(([, { get }]) => get).map(([name]) => name),
      stats: Object.keys(fire.stats),
      parts: [...fire.shadowRoot.querySelectorAll('[part]')].map((element) => element.getAttribute('part')),
    };
  });
});
after(() => browser?.close());

const camel = (/** @type {string} */ id) => id.replace(/_(.)/g, (_, letter) => letter.toUpperCase());
const sorted = (/** @type {Iterable<string>} */ names) => [...new Set(names)].sort();

test('the reference names the attributes, properties, methods and parts of the element, and no others', () => {
  const without = (/** @type {string[]} */ all, /** @type {string[]} */ others) =>
    sorted(all.filter((name) => !others.includes(name)));
  const attributes = PARAMETERS.map(({ attribute }) => attribute).filter((name) => name !== 'model');
  assert.deepEqual(without(named('Attributes'), ['low', 'medium', 'high']), without(has.attributes, attributes));
  const parameters = PARAMETERS.map(({ id }) => camel(id));
  // The statistics are properties of one of them.
  const own = without(has.properties, parameters);
  assert.deepEqual(without(named('Properties'), without(has.stats, own)), own);
  assert.deepEqual(sorted(named('Methods')), sorted(has.methods));
  const parts = [...has.parts, 'panel', 'play', 'retry', 'scale', 'speaker'];
  const described = [...DOC.matchAll(/`::part\(([\w-]+)\)`/g)].map(([, name]) => name);
  assert.deepEqual(sorted(described), sorted(parts));
});

test('a pointer reaches the play button of each fire that something lies above or below, and it hides no words', async () => {
  const layered = EXAMPLES.filter(
    ({ html }) =>
      /position: absolute/.test(html) && html.includes('<hearth-fire') && !/<hearth-fire[^>]* decorative/.test(html),
  );
  assert.ok(layered.length >= 4);
  for (const { heading, html } of layered) {
    const tab = await browser.open(html, { width: 800, height: 600, reducedMotion: true });
    await tab.until(`the button is reached: ${heading}`, () => {
      const fire = document.querySelector('hearth-fire');
      const button = fire?.shadowRoot?.querySelector('.play:not([hidden])')?.getBoundingClientRect();
      if (!button) return false;
      const { left, right, top, bottom } = button;
      const words = document.querySelector('h1')?.getBoundingClientRect();
      const isApart =
        !words || words.top >= bottom || words.bottom <= top || words.left >= right || words.right <= left;
      return isApart && document.elementFromPoint((left + right) / 2, (top + bottom) / 2) === fire;
    });
  }
});

test('a fire that is decoration has no button with reduced motion, and its engine may be loaded before it', async () => {
  const tab = await browser.open('<p></p><script type="module" src="/web/hearth-fire.js"></script>', {
    reducedMotion: true,
  });
  await tab.evaluate(async () => {
    const Fire = /** @type {any} */ (await customElements.whenDefined('hearth-fire'));
    await Fire.preload();
    const loaded = () =>
      performance.getEntriesByType('resource').filter(({ name }) => name.includes('_bg.wasm')).length;
    const before = loaded();
    const fire = Object.assign(document.createElement('hearth-fire'), { decorative: true });
    document.body.append(fire);
    await /** @type {any} */ (fire).ready;
    if (before !== 1 || loaded() !== 1) throw new Error(`${before} and ${loaded()} files of wasm`);
  });
  const buttons = () => tab.fire((fire) => fire.shadowRoot.querySelectorAll('.play:not([hidden])').length);
  assert.equal(await buttons(), 0);
  await tab.fire((fire) => (fire.decorative = false));
  await tab.until('the button', () =>
    document.querySelector('hearth-fire')?.shadowRoot?.querySelector('.play:not([hidden])'),
  );
});

/** How many examples run beside each other, in iframes of one page: with nine, the process of a page of WebKitGTK ends. */
const FRAMES = BROWSER === 'webkit' ? 3 : 9;

/** Runs examples in iframes of a page, and presses their buttons; gives the page. */
async function run(examples) {
  const iframes = examples.map(
    ({ html }) => `<iframe allow="fullscreen" src="${browser.server.publish(html)}"></iframe>`,
  );
  const page = `<!doctype html><link rel="icon" href="data:,">
    <style>body { margin: 0 } iframe { width: 33%; height: 300px; border: 0; float: left }</style>${iframes.join('')}`;
  const tab = await browser.open(page, { width: 1200, height: 900 });
  await tab.until(
    'the fires of all iframes are ready',
    async (burning) => {
      const documents = [...document.querySelectorAll('iframe')].map(
        (iframe) => /** @type {Document} */ (iframe.contentDocument),
      );
      for (const [at, outer] of documents.entries()) {
        const inside = outer.querySelector('iframe')?.contentDocument;
        const within = [outer, ...(inside ? [inside] : [])];
        const fires = within.flatMap((root) => /** @type {any[]} */ ([...root.querySelectorAll('hearth-fire')]));
        if (burning[at] && (fires.length === 0 || fires.some((fire) => fire.ready === undefined))) return false;
        for (const fire of fires) {
          // A fire below the fold may wait.
          if (fire.loading !== 'lazy') await fire.ready;
        }
      }
      return true;
    },
    examples.map(({ html }) => /<hearth-fire|<iframe|'hearth-fire'/.test(html)),
  );
  await tab.frames(10);
  for (const element of await tab.page.$$('iframe')) {
    const iframe = await element.contentFrame();
    const buttons = await iframe.evaluate(() => document.querySelectorAll('button').length);
    for (let button = 0; button < buttons; button += 1) {
      await iframe.evaluate((number) => document.querySelectorAll('button')[number].click(), button);
      await tab.frames(2);
    }
  }
  await tab.frames(5);
  return tab;
}

for (let from = 0; from < EXAMPLES.length; from += FRAMES) {
  const some = EXAMPLES.slice(from, from + FRAMES);
  const names = some.map(({ file, heading }) => `${heading.replace(/^#+ /, '')} in ${file}`).join(', ');
  test(`examples ${from + 1} to ${from + some.length} run: ${names}`, async () => {
    const tab = await run(some);
    const refused = some.some(({ heading }) => heading === '## When something is wrong');
    const problems = (await tab.problemsAfterFrame()).filter((problem) => !refused || !/viscosity = 99/.test(problem));
    assert.deepEqual(problems, []);
  });
}
