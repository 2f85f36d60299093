// Net work round closed loops of poses over their amplitude (results.stability.energy.loops).
import {Chart} from '../../chart.js';
import {kindLabel} from '../../data/accuracy_data.js';
import {choice, h, plainTable} from '../../dom.js';
import {isNumber, short} from '../../format.js';
import {Absent} from '../../parts.js';
import {linesSpec, logChannel, namesOf, RowsPanel} from '../log_lines.js';

const FLOOR = 1e-18; // of the axis: an exact 0 has no place on it

function loopsSpec(loops, only) {
  const rows = loops.flatMap((l) =>
    l.points
      .filter((p) => isNumber(p.relative))
      .map((p) => ({
        formulation: l.formulation,
        amplitude: p.amplitude,
        relative: p.relative,
        shown: Math.max(p.relative, FLOOR),
        slope: isNumber(l.slope) ? short(l.slope, 3) : 'no net work'
      }))
  );
  const x = {
    field: 'amplitude',
    title: 'amplitude of the loop',
    scale: {type: 'log', nice: false, padding: 12},
    axis: {values: [0.0125, 0.025, 0.05, 0.1, 0.2, 0.4, 0.8], format: '~r'}
  };
  const y = logChannel('shown', 'net work over turnover');
  const tooltip = [
    {field: 'formulation'},
    {field: 'amplitude'},
    {field: 'relative', title: 'net work over turnover', format: '.3g'},
    {field: 'slope', title: 'net work ~ amplitude to the'}
  ];
  return linesSpec(rows, x, y, only, tooltip, (encoding) => [
    {mark: {type: 'point', filled: true, size: 22}, encoding}
  ]);
}

function slopeTable(loops) {
  const kinds = [...new Set(loops.map((l) => l.kind))];
  const cell = (formulation, kind) => {
    const l = loops.find((o) => o.formulation === formulation && o.kind === kind);
    return isNumber(l?.slope) ? short(l.slope, 4) : 'none';
  };
  return plainTable(
    'Order of the loop work',
    [{text: 'formulation'}, ...kinds.map((k) => ({text: kindLabel(k), number: true}))],
    namesOf(loops).map((f) => [f, ...kinds.map((k) => cell(f, k))]),
    'Net work ~ amplitude to this power, from 0.0125 to 0.025; none: no net work beyond rounding.'
  );
}

/** @param {import('../../data.js').Results} results */
export function energyLoopsFigure(results) {
  const energy = results.stability?.energy;
  if (!energy?.loops?.length)
    return new Absent('the results hold no loops of poses (stability.energy.loops)');
  const chart = new Chart(
    'energy-loops',
    'Net work round a closed loop over the turnover against the amplitude of the loop, one line ' +
      'per formulation, both axes logarithmic.'
  );
  const panel = new RowsPanel(chart, energy.loops, loopsSpec, () => slopeTable(energy.loops));
  const kinds = [...new Set(energy.loops.map((l) => l.kind))];
  const of = (kind) => energy.loops.filter((l) => l.kind === kind);
  panel.show(of(kinds[0]));
  return h(
    'figure',
    {},
    choice(
      'Kind',
      kinds.map((k) => ({key: k, label: kindLabel(k)})),
      kinds[0],
      (key) => panel.show(of(key))
    ),
    panel.legend,
    chart.box,
    h(
      'figcaption',
      {},
      'A generic loop of poses, loads in double. A conservative joint shows rounding alone, and ' +
        'at the widest loops what the quadrature leaves: there they pass the singular angle of ' +
        'some measures. The orders are held at 50 digits by loop_order.'
    ),
    panel.table
  );
}
