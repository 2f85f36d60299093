// Large rotation: the moment over the whole turn, with and without the unwrapped rotation vector
// (results.stability.range).
import {Chart, isNarrow} from '../../chart.js';
import {folded, h, isolate, swatch} from '../../dom.js';
import {isNumber, short} from '../../format.js';
import {look} from '../../palette.js';
import {Absent} from '../../parts.js';
import {colorOf, faded, hover, onHover} from './range_lines.js';
import {crossingTable, gimbalTable, tangentTable} from './range_tables.js';

const LARGEST = 12; // of the moment, rad: poles leave the picture there
const OUTSIDE = 5 * LARGEST; // browsers draw dashes of very long lines solid
const BREAK = 2.5; // a larger step between neighbours of opposite sign is a jump, not a slope
const UNWRAPPED = ', unwrapped';

/** Points of one curve; a jump begins a new segment. */
function turnRows(curve, suffix) {
  let segment = 0;
  return curve.phi
    .map((phi, i) => {
      const [value, before] = [curve.moment[i], curve.moment[i - 1]];
      if (i > 0 && value * before < 0 && Math.abs(value - before) > BREAK) segment += 1;
      return {
        formulation: curve.formulation,
        series: curve.formulation + suffix,
        phi: phi / Math.PI,
        value,
        segment: `${curve.formulation}${suffix}/${segment}`
      };
    })
    .filter((r) => isNumber(r.value) && Math.abs(r.value) < OUTSIDE);
}

const dashOf = (n) => (n.endsWith(UNWRAPPED) ? [2, 3] : look(n).dash.length ? look(n).dash : [1, 0]);

function turnSpec(rows, only) {
  const names = [...new Set(rows.map((r) => r.series))];
  const plain = (n) => n.replace(UNWRAPPED, '');
  const x = {
    field: 'phi',
    type: 'quantitative',
    title: 'φ, turned about a generic axis',
    scale: {domain: [0, 3], nice: false},
    axis: {
      values: [0, 0.5, 1, 1.5, 2, 2.5, 3],
      labelExpr: "datum.value === 0 ? '0' : datum.value === 1 ? 'π' : datum.value + ' π'"
    }
  };
  const y = {
    field: 'value',
    type: 'quantitative',
    title: 'moment about the axis, rad of a linear spring',
    scale: {domain: [-8, LARGEST], nice: false}
  };
  const color = colorOf(names, 'series', plain);
  const strokeDash = {
    field: 'series',
    type: 'nominal',
    legend: null,
    scale: {domain: names, range: names.map(dashOf)}
  };
  const tooltip = [
    {field: 'series', title: 'formulation'},
    {field: 'phi', title: 'φ/π', format: '.6g'},
    {field: 'value', title: 'moment, rad', format: '.5g'}
  ];
  return {
    height: isNarrow() ? 340 : 440,
    data: {values: rows},
    layer: [
      {
        mark: {type: 'line', strokeWidth: 2, clip: true},
        encoding: {x, y, color, strokeDash, detail: {field: 'segment'}, ...faded('series', only)}
      },
      {...hover(), encoding: {x, y, color, ...onHover, tooltip}}
    ]
  };
}

function turnChart(range) {
  const chart = new Chart(
    'range-turns',
    'Moment about the axis over the relative rotation from 0 to 3 pi, one line per formulation; ' +
      'jumps break the lines.'
  );
  const rows = [
    ...range.curves.flatMap((c) => turnRows(c, '')),
    ...range.unwrapped.flatMap((c) => turnRows(c, UNWRAPPED))
  ];
  const names = [...new Set(rows.map((r) => r.series))];
  const draw = (only) => chart.draw(turnSpec(rows, only));
  const legend = isolate(
    'Isolate a formulation',
    names.map((n) => ({
      key: n,
      label: n,
      swatch: swatch({color: look(n.replace(UNWRAPPED, '')).color, dash: dashOf(n)})
    })),
    draw
  );
  draw(null);
  return [legend, chart.box];
}

/** Where the curve about the generic axis breaks, to the width of its points. */
function breaksOf(range, formulation) {
  const rows = turnRows(
    range.curves.find((c) => c.formulation === formulation),
    ''
  );
  const breaks = rows
    .filter((r, i) => i > 0 && r.segment !== rows[i - 1].segment)
    .map((r) => `${short(r.phi, 2)} π`);
  return [...new Set(breaks)].join(', ') || 'nowhere';
}

/** @param {import('../../data.js').Results} results */
export function turnsFigure(results) {
  const range = results.stability?.range;
  if (!range?.curves?.length) return new Absent('the results hold no large rotations (stability.range)');
  return h(
    'figure',
    {},
    turnChart(range),
    h(
      'figcaption',
      {},
      `Law of ${range.stiffness.join(', ')} N·m/rad. A pose alone tells the rotation vector up to π: laws on it `,
      'jump there, and no moment is left of a full turn. Dotted: the unwrapped vector, which ' +
        'remembers the path.'
    ),
    folded(
      'Across π/2, π, 3π/2 and 2π',
      crossingTable(range, (f) => breaksOf(range, f))
    ),
    folded('Tangents at large angles', tangentTable(range)),
    range.gimbal.length ? folded('Gimbal locks', gimbalTable(range)) : null
  );
}
