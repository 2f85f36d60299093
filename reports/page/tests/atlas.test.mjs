import assert from 'node:assert/strict';
import test from 'node:test';
import {failuresOf} from '../data/atlas_data.js';

const limitsOf = (series) => {
  const [failure] = failuresOf({
    stability: {defects: [{what: 'node_order', formulation: '<script>', ...series}]}
  });
  return failure?.rows[0]?.limits;
};
const at = (limits, tolerance) => limits.find((l) => l.tolerance === tolerance);

test('without stability there is no failure', () => {
  assert.deepEqual(failuresOf({}), []);
  assert.deepEqual(failuresOf({stability: {}}), []);
});

test('a bound lies where the log-log line meets the tolerance', () => {
  const limits = limitsOf({x: [0.01, 0.1, 1], error: [1e-8, 1e-5, 1e-2]});
  assert.ok(Math.abs(at(limits, 1e-6).x / 0.1 / 10 ** (-1 / 3) - 1) < 1e-9);
  assert.ok(Math.abs(at(limits, 1e-3).x / 10 ** (-1 / 3) - 1) < 1e-9);
  assert.equal(at(limits, 1e-12).none, true);
});

test('all that was tried is safe', () => {
  const limits = limitsOf({x: [0.01, 1], error: [0, 0]});
  assert.deepEqual(at(limits, 1e-12), {tolerance: 1e-12, all: true, x: 1});
});

test('NaN and null are failures, not successes', () => {
  for (const hole of [NaN, null, undefined]) {
    assert.equal(at(limitsOf({x: [0.01, 1], error: [0, hole]}), 1e-3).x, 0.01);
    assert.equal(at(limitsOf({x: [0.01], error: [hole]}), 1e-3).none, true);
  }
});

test('a series without points has no row', () => {
  assert.equal(limitsOf({x: [], error: []}), undefined);
});

test('small rotations are safe from a bound on', () => {
  const conditioning = [
    {what: 'phi/double', formulation: 'a', x: [1e-8, 1e-4, 1, 3], error: [1, 1e-9, 1e-14, 1]}
  ];
  const [failure] = failuresOf({stability: {range: {conditioning, refusals: [], large_rotation: []}}});
  assert.equal(failure.from, true);
  const {x} = at(failure.rows[0].limits, 1e-6);
  assert.ok(x > 1e-8 && x < 1e-4);
});

test('energies that are series have a row with the rotation at which they are refused', () => {
  const convexity = [{formulation: 'a', radius: 1.69, says: 'a: rotation of 3.38 rad is beyond'}];
  const range = {convexity, conditioning: [], refusals: [], large_rotation: []};
  const failures = failuresOf({stability: {range}});
  assert.deepEqual(
    failures.map((f) => f.key),
    ['convexity']
  );
  assert.deepEqual(failures[0].rows[0].limits, [{x: 1.69}]);
  assert.equal(failures[0].rows[0].message, convexity[0].says);
  assert.deepEqual(failuresOf({stability: {range: {...range, convexity: undefined}}}), []);
});
