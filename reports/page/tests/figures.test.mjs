import assert from 'node:assert/strict';
import test from 'node:test';
import {Results} from '../data.js';
import {
  axisTitle,
  figuresOf,
  loadAxis,
  outputAxis,
  outputsOf,
  powerOf,
  rowsOf,
  thinned
} from '../data/figures_data.js';
import {curve, fixture} from './fixture.mjs';

test('a new scene has a figure, with or without a description', () => {
  const json = fixture();
  json.curves.push(curve('c99_new', 'invariant', ['factor', 'u_x'], [10, 1]));
  const figures = figuresOf(new Results(json));
  assert.deepEqual(
    figures.map((f) => f.scene.title),
    ['C2 Parallelepiped', 'c99 new']
  );
  assert.equal(figures[1].id, 'scene-c99_new');
  assert.equal(figures[1].outputs.first, 'u_x');
});

test('the component in which the joints differ most comes first; the linear analysis does not decide', () => {
  const columns = ['factor', 'theta_x', 'theta_y'];
  const curves = [
    curve('s', 'a', columns, [1, 1, 2e-7]),
    curve('s', 'b', columns, [1, 1.01, 1e-7]),
    curve('s', 'linearized', columns, [1, -9, 0])
  ];
  assert.deepEqual(outputsOf(curves), {names: ['theta_x', 'theta_y'], first: 'theta_y'});
  assert.deepEqual(outputsOf([]), {names: [], first: undefined});
});

test('holes in a curve are left out of its rows', () => {
  const holed = {
    ...curve('s', 'a', ['factor', 'theta_x'], [1, 1]),
    rows: [
      [1, null],
      [null, 2],
      [2, NaN],
      [3, 4]
    ]
  };
  assert.deepEqual(
    rowsOf([holed], 'theta_x', () => '<script>').map((r) => [r.load, r.value, r.series]),
    [[3, 4, '<script>']]
  );
  assert.deepEqual(
    rowsOf([holed], 'theta_z', () => ''),
    []
  );
});

test('names and units of outputs and loads', () => {
  assert.deepEqual(outputAxis('theta_y'), {title: 'θ₂', unit: 'rad'});
  assert.deepEqual(outputAxis('u_z'), {title: 'u₃', unit: 'm'});
  assert.deepEqual(outputAxis('new_thing'), {title: 'new thing', unit: ''});
  assert.deepEqual(loadAxis({}), {title: 'load factor', unit: ''});
  assert.deepEqual(loadAxis({load: {title: 'moment', unit: 'N m'}}), {title: 'moment', unit: 'N m'});
  assert.equal(axisTitle({title: 'load factor', unit: ''}), 'load factor');
  assert.equal(axisTitle({title: 'θ₂', unit: 'rad'}, -7), 'θ₂, 10⁻⁷ rad');
});

test('powers of ten keep labels short', () => {
  assert.equal(powerOf([1e-7, -3e-7]), -7);
  assert.equal(powerOf([0.5]), 0);
  assert.equal(powerOf([12]), 0);
  assert.equal(powerOf([1e6]), 6);
  assert.equal(powerOf([NaN, null]), 0);
  assert.equal(powerOf([]), 0);
});

test('thinned marks keep the last', () => {
  const rows = Array.from({length: 100}, (_, i) => [i]);
  const {rows: kept} = thinned({rows});
  assert.ok(kept.length <= 33);
  assert.deepEqual(kept.at(-1), [99]);
});
