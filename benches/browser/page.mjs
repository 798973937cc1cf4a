/**
 * Measures the page: time to the first picture, statistics, and the longest task of the
 * page's thread.
 */
import { setTimeout as sleep } from 'node:timers/promises';
import { Browser } from '../../tests/e2e/driver.mjs';

/** Loads of the page in a window of 1280 × 800; the first one fills the disk's cache. */
const LOADS = 9;

/** Time between two loads [ms]. */
const REST = 300;

/** How long the page's thread is watched [ms]. */
const WATCHED = 5000;

/** Runs in the page before anything of it: notes when the first picture is shown. */
export function noteFirstPicture() {
  const { prototype } = ImageBitmapRenderingContext;
  const original = prototype.transferFromImageBitmap;
  prototype.transferFromImageBitmap = function transferFromImageBitmap(bitmap) {
    /** @type {any} */ (window).firstPicture ??= performance.now();
    original.call(this, bitmap);
  };
}

/** The longest task of the page's thread while the fire burns [ms]; 0 where none takes 50. */
function longestTask(milliseconds) {
  return new Promise((resolve) => {
    let longest = 0;
    const observer = new PerformanceObserver((list) => {
      for (const { duration } of list.getEntries()) longest = Math.max(longest, duration);
    });
    observer.observe({ type: 'longtask' });
    setTimeout(() => {
      observer.disconnect();
      resolve(longest);
    }, milliseconds);
  });
}

/**
 * Measures the built site in a folder.
 * @param {string} site
 */
export async function onThePage(site) {
  const browser = await Browser.start({ kind: 'chromium', folders: [site], likeGraphicsCard: true });
  // A page is measured as a first visit loads it, and as it draws by itself.
  browser.server.cached = false;
  const pixels = Infinity;
  try {
    const full = await browser.open('index.html?scene=default', { width: 1280, height: 720, pixels });
    await full.plays(10);
    const stats = await full.fire((fire) => fire.stats);

    const times = [];
    for (let load = 0; load <= LOADS; load += 1) {
      // The page before is taken down beside the next one, which would wait for its graphics.
      await browser.open('<p>Rest</p>');
      await sleep(REST);
      const tab = await browser.open('index.html', { width: 1280, height: 800, pixels, before: noteFirstPicture });
      const time = await tab.until('a picture', () => /** @type {any} */ (window).firstPicture);
      if (load > 0) times.push(time);
    }
    times.sort((a, b) => a - b);

    const many = await browser.open('<hearth-fire particles="10000"></hearth-fire>');
    await many.plays(0.3);
    const longest = await many.evaluate(longestTask, WATCHED);
    const firstPicture = { median: times[times.length >> 1], best: times[0] };
    return { ...stats, firstPicture, longestTask: longest };
  } finally {
    await browser.close();
  }
}
