/**
 * The panel of sliders in any element of a page. The attribute `controls` shows it inside the fire.
 */

import type { HearthFire } from './hearth-fire.js';

/** The options of a panel. */
export interface HearthPanelPlace {
  /** The element that receives the panel; it needs a size. */
  host: HTMLElement;
  /** The fire, or any object with its methods, properties and events. */
  fire: HearthFire;
  /**
   * The URL of the page, if the page is about this fire and applies its URL parameters. The panel then
   * copies links to it, handles its keys while nothing has the focus, and its full screen is the whole
   * page.
   */
  page?: string | URL;
  /**
   * The URL of `hearth-fire.js` in the HTML that the panel copies, if it is not beside the panel's module.
   * In a bundle the URL is unknown, and without this option the HTML is the element alone.
   */
  script?: string | URL;
  /** The ids of the parameters to show, in this order; all parameters without it. */
  only?: string[];
  /** The URL of `embed.html` in that HTML. In a bundle, the panel offers no iframe without it. */
  embed?: string | URL;
}

/** A panel on a page. */
export interface HearthPanel {
  /** Removes the panel. */
  destroy(): void;
}

/**
 * Shows the panel of a fire. Settles when the panel is shown, or when a message in its place says why it is
 * not.
 */
export function mountPanel(place: HearthPanelPlace): Promise<HearthPanel>;
