import assert from 'node:assert/strict';
import {readdirSync, readFileSync} from 'node:fs';
import test from 'node:test';
import {HUE, look, paletteStyle, seriesLook} from '../palette.js';

test('every hue that is named has a colour for light and dark', () => {
  const style = paletteStyle();
  for (const [name, color] of Object.entries(HUE)) {
    assert.equal(color, `var(--hue-${name})`);
    assert.match(style, new RegExp(`--hue-${name}:light-dark\\([^;]+,[^;]+\\)`));
  }
});

test('a new formulation has a look, the same whenever it is asked', () => {
  const first = look('brand_new');
  assert.match(first.color, /^light-dark\(oklch\(.*\), oklch\(.*\)\)$/);
  assert.ok(Array.isArray(first.dash) && first.shape);
  look('another');
  assert.deepEqual(look('brand_new'), first);
  assert.notEqual(look('another').color, first.color);
});

test('a name cannot leave the style', () => {
  assert.match(look('<script>);}').color, /^light-dark\([\w().,\s]+\)$/);
});

test('known families share no look', () => {
  const looks = ['attached_a', 'attached_b', 'invariant', 'intrinsic', 'jointc'].map((n) =>
    JSON.stringify(look(n))
  );
  assert.equal(new Set(looks).size, looks.length);
});

test('several series of one formulation differ by their dash', () => {
  assert.deepEqual(seriesLook('invariant', 0), look('invariant'));
  assert.equal(seriesLook('invariant', 1).color, look('invariant').color);
  assert.notDeepEqual(seriesLook('invariant', 1).dash, look('invariant').dash);
});

test('no colour is written down anywhere else', () => {
  const here = new URL('..', import.meta.url);
  const below = (folder) =>
    readdirSync(new URL(folder, here), {recursive: true}).map((name) => folder + name);
  const modules = [...readdirSync(here), ...below('charts/'), ...below('dashboard/'), ...below('sections/')];
  assert.ok(
    modules.some((m) => m.split('/').length === 3),
    'rooms of charts are read as well'
  );
  const literal = /#[0-9a-f]{6}\b|\brgb\(|\boklch\(/i;
  const found = modules.filter(
    (m) => m.endsWith('.js') && m !== 'palette.js' && literal.test(readFileSync(new URL(m, here), 'utf8'))
  );
  assert.deepEqual(found, []);
});
