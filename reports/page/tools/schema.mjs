// Writes what follows from reports/results.schema.json and run.schema.json: the types that tsc checks the pages
// against, and the tables of SCHEMA.md. With --check writes nothing and ends with 1 where one of them is stale.
import {readFileSync, writeFileSync} from 'node:fs';
import {fileURLToPath} from 'node:url';
import {tables} from './schema_tables.mjs';
import {declarations} from './schema_types.mjs';

const at = (/** @type {string} */ path) => fileURLToPath(new URL(path, import.meta.url));
const end = '<!-- end of the tables -->';

/** @param {string} text @param {string} file @param {string} content */
function between(text, file, content) {
  const begin = `<!-- tables: generated from ${file} -->`;
  const from = text.indexOf(begin);
  const to = text.indexOf(end, from);
  if (from < 0 || to < from) throw new Error(`SCHEMA.md must hold "${begin}" and "${end}"`);
  return `${text.slice(0, from + begin.length)}\n\n${content}\n\n${text.slice(to)}`;
}

const document = at('../../SCHEMA.md');
const wanted = new Map([[document, readFileSync(document, 'utf8')]]);
for (const [file, root] of [
  ['results.schema.json', 'Results'],
  ['run.schema.json', 'Run']
]) {
  const schema = JSON.parse(readFileSync(at(`../../${file}`), 'utf8'));
  wanted.set(at(`../${root.toLowerCase()}.d.ts`), declarations(schema, file, `${root}File`));
  wanted.set(document, between(wanted.get(document) ?? '', file, tables(schema)));
}

const current = (/** @type {string} */ file) => {
  try {
    return readFileSync(file, 'utf8');
  } catch {
    return '';
  }
};
const stale = [...wanted].filter(([file, text]) => current(file) !== text);
if (process.argv.includes('--check')) {
  for (const [file] of stale) console.error(`${file}: stale; run \`npm run schema\` in reports/page`);
  process.exitCode = stale.length ? 1 : 0;
} else {
  for (const [file, text] of stale) writeFileSync(file, text);
}
