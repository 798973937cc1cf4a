/**
 * A fire's settings as URL parameters, as a link and as HTML: pure functions for pages and servers.
 */

import type { HearthConfig } from './hearth-fire.js';

/** Settings whose values may be strings, as in a URL. */
export interface HearthSharedConfig {
  hearth?: 3;
  preset?: string;
  values?: Record<string, unknown>;
  objects?: object[];
  /** For people; neither a URL nor HTML contains them. */
  label?: string;
  description?: string;
  author?: string;
  licence?: string;
}

/** How generated HTML shows a fire. */
export interface HearthShown {
  /** Its width in CSS pixels, 320 by default. */
  width?: number;
  /** Its height in CSS pixels, 400 by default. */
  height?: number;
  /** The element's own attributes, such as `{ warm: '', fit: 'contain' }`. */
  attributes?: Record<string, string>;
}

/** The URL of this file, or of the bundle that contains it. */
export const FILE: string;

/** The settings in URL parameters. */
export interface HearthQuery {
  /** The fire's settings for `importConfig`, which validates them. */
  config: HearthConfig;
  /** The element's own attributes, and the page's own parameters. */
  others: URLSearchParams;
}

/** The URL parameters of a fire, without the question mark; empty for the defaults. */
export function toQuery(config: HearthSharedConfig): string;

/** The settings in URL parameters; `names` are the page's own parameters. */
export function fromQuery(search: string | URLSearchParams, names?: Iterable<string>): HearthQuery;

/** The most characters of URL parameters that are written; longer settings become a fragment. */
export const MAX_QUERY: number;

/** Whether settings become URL parameters: longer ones, and those with a mask, become a fragment. */
export function fitsQuery(config: HearthSharedConfig, query?: string): boolean;

/** The settings in the fragment of a URL; undefined if it has none. Rejects with a `RangeError` if it is damaged. */
export function fromFragment(hash: string): Promise<HearthConfig | undefined>;

/**
 * The URL of a page that shows this fire. `base` is the absolute URL of a page that applies its URL parameters.
 * Settings of more than {@link MAX_QUERY} characters, or with a mask, become a compressed fragment, which no server receives. Rejects with a `RangeError` if they
 * are too long for that too.
 */
export function pageLink(config: HearthSharedConfig, base: string | URL): Promise<string>;

/**
 * HTML that shows this fire on any page: script and element, or the element alone without `scriptUrl`.
 * Throws a `RangeError` if a name is not a parameter or an attribute.
 */
export function elementCode(config: HearthSharedConfig, scriptUrl?: string | URL, shown?: HearthShown): string;

/** The attributes of that element, in order; the value of a flag is empty. */
export function elementAttributes(config: HearthSharedConfig, shown?: HearthShown): [name: string, value: string][];

/** A text as the value of an attribute. */
export function escaped(text: string): string;

/** HTML that shows this fire in an iframe; `embedUrl` is the absolute URL of `embed.html`. Rejects as `pageLink` does. */
export function iframeCode(
  config: HearthSharedConfig,
  embedUrl: string | URL,
  shown?: HearthShown,
): Promise<string>;
