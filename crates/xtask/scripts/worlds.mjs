/**
 * Lets the examples of `examples/worlds` run from the site: `node worlds.mjs SITE`. The script of each contains its engine;
 * Hearth's own stays in `web/`. Each page gets the policy of the landing page, and the licences stand beside them.
 */
import { copyFile, mkdir, readFile, readdir, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from './esbuild.mjs';

const ROOT = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../../..');
const FROM = path.join(ROOT, 'examples/worlds');
const SITE = path.resolve(process.argv[2] ?? '');
const WEB = path.join(SITE, 'web');
const TO = path.join(SITE, 'examples/worlds');

/** The licences that may be released. */
const LICENCES = ['0BSD', 'Apache-2.0', 'BSD-2-Clause', 'BSD-3-Clause', 'ISC', 'MIT', 'Zlib'];

const pages = (await readdir(FROM)).filter((file) => file.endsWith('.html'));
const { exports } = JSON.parse(await readFile(path.join(WEB, 'package.json'), 'utf8'));

const { metafile } = await build({
  absWorkingDir: FROM,
  entryPoints: pages.map((page) => page.replace('.html', '.js')),
  outdir: TO,
  bundle: true,
  format: 'esm',
  minify: true,
  target: 'es2022',
  legalComments: 'none',
  metafile: true,
  logLevel: 'warning',
  plugins: [
    {
      name: 'hearth',
      setup({ onResolve, resolve }) {
        onResolve({ filter: /^hearth-fire\// }, ({ path: name }) => ({
          path: path.join(WEB, exports[name.replace('hearth-fire', '.')].default),
        }));
        onResolve({ filter: /.*/ }, ({ path: name, kind, resolveDir }) => {
          if (kind === 'entry-point' || path.relative(WEB, resolveDir).startsWith('..')) return undefined;
          if (!name.startsWith('.')) return resolve(name, { kind, resolveDir: FROM });
          const file = path.relative(WEB, path.join(resolveDir, name)).split(path.sep).join('/');
          // All fires of a page share these.
          return /^(three|worlds)\//.test(file) ? undefined : { path: `../../web/${file}`, external: true };
        });
      },
    },
  ],
});

await mkdir(TO, { recursive: true });
const landing = await readFile(path.join(ROOT, 'index.html'), 'utf8');
const policy = landing.match(/<meta http-equiv="Content-Security-Policy".*>/)?.[0];
if (!policy) throw new Error('index.html has no policy');
for (const page of pages) {
  const html = await readFile(path.join(FROM, page), 'utf8');
  const bundled = html.replace(/<script type="importmap">[\s\S]*?<\/script>\n/, '');
  await writeFile(path.join(TO, page), bundled.replace('<title>', `${policy}\n<title>`));
}
await copyFile(path.join(FROM, 'style.css'), path.join(TO, 'style.css'));

const inputs = Object.keys(metafile?.inputs ?? {});
const names = inputs.flatMap((file) => file.match(/node_modules\/((?:@[^/]+\/)?[^/]+)/)?.[1] ?? []);
const mit = (await readFile(path.join(ROOT, 'LICENSE-MIT'), 'utf8')).replace(/^[\s\S]*?(?=Permission)/, '');
const notices = [...new Set(names)].sort().map(async (name) => {
  const folder = path.join(FROM, 'node_modules', name);
  const { version, license, author } = JSON.parse(await readFile(path.join(folder, 'package.json'), 'utf8'));
  if (!LICENCES.includes(license)) throw new Error(`${name} has the licence ${license}`);
  const file = (await readdir(folder)).find((entry) => /^licen[cs]e/i.test(entry));
  if (!file && license !== 'MIT') throw new Error(`${name} has no file with its licence`);
  const text = file ? await readFile(path.join(folder, file), 'utf8') : mit;
  return `${name} ${version}, ${license}, by ${author?.name ?? author ?? 'its authors'}\n\n${text.trim()}\n`;
});
await writeFile(path.join(TO, 'THIRD-PARTY.txt'), (await Promise.all(notices)).join(`\n${'='.repeat(80)}\n\n`));
