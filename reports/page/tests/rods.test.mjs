import assert from 'node:assert/strict';
import test from 'node:test';
import {chainName, chainRows, crossed, followRows, reachRows, rodName} from '../data/rods_data.js';
import {degrees} from '../data/ranges_data.js';

const within = (one, five) => [
  {tolerance: 0.01, ...one},
  {tolerance: 0.05, ...five}
];
const at = (moment, angle) => ({moment, angle});
const rods = {
  skew: {
    moment: [100, 200, 300, 400],
    angle: [0.1, 0.2, 0.4, 0.3],
    theta: [],
    curves: [
      {formulation: 'short', error: [0.02, null, 0.001, 0.1], within: within(at(0, 0), at(100, 0.1))},
      {formulation: 'far', error: [0.001, 0.002, 0.003, 0.9], within: within(at(300, 0.4), at(400, 0.3))}
    ]
  }
};

test('the farthest comes first, in degrees, and says whether it is the whole path', () => {
  const rows = reachRows(rods);
  assert.deepEqual(
    rows.map((r) => [r.formulation, r.tolerance, r.moment, r.isWhole]),
    [
      ['far', '1 %', 300, false],
      ['far', '5 %', 400, true],
      ['short', '1 %', 0, false],
      ['short', '5 %', 100, false]
    ]
  );
  assert.equal(rows[0].degrees, degrees(0.4));
});

test('a line ends where its joint is lost, and where the rod turns back', () => {
  const rows = followRows(rods);
  assert.deepEqual(
    rows.filter((r) => r.formulation === 'short').map((r) => r.error),
    [0.02]
  );
  assert.deepEqual(
    rows.filter((r) => r.formulation === 'far').map((r) => r.moment),
    [100, 200, 300]
  );
});

test('without the record there are no rows', () => {
  assert.deepEqual(reachRows({}), []);
  assert.deepEqual(followRows({}), []);
});

test('names of rods, and a table with a gap', () => {
  assert.equal(rodName('c3'), 'C3');
  assert.equal(rodName('strip_10'), 'strip, GJ 10 EI₂');
  assert.equal(rodName('1:2:3'), '1 : 2 : 3');
  const columns = [{rows: [{formulation: 'a', x: 1}]}, {rows: [{formulation: 'b', x: 2}]}];
  assert.deepEqual(
    crossed(columns, (row) => String(row.x)),
    [
      ['a', '1', '–'],
      ['b', '–', '2']
    ]
  );
});

test('chains: a row per number of links that was solved', () => {
  const point = {links: 8, error: 0.1, iterations: 5, ms: 0.2};
  const orders = [
    {formulation: 'a', rod: 'straight_anisotropic', order: 2, points: [point, {...point, error: null}]}
  ];
  const rows = chainRows({chains: {orders, tangents: []}});
  assert.equal(rows.length, 1);
  assert.deepEqual([rows[0].links, rows[0].order, rows[0].ms], [8, 2, 0.2]);
  assert.deepEqual(chainRows({}), []);
  assert.equal(chainName('straight_anisotropic'), 'straight, anisotropic');
  assert.equal(chainName('my_rod'), 'my rod');
});
