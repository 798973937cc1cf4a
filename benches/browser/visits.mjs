/**
 * Prints what a first visit of each entry downloads, and when it shows its first picture: a line of JSON with the bytes of all
 * files until no more come, compressed by brotli, and milliseconds from the start of the page, of this machine.
 * `cargo xtask cost` records them in benches/instructions.json.
 */
import { readFileSync } from 'node:fs';
import { brotliCompressSync } from 'node:zlib';
import { Browser } from '../../tests/e2e/driver.mjs';
import { noteFirstPicture } from './page.mjs';

const DESKTOP = { width: 1280, height: 800 };
const PHONE = { width: 390, height: 844, touch: true };

/** Pictures of the page without another file. */
const QUIET = 120;

/** @type {[entry: string, page: string, screen: {width: number, height: number, touch?: boolean}][]} */
const ENTRIES = [
  ['page', 'index.html', DESKTOP],
  ['page on a phone', 'index.html', PHONE],
  ['element', '<hearth-fire></hearth-fire>', DESKTOP],
  ['element with its panel', '<hearth-fire controls></hearth-fire>', DESKTOP],
];

/** @type {{[entry: string]: {bytes: number, first_picture_ms: number}}} */
const found = {};
for (const [entry, page, screen] of ENTRIES) {
  // A browser of its own has no file in its cache.
  const browser = await Browser.launch();
  /** @type {Set<string>} */
  const files = new Set();
  browser.server.served = (file) => files.add(file);
  try {
    const tab = await browser.open(page, { ...screen, before: noteFirstPicture });
    const time = await tab.until('a picture', () => /** @type {any} */ (window).firstPicture);
    await tab.plays(1);
    // What is not urgent comes when the page has time.
    for (let before = 0; before < files.size; ) {
      before = files.size;
      await tab.frames(QUIET);
    }
    const sizes = [...files].map((file) => brotliCompressSync(readFileSync(file)).length);
    const bytes = sizes.reduce((sum, size) => sum + size, 0);
    found[entry] = { bytes, first_picture_ms: Math.round(time) };
  } finally {
    await browser.close();
  }
}
console.log(JSON.stringify(found));
