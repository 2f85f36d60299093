import assert from 'node:assert/strict';
import test from 'node:test';
import {isOwnTruth, tableOf, truthOf} from '../data/cheapest_data.js';
import {rowsOf} from '../charts/speed/assembly_data.js';
import {candidatesOf} from '../charts/speed/batch_size_data.js';
import {kernelsOf, linesOf} from '../charts/speed/roofline_data.js';
import {pointsOf, scenesOf} from '../charts/speed/work_precision_data.js';
import {Results} from '../data.js';
import * as speed from '../data/speed_data.js';
import {fixture, timing} from './fixture.mjs';

test('results of before kernels were timed get what they lack', () => {
  const {implementation, precision, errors} = speed.withDefaults({name: 'a/angular/residual'});
  assert.deepEqual([implementation, precision, errors], ['reference', 'double', []]);
});

test('a time that is wrong, null or no number is not used', () => {
  for (const t of [{ns: null}, {ns: NaN}, {ns: 0}, {ns: 5, wrong: true}]) {
    assert.equal(speed.usable({wrong: false, ...t}), false);
  }
  assert.equal(speed.usable({ns: 5, wrong: false}), true);
});

test('a batch stands at its fastest size on one thread', () => {
  const batch = (joints, ns, threads = 1) =>
    timing('invariant', 'angular', {implementation: 'batch', isa: 'avx2', joints, ns, threads});
  const best = speed.fastestBatches([batch(256, 7), batch(4096, 6), batch(1e5, 3, 2)]);
  assert.deepEqual(
    best.map((t) => t.ns),
    [6]
  );
});

test('what is timed is named: transcription or kernel, with or without tangent', () => {
  assert.equal(speed.makeOf(timing('a', 'angular', {implementation: 'reference'})), 'transcription');
  assert.equal(speed.briefOf(timing('a', 'angular')), 'kernel');
  assert.equal(speed.whatLabel('residual'), 'without tangent');
  assert.equal(speed.whatLabel('residual_tangent'), 'with tangent');
  assert.equal(speed.whatLabel('new_output'), 'new output');
});

test('marks: what sets a timing most apart comes first', () => {
  const mark = (rest) => speed.markOf(timing('a', 'angular', rest));
  assert.equal(mark({}), 'kernel');
  assert.equal(mark({precision: 'float'}), 'float');
  assert.equal(mark({precision: 'float', variant: 'order_2'}), 'variant');
  assert.equal(mark({variant: 'no_ends', implementation: 'batch'}), 'batch');
  assert.equal(mark({method: 'forward', variant: 'order_2'}), 'method');
  assert.equal(mark({implementation: 'textbook', method: 'forward'}), 'competitor');
  assert.equal(mark({implementation: '<script>'}), 'kernel');
});

test('the floor of rounding is that of the precision', () => {
  assert.equal(speed.roundingFloor({precision: 'float'}), 2 ** -25);
  assert.equal(speed.roundingFloor({precision: 'double'}), 2 ** -54);
});

test('a modelling error is drawn at the time of what computes it well enough', () => {
  const json = fixture();
  json.timings.push(timing('attached_a', 'angular', {variant: 'order_1', ns: 2, error: 10}));
  const view = {kind: 'angular', what: 'residual', marks: new Set(['kernel', 'variant'])};
  const points = pointsOf(new Results(json), {...view, view: 'modelling', scene: 'modelling_error'});
  assert.equal(points.find((p) => p.formulation === 'attached_a').ns, 20);
});

test('ranges of phi in words', () => {
  assert.equal(speed.rangeLabel({from: 0, to: 0.01}), '0 … 10⁻²');
  assert.equal(speed.phiText(Math.PI - 1e-3), 'π − 10⁻³');
  assert.equal(speed.phiText(Math.PI), 'π');
});

test('rates, intensities and limits of batch kernels', () => {
  const t = timing('a', 'angular', {
    implementation: 'batch',
    isa: 'avx2',
    joints: 256,
    ns: 10,
    flops: 80,
    bytes: 160
  });
  const limits = {
    peaks: [{isa: 'avx2', precision: 'double', flops_per_ns: 40}],
    bandwidth: [
      {what: 'read_l1', bytes_per_ns: 64},
      {what: 'read', bytes_per_ns: 10}
    ]
  };
  const choice = {kind: 'angular', precision: 'double', place: 'cache'};
  const [k] = kernelsOf([t], limits, choice);
  assert.deepEqual([k.rate, k.intensity, k.of_peak, k.of_roof], [8, 0.5, 0.2, 0.25]);
  const [uncounted] = kernelsOf([{...t, bytes: null}], {peaks: [], bandwidth: []}, choice);
  assert.deepEqual([uncounted.intensity, uncounted.of_peak, uncounted.share], [null, null, '–']);
  assert.deepEqual(kernelsOf([t], limits, {...choice, place: 'memory'}), []);
  assert.equal(linesOf(limits, [k], 'double', 2).flat[0].label, 'AVX2 peak 40');
});

test('views of work and precision', () => {
  const json = fixture();
  json.timings.find((t) => t.formulation === 'invariant' && t.kind === 'angular').error = NaN;
  const results = new Results(json);
  const view = {kind: 'angular', what: 'residual', marks: new Set(['kernel'])};
  const names = (list) => list.map((p) => p.formulation);
  assert.deepEqual(names(pointsOf(results, {...view, view: 'numerical'})), [
    'attached_a',
    'quaternion',
    'brand_new'
  ]);
  assert.deepEqual(pointsOf(results, {...view, view: 'numerical', marks: new Set()}), []);
  const [scene] = scenesOf(results, 'angular');
  assert.equal(scene.key, 'modelling_error');
  const modelled = pointsOf(results, {...view, view: 'modelling', scene: scene.key});
  assert.deepEqual(names(modelled), ['attached_a', 'quaternion', 'brand_new']);
});

test('the truth is not a candidate in silence', () => {
  const row = (rest) => ({scene: 's', tolerance: 1e-4, formulation: 'invariant', note: '', ...rest});
  const note = 'truth: invariant at 50 digits, since the scene has no xi other than 1/2';
  assert.equal(truthOf(row({note})), 'invariant');
  assert.equal(isOwnTruth(row({note})), true);
  assert.equal(isOwnTruth(row({note, formulation: 'attached_a'})), false);
  assert.equal(isOwnTruth(row({truth: 'invariant'})), true);
  assert.equal(isOwnTruth(row({})), false);
  assert.equal(isOwnTruth(row({formulation: '', truth: ''})), false);
  const {tolerances, scenes} = tableOf([row({note}), row({tolerance: 1e-2, formulation: ''})]);
  assert.deepEqual(tolerances, [1e-2, 1e-4]);
  assert.equal(scenes[0].truth, 'invariant');
});

test('ways from poses to a matrix: in order, by place, threads and wall time apart', () => {
  const json = fixture();
  const way = (implementation, joints, rest = {}) =>
    timing('invariant', 'angular', {what: 'assembly', implementation, joints, ...rest});
  json.timings.push(
    way('assemble', 8064),
    way('assemble', 99904, {variant: 'wall', threads: 1}),
    way('assemble', 99904, {threads: 2}),
    way('batch', 8064),
    way('batch', 99904),
    way('textbook', 99904),
    {...way('assemble', 8064, {variant: 'upper'}), formulation: 'fasse'},
    way('kernel', 99904, {wrong: true})
  );
  const results = new Results(json);
  assert.deepEqual(
    rowsOf(results).map((r) => [r.way, r.place]),
    [
      ['textbook, Eigen', 'from memory'],
      ['batch, whole table', 'in cache'],
      ['batch, whole table', 'from memory'],
      ['assemble', 'in cache'],
      ['assemble, fasse, upper triangle', 'in cache']
    ]
  );
  assert.deepEqual(candidatesOf(results), []);
  assert.deepEqual(rowsOf(new Results(fixture())), []);
});
