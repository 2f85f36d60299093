import assert from 'node:assert/strict';
import test from 'node:test';
import {Results} from '../data.js';
import {choiceOf, conditionOf, firstKind, reachesOf} from '../data/headline_data.js';
import {fixture} from './fixture.mjs';

const near = (a, b, limit = 1e-9) => assert.ok(Math.abs(a - b) <= limit * Math.abs(b), `${a} is not ${b}`);

test('the choice names the truest, fastest first, and the fastest of all', () => {
  const {best, also, fastest} = choiceOf(new Results(fixture()), 'angular');
  assert.equal(best.formulation, 'invariant');
  assert.deepEqual(
    also.map((p) => p.formulation),
    ['quaternion']
  );
  assert.equal(fastest.formulation, 'attached_a');
});

test('the condition is an angle and a load, by the curve of the scene', () => {
  const {phi, load, scene} = conditionOf(new Results(fixture()), 'invariant', 'angular');
  near(phi, (Math.hypot(1.6e-3, 2e-7, 4e-6) * 180) / Math.PI);
  assert.equal(load, '1 N m');
  assert.equal(scene, 'c2_parallelepiped_small');
});

test('without the curve the finding speaks for itself', () => {
  const json = fixture();
  json.curves = [];
  const condition = conditionOf(new Results(json), 'invariant', 'angular');
  assert.equal(condition.phi, undefined);
  assert.equal(condition.where, 'c2_parallelepiped_small, theta_y at 1 N m');
  json.findings.find((f) => f.name === 'invariant/angular/modelling_error').parameter = '<script>';
  assert.deepEqual(conditionOf(new Results(json), 'invariant', 'angular'), {where: '<script>'});
});

test('a hole in the curve is no angle', () => {
  const json = fixture();
  json.curves.find((c) => c.formulation === 'invariant').rows.at(-1)[2] = null;
  assert.equal(conditionOf(new Results(json), 'invariant', 'angular').phi, undefined);
});

test('reaches: of the truest and of what goes farthest', () => {
  const {shown, one, end} = reachesOf(new Results(fixture()), 'angular', ['invariant']);
  assert.deepEqual(
    shown.map((r) => r.formulation),
    ['invariant', 'brand_new']
  );
  assert.equal(one.formulation, 'brand_new');
  assert.equal(end.load, 270);
});

test('nothing measured: no choice, no reach', () => {
  const results = new Results({...fixture(), findings: []});
  assert.equal(choiceOf(results, 'angular'), undefined);
  assert.deepEqual(reachesOf(results, 'angular', []), {shown: [], one: undefined, end: undefined});
  assert.equal(firstKind(results), 'angular');
});

test('the kind with most points is shown first', () => {
  const json = fixture();
  json.timings = json.timings.filter((t) => t.kind !== 'angular');
  assert.equal(firstKind(new Results(json)), 'linear');
});
