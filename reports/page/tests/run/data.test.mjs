// What a run's page is drawn from: poses, choices, words, pieces of the drawing, and the script that they become.
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import test from 'node:test';
import {Ajv2020} from 'ajv/dist/2020.js';
import {angleAxis, composed, exaggerated, inverted, pointOf, posed, turned} from '../../run/poses.js';
import {
  curvesCsv,
  firstChosen,
  multiplierAt,
  proportions,
  rowBeside,
  rowNear,
  seriesOfRun,
  unbalanced
} from '../../run/run_data.js';
import {piecesOf, placesOf, sizesOf} from '../../run/solids.js';
import {balanceOf} from '../../run/energy.js';
import {
  answerWords,
  dampingWords,
  endWords,
  lawWords,
  loadWords,
  outputWords,
  placeText
} from '../../run/words.js';
import {chainFixture, motionFixture, rowFixture, runFixture} from './fixture.mjs';

const schema = JSON.parse(readFileSync(new URL('../../../run.schema.json', import.meta.url), 'utf8'));
const holds = new Ajv2020({allowUnionTypes: true}).compile(schema);
const near = (a, b, most = 1e-12) =>
  a.forEach((x, i) => assert.ok(Math.abs(x - b[i]) < most, `${a} is not ${b}`));
const quarter = [Math.SQRT1_2, 0, 0, Math.SQRT1_2]; // about z

test('the made-up runs satisfy the schema, and a wrong one does not', () => {
  for (const run of [runFixture(), rowFixture(), chainFixture(), motionFixture()]) {
    assert.equal(holds(run), true, JSON.stringify(holds.errors));
  }
  const wrong = runFixture();
  wrong.curves[0].poses = [[1]];
  assert.equal(holds(wrong), false);
});

test('a motion: the time in place of the load factor, loads over it, dampers, what the energies miss', () => {
  const run = motionFixture();
  assert.match(answerWords(run), /^1 of 1 formulation reaches time 10 s\./);
  assert.equal(placeText(run, 2.5, 5), 'time 2.5 s');
  assert.equal(placeText(rowFixture(), 2.5, 5), 'load factor 2.5');
  assert.match(loadWords(run)[0], /; times 0, 1 at 0, 5 s$/);
  assert.match(dampingWords(run.joints[0]), /1, 2, 3 N m s\/rad about joint axes 1, 2, 3\.$/);
  const load = {times: [1, 2, 4], factors: [0, 1, 0.5]};
  near(
    [0, 1, 1.5, 2, 3, 4, 9].map((t) => multiplierAt(/** @type {any} */ (load), t)),
    [0, 0, 0.5, 1, 0.75, 0.5, 0.5]
  );
  near(balanceOf(run.curves[0].energies), [0, 0, 0, 0, -0.25]);
  assert.match(curvesCsv(run), /^formulation,time,/);
});

test('poses: rotations turn, combine and are undone', () => {
  near(turned(quarter, [1, 0, 0]), [0, 1, 0]);
  near(turned(composed(quarter, quarter), [1, 0, 0]), [-1, 0, 0]);
  near(turned(composed(inverted(quarter), quarter), [1, 2, 3]), [1, 2, 3]);
  near(pointOf({x: [1, 2, 3], q: quarter}, [1, 0, 0]), [1, 3, 3]);
  const {angle, axis} = angleAxis(quarter.map((x) => -x)); // the same rotation
  near([angle, ...axis], [Math.PI / 2, 0, 0, 1]);
});

test('a motion that is drawn larger: from rest, about the same axis, and nothing at rest', () => {
  const rest = posed([1, 0, 0, 1, 0, 0, 0]);
  const small = {x: [1, 0.01, 0], q: [Math.cos(0.005), 0, 0, Math.sin(0.005)]};
  const large = exaggerated(rest, small, 20);
  near(large.x, [1, 0.2, 0]);
  near([angleAxis(large.q).angle, ...angleAxis(large.q).axis], [0.2, 0, 0, 1]);
  near(exaggerated(rest, rest, 20).q, rest.q);
  const turnedRest = {x: [0, 0, 0], q: quarter};
  near(exaggerated(turnedRest, turnedRest, 50).q, quarter);
});

test('motions that can be seen are drawn as they are; small ones by 1, 2 or 5 times a power of ten', () => {
  assert.equal(proportions(runFixture()).times, 1);
  const slow = runFixture();
  for (const c of slow.curves) {
    c.poses = c.poses.map((row, i) => [
      row[0],
      [0.7, 1e-5 * i, 0, Math.cos(1e-4 * i), 0, 0, Math.sin(1e-4 * i)]
    ]);
  }
  const {times} = proportions(slow);
  assert.equal(times, 500); // 8e-4 rad at most, 0.5 wanted
});

test('shown at first: one of each group, the one that is drawn among them, and who ends early', () => {
  const run = runFixture();
  assert.equal(firstChosen(run), 'invariant');
  const on = seriesOfRun(run).filter((s) => s.on);
  assert.deepEqual(
    on.map((s) => s.key),
    ['attached_a', 'invariant', 'jointc']
  );
});

test('several xi of one formulation differ in their look', () => {
  const run = runFixture();
  run.curves[1] = {...run.curves[0], label: 'attached_a xi=0.3'};
  const [first, second] = seriesOfRun(run);
  assert.notDeepEqual(first.look, second.look);
});

test('rows by load factor: the nearest, the last of several, none beyond an end or where the path turns back', () => {
  const [whole, , , early] = runFixture().curves;
  assert.equal(rowNear(whole, 4.9), 2);
  assert.equal(rowBeside(early, 5), 2);
  assert.equal(rowBeside(early, 7.5), -1);
  const back = {...whole, rows: [[0], [5], [3], [5]]};
  assert.equal(rowNear(back, 5), 3);
  assert.equal(rowBeside(back, 3), -1);
});

test('what holds the nodes balances as a force and its lever do', () => {
  const poses = [
    [0, 0, 0],
    [2, 0, 0]
  ];
  const pulled = [
    [0, -3, 0, 0, 0, -6],
    [0, 3, 0, 0, 0, 0]
  ];
  near(unbalanced(pulled, poses), [0, 0, 0, 0, 0, 0]);
  pulled[0][5] = -5;
  near(unbalanced(pulled, poses), [0, 0, 0, 0, 0, 1]);
  const along = [
    [-1, -2, -4, 0, 0, 0],
    [1, 2, 4, 0, 0, 0]
  ]; // on the line between the two points
  const skew = [
    [1, 2, 3],
    [2, 4, 7]
  ];
  near(unbalanced(along, skew), [0, 0, 0, 0, 0, 0]);
  along[1][1] = 3;
  near(unbalanced(along, skew), [0, 1, 0, -7, 0, 2]);
});

test('CSV: a line for each row, all digits', () => {
  const run = runFixture();
  run.curves[0].rows[1][1] = 0.1 + 0.2;
  const lines = curvesCsv(run).trimEnd().split('\r\n');
  assert.equal(lines[0], 'formulation,factor,theta_z,u_y,error');
  assert.equal(lines.length, 1 + run.curves.reduce((sum, c) => sum + c.rows.length, 0));
  assert.ok(lines[2].startsWith('attached_a,2.5,0.30000000000000004,'), lines[2]);
});

test('a scene in words, with units', () => {
  const run = runFixture();
  const [joint] = run.joints;
  assert.match(lawWords(joint), /10, 11, 12 N\/m along and 13, 14, 15 N m\/rad about joint axes 1, 2, 3/);
  assert.equal(
    endWords(joint.a),
    'joint point at (0.3, 0.1, 0) m in its axes, joint axes turned by 45° about (0, 1, 0)'
  );
  assert.deepEqual(loadWords(run), [
    'force (0, 2, 0) N on node b, at (0.5, 0, 0) m in its axes, fixed in space',
    'moment (0, 0, 3) N m on node b, turning with it'
  ]);
  const coupled = structuredClone(joint);
  coupled.law.matrix[0][1] = coupled.law.matrix[1][0] = 2;
  assert.match(lawWords(coupled), /coupled.*translation first: \[10, 2, 0, 0, 0, 0\]/);
  assert.match(lawWords(rowFixture().joints[0]), /\(1, 2, 3\) e \+ \(0, 0, 1\) e⁵/);
  assert.equal(outputWords({name: 'theta_x', unit: 'rad'}), 'rotation about x: theta_x, rad');
  assert.equal(outputWords({name: 'energy', unit: 'J'}), 'energy, J');
  assert.match(
    answerWords(run),
    /3 of 4 formulations reach load factor 10, with 2 answers .* 50 %\. 1 ends early\./
  );
});

/** The pieces of a class at a row of the first curve. */
function drawn(run, row, cls, others = []) {
  const pieces = piecesOf(run, seriesOfRun(run)[0], others, row, sizesOf(run));
  return pieces.filter((p) => p.cls.split(' ').includes(cls));
}

test('the drawing: boxes at rest and moved, both joint frames, arms, loads that grow', () => {
  const run = runFixture();
  assert.equal(drawn(run, 4, 'body').length, 12);
  assert.equal(drawn(run, 4, 'arm').length, 2);
  assert.equal(drawn(run, 4, 'frame').length, 6);
  assert.deepEqual(
    drawn(run, 0, 'body')
      .slice(6)
      .map((f) => f.points),
    drawn(run, 4, 'outline').map((f) => f.points)
  );
  assert.equal(drawn(run, 0, 'load').length, 0);
  const length = ({points: [from, to]}) => Math.hypot(...from.map((x, k) => to[k] - x));
  assert.ok(length(drawn(run, 4, 'load')[0]) > 1.5 * length(drawn(run, 1, 'load')[0]));
});

test('a follower load turns with its body, a fixed one does not', () => {
  const run = runFixture();
  run.curves[0].poses[4][1] = [0.7, 0, 0, Math.SQRT1_2, Math.SQRT1_2, 0, 0]; // about x: z goes to -y
  const [force, moment] = drawn(run, 4, 'load').filter((p) => !p.isFace && p.points.length === 2);
  const along = ({points: [from, to]}) =>
    to.map((x, k) => (x - from[k]) / Math.hypot(...to.map((y, j) => y - from[j])));
  near(along(force), [0, 1, 0]);
  near(along(moment), [0, -1, 0]);
});

test('others stand beside at the same load factor, and not beyond their end', () => {
  const run = runFixture();
  const jointc = seriesOfRun(run).filter((s) => s.key === 'jointc');
  assert.equal(drawn(run, 2, 'other', jointc).length, 3);
  assert.equal(drawn(run, 3, 'other', jointc).length, 0);
});

test('several bodies: a box each, every joint, a name each', () => {
  const run = rowFixture();
  assert.equal(drawn(run, 4, 'body').length, 18);
  assert.equal(drawn(run, 4, 'arm').length, 4);
  const words = drawn(run, 4, 'strong').map((p) => p.text);
  for (const name of ['ground', 'lever', 'wheel']) assert.ok(words.includes(name), words.join());
});

test('a chain: its line at the row, those before, at rest', () => {
  const run = chainFixture();
  const lines = drawn(run, 4, 'chain');
  assert.equal(lines.filter((p) => p.cls === 'chain before').length, 3);
  assert.deepEqual(
    lines.find((p) => p.cls === 'chain')?.points.at(-1),
    run.curves[0].poses[4][32].slice(0, 3)
  );
  assert.equal(placesOf(run, run.curves[0], sizesOf(run)).length, 6 * 34);
});

test('every name of the page’s script is there once: the block of modules is read as strict code', () => {
  const page = readFileSync(process.env.RUN_BUNDLE ?? '', 'utf8');
  const script = page.slice(page.lastIndexOf('<script>') + 8, page.lastIndexOf('</script>'));
  assert.doesNotThrow(() => new Function(script));
  assert.ok(script.trimStart().startsWith("'use strict';"));
  const twice = script.replace(/\}\s*$/, 'function piecesOf() {}\n}');
  assert.throws(() => new Function(twice), SyntaxError);
  assert.ok(!/^(import|export)\b/m.test(script));
});
