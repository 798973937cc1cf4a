/**
 * The one way in which tests and benchmarks drive a real browser: serve the
 * site on loopback, start Chromium, Firefox or WebKit on software rendering, open
 * a page at a size, press, drag with mouse or finger, ask the page, take its
 * picture, lose its WebGL2 context, and keep every complaint that it makes.
 *
 * `HEARTH_SITE` names the folder of the built site (else `dist/site`);
 * `HEARTH_CHROMIUM`, `HEARTH_FIREFOX`, `HEARTH_WEBKIT_DRIVER` and `HEARTH_XVFB` the
 * programs (else those on the PATH). A browser that is not there is a failure,
 * never a skipped test; `HEARTH_BROWSERS=chromium,firefox` asks for some of the three.
 */
export { Browser } from './driver/browser.mjs';
export { BROWSERS } from './driver/programs.mjs';

/** @typedef {import('./driver/puppeteer.mjs').PuppeteerTab} Tab */
/** @typedef {import('./driver/tab.mjs').Point} Point */
/** @typedef {import('./driver/tab.mjs').Rectangle} Rectangle */
