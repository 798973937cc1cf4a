/** A thousand elements that come and go, in groups and within one task. */
import { Browser } from '../../driver.mjs';
import { FIRE, outcome } from './outcome.mjs';

const ELEMENTS = 1000;
const GROUP = 20;

/** @returns {AsyncGenerator<import('./outcome.mjs').Finding>} */
export async function* elements() {
  const browser = await Browser.launch();
  try {
    const tab = await browser.open(FIRE);
    await tab.burnt(0.3);
    for (let made = 0; made < ELEMENTS; made += GROUP) {
      const wrong = await tab.evaluate(
        async (count, first) => {
          const fires = Array.from({ length: count }, (_, index) => {
            const fire = /** @type {any} */ (document.createElement('hearth-fire'));
            fire.style.cssText = 'width: 40px; height: 50px';
            fire.setAttribute('max-particles', '100');
            fire.setAttribute('seed', String(first + index));
            return fire;
          });
          document.body.append(...fires);
          // Some leave at once, some come back, the others stay until they are ready.
          const stay = fires.filter((fire, index) => {
            if (index % 4 === 0) fire.remove();
            if (index % 8 === 0) document.body.append(fire);
            return index % 4 !== 0 || index % 8 === 0;
          });
          const failures = await Promise.all(
            stay.map((fire) =>
              fire.ready.then(
                () => '',
                (/** @type {Error} */ { message }) => message,
              ),
            ),
          );
          for (const fire of fires) fire.remove();
          return failures.filter(Boolean);
        },
        GROUP,
        made,
      );
      const fault = `elements ${made + 1} to ${made + GROUP}`;
      const finding = await outcome(tab, fault);
      yield wrong.length === 0 ? finding : { ...finding, outcome: 'reported', detail: wrong.join('; ') };
    }
    const { contexts, workers } = await tab.living();
    const rest = contexts === 1 && workers === 1;
    yield { fault: 'the rest', outcome: rest ? 'burns' : 'silent', detail: `${contexts} contexts, ${workers} workers` };
  } finally {
    await browser.close();
  }
}
