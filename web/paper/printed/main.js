/** The page of fires with one equation as printed: the numbers beside each pair, simulated by the library. */

import '../../hearth-fire.js';
import { measure } from './measure.js';

/** Lets the page draw between two fires. */
const pause = () => new Promise((resolve) => setTimeout(resolve));

const status = /** @type {HTMLElement} */ (document.getElementById('status'));
const sections = /** @type {HTMLElement[]} */ ([...document.querySelectorAll('section[data-flag]')]);

async function showNumbers() {
  status.textContent = 'Simulating …';
  const corrected = await measure('', pause);
  for (const section of sections) {
    const { flag = '', measure: name = '' } = section.dataset;
    const printed = await measure(flag, pause);
    for (const [which, numbers] of Object.entries({ corrected, printed })) {
      const cell = /** @type {HTMLElement} */ (section.querySelector(`[data-number="${which}"]`));
      cell.textContent = numbers[/** @type {keyof typeof numbers} */ (name)].toPrecision(2);
    }
  }
  status.textContent = '';
}

showNumbers().catch((error) => {
  status.textContent = `The numbers could not be simulated: ${error instanceof Error ? error.message : error}.`;
});
