// How far one joint stays with a slender rod under a fixed skew moment (results.rods.skew), as bars in degrees.
import {Chart, isNarrow} from '../../chart.js';
import {reachRows} from '../../data/rods_data.js';
import {h} from '../../dom.js';
import {look} from '../../palette.js';
import {Absent} from '../../parts.js';

function spec(rows) {
  const names = [...new Set(rows.map((r) => r.formulation))];
  const y = {
    field: 'formulation',
    type: 'nominal',
    sort: names,
    title: null,
    axis: {labelColor: 'var(--ink)', labelFontSize: 13, ticks: false, domain: false, labelLimit: 150}
  };
  const x = {
    field: 'degrees',
    type: 'quantitative',
    stack: null,
    axis: {tickCount: 8, labelExpr: "datum.label + '°'"}
  };
  const color = {
    field: 'formulation',
    type: 'nominal',
    legend: null,
    scale: {domain: names, range: names.map((n) => look(n).color)}
  };
  const tooltip = [
    {field: 'formulation'},
    {field: 'tolerance', title: 'stays within'},
    {field: 'degrees', title: 'degrees of the rod', format: '.1f'},
    {field: 'moment', title: 'moment, N·m'}
  ];
  const bars = (tolerance, band, opacity) => ({
    transform: [{filter: `datum.tolerance === '${tolerance}'`}],
    mark: {type: 'bar', height: {band}, opacity},
    encoding: {x: {...x, title: 'rotation of the rod'}, y, color, tooltip}
  });
  return {
    height: {step: isNarrow() ? 20 : 22},
    data: {values: rows},
    layer: [bars('5 %', 0.72, 0.35), bars('1 %', 0.72, 1)]
  };
}

/** @param {import('../../data.js').Results} results */
export function reachFigure(results) {
  const rows = reachRows(results.rods);
  if (!rows.length) return new Absent('the results hold no joints in place of a rod (rods.skew)');
  const chart = new Chart(
    'rod-reach',
    'Rotation up to which each formulation stays within 1 % and 5 % of a slender rod, as bars in degrees.'
  );
  chart.draw(spec(rows));
  return h(
    'figure',
    {},
    chart.box,
    h(
      'figcaption',
      {},
      'One joint in place of a slender rod that has the compliances of C3, under a moment of fixed direction, ' +
        'skew to its axis by a hundredth: within 1 % of the rod’s rotation (full colour), within 5 % (pale). ' +
        'The rod itself has no critical moment: a fixed end moment is the same vector in every section, so that ' +
        'its shape is an initial value problem with one solution. The poles of C3 belong to the single joint.'
    )
  );
}
