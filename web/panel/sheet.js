/**
 * The handle of a panel that is a sheet at the bottom of its fire or of the window. Pointer and keys
 * change its height, which is kept for the next visit.
 */

import { element } from '../element/controls/icon-button.js';
import { remember, remembered } from '../editing/memory.js';

/** Minimum and maximum height as a share of the container. */
const SHARES = [0.2, 0.85];

/** What each key adds to the height. @type {{[key: string]: number}} */
const STEPS = { ArrowUp: 0.05, ArrowDown: -0.05, PageUp: 0.2, PageDown: -0.2, Home: 1, End: -1 };

/** A hundredth of the window's visible height. Servers have no `CSS`. */
const UNIT = globalThis.CSS?.supports('height', '1dvh') ? 'dvh' : 'vh';

/** The custom property that the style sheets of page and panel read. */
const HEIGHT = '--hearth-sheet';

/**
 * @param {HTMLElement} host
 * @param {HTMLElement} [fire]  The container; the window without it.
 * @returns {() => void} removes it
 */
export function addSheet(host, fire) {
  const grip = element('div', {
    class: 'hearth-grip',
    tabindex: '0',
    role: 'separator',
    'aria-orientation': 'horizontal',
    'aria-label': 'Height of the controls',
    'aria-valuemin': String(SHARES[0] * 100),
    'aria-valuemax': String(SHARES[1] * 100),
  });
  host.append(grip);

  const outer = () =>
    fire?.getBoundingClientRect() ?? new DOMRect(0, 0, document.documentElement.clientWidth, window.innerHeight);
  const root = /** @type {ShadowRoot} */ (host.getRootNode());
  const styled = () => /** @type {HTMLElement[]} */ (fire ? [...root.children] : [document.documentElement]);

  /** @param {number} share */
  const resize = (share) => {
    const height = Math.min(SHARES[1], Math.max(SHARES[0], share));
    const value = `${Math.round(height * 1000) / 10}${fire ? '%' : UNIT}`;
    for (const { style } of styled()) style?.setProperty(HEIGHT, value);
  };
  const shareNow = () => host.getBoundingClientRect().height / outer().height;
  // The panel is a sheet if it is lower than its container and as wide.
  const update = () => {
    const [own, all] = [host.getBoundingClientRect(), outer()];
    const isSheet = own.height > 0 && own.height < 0.95 * all.height && own.width > 0.9 * all.width;
    host.classList.toggle('hearth-sheet', isSheet);
    grip.setAttribute('aria-valuenow', String(Math.round(shareNow() * 100) || 0));
  };
  const keep = () => remember({ sheet: Math.round(shareNow() * 1000) / 1000 });

  let offset = 0;
  grip.addEventListener('pointerdown', (event) => {
    // A pointer that is gone cannot be captured.
    try {
      grip.setPointerCapture(event.pointerId);
    } catch {}
    offset = event.clientY - host.getBoundingClientRect().top;
  });
  grip.addEventListener('pointermove', (event) => {
    if (!grip.hasPointerCapture(event.pointerId)) return;
    const all = outer();
    resize((all.bottom - event.clientY + offset) / all.height);
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
  const sizes = new ResizeObserver(update);
  sizes.observe(host);
  if (fire) sizes.observe(fire);
  update();

  return () => {
    sizes.disconnect();
    grip.remove();
    host.classList.remove('hearth-sheet');
    for (const { style } of styled()) style?.removeProperty(HEIGHT);
  };
}
