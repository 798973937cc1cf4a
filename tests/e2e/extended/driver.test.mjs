/**
 * The browser driver: a missing browser is a failure with the name of its package, a page's
 * dialog is a problem of the page, and the server sends the requested replacements.
 */
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { test } from 'node:test';
import { promisify } from 'node:util';
import { Browser } from '../driver.mjs';
import { serve } from '../server.mjs';

const HERE = new URL('..', import.meta.url);

/** The output of a script in a process with its own environment. */
async function output(script, env) {
  const node = promisify(execFile)(process.execPath, ['--input-type=module', '-e', script], {
    cwd: HERE,
    env: { ...process.env, ...env },
  });
  return node.then(
    ({ stdout }) => stdout,
    ({ stderr }) => stderr,
  );
}

for (const [kind, variable, words] of [
  ['chromium', 'HEARTH_CHROMIUM', /no chromium: install Debian's "chromium"/],
  ['firefox', 'HEARTH_FIREFOX', /no firefox-esr: install Debian's "firefox-esr"/],
  ['webkit', 'HEARTH_WEBKIT_DRIVER', /no WebKitWebDriver: install Debian's "webkit2gtk-driver"/],
]) {
  test(`without ${kind} the driver fails and names the package to install`, async () => {
    const start = `import { Browser } from './driver.mjs'; await Browser.start('${kind}');`;
    assert.match(await output(start, { [variable]: '', PATH: '' }), words);
  });
}

test('HEARTH_BROWSERS selects browsers, and a misspelt name is reported', async () => {
  const list = "import { BROWSERS } from './driver.mjs'; console.log(BROWSERS.join());";
  const asked = (names) => output(list, { HEARTH_BROWSERS: names });
  assert.equal((await asked('')).trim(), 'chromium,firefox,webkit');
  assert.equal((await asked('webkit, chromium')).trim(), 'webkit,chromium');
  assert.match(await asked('webkit,opera'), /"opera"; there are: chromium, firefox, webkit/);
});

test('a dialog that a page opens is a problem of the page and does not stop it', async () => {
  const browser = await Browser.launch();
  try {
    const tab = await browser.open('<button onclick="setTimeout(() => alert(\'Hello\'))">Greet</button>');
    await tab.evaluate(() => document.querySelector('button')?.click());
    await tab.frames(3);
    assert.deepEqual(await tab.problemsAfterFrame(), ['dialog: Hello']);
  } finally {
    await browser.close();
  }
});

test('a body that is shown replaces the last one in its page, whose fires are destroyed; after a lost context a page opens', async () => {
  const browser = await Browser.launchWithoutDrawing();
  try {
    const fire = (id) =>
      `<hearth-fire id="${id}" quality="low" paused></hearth-fire><script>window.seen = '${id}'</script>`;
    const first = await browser.show(fire('first'));
    await first.ready();
    await first.evaluate(() => {
      document.title = 'kept';
    });
    const second = await browser.show(fire('second'));
    await second.ready();
    assert.equal(second, first);
    assert.deepEqual(await second.evaluate(() => [document.title, /** @type {any} */ (window).seen]), [
      'kept',
      'second',
    ]);
    assert.deepEqual(await second.evaluate(() => [...document.querySelectorAll('hearth-fire')].map(({ id }) => id)), [
      'second',
    ]);
    assert.equal((await second.living()).contexts, 1);
    assert.notEqual(await browser.show(fire('wide'), { width: 600 }), second);
    const lost = await browser.show(fire('lost'), { width: 600 });
    await lost.ready();
    await lost.loseContext();
    assert.notEqual(await browser.show(fire('next'), { width: 600 }), lost);
  } finally {
    await browser.close();
  }
});

test('the server sends replacements of files, and files that a browser has need not be sent', async () => {
  const server = await serve(HERE.pathname);
  try {
    const get = async (name) => {
      const response = await fetch(`${server.origin}/${name}`);
      const type = response.headers.get('content-type');
      return { status: response.status, type, text: await response.text(), of: response.headers.get('x-of') };
    };
    const whole = await get('run.mjs');
    assert.deepEqual([whole.status, whole.type], [200, 'text/javascript; charset=utf-8']);
    assert.equal((await get('nothing.json')).status, 404);
    server.replace({ 'run.mjs': { keep: 10, type: 'text/plain', headers: { 'x-of': 'a test' } } });
    const partial = await get('run.mjs');
    assert.deepEqual(partial, { status: 200, type: 'text/plain', text: whole.text.slice(0, 10), of: 'a test' });
    server.replace({ 'run.mjs': { drop: true }, 'new.json': { body: '{}' }, 'assertions.mjs': { status: 503 } });
    await assert.rejects(get('run.mjs'));
    assert.deepEqual(await get('new.json'), { status: 200, type: 'application/json', text: '{}', of: null });
    assert.equal((await get('assertions.mjs')).status, 503);
    server.replace({});
    assert.equal((await get('run.mjs')).text, whole.text);
    const ask = async (headers = {}) => {
      const response = await fetch(`${server.origin}/run.mjs`, { headers });
      return { status: response.status, etag: response.headers.get('etag') ?? '', text: await response.text() };
    };
    const { etag } = await ask();
    const kept = { 'if-none-match': etag };
    assert.deepEqual(await ask(kept), { status: 304, etag, text: '' });
    server.replace({ 'run.mjs': { body: 'other' } });
    assert.deepEqual(await ask(kept), { status: 200, etag: '', text: 'other' });
    server.replace({});
    server.cached = false;
    assert.deepEqual(await ask(kept), { status: 200, etag: '', text: whole.text });
    const page = server.publish('<!doctype html><html lang="en">', { 'x-of': 'a page' });
    assert.equal((await get(new URL(page).pathname.slice(1))).of, 'a page');
  } finally {
    await server.close();
  }
});
