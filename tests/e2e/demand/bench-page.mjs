/**
 * Measures the paper's tables on the page `bench.html` and writes them as Markdown: `cargo measure paper`. The
 * arguments are the file and, for a part of the rows, the page's query.
 */
import { writeFileSync } from 'node:fs';
import { setTimeout as sleep } from 'node:timers/promises';
import { Browser } from '../driver.mjs';

/** Time between two looks at the page [ms]. */
const LOOK_MS = 1000;

const [file, query = ''] = process.argv.slice(2);
if (!file) throw new Error('the arguments are a file and, optionally, the query of the page');

const browser = await Browser.start({ kind: 'chromium', likeGraphicsCard: true });
try {
  const tab = await browser.open(`bench.html${query}`, { width: 1000, height: 1000, pixels: Infinity });
  await tab.page.click('#measure');
  const status = () => tab.evaluate(() => document.getElementById('status')?.textContent ?? '');
  let printed = '';
  for (;;) {
    await sleep(LOOK_MS);
    const now = await status();
    if (now !== printed) console.log(`  ${now}`);
    printed = now;
    if (now.startsWith('Done.')) break;
    if (now.startsWith('Not measured')) throw new Error(now);
  }
  await tab.page.click('[data-copies="markdown"]');
  const tables = await tab.evaluate(() => /** @type {HTMLTextAreaElement} */ (document.getElementById('copy')).value);
  writeFileSync(file, tables);
} finally {
  await browser.close();
}
