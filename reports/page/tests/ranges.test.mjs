import assert from 'node:assert/strict';
import test from 'node:test';
import {Results} from '../data.js';
import {angleAt, degrees, farthest, rangesOf, studyOf} from '../data/ranges_data.js';
import {finding, fixture} from './fixture.mjs';

const near = (a, b) => assert.ok(Math.abs(a - b) <= 1e-9 * Math.abs(b), `${a} is not ${b}`);
const curve = {
  rows: [
    [0.5, 0.3, 0.4, 0],
    [1, 0.6, 0.8, 0]
  ]
};

test('angles between the points, from rest, and not beyond the end', () => {
  near(angleAt(curve, 0.25), 0.25);
  near(angleAt(curve, 0.75), 0.75);
  near(angleAt(curve, 1), 1);
  assert.equal(angleAt(curve, 0), 0);
  assert.equal(angleAt(curve, 1.1), undefined);
  assert.equal(angleAt(curve, NaN), undefined);
  assert.equal(angleAt({rows: []}, 0.5), undefined);
});

test('load and angle of each range, by the stored curve', () => {
  const range = rangesOf(new Results(fixture())).find((r) => r.formulation === 'invariant');
  assert.equal(range.one.load, 40);
  assert.equal(range.five.load, 80);
  near(range.one.phi, degrees((0.5 * 40) / 270));
  assert.equal(range.one.isWhole, false);
  assert.equal(range.end.isWhole, true);
});

test('without the curve: loads alone', () => {
  const [range] = rangesOf(new Results({...fixture(), paper: undefined}));
  assert.equal(range.one.load, 20);
  assert.equal(range.one.phi, undefined);
});

test('findings without a value, without words or with strange names', () => {
  const name = '<script>/angular/fe_range_block_moment';
  const words = 'theta_2 within 1 % up to 5, within 5 % up to 9; phi = 0.50 rad at 10';
  const of = (rest) => rangesOf(new Results({...fixture(), findings: [finding(name, rest)]}));
  assert.equal(of({value: null, parameter: words}).length, 0);
  assert.equal(of({value: 5, parameter: ''}).length, 0);
  assert.equal(of({value: 5, parameter: words})[0].formulation, '<script>');
});

test('the study of a kind, and who goes farthest', () => {
  const ranges = rangesOf(new Results(fixture()));
  assert.equal(studyOf(ranges, 'angular'), 'block_moment');
  assert.equal(studyOf(ranges, 'linear'), undefined);
  assert.equal(farthest(ranges, 'five').formulation, 'brand_new');
  assert.equal(farthest([], 'one'), undefined);
});
