/** esbuild, which is pinned in this folder, for the scripts of others. */
/** @typedef {import('esbuild').BuildOptions} BuildOptions @typedef {import('esbuild').Plugin} Plugin */
export { build, context, stop, transform } from 'esbuild';
