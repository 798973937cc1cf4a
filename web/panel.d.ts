/**
 * The panel of sliders, for those who place it themselves; an element with the
 * attribute `controls` has it inside.
 */

import type { HearthFire } from './hearth-fire.js';

/** Where a panel stands, and for which fire. */
export interface HearthPanelPlace {
  /** An element that has a size. */
  host: HTMLElement;
  /** The fire; anything with its methods, properties and events will do. */
  fire: HearthFire;
  /**
   * The address of the page, where it is a page for this fire and shows what its query says.
   * The panel then copies links to it, hears its keys where the focus is nowhere too, and its full
   * screen is the whole page.
   */
  page?: string | URL;
  /**
   * Where other pages find `hearth-fire.js`, for the HTML that the panel copies, if that is not
   * beside the panel's module. Behind a bundler nobody knows; the element alone is copied then.
   */
  script?: string | URL;
  /** The ids of the parameters that it shows, in this order; without it, all of them. */
  only?: string[];
  /** And where they find `embed.html`. Behind a bundler no iframe is offered without it. */
  embed?: string | URL;
}

/** A panel that stands. */
export interface HearthPanel {
  /** Takes it away, with everything that belongs to it. */
  destroy(): void;
}

/**
 * Shows the panel of a fire. It settles when the panel stands, or when it is clear, and said
 * in the panel's place, that it cannot.
 */
export function mountPanel(place: HearthPanelPlace): Promise<HearthPanel>;
