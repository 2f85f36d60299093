// Time and memory of a full nonlinear solve against its size.
import {AT_DECADES, Chart, isNarrow} from '../../chart.js';
import {h} from '../../dom.js';
import {seconds, short} from '../../format.js';
import {bodyLabel, elementLook} from '../../data/solids_data.js';
import {Absent} from '../../parts.js';

const PANELS = [
  {field: 'seconds', title: 'wall time of one solve, s'},
  {field: 'megabytes', title: 'peak memory, MB'}
];

function spec(rows, {field, title}) {
  const keys = [...new Set(rows.map((r) => r.series))];
  const lines = {gridOpacity: AT_DECADES, tickOpacity: AT_DECADES};
  const x = {
    field: 'unknowns',
    type: 'quantitative',
    scale: {type: 'log', nice: false, padding: 16},
    title: 'unknowns',
    axis: {format: '~s', tickCount: 4, ...lines}
  };
  const y = {
    field,
    type: 'quantitative',
    scale: {type: 'log', nice: false, padding: 16},
    title,
    axis: {format: '~r', tickCount: 4, ...lines}
  };
  const color = {
    field: 'series',
    type: 'nominal',
    legend: null,
    scale: {domain: keys, range: keys.map((k) => elementLook(rows.find((r) => r.series === k).element).color)}
  };
  const tooltip = [
    {field: 'series', title: 'body'},
    {field: 'unknowns', format: ','},
    {field: 'iterations', title: 'Newton steps'},
    {field: 'seconds', format: '.3g', title: 'wall time, s'},
    {field: 'megabytes', format: '.4g', title: 'peak memory, MB'}
  ];
  return {
    height: isNarrow() ? 220 : 240,
    data: {values: rows},
    layer: [
      {mark: {type: 'line', strokeWidth: 1.8}, encoding: {x, y, color}},
      {mark: {type: 'point', filled: true, size: 70, opacity: 1}, encoding: {x, y, color, tooltip}}
    ]
  };
}

/** @param {ReturnType<typeof import('../../data/solids_data.js').solidsOf>} solids */
export function newtonFigure(solids) {
  if (!solids.newton.length)
    return new Absent('the results hold no cost of a nonlinear solve (solids.newton)');
  const charts = PANELS.map(
    (p) =>
      new Chart(`solids-newton-${p.field}`, `${p.title} against the number of unknowns, both logarithmic.`)
  );
  const rows = solids.newton.map((r) => ({...r, series: `${bodyLabel(r.body)}, ${r.element}`}));
  charts.forEach((chart, i) => chart.draw(spec(rows, PANELS[i])));
  const most = rows.reduce((a, b) => (b.unknowns > a.unknowns ? b : a));
  return h(
    'figure',
    {},
    h(
      'div',
      {class: 'panels two'},
      charts.map((c) => c.box)
    ),
    h(
      'figcaption',
      {},
      'Newton from the unloaded body; a factorization is kept while each of its steps gains a digit. ',
      `The largest, ${most.series}: ${most.unknowns.toLocaleString('en')} unknowns, ${most.iterations} Newton steps, `,
      `${seconds(most.seconds)}, ${short(most.megabytes, 4)} MB.`
    )
  );
}
