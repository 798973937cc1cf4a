/**
 * A fire's settings as an address, as a link and as HTML to paste: pure functions,
 * for pages and servers alike.
 */

import type { HearthConfig } from './hearth-fire.js';

/** Settings whose values may still be texts, as an address holds them. */
export interface HearthSharedConfig {
  hearth?: 1 | 2;
  preset?: string;
  values?: Record<string, unknown>;
  objects?: object[];
  /** For people; neither an address nor HTML holds them. */
  label?: string;
  description?: string;
}

/**
 * Where this file is, by which the panel knows whether its own files still lie beside each
 * other; what a bundler made of it is somewhere else.
 */
export const FILE: string;

/** What a query asks for. */
export interface HearthQuery {
  /** The fire's settings, to be given to `importConfig`, which checks them. */
  config: HearthConfig;
  /** The element's own attributes, and the names that the page reads itself. */
  others: URLSearchParams;
}

/** The query that gives this fire, without its question mark; empty for the default one. */
export function toQuery(config: HearthSharedConfig): string;

/** What a query asks for; `names` are those that the page itself reads from its address. */
export function fromQuery(search: string | URLSearchParams, names?: Iterable<string>): HearthQuery;

/** The address of a page that reads its query and shows this fire. `base` must be absolute. */
export function pageLink(config: HearthSharedConfig, base: string | URL): string;

/**
 * HTML that shows this fire on any page: script and element, or without the script's address the
 * element alone. Throws a `RangeError` where a
 * value's name is no parameter's.
 */
export function elementCode(config: HearthSharedConfig, scriptUrl?: string | URL): string;

/** HTML that shows this fire in a frame; `embedUrl` is the whole address of `embed.html`. */
export function iframeCode(config: HearthSharedConfig, embedUrl: string | URL): string;
