// The dashboard's numbers and words, without a document.
import assert from 'node:assert/strict';
import test from 'node:test';
import {Blocks, Damaged, unpack} from '../../dashboard/blocks.js';
import {History, indexFault, isOpen} from '../../dashboard/history_data.js';
import {Place} from '../../dashboard/place.js';
import {evenly, logCan, logFits, scaleOf} from '../../dashboard/scale.js';
import {extents, placed, pointsAt, pointsCsv} from '../../dashboard/scatter_data.js';
import {statesOf} from '../../dashboard/state_data.js';
import {blockFault, csvOf, extremes, levels, medians, steps, trendOf} from '../../dashboard/trend_data.js';
import {HOSTILE, makeHistory, packed, randomOf, smallHistory} from './history_fixture.mjs';

const small = smallHistory();
const history = new History(small.index);
const numberOf = (name) => history.numbers.get(name);
const trend = (name, series = 0) => {
  const i = numberOf(name);
  const stretch = small.blocks[i].s.find((s) => s.series === series);
  return trendOf(stretch, history.series[series].runs, history.figures.kind[i] !== 'time');
};
const TIME = 'invariant/angular/residual/kernel';
const ERROR = 'invariant/angular/modelling_error';

/** The text with one character exchanged for another of the base64 alphabet. */
const flipped = (text, i) => text.slice(0, i) + (text[i] === 'A' ? 'B' : 'A') + text.slice(i + 1);

test('the same seed makes the same file, another seed another', () => {
  const make = (seed) =>
    JSON.stringify(
      makeHistory({
        seed,
        order: [0, 0],
        specs: [{name: 'a', unit: '', kind: 'time', formulation: '', base: 1}]
      })
    );
  assert.equal(make(1), make(1));
  assert.notEqual(make(1), make(2));
});

test('a block comes back in both forms of zlib', async () => {
  for (const isRaw of [true, false]) {
    const [, [id, text]] = packed(small, isRaw);
    assert.equal(id, 'f0');
    assert.deepEqual(await unpack(text), JSON.parse(JSON.stringify(small.blocks[0])));
  }
});

/** How many single flips of a character give other data and no error. */
async function unnoticed(text) {
  const whole = JSON.stringify(await unpack(text));
  let count = 0;
  for (let i = 0; i < text.replace(/=+$/, '').length; i++) {
    const got = await unpack(flipped(text, i)).then(JSON.stringify, () => whole);
    if (got !== whole) count++;
  }
  return count;
}

test('with the checksum of zlib no flipped byte goes unnoticed; without it some do', async () => {
  assert.equal(await unnoticed(packed(small, false)[1][1]), 0);
  assert.ok((await unnoticed(packed(small, true)[1][1])) > 0); // so the check above can fail
});

test('what cannot be read is named', async () => {
  const texts = Object.fromEntries(packed(small, false));
  texts.f1 = flipped(texts.f1, 20);
  const blocks = new Blocks((id) => texts[id]);
  const whole = () => '';
  assert.ok((await blocks.get('f0', 'zero', whole)).s);
  await assert.rejects(
    blocks.get('f1', HOSTILE, whole),
    (e) => e instanceof Damaged && e.message.includes(HOSTILE)
  );
  await assert.rejects(blocks.get('f99', 'none', whole), /none are not in this file \(no block “f99”\)/);
  await assert.rejects(
    new Blocks((id) => texts[id]).get('f0', 'zero', () => 'too short'),
    /do not fit .*too short/
  );
});

test('blocks are kept, and the oldest let go', async () => {
  let read = 0;
  const text = packed(small)[1][1];
  const blocks = new Blocks(() => (read++, text));
  await Promise.all([blocks.get('f0', '', () => ''), blocks.get('f0', '', () => '')]);
  assert.equal(read, 1);
  for (let i = 1; i <= 130; i++) await blocks.get(`f${i}`, '', () => '');
  await blocks.get('f0', '', () => '');
  assert.equal(read, 132);
});

test('an index of another schema, version or uneven columns is refused by what is wrong', () => {
  assert.equal(indexFault(small.index), '');
  const faultOf = (change) => {
    const index = structuredClone(small.index);
    change(index);
    return indexFault(index);
  };
  assert.match(
    faultOf((i) => (i.version = 2)),
    /version 2; this page reads halfway-dashboard version 1/
  );
  assert.match(
    faultOf((i) => (i.schema = 'other')),
    /schema other/
  );
  assert.match(
    faultOf((i) => i.runs.title.pop()),
    /title has 71 entries, commit has 72/
  );
  assert.match(
    faultOf((i) => i.latest[1].value.pop()),
    /value has 18 entries, figures has 19/
  );
  assert.match(
    faultOf((n) => (n.changes[0].run = 72)),
    /a change names run 72, of 72/
  );
  assert.match(
    faultOf((n) => (n.pairs[0].error = -1)),
    /a pair names figure -1/
  );
  assert.match(
    faultOf((i) => i.latest.pop()),
    /latest run for each series/
  );
});

test('a figure whose columns do not fit is refused', () => {
  const fault = blockFault(history);
  assert.equal(fault(small.blocks[0]), '');
  assert.match(fault({s: [{...small.blocks[0].s[0], v: [1]}]}), /1 values for 60 runs/);
  assert.match(fault({s: [{series: 7, r: null, v: []}]}), /series 7, of 2/);
  assert.match(fault({}), /holds no values/);
});

test('regressions come first, newest first; what was mended comes last and does not stand', () => {
  const list = history.changesOf(0);
  assert.deepEqual(list.map((c) => history.figures.name[c.figure]).slice(0, 2), [ERROR, TIME]);
  assert.equal(list.at(-1).mended.verdict, 'improvement');
  assert.equal(list.filter(isOpen).length, 2);
  assert.ok(list.findIndex((c) => c.verdict === 'improvement') > 1);
});

test('what fails comes before what is newer', () => {
  const index = structuredClone(small.index);
  index.latest[0].verdict[numberOf(TIME)] = 'fail';
  const [first] = new History(index).changesOf(0);
  assert.equal(history.figures.name[first.figure], TIME);
});

test('a series keeps its key whatever its number', () => {
  const index = structuredClone(small.index);
  index.series.reverse();
  index.latest.reverse();
  assert.deepEqual(
    new Set(new History(index).series.map((s) => s.key)),
    new Set(history.series.map((s) => s.key))
  );
  assert.notEqual(history.series[0].key, history.series[1].key);
});

test('states count verdicts, and name the figure that lost most digits', () => {
  const rows = statesOf(history, 0);
  const of = (name) => rows.find((r) => r.name === name);
  assert.deepEqual(of('attached_a').tally, {pass: 2, known_failure: 1, fail: 0});
  assert.equal(history.figures.name[of('invariant').worst.figure], ERROR);
  assert.ok(Math.abs(of('invariant').worst.digits - 0.5) < 1e-3);
  assert.equal(of('quaternion').worst, null);
  assert.equal(statesOf(history, 1).find((r) => r.name === 'quaternion').tally.fail, 1);
  assert.equal(rows.at(-1).name, '');
});

test('times have one value a run; other values hold until they change', () => {
  const time = trend(TIME);
  assert.equal(time.value.length, 60);
  const error = trend(ERROR);
  assert.ok(Math.abs(error.value[49] / 1e-5 - 1) < 1e-12);
  assert.ok(Math.abs(error.value[50] / 10 ** -4.5 - 1) < 1e-12 && error.value[59] === error.value[50]);
  assert.deepEqual(steps(error), [0, 50]);
  assert.ok(Math.abs(error.limit[59] / 1e-4 - 1) < 1e-12);
  assert.ok(trendOf(undefined, [1, 2], true).value.every((v) => v === null));
  assert.deepEqual(trendOf({series: 0, r: [2], v: [5]}, [1, 2, 3], true).value, [null, 5, 5]);
  assert.deepEqual(trendOf({series: 0, r: [2], v: [5]}, [1, 2, 3], false).value, [null, 5, null]);
  assert.deepEqual(trendOf({series: 0, r: [1, 3], v: [5, null]}, [1, 2, 3], true).value, [5, 5, null]);
});

test('thinning loses no extreme', () => {
  const random = randomOf(3);
  const values = Array.from({length: 9973}, () => random());
  values[5000] = 40;
  values[7001] = -3;
  const keepsAll = (thin) => {
    const kept = new Set(thin(values, 800));
    const size = values.length / 800;
    return Array.from({length: 800}).every((_, c) => {
      const part = [...values.keys()].slice(Math.ceil(c * size), Math.ceil((c + 1) * size));
      const by = (pick) => part.find((i) => values[i] === pick(...part.map((n) => values[n])));
      return kept.has(by(Math.min)) && kept.has(by(Math.max));
    });
  };
  assert.ok(keepsAll(extremes));
  const everyFew = (v, n) => [...v.keys()].filter((i) => i % Math.ceil(v.length / n) === 0);
  assert.ok(!keepsAll(everyFew)); // the check can fail
  assert.ok(extremes(values, 800).length <= 3200);
  const rising = extremes(values, 800);
  assert.ok(rising.every((n, i) => !i || n > rising[i - 1]));
  assert.deepEqual(extremes([1, null, null, 2], 100), [0, -1, 3]);
  assert.deepEqual(extremes([], 100), []);
});

test('levels are the medians between changes, and find the seeded 10 %', () => {
  const time = trend(TIME);
  const changes = history.changesOf(0, (c) => history.figures.name[c.figure] === TIME);
  const [before, after] = levels(time, changes);
  assert.deepEqual([before.from, before.to, after.from, after.to], [0, 41, 42, 59]);
  assert.ok(Math.abs(after.value / before.value - 1.1) < 0.03, `${after.value / before.value}`);
  assert.deepEqual(levels({runs: [], value: []}, []), []);
  assert.deepEqual(medians([3, 1, 2, null], 1), [{n: 1.5, value: 2}]);
  assert.deepEqual(medians([null], 1), [{n: 0, value: null}]);
});

test('CSV quotes what needs it, one line a run', () => {
  const lines = csvOf(history, numberOf(TIME), trend(TIME)).split('\r\n');
  assert.equal(lines.length, 62);
  assert.equal(lines[0], 'figure,unit,commit,date,title,value,low,high,limit,verdict');
  assert.ok(lines.some((l) => l.includes('"Faster <b>tables</b>, ""twice"""')));
});

test('axes show every value, with ticks inside', () => {
  for (const [values, isLog] of [
    [[1, 2, 3], false],
    [[1e-16, 1e-3], true],
    [[5], false],
    [[0], false],
    [[5], true],
    [[30, 40], true],
    [[-1, 1], false]
  ]) {
    const {at, ticks} = scaleOf(values, 300, 10, isLog);
    const inside = (x) => at(x) >= 10 - 1e-9 && at(x) <= 300 + 1e-9;
    assert.ok(values.every(inside) && ticks.every(inside), `${values}`);
    assert.ok(ticks.length >= 1 && ticks.length <= 10, `${values}: ${ticks}`);
  }
  assert.ok(logFits([1e-16, 1e-3]) && !logFits([30, 40]) && !logFits([0, 1]));
  assert.ok(logCan([1]) && !logCan([0, 1]) && !logCan([]));
  assert.deepEqual(evenly(10, 4), [0, 3, 6, 9]);
  assert.deepEqual([evenly(1, 4), evenly(0, 4)], [[0], []]);
});

test('accuracy against speed takes the last value up to a run', () => {
  const t = (value) => ({value});
  const measured = [
    {formulation: 'a', time: t([5, null, 7]), error: t([1e-3, 1e-4, 1e-4])},
    {formulation: 'b', time: t([null, 2, 2]), error: t([0, 0, 0])}
  ];
  assert.deepEqual(pointsAt(measured, 0), [{formulation: 'a', ns: 5, error: 1e-3}]);
  assert.deepEqual(pointsAt(measured, 1)[0], {formulation: 'a', ns: 5, error: 1e-4});
  const {floor, hasZero, ns} = extents(measured);
  assert.ok(hasZero && Math.abs(floor - 1e-5) < 1e-18);
  assert.deepEqual(ns, [2, 7]);
});

test('labels of points do not overlap', () => {
  const random = randomOf(5);
  const points = Array.from({length: 40}, () => ({x: 300 * random(), y: 200 * random(), width: 60}));
  const frame = {left: 0, right: 300, top: 0, bottom: 200};
  const overlaps = (list) => {
    const boxes = list.flatMap((l, i) => (l ? [{...l, width: points[i].width}] : []));
    return boxes.some((a, i) =>
      boxes.some((b, k) => k > i && Math.abs(a.x - b.x) < 60 && Math.abs(a.y - b.y) < 14)
    );
  };
  const list = placed(points, frame);
  assert.ok(!overlaps(list) && list.some(Boolean));
  assert.ok(overlaps(points.map(({x, y}) => ({x: x + 8, y})))); // always to the right: the check can fail
});

test('an address brings back the figure, the series and the filters', () => {
  const place = new Place(history);
  place.read(
    place.hash({
      figure: `${HOSTILE}/linear/modelling_error`,
      series: history.series[1].key,
      show: 'all',
      kind: 'linear',
      run: 'abc'
    })
  );
  const again = new Place(history);
  assert.deepEqual(again.read(place.hash()), []);
  assert.equal(history.figures.name[again.figure], `${HOSTILE}/linear/modelling_error`);
  assert.deepEqual([again.series.number, again.show, again.kind, again.run], [1, 'all', 'linear', 'abc']);
  assert.deepEqual(again.read('#figure=no%20such&series=none'), [
    'a machine or build “none”',
    'a figure “no such”'
  ]);
  assert.equal(new Place(history).hash().includes('<'), false);
});

test('accuracy against speed as CSV: a line a run and formulation', () => {
  const measured = [{formulation: 'invariant', time: trend(TIME), error: trend(ERROR)}];
  const lines = pointsCsv(history, history.series[0].runs, measured).split('\r\n');
  assert.equal(lines.length, 62);
  assert.equal(lines[0], 'commit,date,formulation,ns,error');
  assert.ok(lines[60].includes(`,${measured[0].time.value[59]},${measured[0].error.value[59]}`));
});

test('least and largest repetitions may be those of the last runs alone', () => {
  const late = trendOf({series: 0, r: null, v: [5, 6, 7], l: [6.5], h: [8]}, [1, 2, 3], false);
  assert.deepEqual(
    [late.low, late.high],
    [
      [null, null, 6.5],
      [null, null, 8]
    ]
  );
  const {s} = small.blocks[numberOf(TIME)];
  assert.equal(blockFault(history)({s: [{...s[0], l: s[0].l.slice(-5)}]}), '');
  assert.match(blockFault(history)({s: [{...s[0], l: [...s[0].l, 1]}]}), /61 values for 60 runs/);
});
