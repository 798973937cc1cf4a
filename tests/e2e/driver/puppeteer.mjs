/**
 * Chromium, headless with software rendering, and Firefox, in a window of a virtual display;
 * puppeteer drives both.
 */
import { isDeepStrictEqual } from 'node:util';
import puppeteer from 'puppeteer-core';
import { display } from './display.mjs';
import { CHROMIUM_ALONE, chromium as whole, headlessShell, program } from './programs.mjs';
import { WAIT_MS, Tab } from './tab.mjs';

const CHROMIUM_FLAGS = [
  '--no-sandbox',
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
  '--ignore-gpu-blocklist',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  '--no-first-run',
  '--disable-quic',
];

/**
 * The processor composes the page, as in every Chromium without a graphics card. Composed by SwiftShader, a page waits
 * for the fire's picture and takes a quarter more time of the processor.
 */
const COMPOSED_BY_PROCESSOR = '--disable-gpu-compositing';

/** Pages of one origin share a process, which ends with the last of them. */
const ONE_PROCESS = '--process-per-site';

/** Timeout of one request of the driver to a page [ms]. */
const protocolTimeout = 4 * WAIT_MS;

/** @typedef {import('./browser.mjs').Opening} Opening */

/**
 * @param {{shell?: boolean, likeGraphicsCard?: boolean}} options
 * @param {import('../server.mjs').Server} server
 * @returns {Promise<import('./browser.mjs').Engine>}
 */
export async function chromium({ shell = false, likeGraphicsCard = false }, server) {
  const args = [...CHROMIUM_FLAGS];
  if (!likeGraphicsCard) args.push(COMPOSED_BY_PROCESSOR);
  if (shell) args.push(ONE_PROCESS);
  const executablePath = shell ? headlessShell() : whole();
  const browser = await puppeteer.launch({ executablePath, headless: shell ? 'shell' : true, args, protocolTimeout });
  // An empty page keeps the process between two pages of a test.
  if (shell) await (await browser.newPage()).goto(server.publish('<!doctype html>'));
  return {
    browser,
    version: () => versionOf(browser),
    fits: () => true,
    async open(opening) {
      const tab = await opened(browser, opening);
      await prefer(tab, opening.preferences);
      return tab;
    },
    close: () => browser.close(),
  };
}

/**
 * Gives a page of Chromium what a visitor prefers, while it runs too.
 * @param {Tab} tab @param {import('./browser.mjs').Preferences} preferences
 */
export async function prefer(tab, { reducedMotion, scheme, forcedColors }) {
  const client = await tab.page.createCDPSession();
  await client.send('Emulation.setEmulatedMedia', {
    features: [
      { name: 'prefers-reduced-motion', value: reducedMotion ? 'reduce' : 'no-preference' },
      { name: 'prefers-color-scheme', value: scheme },
      { name: 'forced-colors', value: forcedColors ? 'active' : 'none' },
    ],
  });
}

/** What a finger can point at, and a mouse: bits of Firefox's preference for the media queries of pointers. */
const POINTS = { finger: 1, mouse: 6 };

/**
 * @param {import('./browser.mjs').Desktop} options  Of all its pages.
 * @returns {Promise<import('./browser.mjs').Engine>}
 */
export async function firefox({ preferences, touch }) {
  const points = touch ? POINTS.finger : POINTS.mouse;
  const executablePath = program('HEARTH_FIREFOX', ['firefox-esr', 'firefox'], 'firefox-esr');
  const screen = await display();
  const browser = await puppeteer
    .launch({
      browser: 'firefox',
      executablePath,
      headless: false,
      env: { ...process.env, DISPLAY: screen.name, WAYLAND_DISPLAY: undefined },
      extraPrefsFirefox: {
        'ui.prefersReducedMotion': preferences.reducedMotion ? 1 : 0,
        'layout.css.prefers-color-scheme.content-override': preferences.scheme === 'dark' ? 0 : 1,
        'browser.display.document_color_use': preferences.forcedColors ? 2 : 1,
        'ui.primaryPointerCapabilities': points,
        'ui.allPointerCapabilities': points,
      },
      protocolTimeout,
    })
    .catch((error) => {
      screen.close();
      throw error;
    });
  return {
    browser,
    version: () => versionOf(browser),
    fits: (opening) => isDeepStrictEqual([opening.preferences, opening.touch], [preferences, touch]),
    async open(opening) {
      const tab = await opened(browser, opening);
      // Keys would go to the line of the address.
      await tab.page.bringToFront();
      Object.assign(tab.page, CHROMIUM_ALONE);
      return tab;
    },
    async close() {
      await browser.close();
      screen.close();
    },
  };
}

/** `Chrome/156.0.8078.108` → `156.0.8078`. @param {import('puppeteer-core').Browser} browser */
const versionOf = async (browser) => String((await browser.version()).match(/\d+(\.\d+){0,2}/)?.[0]);

/**
 * A new page, which records its problems.
 * @param {import('puppeteer-core').Browser} browser
 * @param {Opening} opening
 */
async function opened(browser, { width, height, ratio, touch, before }) {
  const page = await browser.newPage();
  const tab = new Tab(page);
  const { problems } = tab;
  page.on('console', (message) => {
    // A software renderer reports its own speed, which depends on the machine.
    if (message.text().includes('GL Driver Message (OpenGL, Performance')) return;
    if (['error', 'warn', 'warning', 'assert'].includes(message.type())) {
      problems.push(`console.${message.type()}: ${message.text()}`);
    }
  });
  page.on('pageerror', (error) => {
    const message = error instanceof Error ? error.message : String(error);
    // What a page's policy blocks is an error of Firefox without an exception of the page.
    problems.push(message.startsWith('Content-Security-Policy:') ? message : `uncaught: ${message}`);
  });
  // An open dialog stops the page, so that the next evaluation would wait for ever.
  page.on('dialog', (dialog) => {
    problems.push(`dialog: ${dialog.message()}`);
    void dialog.dismiss();
  });
  page.on('requestfailed', (request) => {
    const why = request.failure()?.errorText ?? '';
    // Firefox reports what an iframe still loads when its page removes it.
    if (why !== 'Browsing context already closed.') problems.push(`request failed: ${request.url()} ${why}`);
  });
  page.on('response', (response) => {
    if (response.status() >= 400) problems.push(`${response.status()}: ${response.url()}`);
  });
  await page.setViewport({ width, height, deviceScaleFactor: ratio, isMobile: touch, hasTouch: touch });
  for (const script of before) await page.evaluateOnNewDocument(script);
  return tab;
}
