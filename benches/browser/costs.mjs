/**
 * Measures what a fire costs the page around it, and writes the tables of docs/costs.md: Core Web Vitals without a fire
 * and with one, over a slow line, and the processor's time of a hero that burns for as long as the page is open. Times of the
 * processor are those of a second of fire and of a picture, which a busy machine does not change.
 *
 * `node benches/browser/costs.mjs` measures the built site; `vitals` or `hero` behind it measures that alone.
 */
import { readFileSync, readdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { setTimeout as sleep } from 'node:timers/promises';
import { brotliCompressSync } from 'node:zlib';
import { Browser } from '../../tests/e2e/driver.mjs';
import { SITE } from '../../tests/e2e/site.mjs';

const DOCUMENT = new URL('../../docs/costs.md', import.meta.url);

/** The line: its latency [ms] and bits a second. */
const LINE = { latency: 150, rate: 1.6e6 };
const ROUNDS = Number(process.env.HEARTH_ROUNDS ?? 3);
/** Presses of the button, and the time between two [ms]. */
const PRESSES = 10;
const BETWEEN = 250;

/** How long a hero burns up, and is measured [ms]. */
const BURN_UP = 5000;
const MEASURED = 8000;

const PLACE = 'position: absolute; inset: 0 0 0 40%';
const POSTER =
  '<img slot="poster" src="/web/poster.jpg" width="1200" height="630" alt="" style="width: 100%; height: 100%">';
const CARD =
  '<hearth-fire preset="candle" seed="auto" warm decorative style="width: 200px; height: 200px"></hearth-fire>';

const HERO = `<hearth-fire preset="campfire" warm decorative style="${PLACE}"></hearth-fire>`;

/** What stands in the header of each page, and whether the processor draws it. @type {[name: string, fire: string, draws: boolean][]} */
const VITALS = [
  ['no fire', '', true],
  ['a hero', HERO, false],
  [
    'a hero with a poster',
    `<hearth-fire preset="campfire" warm decorative style="${PLACE}">${POSTER}</hearth-fire>`,
    false,
  ],
  ['three candles on cards', CARD.repeat(3), false],
  ['a hero that the processor draws', HERO, true],
];

/** The heroes: their attributes, and what happens to them. @type {[name: string, attributes: string, then?: 'still' | 'away'][]} */
const HEROES = [
  ['level by itself (`auto`)', ''],
  ['`quality="low"`', 'quality="low"'],
  ['`quality="low" fps-limit="30"`', 'quality="low" fps-limit="30"'],
  ['`quality="high"`', 'quality="high"'],
  ['`model="classic"`', 'model="classic"'],
  ['scrolled away', '', 'away'],
  ['reduced motion: a still picture', '', 'still'],
];

const page = (/** @type {string} */ fire, /** @type {string} */ height) => `<!doctype html>
<html lang="en">
<meta charset="utf-8"><title>A page</title><link rel="icon" href="data:,">
<style>
  body { margin: 0; font: 18px/1.5 system-ui, sans-serif }
  header { position: relative; height: ${height}; padding: 40px; background: #120c0a; color: #fff }
  hearth-fire { display: inline-block; overflow: hidden }
  main { height: 2000px; padding: 40px }
</style>
${fire ? '<script type="module" src="/web/hearth-fire.js"></script>' : ''}
<header><h1>Winter menu</h1><p>Cooked over the fire, from five in the evening.</p>${fire}</header>
<main><button onclick="this.textContent = Number(this.textContent) + 1">0</button></main>
</html>`;

/** Runs in the page before its scripts: counts the pictures that it shows. */
function countPictures() {
  const { prototype } = ImageBitmapRenderingContext;
  const show = prototype.transferFromImageBitmap;
  let pictures = 0;
  prototype.transferFromImageBitmap = function transfer(bitmap) {
    pictures += 1;
    show.call(this, bitmap);
  };
  Object.defineProperty(window, 'pictures', { get: () => pictures });
}

/** Runs in the page before its scripts: keeps what browsers report of it. */
function watch() {
  /** @type {{lcp: number, cls: number, longest: Map<number, number>}} */
  const seen = { lcp: 0, cls: 0, longest: new Map() };
  Object.assign(window, { seen });
  /** @param {string} type @param {(entry: any) => void} take @param {object} [options] */
  const observe = (type, take, options) =>
    new PerformanceObserver((list) => list.getEntries().forEach(take)).observe({ type, buffered: true, ...options });
  observe('largest-contentful-paint', ({ startTime }) => (seen.lcp = startTime));
  observe('layout-shift', ({ value, hadRecentInput }) => (seen.cls += hadRecentInput ? 0 : value));
  observe(
    'event',
    ({ interactionId, duration }) => {
      if (interactionId) seen.longest.set(interactionId, Math.max(seen.longest.get(interactionId) ?? 0, duration));
    },
    { durationThreshold: 16 },
  );
}

/** The files of an element as a server sends them, compressed; the driver starts the worker from one of its own. */
function compressed() {
  const names = readdirSync(path.join(SITE, 'web'), { recursive: true }).map(String);
  const sent = names.filter((name) => /\.(js|wasm)$/.test(name) && !/panel|sim|worker/.test(name));
  const entries = sent.map((name) => {
    const body = brotliCompressSync(readFileSync(path.join(SITE, 'web', name)));
    return /** @type {const} */ ([`/web/${name}`, { body, headers: { 'content-encoding': 'br' } }]);
  });
  return Object.fromEntries(entries);
}

const median = (/** @type {number[]} */ values) => values.toSorted((a, b) => a - b)[Math.floor(values.length / 2)];

/** @param {Browser} browser @param {{[name: string]: import('../../tests/e2e/server.mjs').Instead}} files @param {string} fire @param {boolean} draws */
async function vitals(browser, files, fire, draws) {
  const size = { width: 1280, height: 800 };
  const tab = await browser.open('<!doctype html><title>Before</title>', { ...size, before: watch, draws });
  browser.server.replace(files);
  await tab.page.setCacheEnabled(false);
  const line = await tab.page.createCDPSession();
  const throughput = LINE.rate / 8;
  const { latency } = LINE;
  const conditions = { offline: false, latency, downloadThroughput: throughput, uploadThroughput: throughput };
  await line.send('Network.emulateNetworkConditions', conditions);
  await tab.page.goto(browser.server.publish(page(fire, '480px')));
  if (fire) {
    await tab.until('the fires are ready', () =>
      [...document.querySelectorAll('hearth-fire')].every((it) => /** @type {any} */ (it).stats?.fps > 0),
    );
  }
  const shown = fire ? await tab.evaluate(() => performance.now()) : 0;
  for (let press = 0; press < PRESSES; press += 1) {
    await tab.page.click('button');
    await sleep(BETWEEN + 37 * (press % 5));
  }
  const { lcp, cls, longest } = await tab.evaluate(() => {
    const { seen } = /** @type {any} */ (window);
    return { ...seen, longest: [...seen.longest.values()] };
  });
  // An interaction below the threshold has no entry.
  return { lcp, cls, inp: Math.max(16, ...longest), shown };
}

/** The processor's time of each kind of process so far [s]. @param {any} session */
async function processorTime(session) {
  const { processInfo } = await session.send('SystemInfo.getProcessInfo');
  const of = (/** @type {string} */ kind) =>
    processInfo.filter(({ type }) => type === kind).reduce((sum, { cpuTime }) => sum + cpuTime, 0);
  return { page: of('renderer'), drawing: of('GPU') };
}

/**
 * The processor's time of a hero [s]: of simulation and page for each second of fire, or of the clock where it does not
 * burn; of drawing for each picture, if the processor draws.
 * @param {Browser} browser @param {any} session @param {typeof HEROES[number]} hero @param {boolean} draws
 */
async function hero(browser, session, [, attributes, then], draws) {
  const fire = `<hearth-fire preset="campfire" warm decorative ${attributes} style="position: absolute; inset: 0"></hearth-fire>`;
  const opening = { width: 1280, height: 800, reducedMotion: then === 'still', before: countPictures, draws };
  const tab = await browser.open(page(fire, '400px'), opening);
  await tab.ready();
  await sleep(BURN_UP);
  if (then === 'away') await tab.evaluate(() => scrollTo(0, 1000));
  if (then === 'away') await sleep(1000);
  const now = async () => {
    const { time, pictures } = await tab.fire((it) => ({
      time: it.stats.time,
      pictures: /** @type {any} */ (window).pictures,
    }));
    return { time, pictures, clock: performance.now() / 1000, ...(await processorTime(session)) };
  };
  const from = await now();
  await sleep(MEASURED);
  const to = await now();
  const passed = (/** @type {keyof typeof from} */ what) => to[what] - from[what];
  return {
    own: passed('page') / (then ? passed('clock') : passed('time')),
    picture: passed('drawing') / Math.max(1, passed('pictures')),
    stats: await tab.fire(({ stats }) => ({ ...stats })),
  };
}

/** @param {string} mark @param {string[]} lines */
function write(mark, lines) {
  const [begin, end] = [`<!-- ${mark}: begin -->`, `<!-- ${mark}: end -->`];
  const text = readFileSync(DOCUMENT, 'utf8');
  const at = text.indexOf(begin) + begin.length;
  writeFileSync(DOCUMENT, `${text.slice(0, at)}\n\n${lines.join('\n')}\n\n${text.slice(text.indexOf(end))}`);
  console.log(lines.join('\n'));
}

const [only] = process.argv.slice(2);
const browser = await Browser.launch();
try {
  const chromium = /** @type {any} */ (browser.engine).browser;
  if (only !== 'hero') {
    const files = compressed();
    /** @type {Awaited<ReturnType<typeof vitals>>[][]} */
    const found = VITALS.map(() => []);
    for (let round = 0; round < ROUNDS; round += 1) {
      for (const [at, [, fire, draws]] of VITALS.entries()) found[at].push(await vitals(browser, files, fire, draws));
    }
    const rows = VITALS.map(([name], at) => {
      const of = (/** @type {'lcp' | 'cls' | 'inp' | 'shown'} */ what) => median(found[at].map((one) => one[what]));
      const shown = of('shown') ? `${(of('shown') / 1000).toFixed(1)} s` : '';
      return `| ${name} | ${(of('lcp') / 1000).toFixed(2)} s | ${of('cls').toFixed(3)} | ${of('inp').toFixed(0)} ms | ${shown} |`;
    });
    write('vitals', [
      `${await chromium.version()}, medians of ${ROUNDS} rounds. Where nothing else is said, drawing is left out, as a graphics card would take it.`,
      '',
      '| page | LCP | CLS | INP | the fire is seen after |',
      '|---|--:|--:|--:|--:|',
      ...rows,
    ]);
  }
  if (only !== 'vitals') {
    browser.server.replace({});
    const session = await chromium.target().createCDPSession();
    const rows = [];
    for (const one of HEROES) {
      const { own, stats } = await hero(browser, session, one, false);
      const burns = one[2] ? '| |' : `${stats.particles} | ${stats.stepMs.toFixed(1)} ms |`;
      rows.push(`| ${one[0]} | ${(100 * own).toFixed(own < 0.1 ? 1 : 0)} % | ${burns}`);
    }
    const { picture, stats } = await hero(browser, session, HEROES[0], true);
    write('hero', [
      `${await chromium.version()}. Where the processor draws, a picture of the first row takes ${(1000 * picture).toFixed(0)} ms` +
        ` more at the level ${stats.quality}.`,
      '',
      '| hero | simulation and page, of one core | particles | a step |',
      '|---|--:|--:|--:|',
      ...rows,
    ]);
  }
} finally {
  await browser.close();
}
