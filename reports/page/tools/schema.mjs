// Writes what follows from reports/results.schema.json: the types that tsc checks the page against, and the
// tables of SCHEMA.md. With --check writes nothing and ends with 1 where one of them is stale.
import {readFileSync, writeFileSync} from 'node:fs';
import {fileURLToPath} from 'node:url';
import {tables} from './schema_tables.mjs';
import {declarations} from './schema_types.mjs';

const at = (/** @type {string} */ path) => fileURLToPath(new URL(path, import.meta.url));
const [begin, end] = ['<!-- tables: generated from results.schema.json -->', '<!-- end of the tables -->'];

/** @param {string} text @param {string} content */
function between(text, content) {
  const [from, to] = [text.indexOf(begin), text.indexOf(end)];
  if (from < 0 || to < from) throw new Error(`SCHEMA.md must hold "${begin}" and "${end}"`);
  return `${text.slice(0, from + begin.length)}\n\n${content}\n\n${text.slice(to)}`;
}

const schema = JSON.parse(readFileSync(at('../../results.schema.json'), 'utf8'));
const document = at('../../SCHEMA.md');
const wanted = new Map([
  [at('../results.d.ts'), declarations(schema)],
  [document, between(readFileSync(document, 'utf8'), tables(schema))]
]);

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
