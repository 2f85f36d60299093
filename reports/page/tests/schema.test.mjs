import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import test from 'node:test';
import {Ajv2020} from 'ajv/dist/2020.js';
import {tables} from '../tools/schema_tables.mjs';
import {declarations} from '../tools/schema_types.mjs';
import {fixture} from './fixture.mjs';

const schema = JSON.parse(readFileSync(new URL('../../results.schema.json', import.meta.url), 'utf8'));
const holds = new Ajv2020({allowUnionTypes: true}).compile(schema);

test('the tests’ own results satisfy the schema', () => {
  assert.equal(holds(fixture()), true, JSON.stringify(holds.errors));
});

test('a field that is missing or of another type does not', () => {
  const without = fixture();
  delete without.timings;
  assert.equal(holds(without), false);
  const wrong = fixture();
  wrong.findings[0].value = 'NaN';
  assert.equal(holds(wrong), false);
  wrong.findings[0].value = null;
  assert.equal(holds(wrong), true);
});

test('types: optional fields, lists, references and nulls', () => {
  const small = {
    properties: {list: {type: 'array', items: {$ref: '#/$defs/Thing'}}, kind: {enum: ['a', 'b']}},
    required: ['list'],
    $defs: {Thing: {properties: {x: {type: ['number', 'null'], description: 'how much'}}, required: ['x']}}
  };
  const text = declarations(small, 'small.json', 'Small');
  assert.match(text, /list: Array<Thing>;/);
  assert.match(text, /kind\?: "a" \| "b";/);
  assert.match(text, /x: number \| null;/);
  assert.match(
    tables({...small, properties: {list: small.properties.list}}),
    /## `list\[\]`[^]*\| `x` \| number or null \| how much \|/
  );
});
