// Large rotation and conditioning: the moment over the whole turn, and the digits lost to what.
// Reads results.stability.range.
import {AT_DECADES, Chart, isNarrow} from '../chart.js';
import {h, isolate, plainTable, select, swatch} from '../dom.js';
import {full, isNumber, short} from '../format.js';
import {look} from '../palette.js';

const FADED = 0.1;
const LARGEST = 12; // of the moment, rad: poles leave the picture there
const OUTSIDE = 5 * LARGEST; // browsers draw dashes of very long lines solid
const BREAK = 2.5; // a larger step between neighbours of opposite sign is a jump, not a slope
const FLOOR = 2 ** -54;
const UNWRAPPED = ', unwrapped';

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

function colorOf(names, field, nameOf) {
  return {
    field,
    type: 'nominal',
    legend: null,
    scale: {domain: names, range: names.map((n) => look(nameOf(n)).color)}
  };
}

const dashOf = (n) => (n.endsWith(UNWRAPPED) ? [2, 3] : look(n).dash.length ? look(n).dash : [1, 0]);
const faded = (field, only) =>
  only
    ? {opacity: {condition: {test: `datum.${field} === ${JSON.stringify(only)}`, value: 1}, value: FADED}}
    : {};
const hover = () => ({
  params: [{name: 'near', select: {type: 'point', on: 'pointerover', nearest: true, clear: 'pointerout'}}],
  mark: {type: 'point', filled: true, size: 45, clip: true}
});
const onHover = {opacity: {condition: {param: 'near', empty: false, value: 1}, value: 0}};

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
    'Moment about the axis over the relative rotation from 0 to 3 pi, one line per formulation; jumps break the lines.'
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
    'Relative error against 50 digits over rotation, stiffness ratio, drift or distance, one line per formulation, logarithmic.'
  );
  const offered = SERIES.filter((s) => errorRows(range, s.key).length);
  const state = {what: offered[0]?.key, only: null};
  const draw = () => chart.draw(errorSpec(errorRows(range, state.what), state.what, state.only));
  if (!offered.length) {
    chart.empty('no error series in the results (stability.range.conditioning).');
    return [chart.box];
  }
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

function crossingText(c) {
  if (!c) return '–';
  if (c.behaviour === 'jump') return `jumps by ${short(c.jump, 3)} |K|φ`;
  if (c.behaviour === 'pole') return `pole of order ${short(c.order, 2)}`;
  return c.behaviour;
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

function crossingTable(range) {
  const angles = range.large_rotation[0]?.crossings.map((c) => c.angle) ?? [];
  const rows = range.large_rotation.map((l) => [
    l.formulation,
    l.axis,
    ...angles.map((a) => crossingText(l.crossings.find((c) => c.angle === a))),
    l.axis === 'generic' ? breaksOf(range, l.formulation) : ''
  ]);
  return plainTable(
    'Across large angles',
    [
      {text: 'formulation'},
      {text: 'axis'},
      ...angles.map((a) => ({text: `at ${a.replace('pi', 'π')}`})),
      {text: 'the line breaks at'}
    ],
    rows,
    'What the moment does across an angle, the pose alone being known: limits from both sides at 50 digits. K has the largest stiffness |K|.'
  );
}

function tangentTable(range) {
  const rows = range.large_rotation
    .filter((l) => l.axis === 'generic')
    .flatMap((l) =>
      l.points.map((p) => [
        l.formulation,
        p.angle.replace('pi', 'π'),
        short(p.moment, 3),
        short(p.smallest, 3),
        short(p.condition, 3)
      ])
    );
  return plainTable(
    'Tangent at large angles',
    [
      {text: 'formulation'},
      {text: 'φ'},
      {text: '|m|/(|K|φ)', number: true},
      {text: 'smallest singular value/|K|', number: true},
      {text: 'condition', number: true}
    ],
    rows,
    'Tangent about the generic axis; –: not finite'
  );
}

function gimbalTable(range) {
  const rows = range.gimbal.map((g) => [
    g.formulation,
    g.sequence,
    short(g.load_order, 3),
    short(g.tangent_order, 3),
    g.lost_1e6 ? short(g.lost_1e6) : 'never',
    g.lost_1e3 ? short(g.lost_1e3) : 'never'
  ]);
  return plainTable(
    'Gimbal locks',
    [
      {text: 'formulation'},
      {text: 'axes'},
      {text: 'loads grow as distance to the −', number: true},
      {text: 'tangent', number: true},
      {text: '10⁻⁶ lost at, rad', number: true},
      {text: '10⁻³ lost at, rad', number: true}
    ],
    rows,
    'Near a quarter turn about the middle one of three axes'
  );
}

function refusalTable(range) {
  return plainTable(
    'What is refused',
    [{text: 'input'}, {text: 'by'}, {text: 'message'}],
    range.refusals.map((r) => [r.what, r.who, r.says || 'accepted']),
    'What is refused, and how'
  );
}

const folded = (title, table) => h('details', {class: 'more'}, h('summary', {}, title), table);

export function rangeFigure(results) {
  const range = results.stability?.range;
  if (!range?.curves?.length) {
    const chart = new Chart('range-turns', 'Moment about the axis over the relative rotation.');
    chart.empty('no large rotations in the results (stability.range).');
    return h('figure', {id: 'range'}, h('h3', {}, 'Large rotation and conditioning'), chart.box);
  }
  return h(
    'figure',
    {id: 'range'},
    h('h3', {}, 'Beyond half a turn'),
    turnChart(range),
    h(
      'figcaption',
      {},
      `Law of ${range.stiffness.join(', ')} N·m/rad. A pose alone tells the rotation vector up to π: laws on it jump there, and no moment is left of a full turn. Dotted: the unwrapped vector, which remembers the path.`
    ),
    folded('Across π/2, π, 3π/2 and 2π', crossingTable(range)),
    folded('Tangents at large angles', tangentTable(range)),
    range.gimbal.length ? folded('Gimbal locks', gimbalTable(range)) : null,
    h('h3', {}, 'Digits lost, and to what'),
    errorChart(range),
    h(
      'figcaption',
      {},
      `Loads or equilibria in double (or float) against the same input at 50 digits. A drifted matrix against the nearest rotation: reading a quaternion off it takes ${range.projection.quaternion} flops, a polar step ${range.projection.polar}.`
    ),
    folded('What is refused', refusalTable(range))
  );
}
