import assert from 'node:assert/strict';
import test from 'node:test';
import {percent} from '../format.js';
import {
  bodyLabel,
  familyLabel,
  lawLook,
  paperXi,
  printedDigits,
  solidsOf,
  withBar
} from '../data/solids_data.js';

test('every list is there, even of nothing', () => {
  const none = solidsOf({});
  assert.equal(none.given, false);
  assert.deepEqual([none.bodies, none.shapes, none.newton, none.missing], [[], [], [], []]);
  assert.equal(solidsOf({solids: {}}).given, true);
});

test('error bars to their second digit', () => {
  assert.equal(withBar(0.553812, 0.00066), '0.55381 ± 0.00066');
  assert.equal(withBar(0.029375, 3.8e-5), '0.029375 ± 0.000038');
  assert.equal(withBar(0.029375, 3.8e-5, true), '(2.9375 ± 0.0038)·10⁻²');
  assert.equal(withBar(-0.5, 0.01), '−0.500 ± 0.010');
  assert.equal(withBar(0.5, 1e-14), '0.5 ± 1.0·10⁻¹⁴');
});

test('without a number, or without its bar', () => {
  for (const x of [NaN, null, undefined]) assert.equal(withBar(x, 1), '–');
  for (const bar of [NaN, null, undefined, 0]) assert.equal(withBar(0.5, bar), '0.5');
  assert.equal(percent(null), '–');
  assert.equal(percent(0.0123), '1.2 %');
  assert.equal(printedDigits(NaN), '–');
  assert.equal(printedDigits(1.59e-3), '1.59000·10⁻³');
});

test('names of what no list knows', () => {
  assert.equal(lawLook('<script>').label, '<script>');
  assert.equal(bodyLabel('frustum_top'), 'frustum, top clamped');
  assert.equal(familyLabel(undefined), 'unnamed family');
  assert.equal(familyLabel({cut: 'saddle', hole: 'none'}), 'saddle, no hole');
});

test('the xi of the paper is that of moments 1 and 3', () => {
  const xis = [
    {
      law: 'hencky',
      moments: [
        {name: '23', value: 1},
        {name: '13', value: 2}
      ]
    }
  ];
  assert.equal(paperXi({xis}, 'hencky').value, 2);
  assert.equal(paperXi({xis}, 'neo_hooke'), undefined);
  assert.equal(paperXi({}, 'hencky'), undefined);
});
