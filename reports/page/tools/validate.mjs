// Checks a results.json against reports/results.schema.json: node validate.mjs RESULTS.json. With --strict a
// field that the schema does not describe is a mistake as well.
import {readFileSync} from 'node:fs';
import {Ajv2020} from 'ajv/dist/2020.js';

const kMostShown = 20;
const [file] = process.argv.slice(2).filter((a) => !a.startsWith('--'));
if (!file) throw new Error('usage: node validate.mjs RESULTS.json [--strict]');
const schema = JSON.parse(readFileSync(new URL('../../results.schema.json', import.meta.url), 'utf8'));
if (process.argv.includes('--strict')) {
  for (const def of [schema, ...Object.values(schema.$defs)]) def.additionalProperties = false;
}

const validate = new Ajv2020({allErrors: true, allowUnionTypes: true}).compile(schema);
if (!validate(JSON.parse(readFileSync(file, 'utf8')))) {
  const mistakes = new Set(
    (validate.errors ?? []).map((e) => {
      const place = e.instancePath.replace(/\/\d+/g, '[]');
      return `${place}: ${e.message}${e.params.additionalProperty ? ` (${e.params.additionalProperty})` : ''}`;
    })
  );
  for (const mistake of [...mistakes].slice(0, kMostShown)) console.error(mistake);
  if (mistakes.size > kMostShown) console.error(`and ${mistakes.size - kMostShown} more`);
  process.exitCode = 1;
}
