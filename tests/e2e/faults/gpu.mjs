/** Crashes of Chromium's process for graphics. */
import { Browser } from '../driver.mjs';
import { FIRE, outcome, retry } from './outcome.mjs';

const CRASHES = 10;

/** @returns {AsyncGenerator<import('./outcome.mjs').Finding>} */
export async function* gpu() {
  const browser = await Browser.launch();
  try {
    const tab = await browser.open(FIRE);
    await tab.burnt(0.3);
    const session = await browser.browser.target().createCDPSession();
    for (let crash = 1; crash <= CRASHES; crash += 1) {
      await session.send('Browser.crashGpuProcess');
      yield await outcome(tab, `crash ${crash}`);
      await retry(tab);
    }
  } finally {
    await browser.close();
  }
}
