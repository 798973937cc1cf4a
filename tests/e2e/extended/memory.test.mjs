/**
 * A frame allocates no JavaScript objects, except the picture that is posted and the
 * statistics four times a second.
 */
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';
import { SITE } from '../site.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.launch();
});
after(() => browser?.close());

/** What handing on a picture may make, with its message where it goes to another thread. */
const PICTURE = { worker: 700, main: 250 };

/** The engine's script of wasm. */
const GLUE = 'web/wasm/hearth-engine.js';

/**
 * What a function in it does, by its name: gives a view of wasm's memory, or is imported by wasm and has this body.
 * @type {Map<string, string>}
 */
const ROLES = new Map();
const code = readFileSync(path.join(SITE, GLUE), 'utf8');
for (const [, name] of code.matchAll(/function ([\w$]+)\([^)]*\)\{[^{}]*\(\)\.subarray\([^()]*\)\}/g)) {
  ROLES.set(name, 'view');
}
for (const [, name, body] of code.matchAll(/[{,]([\w$]+):function\([^)]*\)\{(.*?)\}(?=,[\w$]+:function|\}\})/g)) {
  ROLES.set(name, `import ${body}`);
}

/**
 * Bytes that each function of the site allocated on the engine's thread, the rubbish
 * too, and how many pictures and messages came meanwhile.
 */
async function allocated(tab, thread, pictures) {
  const [worker] = tab.page.workers();
  const session = thread === 'worker' ? worker.client : await tab.page.createCDPSession();
  await session.send('HeapProfiler.enable');
  await session.send('HeapProfiler.startSampling', {
    samplingInterval: 64,
    includeObjectsCollectedByMajorGC: true,
    includeObjectsCollectedByMinorGC: true,
  });
  const counted = await tab.fire(async (fire, wanted) => {
    const seen = { reported: 0, pictures: 0 };
    fire.addEventListener('stats', () => (seen.reported += 1));
    const { prototype } = ImageBitmapRenderingContext;
    const original = prototype.transferFromImageBitmap;
    await new Promise((resolve) => {
      prototype.transferFromImageBitmap = function transferFromImageBitmap(bitmap) {
        original.call(this, bitmap);
        seen.pictures += 1;
        if (seen.pictures === wanted) resolve(undefined);
      };
    });
    prototype.transferFromImageBitmap = original;
    return seen;
  }, pictures);
  const { profile } = await session.send('HeapProfiler.stopSampling');
  const bytes = new Map();
  const visit = (node) => {
    const { url, functionName } = node.callFrame;
    if (url.includes('/web/') || url.startsWith('wasm:')) {
      const name = (url.endsWith(GLUE) && ROLES.get(functionName)) || functionName;
      bytes.set(name, (bytes.get(name) ?? 0) + node.selfSize);
    }
    for (const child of node.children) visit(child);
  };
  visit(profile.head);
  return { bytes, ...counted };
}

for (const thread of ['worker', 'main']) {
  for (const model of ['combustion', 'classic']) {
    test(`frames of a burning ${model} fire make no objects on the engine’s thread, ${thread}`, async () => {
      const tab = await browser.open(
        `<hearth-fire model="${model}" quality="low" max-pixels="10000"></hearth-fire><script type="module">
          import { HearthFire } from '/web/hearth-fire.js';
          HearthFire.engine = '${thread}';
        </script>`,
        { width: 260, height: 260 },
      );
      await tab.burnt(1);
      await tab.plays((await tab.fire((fire) => fire.stats.time)) + 0.3);
      const { bytes, pictures, reported } = await allocated(tab, thread, 100);
      // A time is a fraction, which V8 puts on the heap where it passes between the
      // browser, JavaScript and wasm.
      const boxed = /performance\.now|^js-to-wasm/;
      const ours = [...bytes].filter(([name]) => !boxed.test(name)).sort(([, a], [, b]) => b - a);
      const sum = ours.reduce((all, [, bytes]) => all + bytes, 0);
      const list = JSON.stringify(ours.slice(0, 8));
      // A message with its statistics has some forty fields.
      const most = 6000 * (reported + 1) + PICTURE[thread] * pictures;
      assert.ok(sum < most, `${sum} bytes in ${pictures} pictures and ${reported} messages: ${list}`);
      // A view or a list of arguments for a call of WebGL would be fifty bytes a frame.
      const roles = [...ROLES.values()];
      assert.ok(roles.includes('view'), 'wasm’s script has functions that give views');
      assert.ok(
        roles.some((role) => /^import .*drawArrays/.test(role)),
        'wasm imports functions that draw',
      );
      const drawing = ours.filter(([name]) => /^import (?!.*(\]=|new |\.call\())|^view$/.test(name));
      for (const [name, size] of drawing) {
        assert.ok(size < 25 * pictures, `${name} makes ${size} bytes in ${pictures} pictures`);
      }
      assert.deepEqual(tab.problems, []);
    });
  }
}
