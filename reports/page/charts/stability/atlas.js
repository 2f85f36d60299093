// One small chart per way to fail, one row per formulation: the bound of its safe range for each tolerance.
import {AT_DECADES, Chart} from '../../chart.js';
import {TOLERANCES, failuresOf} from '../../data/atlas_data.js';
import {folded, h, plainTable, swatch} from '../../dom.js';
import {short} from '../../format.js';
import {Absent} from '../../parts.js';
import {HUE} from '../../palette.js';

const MARKS = {
  [1e-3]: {color: HUE.gold, shape: 'circle'},
  [1e-6]: {color: HUE.blue, shape: 'diamond'},
  [1e-12]: {color: HUE.magenta, shape: 'square'}
};
const ANY = {color: 'var(--ink)', shape: 'triangle-up'};
const labelOf = (tolerance) => TOLERANCES.find((t) => t.key === tolerance)?.label ?? 'any';

const bound = (limit, from) =>
  limit.all
    ? `all (${from ? 'from' : 'to'} ${short(limit.x)})`
    : limit.none
      ? 'nowhere'
      : `${from ? 'from' : 'to'} ${short(limit.x, 3)}`;

function rowsOf(failure) {
  return failure.rows.flatMap((r) =>
    r.limits.map((l) => ({
      formulation: r.formulation,
      x: l.x,
      tolerance: labelOf(l.tolerance),
      whole: Boolean(l.all),
      nowhere: Boolean(l.none),
      says: bound(l, failure.from),
      message: r.message ?? failure.message
    }))
  );
}

/** Decades where there are several, else plain numbers; all that was tried is on the axis. */
function axisOf(failure) {
  const xs = failure.rows.flatMap((r) => [...(r.tried ?? []), ...r.limits.map((l) => l.x)]);
  const domain = [Math.min(...xs), Math.max(...xs)];
  if (!failure.log || domain[1] < 100 * domain[0])
    return {scale: {zero: true, padding: 10}, axis: {tickCount: 6}};
  return {
    scale: {type: 'log', domain, nice: false, padding: 10},
    axis: {labelExpr: 'power10(datum.value)', tickCount: 6, gridOpacity: AT_DECADES, tickOpacity: AT_DECADES}
  };
}

function spec(failure) {
  const rows = rowsOf(failure);
  const names = failure.rows.map((r) => r.formulation);
  const labels = [...TOLERANCES.map((t) => t.label), 'any'];
  const marks = [...TOLERANCES.map((t) => MARKS[t.key]), ANY];
  const y = {
    field: 'formulation',
    type: 'nominal',
    sort: names,
    title: null,
    axis: {grid: true, ticks: false, domain: false, labelLimit: 130}
  };
  const x = {field: 'x', type: 'quantitative', title: failure.axis, ...axisOf(failure)};
  const color = {
    field: 'tolerance',
    type: 'nominal',
    legend: null,
    scale: {domain: labels, range: marks.map((m) => m.color)}
  };
  const shape = {
    field: 'tolerance',
    type: 'nominal',
    legend: null,
    scale: {domain: labels, range: marks.map((m) => m.shape)}
  };
  const opacity = {
    condition: [
      {test: 'datum.nowhere', value: 0.25},
      {test: 'datum.whole', value: 0.45}
    ],
    value: 1
  };
  const tooltip = [
    {field: 'formulation'},
    {field: 'tolerance', title: 'within'},
    {field: 'says', title: 'safe'},
    {field: 'message', title: 'a user is told'}
  ];
  return {
    height: {step: 17},
    data: {values: rows},
    mark: {type: 'point', size: 55, strokeWidth: 1.6},
    encoding: {x, y, color, shape, opacity, tooltip}
  };
}

function tableOf(failure) {
  const says = (row) =>
    row.limits
      .map((l) =>
        l.tolerance ? `${labelOf(l.tolerance)}: ${bound(l, failure.from)}` : bound(l, failure.from)
      )
      .join('; ');
  return plainTable(
    failure.title,
    [{text: 'formulation'}, {text: 'safe'}, {text: 'a user is told'}],
    failure.rows.map((r) => [r.formulation, says(r), r.message ?? failure.message])
  );
}

function panel(failure) {
  const chart = new Chart(
    `atlas-${failure.key}`,
    `${failure.title}: bound of the safe range of each formulation for errors of 1e-3, 1e-6 and 1e-12.`
  );
  chart.draw(spec(failure));
  return h(
    'div',
    {class: 'panel'},
    h('h4', {}, failure.title),
    chart.box,
    h('p', {class: 'note'}, `Beyond: ${failure.first}.`),
    folded('Numbers and messages', tableOf(failure))
  );
}

/** @param {import('../../data.js').Results} results */
export function atlasFigure(results) {
  const failures = failuresOf(results);
  if (!failures.length) return new Absent('the results hold no failures (stability)');
  const keys = [...TOLERANCES.map((t) => [t.label, MARKS[t.key]]), ['whatever the tolerance', ANY]].map(
    ([text, mark]) => h('span', {class: 'key'}, swatch(mark), text)
  );
  return h(
    'figure',
    {},
    h('p', {class: 'keys'}, 'Safe within', keys),
    h('div', {class: 'panels'}, failures.map(panel)),
    h(
      'figcaption',
      {},
      'Each mark is the bound of what was measured to stay within the tolerance; pale at an ' +
        'edge: all that was tried is safe, paler: none is.'
    )
  );
}
