/**
 * The button that folds and unfolds a panel inside its fire. The panel starts folded in a fire that is
 * too small for it, and where the visitor folded it at the last visit.
 */

import { remember, remembered } from './memory.js';

/** A lower panel shows hardly more than its header [CSS pixels]. */
const USEFUL = 130;

const ICON = 'M4 7h9m5 0h2M4 17h2m5 0h9M18 7a2.5 2.5 0 1 1-5 0a2.5 2.5 0 1 1 5 0M11 17a2.5 2.5 0 1 1-5 0a2.5 2.5 0 1 1 5 0';

/**
 * @param {HTMLElement} host
 * @returns {{toggle: () => void, remove: () => void}}
 */
export function addFold(host) {
  host.classList.add('hearth-inside');
  host.setAttribute('role', 'group');
  host.setAttribute('aria-label', 'Controls of the fire');
  const button = document.createElement('button');
  button.type = 'button';
  button.className = 'hearth-fold';
  button.setAttribute('aria-label', 'Controls');
  button.title = 'Hide or show the controls (H)';
  const picture = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
  picture.setAttribute('viewBox', '0 0 24 24');
  picture.setAttribute('aria-hidden', 'true');
  const path = document.createElementNS('http://www.w3.org/2000/svg', 'path');
  path.setAttribute('d', ICON);
  picture.append(path);
  button.append(picture);
  host.append(button);

  /** @param {boolean} folded */
  const fold = (folded) => {
    host.classList.toggle('hearth-folded', folded);
    button.setAttribute('aria-expanded', String(!folded));
  };
  const toggle = () => {
    const folded = !host.classList.contains('hearth-folded');
    const root = /** @type {ShadowRoot} */ (host.getRootNode());
    watch.disconnect();
    fold(folded);
    remember({ hidden: folded });
    // What is folded away cannot keep the focus; the keys go on with the button's.
    if (folded && (root.activeElement === null || host.contains(root.activeElement))) {
      button.focus({ preventScroll: true });
    }
  };
  button.addEventListener('click', toggle);
  // In a fire that is not shown yet nobody knows how much room there is.
  const watch = new ResizeObserver(() => {
    if (!(host.clientHeight > 0)) return;
    watch.disconnect();
    fold(host.clientHeight < USEFUL || remembered().hidden === true);
  });
  fold(false);
  if (host.clientHeight > 0) fold(host.clientHeight < USEFUL || remembered().hidden === true);
  else watch.observe(host);

  return {
    toggle,
    remove() {
      watch.disconnect();
      button.remove();
      host.classList.remove('hearth-inside', 'hearth-folded');
      host.removeAttribute('role');
      host.removeAttribute('aria-label');
    },
  };
}
