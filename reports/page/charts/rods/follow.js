// Error of one joint against the rod over the rod's rotation (results.rods.skew), a line per formulation.
import {Chart} from '../../chart.js';
import {followRows} from '../../data/rods_data.js';
import {h} from '../../dom.js';
import {Absent} from '../../parts.js';
import {linesSpec, logAxis, RowsPanel} from '../log_lines.js';

const FLOOR = 1e-6; // of the axis: what is better is as good for a chart
const kCeiling = 5; // beyond it a joint is simply elsewhere

function spec(rows, only) {
  const x = {
    field: 'degrees',
    title: 'rotation of the rod',
    axis: {tickCount: 9, labelExpr: "datum.label + '°'"}
  };
  const y = {
    field: 'shown',
    title: 'error of the joint’s rotation',
    scale: {type: 'log', domain: [FLOOR, kCeiling], nice: false},
    axis: logAxis(9)
  };
  const tooltip = [
    {field: 'formulation'},
    {field: 'degrees', format: '.1f'},
    {field: 'moment', title: 'moment, N·m'},
    {field: 'error', format: '.3g'}
  ];
  const shown = rows.map((r) => ({...r, shown: Math.min(Math.max(r.error, FLOOR), kCeiling)}));
  const lines = linesSpec(shown, x, y, only, tooltip, () => []);
  const limits = {
    data: {values: [{limit: 0.01}, {limit: 0.05}]},
    mark: {type: 'rule', color: 'var(--ink)', strokeDash: [3, 3]},
    encoding: {y: {...y, type: 'quantitative', field: 'limit'}}
  };
  return {...lines, layer: [limits, ...lines.layer]};
}

/** @param {import('../../data.js').Results} results */
export function followFigure(results) {
  const rows = followRows(results.rods);
  if (!rows.length) return new Absent('the results hold no joints in place of a rod (rods.skew)');
  const chart = new Chart(
    'rod-follow',
    'Error of one joint against a slender rod over the rotation of the rod, one line per formulation, ' +
      'the error on a logarithmic axis.'
  );
  const panel = new RowsPanel(chart, rows, spec, () => '');
  panel.show(rows);
  return h(
    'figure',
    {},
    panel.legend,
    chart.box,
    h(
      'figcaption',
      {},
      'The same joints: |θ of the joint − θ of the rod| over |θ of the rod|. Dashed: 1 % and 5 %. A line ends where ' +
        'its joint has no equilibrium that the solver reaches.'
    )
  );
}
