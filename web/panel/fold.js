/**
 * The button that folds and unfolds a panel inside its fire. The panel starts folded if the fire is too
 * small for it, or if the visitor folded it at the last visit.
 */

import { iconButton } from '../element/controls/icon-button.js';
import { remember, remembered } from '../editing/memory.js';

/** The minimum height of an open panel: a lower one shows hardly more than its header [CSS pixels]. */
const MIN_HEIGHT = 130;

const ICON =
  'M4 7h9m5 0h2M4 17h2m5 0h9M18 7a2.5 2.5 0 1 1-5 0a2.5 2.5 0 1 1 5 0M11 17a2.5 2.5 0 1 1-5 0a2.5 2.5 0 1 1 5 0';

/**
 * @param {HTMLElement} host
 * @returns {{toggle: () => void, remove: () => void}}
 */
export function addFold(host) {
  host.classList.add('hearth-inside');
  host.setAttribute('role', 'group');
  host.setAttribute('aria-label', 'Fire controls');
  const button = iconButton(ICON, {
    class: 'hearth-fold',
    'aria-label': 'Controls',
    title: 'Hide or show the controls (H)',
  });
  host.append(button);

  /** @param {boolean} folded */
  const fold = (folded) => {
    host.classList.toggle('hearth-folded', folded);
    button.setAttribute('aria-expanded', String(!folded));
  };
  const toggle = () => {
    const folded = !host.classList.contains('hearth-folded');
    const root = /** @type {ShadowRoot} */ (host.getRootNode());
    size.disconnect();
    fold(folded);
    remember({ hidden: folded });
    // A folded panel cannot keep the focus; the shortcuts work on the button.
    if (folded && (root.activeElement === null || host.contains(root.activeElement))) {
      button.focus({ preventScroll: true });
    }
  };
  button.addEventListener('click', toggle);
  // The size of a fire that is not displayed is unknown.
  const size = new ResizeObserver(() => {
    if (!(host.clientHeight > 0)) return;
    size.disconnect();
    fold(host.clientHeight < MIN_HEIGHT || remembered().hidden === true);
  });
  fold(false);
  if (host.clientHeight > 0) fold(host.clientHeight < MIN_HEIGHT || remembered().hidden === true);
  else size.observe(host);

  return {
    toggle,
    remove() {
      size.disconnect();
      button.remove();
      host.classList.remove('hearth-inside', 'hearth-folded');
      host.removeAttribute('role');
      host.removeAttribute('aria-label');
    },
  };
}
