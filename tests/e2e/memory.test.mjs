/**
 * A burning fire makes no garbage: no JavaScript object is made for a frame, only
 * for the messages that the fire sends four times a second.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from './driver.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launch();
});
after(() => browser?.close());

/** Bytes that each function of the site allocated, the rubbish too, while `frames` frames were drawn. */
async function allocated(tab, frames) {
  const session = await tab.page.createCDPSession();
  await session.send('HeapProfiler.enable');
  await session.send('HeapProfiler.startSampling', {
    samplingInterval: 64,
    includeObjectsCollectedByMajorGC: true,
    includeObjectsCollectedByMinorGC: true,
  });
  const stats = await tab.fire(async (fire, wanted) => {
    let told = 0;
    fire.addEventListener('stats', () => (told += 1));
    for (let left = wanted; left > 0; left -= 1) await new Promise(requestAnimationFrame);
    return told;
  }, frames);
  const { profile } = await session.send('HeapProfiler.stopSampling');
  await session.detach();
  const bytes = new Map();
  const visit = (node) => {
    const { url, functionName } = node.callFrame;
    if (url.includes('/web/') || url.startsWith('wasm:')) {
      bytes.set(functionName, (bytes.get(functionName) ?? 0) + node.selfSize);
    }
    for (const child of node.children) visit(child);
  };
  visit(profile.head);
  return { bytes, stats };
}

for (const model of ['combustion', 'classic']) {
  test(`frames of a burning ${model} fire make no objects`, async () => {
    const tab = await browser.open(
      `<hearth-fire model="${model}" quality="low"></hearth-fire>`,
      { width: 260, height: 260 },
    );
    await tab.burnt(2);
    const frames = 200;
    const { bytes, stats } = await allocated(tab, frames);
    // A time is a fraction, which V8 puts on the heap where it passes between the
    // browser, JavaScript and wasm.
    const boxed = /^__wbg_now|^js-to-wasm/;
    const ours = [...bytes].filter(([name]) => !boxed.test(name)).sort(([, a], [, b]) => b - a);
    const sum = ours.reduce((all, [, one]) => all + one, 0);
    const list = JSON.stringify(ours.slice(0, 8));
    // A message has some forty fields.
    const most = 6000 * (stats + 1);
    assert.ok(sum < most, `${sum} bytes in ${frames} frames and ${stats} messages: ${list}`);
    // A view or a list of arguments for a call of WebGL would be fifty bytes a frame.
    const drawing = ours.filter(([name]) => /^__wbg_(?!set|new|call|now)|[aA]rray/.test(name));
    for (const [name, size] of drawing) {
      assert.ok(size < 25 * frames, `${name} makes ${size} bytes in ${frames} frames`);
    }
    assert.deepEqual(tab.problems, []);
  });
}
