/**
 * The toolbar that draws, moves and erases the objects of a fire. The attribute `controls` offers it inside
 * the fire.
 */

import type { HearthFire } from './hearth-fire.js';

/** The options of a toolbar. */
export interface HearthToolsPlace {
  /** The element that receives the toolbar. It covers the fire: the toolbar places it absolutely in its parent. */
  host: HTMLElement;
  /** The fire. */
  fire: HearthFire;
  /** Whether the page is about this fire: the keys of the tools work anywhere on it. */
  page?: boolean;
  /** The visitor has pressed the button that closes the toolbar. */
  closed?: () => void;
}

/** A toolbar on a page. */
export interface HearthTools {
  /** Removes the toolbar. What it has drawn stays. */
  destroy(): void;
}

/** Shows the toolbar of a fire. Settles when it is shown. */
export function mountTools(place: HearthToolsPlace): Promise<HearthTools>;
