import assert from 'node:assert/strict';
import test from 'node:test';
import {accuracyOf, errorOf, front} from '../data/accuracy_data.js';
import {holds, Results} from '../data.js';
import {finding, fixture, timing} from './fixture.mjs';

const MODELLING = {what: 'residual', error: 'modelling'};
const pointOf = (results, name, choice = MODELLING) =>
  accuracyOf(results, choice).points.find((p) => p.formulation === name && p.kind === 'angular');
const missingOf = (results, name, choice = MODELLING) =>
  accuracyOf(results, choice).missing.find((p) => p.name === name && p.kind === 'angular')?.reason;

test('other schemas are refused', () => {
  assert.throws(() => new Results({...fixture(), version: 2}), /version 2/);
  assert.throws(() => new Results({...fixture(), schema: '<script>'}), /<script>/);
});

test('an error below the uncertainty of its truth stands at it', () => {
  const results = new Results(fixture());
  const floored = pointOf(results, 'invariant');
  assert.equal(floored.error, 2.5e-6);
  assert.equal(floored.floored, true);
  assert.equal(pointOf(results, 'attached_a').floored, false);
});

test('the kernel is timed before the transcription, unless that is asked for', () => {
  const json = fixture();
  json.timings.push(timing('invariant', 'angular', {implementation: 'reference', ns: 153}));
  const results = new Results(json);
  assert.equal(pointOf(results, 'invariant').ns, 25);
  assert.equal(pointOf(results, 'invariant').implementation_label, 'kernel');
  const readable = pointOf(results, 'invariant', {...MODELLING, implementation: 'reference'});
  assert.equal(readable.ns, 153);
  assert.equal(readable.implementation_label, 'transcription');
});

test('a point that cannot be drawn says why', () => {
  const json = fixture();
  const timingOf = (name) => json.timings.find((t) => t.formulation === name && t.kind === 'angular');
  Object.assign(timingOf('invariant'), {wrong: true, ns: null, message: 'off by 2'});
  timingOf('quaternion').ns = null;
  json.findings.find((f) => f.name === 'attached_a/angular/modelling_error').value = NaN;
  const results = new Results(json);
  assert.match(missingOf(results, 'invariant'), /refused it: off by 2/);
  assert.equal(missingOf(results, 'quaternion'), 'not timed');
  assert.match(missingOf(results, 'attached_a'), /not a number/);
});

test('an error of 0 with a truth known exactly has no place on a log axis', () => {
  assert.match(errorOf(finding('a/angular/x', {value: 0, uncertainty: null}), 'angular').reason, /log axis/);
  assert.equal(errorOf(undefined, 'angular').reason, 'no modelling error measured');
  assert.equal(
    errorOf(finding('a/angular/x', {verdict: 'left_out', reason: 'why'}), 'angular').reason,
    'why'
  );
});

test('numerical errors do not fall below half a unit of rounding', () => {
  const json = fixture();
  json.timings.find((t) => t.formulation === 'invariant' && t.kind === 'angular').error = 0;
  const point = pointOf(new Results(json), 'invariant', {what: 'residual', error: 'numerical'});
  assert.equal(point.error, 2 ** -54);
});

test('the front holds what no other point beats in both', () => {
  const points = [
    {ns: 3, error: 1},
    {ns: 1, error: 9},
    {ns: 2, error: 10},
    {ns: 4, error: 1}
  ];
  assert.deepEqual(front(points), [points[1], points[0]]);
  assert.deepEqual(front([]), []);
});

test('a property holds, does not hold, or was not measured', () => {
  assert.equal(holds(undefined), undefined);
  assert.equal(holds(finding('x', {verdict: 'left_out'})), undefined);
  assert.equal(holds(finding('x')), 'yes');
  assert.equal(holds(finding('x', {verdict: 'known_failure'})), 'no');
});
