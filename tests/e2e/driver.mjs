/**
 * The browser driver of tests and benchmarks. It serves the site on loopback, starts
 * Chromium, Firefox or WebKit with software rendering, opens pages, sends input, runs
 * functions in the page, takes pictures, loses WebGL2 contexts and records problems.
 *
 * `HEARTH_SITE` names the folder of the built site (`dist/site` by default);
 * `HEARTH_CHROMIUM`, `HEARTH_HEADLESS_SHELL`, `HEARTH_FIREFOX`, `HEARTH_WEBKIT_DRIVER` and
 * `HEARTH_XVFB` name programs (by default those on the PATH). A missing browser is a failure, never a skipped
 * test; `HEARTH_BROWSERS=firefox` names another browser than Chromium.
 */
export { Browser } from './driver/browser.mjs';
export { BACKWARDS, BROWSER, BROWSERS, STOPPED, TABS, THREAD, THREADS, except } from './driver/programs.mjs';
export { eventually } from './driver/tab.mjs';

/** @typedef {import('./driver/tab.mjs').Tab} Tab */
/** @typedef {import('./driver/tab.mjs').Point} Point */
/** @typedef {import('./driver/tab.mjs').Rectangle} Rectangle */
