import assert from 'node:assert/strict';
import test from 'node:test';
import {notRun, tallyOf} from '../data/tally_data.js';
import {finding, fixture} from './fixture.mjs';

test('every finding counts once, by its verdict', () => {
  assert.deepEqual(tallyOf(fixture().findings), {pass: 20, fail: 0, known_failure: 1, left_out: 1});
  const failed = [finding('a/angular/x', {verdict: 'fail', value: null})];
  assert.deepEqual(tallyOf(failed), {pass: 0, fail: 1, known_failure: 0, left_out: 0});
});

test('a finding that was left out is not counted again among the paths and timings', () => {
  const results = fixture();
  assert.deepEqual(
    notRun(results).map((l) => l.what),
    ['c2_parallelepiped_small/cayley, the rest of the path']
  );
});

test('what is listed twice is counted once', () => {
  const twice = {what: '<script>', reason: ''};
  assert.equal(notRun({findings: [], left_out: [twice, {...twice}]}).length, 1);
});
