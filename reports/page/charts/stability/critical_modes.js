// The lowest eigenvalue of small motions on the way to the critical moment (results.stability.kind.modes).
import {Chart, isNarrow} from '../../chart.js';
import {choice, h, isolate, swatch} from '../../dom.js';
import {look} from '../../palette.js';
import {Absent} from '../../parts.js';
import {momentLabel as labelOf} from './moments.js';

const LOADS = [0, 2000]; // N m
const EIGENVALUES = [-200, 800]; // 1/s²
/** Lines leave the picture in their own direction and end not far outside: a mark of millions of pixels is more
 * than some tools survive.
 */
const kOutside = 3;
/** @param {number} x @param {number[]} domain */
const within = (x, [low, high]) =>
  Math.min(Math.max(x, low - kOutside * (high - low)), high + kOutside * (high - low));

/** Lowest eigenvalue over the load: dotted where two modes have met and grow. */
function modesSpec(kind, moment, only) {
  const rows = kind.modes
    .filter((m) => m.moment === moment)
    .flatMap((m) =>
      m.points.map((p, order) => {
        const [load, angle, lowest, imaginary, growth] = p;
        return {
          formulation: m.formulation,
          order,
          load,
          angle,
          lowest,
          shown: within(lowest, EIGENVALUES),
          growth,
          complex: imaginary > 1e-6 * Math.abs(lowest)
        };
      })
    )
    .filter((row) => row.load < kOutside * LOADS[1]);
  const names = [...new Set(rows.map((r) => r.formulation))];
  const faded = only
    ? {opacity: {condition: {test: `datum.formulation === ${JSON.stringify(only)}`, value: 1}, value: 0.1}}
    : {};
  const x = {
    field: 'load',
    type: 'quantitative',
    title: 'moment about axis 1, N·m',
    scale: {domain: LOADS, nice: false},
    axis: {tickCount: 5}
  };
  const y = {
    field: 'shown',
    type: 'quantitative',
    title: 'lowest eigenvalue μ, 1/s²',
    scale: {domain: EIGENVALUES, nice: false}
  };
  const color = {
    field: 'formulation',
    type: 'nominal',
    legend: null,
    scale: {domain: names, range: names.map((n) => look(n).color)}
  };
  const strokeDash = {
    field: 'formulation',
    type: 'nominal',
    legend: null,
    scale: {domain: names, range: names.map((n) => (look(n).dash.length ? look(n).dash : [1, 0]))}
  };
  const tooltip = [
    {field: 'formulation'},
    {field: 'load', title: 'moment, N·m'},
    {field: 'angle', title: 'rotation, rad'},
    {field: 'lowest', title: 'lowest real part, 1/s²'},
    {field: 'growth', title: 'growth, 1/s'}
  ];
  return {
    height: isNarrow() ? 300 : 380,
    data: {values: rows},
    layer: [
      {
        data: {values: [{zero: 0}]},
        mark: {type: 'rule', color: 'var(--ink)'},
        encoding: {y: {field: 'zero', type: 'quantitative'}}
      },
      {
        mark: {type: 'line', clip: true, strokeWidth: 2},
        encoding: {x, y, color, strokeDash, order: {field: 'order', type: 'quantitative'}, ...faded}
      },
      {
        transform: [{filter: 'datum.complex'}],
        mark: {type: 'point', clip: true, filled: false, size: 35},
        encoding: {x, y, color, tooltip, ...faded}
      },
      {
        transform: [{filter: '!datum.complex'}],
        mark: {type: 'point', clip: true, filled: true, size: 40, opacity: 0},
        encoding: {x, y, tooltip}
      }
    ]
  };
}

/** @param {import('../../data.js').Results} results */
export function criticalModesFigure(results) {
  const kind = results.stability?.kind;
  if (!kind?.modes?.length) return new Absent('the results hold no modes (stability.kind.modes)');
  const chart = new Chart(
    'critical-modes',
    'Lowest eigenvalue of small motions over the moment about axis 1, one line for each formulation.'
  );
  const state = {moment: 'fixed', only: null};
  const show = () => chart.draw(modesSpec(kind, state.moment, state.only));
  const names = [...new Set(kind.modes.map((m) => m.formulation))];
  const moments = [...new Set(kind.modes.map((m) => m.moment))].map((key) => ({key, label: labelOf(key)}));
  show();
  return h(
    'figure',
    {},
    h(
      'div',
      {class: 'controls'},
      choice('moment', moments, state.moment, (m) => {
        state.moment = m;
        show();
      })
    ),
    isolate(
      'Isolate a formulation',
      names.map((n) => ({key: n, label: n, swatch: swatch(look(n))})),
      (only) => {
        state.only = only;
        show();
      }
    ),
    chart.box,
    h(
      'figcaption',
      {},
      'Small motions about axis 1 of the block of C3, three equal inertias of 1 kg·m²: below ' +
        'zero the equilibrium diverges, circles mark flutter. Cut off at 2000 N·m.'
    )
  );
}
