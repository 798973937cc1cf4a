/**
 * Two fires beside each other: the present one stays as A, and the page goes on with B. A is above B on an upright stage. A
 * waits while B does, so a dialog that has a fire of its own finds one place free. It is loaded with the first press.
 *
 * @typedef {import('../hearth-fire.js').HearthFire} HearthFire
 */

import { element } from '../element/controls/icon-button.js';
import { elementAttributes } from '../share.js';

/** What of the picture of B is that of A as well. */
const CAMERA = ['zoom', 'pan'];

const STYLES = new CSSStyleSheet();
STYLES.replaceSync(`
#stage:has(#kept) { display: grid; grid-template: minmax(0, 1fr) / minmax(0, 1fr) minmax(0, 1fr); }
#kept { position: relative; order: -1; overflow: hidden; border-right: 2px solid #4a403a; }
#kept > hearth-fire { width: 100%; height: 100%; }
#stage:has(#kept) > #tools { position: absolute; inset: 0 0 0 50%; }
:root[data-fire='shown'] #kept::after {
  position: absolute; inset: 0 0 auto; height: 240px; transition: opacity 0.4s; pointer-events: none; content: '';
  background: linear-gradient(rgb(0 0 0 / 0.66) 70%, transparent);
}
[data-chrome='back'] #kept::after { opacity: 0; }
[data-tools='shown'] #kept::after { visibility: hidden; }
.letter {
  position: absolute; bottom: 8px; z-index: 1; display: flex; gap: 8px; align-items: center; min-height: 40px; margin: 0; padding: 0 12px;
  translate: -50%; border-radius: 20px; background: rgb(12 10 9 / 0.82); pointer-events: none; white-space: nowrap;
}
#kept > .letter { left: 50%; padding-right: 4px; }
#stage > .letter { left: 75%; }
[data-tools='shown'] #stage:has(#kept) > :is(#scenes, .letter) { display: none; }
.letter > button {
  width: 32px; height: 32px; padding: 0; border: 1px solid #94877c; border-radius: 50%; background: #2e2621; color: inherit; line-height: 1;
  pointer-events: auto;
}
@media (width < 720px) and (height >= 480px) {
  #stage:has(#kept) { grid-template: minmax(0, 1fr) minmax(0, 1fr) / minmax(0, 1fr); }
  #kept { border-width: 0 0 2px; }
  #stage:has(#kept) > #tools { inset: 50% 0 0; }
  #stage:has(#kept) > #fire::after { display: none; }
  #stage > .letter { left: 50%; }
}
@media (prefers-reduced-motion: reduce) { #kept::after { transition: none !important; } }
`);

/** Ends what is open. @type {(() => void) | undefined} */
let end;

/**
 * Keeps the present fire as A, or lets it go.
 * @param {HearthFire} fire  B: the fire of the page.
 * @param {HTMLElement} button  Shows whether there are two.
 */
export async function toggleBeside(fire, button) {
  if (end) end();
  else await keep(fire, button);
}

/** @param {HearthFire} fire @param {HTMLElement} button */
async function keep(fire, button) {
  const closed = new AbortController();
  const { signal } = closed;
  end = () => {
    closed.abort();
    end = undefined;
    button.setAttribute('aria-pressed', 'false');
  };
  button.setAttribute('aria-pressed', 'true');
  const config = await fire.exportConfig().catch((error) => {
    end?.();
    throw error;
  });
  if (signal.aborted) return;
  if (!document.adoptedStyleSheets.includes(STYLES)) document.adoptedStyleSheets.push(STYLES);
  const kept = keptFire(fire, /** @type {any} */ (config));
  const close = element('button', { type: 'button', 'aria-label': 'Close fire A', title: 'Close' }, '×');
  const a = element('section', { id: 'kept', 'aria-label': 'Fire A' });
  a.append(kept, element('p', { class: 'letter' }, 'A stays as it was', close));
  const b = element('p', { class: 'letter' }, 'B is yours');
  fire.before(a);
  fire.after(b);

  const follow = () => (fire.paused ? kept.pause() : kept.play());
  for (const event of ['pause', 'play']) fire.addEventListener(event, follow, { signal });
  const camera = new MutationObserver((changes) => {
    for (const { attributeName } of changes) copy(fire, kept, String(attributeName));
  });
  camera.observe(fire, { attributeFilter: CAMERA });
  close.addEventListener('click', () => {
    end?.();
    button.focus();
  });
  signal.addEventListener('abort', () => {
    camera.disconnect();
    for (const part of [a, b]) part.remove();
  });
}

/** Another fire with the settings and the picture of that one. @param {HearthFire} fire @param {import('../share.js').HearthSharedConfig} config */
function keptFire(fire, config) {
  const kept = /** @type {HearthFire} */ (document.createElement('hearth-fire'));
  for (const [name, value] of elementAttributes(config, {})) if (name !== 'style') kept.setAttribute(name, value);
  for (const name of [...CAMERA, 'fit', 'align', 'quality', 'reduced-motion']) copy(fire, kept, name);
  for (const [name, value] of [
    ['warm', ''],
    ['loading', 'eager'],
    ['alt', 'Fire A, as it was'],
  ])
    kept.setAttribute(name, value);
  if (fire.paused) kept.setAttribute('paused', '');
  return kept;
}

/** @param {Element} from @param {Element} to @param {string} name */
function copy(from, to, name) {
  const value = from.getAttribute(name);
  if (value === null) to.removeAttribute(name);
  else to.setAttribute(name, value);
}
