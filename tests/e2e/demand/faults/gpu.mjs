/** Crashes of Chromium's process for graphics. */
import { Browser } from '../../driver.mjs';
import { FIRE, outcome, retry } from './outcome.mjs';

/** Chromium ends itself after the ninth crash within minutes, so two browsers share them. */
const [BROWSERS, CRASHES] = [2, 5];

/** @returns {AsyncGenerator<import('./outcome.mjs').Finding>} */
export async function* gpu() {
  for (let browser = 1; browser <= BROWSERS; browser += 1) yield* crashes(`browser ${browser}`);
}

/** @param {string} name @returns {AsyncGenerator<import('./outcome.mjs').Finding>} */
async function* crashes(name) {
  const browser = await Browser.launch();
  try {
    const tab = await browser.open(FIRE);
    await tab.burnt(0.3);
    const session = await browser.browser.target().createCDPSession();
    for (let crash = 1; crash <= CRASHES; crash += 1) {
      await session.send('Browser.crashGpuProcess');
      yield await outcome(tab, `${name}, crash ${crash}`);
      await retry(tab);
    }
  } finally {
    await browser.close();
  }
}
