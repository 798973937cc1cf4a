/** `to` by the real clock; its steps and what interrupts them are tested in `tests/web/transition.test.mjs`. */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launchWithoutDrawing();
});
after(() => browser?.close());

test('a transition that is requested before the fire is ready starts with it; numbers grow, and colours mix in OkLab', async () => {
  const tab = await browser.show('<p></p>');
  const { done, values } = await tab.evaluate(async () => {
    await import('./web/hearth-fire.js');
    const fire = /** @type {any} */ (document.createElement('hearth-fire'));
    fire.style.cssText = 'width: 40px; height: 50px';
    fire.setAttribute('paused', '');
    fire.setAttribute('background', '#000000');
    const values = { wind: [], background: [] };
    fire.addEventListener('params-change', ({ detail }) => values[detail.id]?.push(detail.value));
    const to = { wind: 1, background: 'white' };
    const done = fire.to(to, { duration: 300, easing: 'cubic-bezier(0.2, 0.4, 0.6, 1)' });
    document.body.append(fire);
    return { done: await done, values };
  });
  assert.equal(done, true);
  assert.deepEqual([values.wind.at(-1), values.background.at(-1)], [1, '#ffffff']);
  assert.ok(
    values.wind.every((value, index) => index === 0 || value > values.wind[index - 1]),
    `${values.wind}`,
  );
  for (const colour of values.background) assert.match(colour, /^#(\w\w)\1\1$/);
  assert.ok(values.background.length > 2, `${values.background}`);
  assert.deepEqual(await tab.problemsAfterFrame(), []);
});

test('with reduced motion values arrive at once', async () => {
  const tab = await browser.open('<hearth-fire paused></hearth-fire>', { reducedMotion: true });
  await tab.ready();
  const whole = await tab.fire((fire) => fire.to({ wind: 1 }, { duration: 1e9 }));
  assert.deepEqual([whole, await tab.fire((fire) => fire.wind)], [true, 1]);
});
