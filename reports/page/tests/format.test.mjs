import assert from 'node:assert/strict';
import test from 'node:test';
import {full, isNumber, nanoseconds, plural, seconds, short} from '../format.js';

test('what is no finite number is a dash', () => {
  for (const x of [NaN, Infinity, null, undefined, '1', {}]) {
    assert.equal(isNumber(x), false);
    for (const text of [short(x), full(x), nanoseconds(x), seconds(x)]) assert.equal(text, '–');
  }
});

test('short numbers: plain digits, or a power of ten', () => {
  assert.equal(short(0), '0');
  assert.equal(short(830.4555, 4), '830.5');
  assert.equal(short(123.4), '123');
  assert.equal(short(-0.5), '−0.5');
  assert.equal(short(2.54e-6), '2.5·10⁻⁶');
  assert.equal(short(-3e12), '−3.0·10¹²');
});

test('times and counts', () => {
  assert.equal(nanoseconds(6.12), '6.1');
  assert.equal(nanoseconds(152.7), '153');
  assert.equal(seconds(12.34), '12.3 s');
  assert.equal(seconds(120), '2.0 min');
  assert.equal(plural(1, 'finding'), '1 finding');
  assert.equal(plural(0, 'path or timing', 'paths and timings'), '0 paths and timings');
});
