// What the dashboard says of a change.
import assert from 'node:assert/strict';
import test from 'node:test';
import {amount, fromTo, ratioText, sure, told} from '../../dashboard/words.js';
import {powerOfTen} from '../../format.js';

test('changes in words', () => {
  const c = {digits: null, ratio: null, verdict: 'regression', p: null};
  assert.equal(amount({...c, ratio: 1.1}), '+10 %');
  assert.equal(amount({...c, ratio: 0.9}), '−10 %');
  assert.equal(ratioText(3), '× 3');
  assert.equal(amount({...c, digits: -0.5}), '0.5 digits lost');
  assert.equal(amount({...c, digits: 0.5, verdict: 'improvement'}), '0.5 digits gained');
  assert.equal(amount(c), '');
  assert.deepEqual([sure(c), sure({...c, p: 2e-4})], ['exact', 'p = 2·10⁻⁴']);
  assert.deepEqual([sure({...c, p: 0}), sure({...c, p: 1e-99})], ['p < 10⁻⁶', 'p < 10⁻⁶']);
});

test('both values in as many digits as tell them apart', () => {
  assert.equal(fromTo({before: 1e-5, after: 10 ** -4.5}, 'rad'), '1.000·10⁻⁵ → 3.162·10⁻⁵ rad');
  assert.equal(fromTo({before: 123456, after: 123457}, ''), '1.23456·10⁵ → 1.23457·10⁵');
  assert.equal(fromTo({before: 2, after: null}, 'rad'), '2 → not measured');
  assert.equal(fromTo({before: 2, after: 2}, 'rad'), '2 → 2 rad');
});

test('of what a change says, what its values do not say, in few digits', () => {
  assert.equal(told('time +10.2 %'), '');
  assert.equal(told('1e-05 -> 3.1620000000000004e-05, 0.5 digits lost'), '');
  assert.equal(told('334 -> 335'), '');
  assert.equal(told('-0.5 -> not measured'), '');
  assert.equal(told('pass -> fail; 1.2345678901234e-15 -> 0.1'), 'pass → fail');
  assert.equal(told('fail -> known_failure; 0.1 -> 0.1'), 'fail → known failure');
  assert.equal(told('limit 1.2345678901234e-12 -> not measured'), 'limit 1.235·10⁻¹² → not measured');
  assert.equal(told('instructions +0 %: layout or machine'), 'instructions +0 %: layout or machine');
});

test('powers of ten', () => {
  assert.deepEqual([1e-12, 1000, 3].map(powerOfTen), ['10⁻¹²', '10³', '']);
});
