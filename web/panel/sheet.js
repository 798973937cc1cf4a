/**
 * The handle of a panel that is a sheet at the lower end of its fire or of the window. Pointer and
 * keys drag it up and down, and its height is kept for the next visit.
 */

import { remember, remembered } from './memory.js';

/** Least and greatest height, as a share of what it lies in. */
const SHARES = [0.2, 0.85];

/** What a key adds to it. @type {{[key: string]: number}} */
const STEPS = { ArrowUp: 0.05, ArrowDown: -0.05, PageUp: 0.2, PageDown: -0.2, Home: 1, End: -1 };

/** A hundredth of the window, without what the browser lays over it. Servers have no `CSS`. */
const VIEW = globalThis.CSS?.supports('height', '1dvh') ? 'dvh' : 'vh';

/** What the page's and the panel's style sheets read. */
const HEIGHT = '--hearth-sheet';

/**
 * @param {HTMLElement} host
 * @param {HTMLElement} [fire]  In which it lies; in the window, without.
 * @returns {() => void} ends it
 */
export function addSheet(host, fire) {
  const grip = document.createElement('div');
  grip.className = 'hearth-grip';
  grip.tabIndex = 0;
  grip.setAttribute('role', 'separator');
  grip.setAttribute('aria-orientation', 'horizontal');
  grip.setAttribute('aria-label', 'Height of the controls');
  grip.setAttribute('aria-valuemin', String(SHARES[0] * 100));
  grip.setAttribute('aria-valuemax', String(SHARES[1] * 100));
  host.append(grip);

  const outer = () => fire?.getBoundingClientRect()
    ?? new DOMRect(0, 0, document.documentElement.clientWidth, window.innerHeight);
  const root = /** @type {ShadowRoot} */ (host.getRootNode());
  const styled = () => /** @type {HTMLElement[]} */ (fire ? [...root.children] : [document.documentElement]);

  /** @param {number} share */
  const resize = (share) => {
    const height = Math.min(SHARES[1], Math.max(SHARES[0], share));
    const value = `${Math.round(height * 1000) / 10}${fire ? '%' : VIEW}`;
    for (const { style } of styled()) style?.setProperty(HEIGHT, value);
  };
  const shareNow = () => host.getBoundingClientRect().height / outer().height;
  // It is one where it lies at the lower end and is as wide as what it lies in.
  const look = () => {
    const [own, all] = [host.getBoundingClientRect(), outer()];
    const lies = own.height > 0 && own.height < 0.95 * all.height && own.width > 0.9 * all.width;
    host.classList.toggle('hearth-sheet', lies);
    grip.setAttribute('aria-valuenow', String(Math.round(shareNow() * 100) || 0));
  };
  const keep = () => remember({ sheet: Math.round(shareNow() * 1000) / 1000 });

  let holds = 0;
  grip.addEventListener('pointerdown', (event) => {
    grip.setPointerCapture(event.pointerId);
    holds = event.clientY - host.getBoundingClientRect().top;
  });
  grip.addEventListener('pointermove', (event) => {
    if (!grip.hasPointerCapture(event.pointerId)) return;
    const all = outer();
    resize((all.bottom - event.clientY + holds) / all.height);
  });
  grip.addEventListener('lostpointercapture', keep);
  grip.addEventListener('keydown', (event) => {
    const step = Object.hasOwn(STEPS, event.key) ? STEPS[event.key] : 0;
    if (!step || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    event.stopPropagation();
    resize(shareNow() + step);
    keep();
  });

  const { sheet } = remembered();
  if (typeof sheet === 'number' && sheet > 0) resize(sheet);
  const watch = new ResizeObserver(look);
  watch.observe(host);
  if (fire) watch.observe(fire);
  look();

  return () => {
    watch.disconnect();
    grip.remove();
    host.classList.remove('hearth-sheet');
    for (const { style } of styled()) style?.removeProperty(HEIGHT);
  };
}
