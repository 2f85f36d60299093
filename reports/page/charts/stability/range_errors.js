// Digits lost to small rotations, stiffness ratios, drifted matrices and distances
// (results.stability.range.conditioning), and what is refused.
import {AT_DECADES, Chart, isNarrow} from '../../chart.js';
import {folded, h, isolate, plainTable, select, swatch} from '../../dom.js';
import {full, isNumber} from '../../format.js';
import {look} from '../../palette.js';
import {Absent} from '../../parts.js';
import {colorOf, faded, hover, onHover} from './range_lines.js';

const FLOOR = 2 ** -54;

const SERIES = [
  {key: 'phi/double', label: 'rotation, double'},
  {key: 'phi/kernel', label: 'rotation, kernel'},
  {key: 'phi/compensated', label: 'rotation, compensated kernel'},
  {key: 'phi/float', label: 'rotation, kernel in float'},
  {key: 'ratio_diagonal/loads', label: 'stiffness ratio, loads'},
  {key: 'ratio_rotated/loads', label: 'stiffness ratio, turned law, loads'},
  {key: 'ratio_diagonal/solve', label: 'stiffness ratio, equilibrium'},
  {key: 'ratio_rotated/solve', label: 'stiffness ratio, turned law, equilibrium'},
  {key: 'drift/angular', label: 'drifted matrix'},
  {key: 'drift_quaternion/angular', label: 'drifted matrix, by way of a quaternion'},
  {key: 'drift_polar/angular', label: 'drifted matrix, one polar step'},
  {key: 'distance/linear', label: 'distance from the origin, linear'},
  {key: 'distance/linear_angular', label: 'distance from the origin, linear/angular'},
  {key: 'offset/linear', label: 'offset of the joint, linear'},
  {key: 'offset/linear_angular', label: 'offset of the joint, linear/angular'}
];
const X_TITLES = {
  phi: 'φ, rad',
  ratio: 'largest over smallest stiffness',
  drift: 'drift |R − nearest rotation|',
  distance: 'distance, m',
  offset: 'offset, m'
};
const xTitle = (what) => X_TITLES[what.split(/[_/]/)[0]];

const dashOf = (n) => (look(n).dash.length ? look(n).dash : [1, 0]);

function errorRows(range, what) {
  return range.conditioning
    .filter((s) => s.what === what)
    .flatMap((s) => s.x.map((x, i) => ({formulation: s.formulation, x, error: s.error[i]})))
    .filter((r) => isNumber(r.error) && r.x > 0)
    .map((r) => ({...r, shown: full(r.error), error: Math.max(r.error, FLOOR)}));
}

function errorSpec(rows, what, only) {
  const names = [...new Set(rows.map((r) => r.formulation))];
  const log = {
    labelExpr: 'power10(datum.value)',
    tickCount: 9,
    gridOpacity: AT_DECADES,
    tickOpacity: AT_DECADES
  };
  const x = {
    field: 'x',
    type: 'quantitative',
    title: xTitle(what),
    scale: {type: 'log', nice: false, padding: 8},
    axis: log
  };
  const y = {
    field: 'error',
    type: 'quantitative',
    title: 'error against 50 digits, relative',
    scale: {type: 'log', padding: 8},
    axis: log
  };
  const color = colorOf(names, 'formulation', (n) => n);
  const strokeDash = {
    field: 'formulation',
    type: 'nominal',
    legend: null,
    scale: {domain: names, range: names.map(dashOf)}
  };
  return {
    height: isNarrow() ? 320 : 400,
    data: {values: rows},
    layer: [
      {
        mark: {type: 'line', strokeWidth: 2},
        encoding: {x, y, color, strokeDash, ...faded('formulation', only)}
      },
      {
        ...hover(),
        encoding: {
          x,
          y,
          color,
          ...onHover,
          tooltip: [
            {field: 'formulation'},
            {field: 'x', title: xTitle(what), format: '.3g'},
            {field: 'shown', title: 'error'}
          ]
        }
      }
    ]
  };
}

function errorChart(range) {
  const chart = new Chart(
    'range-errors',
    'Relative error against 50 digits over rotation, stiffness ratio, drift or distance, one ' +
      'line per formulation, logarithmic.'
  );
  const offered = SERIES.filter((s) => errorRows(range, s.key).length);
  const state = {what: offered[0].key, only: null};
  const draw = () => chart.draw(errorSpec(errorRows(range, state.what), state.what, state.only));
  const names = [...new Set(range.conditioning.map((s) => s.formulation))];
  const legend = isolate(
    'Isolate a formulation',
    names.map((n) => ({key: n, label: n, swatch: swatch({color: look(n).color, dash: dashOf(n)})})),
    (only) => {
      state.only = only;
      draw();
    }
  );
  const control = select('Error over', offered, state.what, (what) => {
    state.what = what;
    draw();
  });
  draw();
  return [control, legend, chart.box];
}

function refusalTable(range) {
  return plainTable(
    'What is refused',
    [{text: 'input'}, {text: 'by'}, {text: 'message'}],
    range.refusals.map((r) => [r.what, r.who, r.says || 'accepted']),
    'What is refused, and how'
  );
}

/** @param {import('../../data.js').Results} results */
export function digitsLostFigure(results) {
  const range = results.stability?.range;
  if (!range?.conditioning?.length)
    return new Absent('the results hold no error series (stability.range.conditioning)');
  return h(
    'figure',
    {},
    errorChart(range),
    h(
      'figcaption',
      {},
      'Loads or equilibria in double (or float) against the same input at 50 digits. A drifted ' +
        'matrix against the ',
      `nearest rotation: reading a quaternion off it takes ${range.projection.quaternion} flops, a polar step `,
      `${range.projection.polar}.`
    ),
    folded('What is refused', refusalTable(range))
  );
}
