/**
 * The tooltip of a row of the panel, which says what the row is about. It is an element of the page, because it lies
 * beside the panel, where it covers no other row. The accessible controls have the same texts.
 */

import { element } from '../element/controls/icon-button.js';

/** How long the pointer rests before it [ms]. */
const REST_MS = 600;

/** The distance from the panel and from the edges of the window [CSS px]. */
const GAP = 8;

/** @typedef {[text: string, top: number, height: number]} Row  In CSS pixels of the window. */

/** @param {HTMLElement} host  The panel. */
export function addTooltip(host) {
  // A popover is in the top layer: neither the panel nor the fire cuts it.
  const tooltip = element('div', { class: 'hearth-tooltip', 'aria-hidden': 'true', popover: 'manual', hidden: '' });
  host.append(tooltip);
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let planned;
  let shown = '';

  const hide = () => {
    clearTimeout(planned);
    if (tooltip.hidden) return;
    tooltip.hidePopover?.();
    tooltip.hidden = true;
  };
  /** @param {Row} row */
  const place = ([text, top, height]) => {
    tooltip.textContent = text;
    tooltip.hidden = false;
    tooltip.showPopover?.();
    const panel = host.getBoundingClientRect();
    const { offsetWidth, offsetHeight } = tooltip;
    const [least, most] = [GAP, document.documentElement.clientWidth - GAP - offsetWidth];
    const beside = [panel.left - GAP - offsetWidth, panel.right + GAP].find((x) => x >= least && x <= most);
    // Without room beside it, it lies above the row.
    const x = beside ?? Math.max(least, Math.min(most, panel.left + GAP));
    const y = beside === undefined ? top - GAP - offsetHeight : top + height / 2 - offsetHeight / 2;
    const lowest = window.innerHeight - GAP - offsetHeight;
    if (beside === undefined && y < GAP) return hide();
    tooltip.style.left = `${x}px`;
    tooltip.style.top = `${Math.max(GAP, Math.min(lowest, y))}px`;
  };
  return {
    /** Shows it after a while, unless the pointer leaves the row or acts before. @param {Row} [row] */
    show(row) {
      const wanted = row ? String(row) : '';
      if (wanted === shown) return;
      hide();
      shown = wanted;
      if (row) planned = setTimeout(() => place(row), REST_MS);
    },
    remove() {
      hide();
      tooltip.remove();
    },
  };
}
