/**
 * The page of the paper's figures. A figure is measured when it first comes into sight, by the library, so its numbers
 * are the same on every machine; a fire out of sight does not run.
 */

import '../../hearth-fire.js';
import { addCell } from './cells.js';
import { showColours } from './colours.js';
import { COMPARISONS } from './comparisons.js';
import { addCounts } from './counts.js';
import { showLoop } from './loop.js';
import { seen } from './sight.js';

/** @type {(selector: string) => any} */
const find = (selector) => document.querySelector(selector);

/** @param {unknown} error */
const warn = (error) => {
  find('#status').textContent = `A figure could not be made: ${error instanceof Error ? error.message : error}.`;
};

for (const [id, cells] of Object.entries(COMPARISONS)) {
  const fires = find(`[aria-labelledby="${id}"] .fires`);
  for (const cell of cells) {
    const measure = addCell(fires, cell, warn);
    seen(fires.lastElementChild).then(measure);
  }
}

const colours = find('#colours');
seen(colours)
  .then(() => showColours(find('#colours hearth-fire'), find('#scale'), find('#kelvin'), find('#colour')))
  .catch(warn);

for (const list of /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll('.loop'))) {
  const fire = list.closest('figure')?.querySelector('hearth-fire');
  if (fire) showLoop(list, fire, list.dataset.model === 'classic' ? 'classic' : 'combustion');
}

addCounts(find('#counts'), location.search, warn);
