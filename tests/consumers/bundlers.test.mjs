/**
 * A page that other bundlers build: those that move the files of the package, with `exports`
 * and without, and those that move none.
 */
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { cp } from 'node:fs/promises';
import { createRequire } from 'node:module';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { promisify } from 'node:util';
import { serve } from '../e2e/server.mjs';
import { installed } from './package.mjs';
import { browser, burnsWell } from './pages.mjs';

const { open } = browser();
/** @type {string} */
let root;
/** @type {NodeRequire} */
let require;
/** @type {import('../e2e/server.mjs').Server[]} */
const servers = [];

before(async () => {
  root = await installed('bundlers');
  require = createRequire(path.join(root, 'package.json'));
});
after(() => Promise.all(servers.map((server) => server.close())));

/** What the single file loads on request, which tools that move no files leave out. */
const external = ['./panel.js', './tools.js'];

/** How each bundler makes a page of the project in a folder. @type {{[name: string]: (folder: string) => Promise<unknown>}} */
const BUNDLERS = {
  'webpack 5': (folder) => webpack(folder, 'main.js'),
  // Of versions before 5, which add extensions too.
  'webpack without exports, from the single file': (folder) =>
    webpack(folder, 'inline.js', { exportsFields: [], fullySpecified: false }),
  'Parcel, which reads no exports': (folder) => {
    const words = ['build', 'index.html', '--dist-dir', folder, '--no-cache', '--log-level', 'error'];
    const program = path.join(root, 'node_modules/parcel/lib/bin.js');
    return promisify(execFile)(process.execPath, [program, ...words], { cwd: root });
  },
  'esbuild, from the single file': async (folder) => {
    const outfile = path.join(folder, 'main.js');
    const entryPoints = [path.join(root, 'inline.js')];
    await require('esbuild').build({ entryPoints, bundle: true, format: 'esm', outfile, external, logLevel: 'error' });
    await page(folder);
  },
  'Rollup, from the single file': async (folder) => {
    const { nodeResolve } = require('@rollup/plugin-node-resolve');
    const input = path.join(root, 'inline.js');
    // Without `makeAbsoluteExternalsRelative`, external files are beside the script that is built.
    const options = { input, external, makeAbsoluteExternalsRelative: false, plugins: [nodeResolve()] };
    const bundle = await require('rollup').rollup(options);
    await bundle.write({ file: path.join(folder, 'main.js'), inlineDynamicImports: true });
    await page(folder);
  },
};

for (const [name, build] of Object.entries(BUNDLERS)) {
  test(`${name}: what it builds burns in a worker`, async () => {
    const folder = path.join(root, 'built', name.replaceAll(/\W+/g, '-'));
    await build(folder);
    const server = await serve(folder);
    servers.push(server);
    await burnsWell(await open(`${server.origin}/`));
  });
}

/**
 * Builds a page with webpack.
 * @param {string} folder
 * @param {string} script
 * @param {{exportsFields?: string[], fullySpecified?: boolean}} [resolve]
 */
async function webpack(folder, script, resolve = {}) {
  const stats = await promisify(require('webpack'))({
    mode: 'production',
    context: root,
    entry: `./${script}`,
    output: { path: folder, filename: 'main.js' },
    module: { rules: [{ resolve }] },
  });
  assert.deepEqual(stats.toJson({ errors: true }).errors, []);
  await page(folder);
}

/** Puts the page of the project beside a built script. @param {string} folder */
async function page(folder) {
  await cp(path.join(root, 'index.html'), path.join(folder, 'index.html'));
}
