// Bundles the pages: node build.mjs [OUTPUT]. The report goes to OUTPUT (page.html), the dashboard beside it: each
// one self-contained HTML file, with the placeholder where the C++ writers put their data.
import {mkdirSync, readFileSync, renameSync, writeFileSync} from 'node:fs';
import {dirname, join, resolve} from 'node:path';
import {fileURLToPath} from 'node:url';
import {build} from 'esbuild';

const here = dirname(fileURLToPath(import.meta.url));
const output = resolve(process.argv[2] ?? 'page.html');
const PAGES = [
  {
    file: output,
    entry: 'page.js',
    styles: [
      'styles/style.css',
      'styles/charts.css',
      'styles/tables.css',
      'styles/pictures.css',
      'styles/media.css'
    ], // later ones change earlier ones
    placeholder: '@HALFWAY_RESULTS@',
    text: {
      TITLE: 'Halfway: deformable joints, accuracy and cost',
      DESCRIPTION: 'Accuracy and cost of deformable-joint formulations: verification and benchmarks.',
      SUBTITLE: 'deformable joints',
      NOSCRIPT:
        'This page draws its charts with JavaScript; the same results are in results.json and summary.md.',
      DATA: '<script type="application/json" id="results">@HALFWAY_RESULTS@</script>'
    }
  },
  {
    file: join(dirname(output), 'dashboard.html'),
    entry: 'dashboard/dashboard.js',
    styles: [
      'styles/style.css',
      'styles/charts.css',
      'styles/tables.css',
      'styles/plot.css',
      'dashboard/dashboard.css',
      'styles/media.css'
    ],
    placeholder: '<!-- halfway data -->',
    text: {
      TITLE: 'Halfway: what got worse, since when',
      DESCRIPTION: 'History of accuracy and speed of deformable-joint formulations.',
      SUBTITLE: 'history of accuracy and speed',
      NOSCRIPT:
        'This page draws its charts with JavaScript; ./halfway history and compare show the same as text.',
      DATA: '<!-- halfway data -->'
    }
  }
];

/** A script element ends at the first "</script", wherever it stands; an opening comment hides that end. */
const escaped = (script) => script.replace(/<\/(script)/gi, '<\\/$1').replace(/<!--/g, '<\\!--');

async function bundle(entry) {
  const bundled = await build({
    entryPoints: [join(here, entry)],
    bundle: true,
    write: false,
    format: 'iife',
    target: 'es2021',
    minify: true,
    legalComments: 'eof',
    logLevel: 'warning'
  });
  return escaped(bundled.outputFiles[0].text);
}

for (const {file, entry, styles, placeholder, text} of PAGES) {
  const parts = {
    ...text,
    STYLE: styles.map((style) => readFileSync(join(here, style), 'utf8')).join('\n'),
    SCRIPT: await bundle(entry)
  };
  let page = readFileSync(join(here, 'template.html'), 'utf8');
  for (const [mark, value] of Object.entries(parts)) page = page.replace(`@${mark}@`, () => value);
  if (page.split(placeholder).length !== 2) {
    throw new Error(`${entry}: ${placeholder} must occur exactly once in the page`);
  }
  mkdirSync(dirname(file), {recursive: true});
  writeFileSync(`${file}.part`, page);
  renameSync(`${file}.part`, file);
}
