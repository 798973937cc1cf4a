/** esbuild, which is pinned in this folder, for the scripts of others. */
export { build, context } from 'esbuild';
