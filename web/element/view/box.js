/**
 * Why an element has no box, so that its fire draws no picture. This code is loaded when that is so for a while.
 */

import { cut } from '../../quoted.js';

/** @param {HTMLElement} fire */
export function whyNoBox(fire) {
  if (!fire.isConnected) return 'is on no page: its calls wait until it is inserted';
  const { display } = getComputedStyle(fire);
  if (display === 'contents') return 'has display: contents, and so no box: there is no picture';
  // A part of the page that is hidden may be shown later.
  if (!fire.checkVisibility?.()) return '';
  const { offsetWidth: width, offsetHeight: height } = fire;
  return width && height ? '' : `is ${width} × ${height} pixels large: there is no picture until it has a size`;
}

/** Warns about an element without a box, and names it. @param {HTMLElement} fire */
export function warnOfBox(fire) {
  const why = whyNoBox(fire);
  if (why) console.warn(`<hearth-fire${fire.id && ` id="${cut(fire.id)}"`}> ${why}.`);
}
