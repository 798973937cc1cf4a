/**
 * `package.json` of the package: that of `web/`, which may be published, and what
 * its entry points are.
 *
 * @typedef {{[field: string]: any}} Manifest
 */

/** The entry point that is made from the others. */
const INLINE = './hearth-fire.inline.js';

/** Modules that no script of the package contains: those of Node, where there is Node, and the peers. */
export const OUTSIDE = ['node:*', 'three', 'react', '@react-three/fiber', 'pixi.js', 'phaser'];

/** What users of the package read. */
export const DOCS = [
  'SECURITY.md',
  ...[
    'element',
    'embedding',
    'iframe',
    'package',
    'parameters',
    'recipes',
    'scenes',
    'simulation',
    'sound',
    'worlds',
  ].map((name) => `docs/${name}.md`),
];

/**
 * What is published.
 * @param {Manifest} source
 * @param {string} version
 * @returns {Manifest & {name: string, version: string, license: string}}
 */
export function packageJson(source, version) {
  const { name, license, private: _, ...rest } = source;
  return { name, version, license, ...rest };
}

/** The scripts and pages that a browser, a bundler or Node may begin with. @param {Manifest} manifest */
export function beginningsOf(manifest) {
  return entries(manifest)
    .map(({ target }) => target)
    .filter((target) => target !== INLINE && /\.(js|html)$/.test(target));
}

/** The types of the entry points. @param {Manifest} manifest */
export function typesOf(manifest) {
  return [...new Set(entries(manifest).flatMap(({ types }) => types ?? []))];
}

/**
 * Every entry point: how it is imported, its file and that of its types.
 * @param {Manifest} manifest
 * @returns {{entry: string, target: string, types?: string}[]}
 */
export function entries(manifest) {
  return Object.entries(manifest.exports).map(([entry, target]) =>
    typeof target === 'string' ? { entry, target } : { entry, target: target.default, types: target.types },
  );
}
