/** Each file that a page requests fails, in each way in which a server fails. */
import { Browser } from '../../driver.mjs';
import { FIRE, outcome } from './outcome.mjs';

/** @type {{[how: string]: import('../../server.mjs').Instead}} */
const FAULTS = {
  'is missing': { status: 404, type: 'text/plain', body: 'not found' },
  'is refused by the server': { status: 500, type: 'text/plain', body: 'an error' },
  'loses its connection': { drop: true },
  'is cut': { keep: 100 },
  'is a page of a proxy': { type: 'text/html', body: '<!doctype html><p>Sign in' },
  'is empty': { body: '' },
  'never arrives': { silent: true },
};

const FILE = JSON.stringify({ hearth: 3, values: { bloom: 0.3 } });

/** A fire that requests every kind of file, on the page's thread as well as in a worker. */
const BODY = FIRE.replace('<hearth-fire', '<hearth-fire preset="fireside" warm="0.1" controls="playback"');

/** Runs in the page: limits of downloads, and of a worker's start, pass ten times as fast. */
function hurry() {
  const { timeout } = AbortSignal;
  AbortSignal.timeout = (milliseconds) => timeout.call(AbortSignal, milliseconds / 10);
  const { setTimeout } = window;
  const scope = /** @type {any} */ (window);
  scope.setTimeout = (act, time, ...rest) => setTimeout(act, time >= 5000 ? time / 10 : time, ...rest);
}

/** @returns {AsyncGenerator<import('./outcome.mjs').Finding>} */
export async function* network() {
  const browser = await Browser.launch();
  try {
    for (const [name, body] of Object.entries(bodies())) {
      const files = { 'settings.json': { body: FILE, type: 'application/json' } };
      for (const file of await requested(browser, body, files)) {
        for (const [how, instead] of Object.entries(FAULTS)) {
          // A page whose script never arrives is never loaded, and seen all the same.
          const tab = await browser
            .open(body, { files: { [file]: instead, ...files }, before: hurry })
            .catch(() => browser.tab);
          yield await outcome(tab, `${name}: ${file} ${how}`);
        }
      }
    }
  } finally {
    await browser.close();
  }
}

/** Bodies whose files differ. @returns {{[name: string]: string}} */
function bodies() {
  const main = `<script type="module">
    import { HearthFire } from '/web/hearth-fire.js';
    HearthFire.engine = 'main';
  </script>`;
  return {
    'in a worker': BODY,
    'on the page’s thread': FIRE.replace('<hearth-fire', '<hearth-fire src="settings.json"') + main,
  };
}

/**
 * The files that the fire of a body requests.
 * @param {Browser} browser
 * @param {string} body
 * @param {{[name: string]: import('../../server.mjs').Instead}} files
 */
async function requested(browser, body, files) {
  const tab = await browser.open(body, { files });
  await tab.burnt(0.3);
  const names = await tab.evaluate(() =>
    performance
      .getEntriesByType('resource')
      .map(({ name }) => new URL(name))
      .map(
        ({ pathname, searchParams }) =>
          (pathname.startsWith('/driver/') ? new URL(searchParams.get('of') ?? location.href) : { pathname }).pathname,
      ),
  );
  return [...new Set(names)].filter((name) => /\.(js|wasm|fire|json)$/.test(name));
}
