// TypeScript declarations of results.json, or of a run's page, from its JSON Schema.

/** @typedef {Record<string, any>} Schema */

const SCALARS = {string: 'string', number: 'number', integer: 'number', boolean: 'boolean', null: 'null'};

/** @param {Schema} schema @returns {string} */
function typeOf(schema) {
  if (schema.$ref) return schema.$ref.split('/').at(-1);
  if (schema.const !== undefined) return JSON.stringify(schema.const);
  if (schema.enum) return schema.enum.map((/** @type {unknown} */ v) => JSON.stringify(v)).join(' | ');
  if (Array.isArray(schema.type)) return schema.type.map((t) => typeOf({type: t})).join(' | ');
  if (schema.type === 'array') return `Array<${typeOf(schema.items)}>`;
  if (schema.type === 'object' && schema.additionalProperties) {
    return `Record<string, ${typeOf(schema.additionalProperties)}>`;
  }
  return SCALARS[/** @type {keyof typeof SCALARS} */ (schema.type)] ?? 'any';
}

/** @param {string} name @param {Schema} schema */
function declaration(name, schema) {
  const required = new Set(schema.required ?? []);
  const lines = Object.entries(schema.properties).map(
    ([key, value]) => `  ${key}${required.has(key) ? '' : '?'}: ${typeOf(value)};`
  );
  return `export interface ${name} {\n${lines.join('\n')}\n}\n`;
}

/** @param {Schema} schema the whole @param {string} file it is in @param {string} root name of the whole */
export const declarations = (schema, file, root) =>
  [
    `// Generated from reports/${file} by tools/schema.mjs; edit that, then run \`npm run schema\`.\n`,
    declaration(root, schema),
    ...Object.entries(schema.$defs).map(([name, def]) => declaration(name, def))
  ].join('\n');
