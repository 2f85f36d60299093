import assert from 'node:assert/strict';
import test from 'node:test';
import {Results} from '../data.js';
import {countsOf, defectText, rowsOf} from '../data/programs_data.js';
import {fixture, program, run} from './fixture.mjs';

test('one row a program that was run, one a law that was only read, in the order of the results', () => {
  const rows = rowsOf(new Results(fixture()));
  assert.deepEqual(
    rows.map((r) => [r.program, r.version, r.law, r.known, r.agreement, r.isAgain]),
    [
      ['Engine <engine>', '1.0', 'engine_law', 'measured', '5.4', false],
      ['Engine <engine_2>', '1.0', 'engine_law', 'measured', '5.4', true],
      ['engine <read_law>', '', 'read_law', 'read in the source', '', false]
    ]
  );
});

test('defects in words with their sizes; none is no text', () => {
  const [first, , read] = rowsOf(new Results(fixture()));
  assert.equal(first.defects, 'moments do not balance: 0.66; the order of the bodies matters: 1.3');
  assert.equal(first.facts, 'no axes of its own');
  assert.equal(read.defects, '');
  assert.equal(defectText({words: 'works', size: 4.2e-4, finding: ''}), 'works: 4.2·10⁻⁴');
});

test('where answers are from, how many, and what they are good for', () => {
  const law = program('x', {cases: [run('a', {digits: 12, good_to: 13}), run('b', {answers: 'live'})]});
  const [kept, live] = rowsOf({programs: [law]});
  assert.equal(kept.agreement, '12.0');
  assert.equal(kept.details, '32 poses; kept answers, good to 13 digits: one step from rest');
  assert.match(live.details, /; live answers,/);
});

test('programs and laws are counted; older results have none', () => {
  assert.deepEqual(countsOf(new Results(fixture())), {laws: 2, run: 2});
  const old = new Results({...fixture(), programs: undefined});
  assert.deepEqual(countsOf(old), {laws: 0, run: 0});
  assert.deepEqual(rowsOf(old), []);
});
