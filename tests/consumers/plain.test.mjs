/**
 * A static page with a copy of the package: beside it, above it and on another origin.
 */
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { serve } from '../e2e/server.mjs';
import { PACKAGE, copied } from './package.mjs';
import { browser, burnsWell, page } from './pages.mjs';

const { open } = browser();
/** @type {import('../e2e/server.mjs').Server} */
let site;
/** @type {import('../e2e/server.mjs').Server} */
let elsewhere;

before(async () => {
  site = await serve(await copied());
  elsewhere = await serve(PACKAGE);
});
after(async () => {
  await site?.close();
  await elsewhere?.close();
});

test('a copy of the package in a static folder burns', async () => {
  await burnsWell(await open(`${site.origin}/`));
});

test('and from a page in a folder below', async () => {
  await burnsWell(await open(`${site.origin}/deep/er/`));
});

test('a package that another site serves to everyone burns, in a worker too', async () => {
  elsewhere.replace({ '': { headers: { 'access-control-allow-origin': '*' } } });
  await burnsWell(await open(site.publish(page(`${elsewhere.origin}/hearth-fire.js`))));
});

test('custom-elements.json names what the element has', async () => {
  const { modules } = JSON.parse(await readFile(path.join(PACKAGE, 'custom-elements.json'), 'utf8'));
  const [manifest] = modules[0].declarations;
  const names = (/** @type {string} */ list) => manifest[list].map(({ name }) => name).sort();
  const tab = await open(`${site.origin}/`);
  await tab.ready();
  await tab.fire(async (fire) => {
    fire.controls = true;
    fire.displayMode = 'temperature';
    const there = (part) => fire.shadowRoot.querySelector(`[part~=${part}]`);
    while (!there('panel') || !there('scale')) await new Promise(requestAnimationFrame);
  });
  const has = await tab.fire((fire) => {
    const { constructor: Fire, shadowRoot } = fire;
    const own = (/** @type {object} */ of) => Object.getOwnPropertyNames(of);
    const members = [];
    for (let type = Fire.prototype; type !== HTMLElement.prototype; type = Object.getPrototypeOf(type)) {
      members.push(...own(type).filter((name) => !name.endsWith('Callback')));
    }
    return {
      members: [...new Set(members)],
      ofClass: own(Fire),
      attributes: Fire.observedAttributes,
      // The panel's own inside is not for others to style.
      cssParts: [...shadowRoot.querySelectorAll('.root [part], .panel[part]')].flatMap((element) => [...element.part]),
      slots: [...shadowRoot.querySelectorAll('slot')].map((slot) => slot.name),
    };
  });
  assert.deepEqual(names('attributes'), [...new Set(has.attributes)].sort());
  assert.deepEqual(names('slots'), has.slots.sort());
  // The playback button is loaded for reduced motion only, the speaker button while the sound waits for a gesture.
  assert.deepEqual(names('cssParts'), [...new Set([...has.cssParts, 'play', 'retry', 'speaker'])].sort());
  const members = manifest.members.filter((member) => !member.static).map(({ name }) => name);
  // What the parts of the element have for each other, no one else calls.
  const inner = ['constructor', 'keepEarlyProperties', 'chosen'];
  assert.deepEqual(members.sort(), has.members.filter((name) => !inner.includes(name)).sort());
  const ofClass = manifest.members.filter((member) => member.static).map(({ name }) => name);
  for (const name of ofClass) assert(has.ofClass.includes(name), name);
});
