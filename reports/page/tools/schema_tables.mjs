// Tables for people of results.json, or of a run's page, from its JSON Schema.

/** @typedef {Record<string, any>} Schema */

const WORDS = {
  string: 'text',
  number: 'number',
  integer: 'integer',
  boolean: 'bool',
  null: 'null',
  object: 'object'
};

/** @param {Schema} schema @returns {string} */
function words(schema) {
  if (schema.$ref) return 'object';
  if (schema.const !== undefined) return typeof schema.const === 'number' ? 'integer' : 'text';
  if (Array.isArray(schema.type)) return schema.type.map((t) => words({type: t})).join(' or ');
  if (schema.type === 'array') return `list of ${words(schema.items)}`;
  if (schema.enum) return 'text';
  return WORDS[/** @type {keyof typeof WORDS} */ (schema.type)] ?? 'any';
}

/** @param {Schema} value */
const choices = (value) =>
  value.enum && !value.enum.every((/** @type {string} */ v) => value.description.includes(`\`${v}\``))
    ? ` (${value.enum.map((/** @type {string} */ v) => `\`${v}\``).join(', ')})`
    : '';

/** @param {Schema} def */
function table(def) {
  const required = new Set(def.required ?? []);
  const rows = Object.entries(def.properties).map(([key, value]) => {
    const optional = required.has(key) ? '' : ', may be missing';
    return `| \`${key}\` | ${words(value)}${optional} | ${value.description ?? ''}${choices(value)} |`;
  });
  return ['| field | type | meaning |', '|---|---|---|', ...rows].join('\n');
}

/** Where each definition stands: name -> paths like `speed.peaks[]`.
 * @param {Schema} schema
 */
function placesOf(schema) {
  /** @type {Map<string, string[]>} */
  const places = new Map();
  const walk = (/** @type {Schema} */ def, /** @type {string} */ prefix) => {
    for (const [key, value] of Object.entries(def.properties)) {
      const ref = value.$ref ?? value.items?.$ref;
      if (!ref) continue;
      const name = ref.split('/').at(-1);
      const path = `${prefix}${key}${value.items ? '[]' : ''}`;
      const known = places.get(name);
      places.set(name, [...(known ?? []), path]);
      if (!known) walk(schema.$defs[name], `${path}.`);
    }
  };
  walk(schema, '');
  return places;
}

/** @param {Schema} schema the whole */
export function tables(schema) {
  const parts = [...placesOf(schema)].map(([name, paths]) => {
    const def = schema.$defs[name];
    const level = paths[0].includes('.') ? '###' : '##';
    const heading = `${level} ${paths.map((p) => `\`${p}\``).join(', ')}`;
    return [heading, def.description, table(def)].filter(Boolean).join('\n\n');
  });
  return [table(schema), ...parts].join('\n\n');
}
