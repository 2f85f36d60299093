// The tangent by method: time, and error over phi up to pi, where differences fail.
import {KINDS} from '../../data/accuracy_data.js';
import {choice, h, plainTable, select} from '../../dom.js';
import {isNumber, nanoseconds, short} from '../../format.js';
import {methodLabel, nearPi, present, ratio, usable} from '../../data/speed_data.js';
import {Absent} from '../../parts.js';
import {SeriesPanels} from '../series_panels.js';
import {HUE} from '../../palette.js';

const LOOKS = {
  analytic: {color: 'var(--ink)', dash: [1, 0]},
  dual: {color: HUE.blue, dash: [7, 3]},
  autodiff: {color: HUE.sky, dash: [2, 3]},
  ceres_jet: {color: HUE.green, dash: [9, 3, 2, 3]},
  complex_step: {color: HUE.magenta, dash: [4, 2]},
  forward: {color: HUE.vermilion, dash: [1, 0]},
  central: {color: HUE.gold, dash: [1, 0]}
};
const OTHER = {color: 'var(--muted)', dash: [4, 2]};
const kWhat = 'residual_tangent';
const kOwn = 'kernel';
const kFirst = 'invariant';

const isCandidate = (t) =>
  t.what === kWhat &&
  t.variant === '' &&
  t.precision === 'double' &&
  t.implementation !== 'batch' &&
  usable(t);
const methodOf = (t) => t.method || 'analytic';

/** One series per method and implementation; an unnamed method is analytic and counts for kernels only.
 * @param {import('../../data.js').Results} results
 */
function seriesOf(results, {formulation, kind}) {
  const timings = results.timings.filter(
    (t) =>
      isCandidate(t) &&
      t.formulation === formulation &&
      t.kind === kind &&
      (t.method || t.implementation === kOwn)
  );
  const byKey = new Map(timings.map((t) => [`${methodOf(t)} ${t.implementation}`, t]));
  const shared = (t) => [...byKey.values()].filter((o) => methodOf(o) === methodOf(t)).length > 1;
  return [...byKey.entries()]
    .map(([key, timing]) => ({
      key,
      timing,
      method: methodOf(timing),
      label: `${methodLabel(methodOf(timing))}${shared(timing) ? `, ${timing.implementation}` : ''}`
    }))
    .sort((a, b) => a.timing.ns - b.timing.ns);
}

/** The analytic tangent of the reference stands beside the kernel's. */
const lookOf = ({method, timing}) =>
  method === 'analytic' && timing.implementation !== kOwn
    ? {color: HUE.steel, dash: [4, 2]}
    : (LOOKS[method] ?? OTHER);
const looksOf = (series) => Object.fromEntries(series.map((s) => [s.key, lookOf(s)]));

/** Worst error of the ranges that are, or are not, next to pi. */
function worst(timing, atPi) {
  const errors = timing.errors.filter((e) => nearPi(e) === atPi && isNumber(e.error)).map((e) => e.error);
  return errors.length ? short(Math.max(...errors)) : '–';
}

function tableOf(series) {
  const analytic = series.filter((s) => s.method === 'analytic').map((s) => s.timing);
  const base = (t) => (analytic.find((a) => a.implementation === t.implementation) ?? analytic[0])?.ns;
  const columns = [
    {text: 'method'},
    {text: 'ns', number: true},
    {text: 'times analytic', number: true},
    {text: 'worst error', number: true},
    {text: 'away from π', number: true},
    {text: 'next to π', number: true}
  ];
  return plainTable(
    'Tangent by method',
    columns,
    series.map(({label, timing: t}) => [
      label,
      nanoseconds(t.ns),
      base(t) ? ratio(t.ns / base(t)) : '–',
      short(t.error),
      worst(t, false),
      worst(t, true)
    ])
  );
}

function controls(candidates, state, changed) {
  const formulations = present(
    candidates.map((t) => t.formulation),
    [kFirst]
  );
  const kinds = KINDS.filter((k) => candidates.some((t) => t.kind === k.key));
  Object.assign(state, {
    formulation: formulations[0],
    kind: candidates.find((t) => t.formulation === formulations[0]).kind
  });
  const set = (key) => (value) => {
    state[key] = value;
    changed();
  };
  const joint =
    formulations.length > 1
      ? select(
          'Joint',
          formulations.map((key) => ({key, label: key})),
          state.formulation,
          set('formulation')
        )
      : h('code', {}, state.formulation);
  return h('div', {class: 'controls'}, joint, choice('Kind', kinds, state.kind, set('kind')));
}

/** @param {import('../../data.js').Results} results */
export function tangentFigure(results) {
  const candidates = results.timings.filter((t) => isCandidate(t) && t.method && t.method !== 'analytic');
  if (!candidates.length)
    return new Absent('the results hold no tangent by another method than the analytic one');
  const panels = new SeriesPanels({
    id: 'tangent',
    noun: 'method',
    looksOf,
    tableOf,
    over: 'ranges',
    log: true,
    title: 'with tangent, ns'
  });
  const box = h('div', {class: 'panels two'}, panels.error.box, h('div', {}, panels.time.box, panels.table));
  /** @type {any} */
  const state = {};
  const draw = () => panels.show(seriesOf(results, state));
  const choices = controls(candidates, state, draw);
  draw();
  return h(
    'figure',
    {},
    choices,
    panels.legend,
    box,
    h(
      'figcaption',
      {},
      'Worst error of the poses of each range of φ, which is named by its lower end and narrows ' +
        'towards π. A difference whose step crosses π takes two branches of the logarithm. Times ' +
        'analytic: of the same implementation.'
    )
  );
}
