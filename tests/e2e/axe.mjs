/** axe-core, in a page. */
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';

const AXE = await readFile(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

/**
 * What axe-core finds wrong, a line each.
 * @param {import('./driver.mjs').Tab} tab
 * @returns {Promise<string[]>}
 */
export async function violations(tab) {
  // Evaluated by the driver, whatever the page's policy allows.
  await tab.evaluate(AXE);
  return tab.evaluate(async () => {
    const { axe } = /** @type {any} */ (window);
    const { violations: found } = await axe.run(document, { resultTypes: ['violations'] });
    return found.flatMap(({ id, help, nodes }) =>
      nodes.map(({ target, failureSummary }) => `${id} (${help}) at ${target.flat().join(' ')}: ${failureSummary}`),
    );
  });
}
