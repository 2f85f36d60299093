// Bundles the page: node build.mjs [OUTPUT]. One self-contained HTML file with the placeholder where the
// C++ writer puts results.json.
import {mkdirSync, readFileSync, renameSync, writeFileSync} from 'node:fs';
import {dirname, join, resolve} from 'node:path';
import {fileURLToPath} from 'node:url';
import {build} from 'esbuild';

const here = dirname(fileURLToPath(import.meta.url));
const output = resolve(process.argv[2] ?? 'page.html');
const placeholder = '@HALFWAY_RESULTS@';
const styles = ['style.css', 'charts.css', 'tables.css', 'pictures.css', 'media.css']; // later ones change earlier ones

const bundled = await build({
  entryPoints: [join(here, 'page.js')],
  bundle: true,
  write: false,
  format: 'iife',
  target: 'es2021',
  minify: true,
  legalComments: 'eof',
  logLevel: 'warning'
});

// A script element ends at the first "</script", wherever it stands; an opening comment hides that end.
const script = bundled.outputFiles[0].text.replace(/<\/(script)/gi, '<\\/$1').replace(/<!--/g, '<\\!--');
const parts = {
  '@STYLE@': styles.map((file) => readFileSync(join(here, file), 'utf8')).join('\n'),
  '@SCRIPT@': script
};
let page = readFileSync(join(here, 'template.html'), 'utf8');
for (const [mark, text] of Object.entries(parts)) page = page.replace(mark, () => text);

if (page.split(placeholder).length !== 2) {
  throw new Error(`template.html: ${placeholder} must occur exactly once in the page`);
}
mkdirSync(dirname(output), {recursive: true});
writeFileSync(`${output}.part`, page);
renameSync(`${output}.part`, output);
