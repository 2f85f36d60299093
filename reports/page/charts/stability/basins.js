// Plain Newton in one load step: iterations and outcome over load and direction, and what every start converges to.
import {Chart, isNarrow} from '../../chart.js';
import {choice, h, plainTable, select} from '../../dom.js';
import {isNumber, short} from '../../format.js';
import {Absent} from '../../parts.js';
import {HUE} from '../../palette.js';

const kEndFactor = 64; // of a cell's number: iterations + 64 times the index of its end
const FIRST = 'invariant';
const TANGENTS = {
  analytic: 'analytic',
  symmetrised: 'symmetrised',
  frozen: 'frozen',
  forward_difference: 'finite difference'
};
const tangentLabel = (key) => TANGENTS[key] ?? key;

/** Iterations in classes, lightest first; each up to and with `most`. */
const CLASSES = [
  [3, '1–3'],
  [4, '4'],
  [5, '5'],
  [6, '6'],
  [9, '7–9'],
  [19, '10–19'],
  [Infinity, '20 and more']
].map(([most, name], i) => ({
  most,
  label: `${name} iterations`,
  color: `color-mix(in oklab, ${HUE.blue} ${8 + 15 * i}%, var(--paper))`
}));
const END_COLORS = ['', HUE.vermilion, 'var(--muted)', 'var(--ink)', 'var(--fail)'];
const EQUILIBRIUM_COLORS = [HUE.blue, HUE.vermilion, HUE.green, HUE.magenta, HUE.moss, HUE.sky, HUE.indigo];
const NONE = {label: 'converges to none', color: 'var(--muted)'};

const classOf = (iterations) => (CLASSES.find((c) => iterations <= c.most) ?? CLASSES[0]).label;

/** One row per cell; the first step begins at 0 and the directions end at their axes. */
function loadRows(record, grid, map) {
  const turn = 90 / (grid.angles - 1);
  const step = grid.largest / grid.steps;
  return map.cells.map((code, n) => {
    const [i, k] = [Math.floor(n / grid.steps), n % grid.steps];
    const [end, iterations] = [Math.floor(code / kEndFactor), code % kEndFactor];
    return {
      from: (i - 0.5) * turn,
      to: (i + 0.5) * turn,
      low: (k + 0.5) * step,
      high: (k + 1.5) * step,
      angle: i * turn,
      magnitude: (k + 1) * step,
      iterations,
      end: record.ends[end],
      look: end === 0 ? classOf(iterations) : record.ends[end]
    };
  });
}

const axis = (field, title, domain) => ({
  field,
  type: 'quantitative',
  title,
  scale: {domain, nice: false},
  axis: {grid: false, tickCount: isNarrow() ? 4 : 7}
});

/** looks: {label, color} of all cells, in the order of the legend. */
function heatMap(rows, looks, {second: x2, ...x}, {second: y2, ...y}, tooltip) {
  const used = looks.filter((l) => rows.some((r) => r.look === l.label));
  const color = {
    field: 'look',
    type: 'nominal',
    scale: {domain: used.map((l) => l.label), range: used.map((l) => l.color)},
    legend: {
      title: null,
      orient: 'bottom',
      columns: isNarrow() ? 2 : 4,
      symbolType: 'square',
      symbolStrokeWidth: 0,
      labelColor: 'var(--ink)',
      labelFontSize: 12,
      labelLimit: 260
    }
  };
  return {
    height: isNarrow() ? 300 : 380,
    data: {values: rows},
    mark: {type: 'rect', clip: true, strokeWidth: 0},
    encoding: {x, y, x2: {field: x2}, y2: {field: y2}, color, tooltip}
  };
}

function loadSpec(record, grid, map) {
  const unit = grid.unit === 'rad' ? 'linear response, rad' : 'moment, N·m';
  const looks = [...CLASSES, ...record.ends.map((label, i) => ({label, color: END_COLORS[i]})).slice(1)];
  const step = grid.largest / grid.steps;
  const x = {
    ...axis(
      'from',
      `${isNarrow() ? 'direction' : 'direction of the moment'}, axis ${grid.axes[0]} (0°) to axis ${grid.axes[1]} (90°)`,
      [0, 90]
    ),
    second: 'to'
  };
  const y = {...axis('low', unit, [step / 2, grid.largest + step / 2]), second: 'high'};
  return heatMap(loadRows(record, grid, map), looks, x, y, [
    {field: 'angle', title: 'direction, °', format: '.3~g'},
    {field: 'magnitude', title: unit, format: '.4~g'},
    {field: 'end', title: 'reaches'},
    {field: 'iterations'}
  ]);
}

const angles = (theta) => theta.map((t) => short(t, 3)).join(', ');

/** The continuous branch first; equilibria beyond the palette share its last colour. */
function equilibriumLooks(map) {
  return map.equilibria.map((e, i) => ({
    label: `${map.has_branch && i === 0 ? 'continuous branch: ' : ''}(${angles(e.theta)})`,
    color: EQUILIBRIUM_COLORS[map.has_branch ? i : i + 1] ?? HUE.brown
  }));
}

function startSpec(map) {
  const looks = equilibriumLooks(map);
  const step = (2 * Math.PI) / (map.resolution - 1);
  const rows = map.cells.map((index, n) => {
    const [a, b] = [Math.floor(n / map.resolution) * step - Math.PI, (n % map.resolution) * step - Math.PI];
    return {
      from: a - step / 2,
      to: a + step / 2,
      low: b - step / 2,
      high: b + step / 2,
      a,
      b,
      look: (looks[index] ?? NONE).label
    };
  });
  const domain = [-Math.PI - step / 2, Math.PI + step / 2];
  const spec = heatMap(
    rows,
    [...looks, NONE],
    {...axis('from', 'start, rotation about axis 1, rad', domain), second: 'to'},
    {...axis('low', 'start, rotation about axis 2, rad', domain), second: 'high'},
    [
      {field: 'a', title: 'start, axis 1', format: '.3f'},
      {field: 'b', title: 'start, axis 2', format: '.3f'},
      {field: 'look', title: 'converges to θ, rad'}
    ]
  );
  spec.encoding.color.legend.columns = isNarrow() ? 1 : 2;
  return spec;
}

/** Safe single steps and observed orders, one row per formulation. */
function table(record, names) {
  const map = (grid, f, t) =>
    record.maps.find((m) => m.grid === grid && m.formulation === f && m.tangent === t);
  const safe = (grid, f, t) => {
    const m = map(grid.name, f, t);
    return !m ? '–' : m.safe_step >= grid.largest ? `≥ ${short(grid.largest, 3)}` : short(m.safe_step, 3);
  };
  const share = (grid, f, t) => {
    const m = map(grid.name, f, t);
    return m ? `${(100 * m.share).toFixed(0)} %` : '–';
  };
  const order = (f, t) => {
    const o = record.orders.find((r) => r.formulation === f && r.tangent === t);
    if (!isNumber(o?.order)) return '–';
    return o.predicted > 0
      ? `${short(o.order, 3)}, × ${short(o.factor, o.predicted > 1e-3 ? 2 : 1)}`
      : short(o.order, 3);
  };
  const columns = [
    {text: 'formulation'},
    ...record.grids.map((g) => ({
      text: `safe step, axes ${g.axes.join('–')}, ${g.unit.replace(' ', '·')}`,
      number: true
    })),
    ...record.tangents.map((t) => ({text: `share, ${tangentLabel(t)}`, number: true})),
    ...record.tangents.map((t) => ({text: `order, ${tangentLabel(t)}`, number: true}))
  ];
  return plainTable(
    'Safe single steps and orders',
    columns,
    names.map((f) => [
      h('code', {}, f),
      ...record.grids.map((g) => safe(g, f, 'analytic')),
      ...record.tangents.map((t) => share(record.grids[0], f, t)),
      ...record.tangents.map((t) => order(f, t))
    ])
  );
}

function drawLoads(chart, record, state) {
  const map = record.maps.find(
    (m) => m.grid === state.grid && m.formulation === state.formulation && m.tangent === state.tangent
  );
  if (map)
    chart.draw(
      loadSpec(
        record,
        record.grids.find((g) => g.name === state.grid),
        map
      )
    );
  else chart.say('No map for this choice.');
}

function drawStarts(chart, record, state) {
  const map = record.starts.find((s) => s.formulation === state.formulation);
  if (map?.equilibria.length) chart.draw(startSpec(map));
  else chart.say('No start converges.');
}

/** results.stability.basins: the record of the writer stability_basins.
 * @param {import('../../data.js').Results} results
 */
export function basinsFigure(results) {
  const record = results.stability?.basins;
  if (!record?.maps?.length) return new Absent('the results hold no maps of Newton (stability.basins)');
  const loads = new Chart(
    'basins-loads',
    'Map of a single Newton load step: direction of the moment across, its size upwards, colour ' +
      'for iterations and outcome.'
  );
  const starts = new Chart(
    'basins-starts',
    'Map of starts: rotation about axes 1 and 2, colour for the equilibrium that Newton converges to.'
  );
  const names = [...new Set(record.maps.map((m) => m.formulation))];
  const state = {
    formulation: names.includes(FIRST) ? FIRST : names[0],
    tangent: record.tangents[0],
    grid: record.grids[0].name
  };
  const set = (key) => (value) => {
    state[key] = value;
    drawLoads(loads, record, state);
    if (key === 'formulation') drawStarts(starts, record, state);
  };
  const controls = h(
    'div',
    {class: 'controls'},
    select(
      'Formulation',
      names.map((key) => ({key, label: key})),
      state.formulation,
      set('formulation')
    ),
    choice(
      'Tangent',
      record.tangents.map((key) => ({key, label: tangentLabel(key)})),
      state.tangent,
      set('tangent')
    ),
    choice(
      'Plane',
      record.grids.map((g) => ({key: g.name, label: `axes ${g.axes.join(' and ')}`})),
      state.grid,
      set('grid')
    )
  );
  drawLoads(loads, record, state);
  drawStarts(starts, record, state);
  const moment = record.starts[0]?.moment;
  return h(
    'figure',
    {},
    controls,
    h('div', {class: 'panels two'}, h('div', {}, loads.box), h('div', {}, starts.box)),
    h(
      'figcaption',
      {},
      'The block of 4.1.2 under a fixed moment. Left: Newton from rest with the whole moment in ' +
        'one step, no damping; blue: it reaches the state that small load steps reach, in that ' +
        'many iterations; ',
      'orange: in equilibrium, but elsewhere, or where the continuous branch has ended. ',
      `Right: what each start converges to under ${short(moment, 4)} N·m along C3’s load, analytic tangent; the equilibria by their rotation vectors, rad. `,
      `A run ends after ${record.most_iterations} iterations.`
    ),
    table(record, names),
    h(
      'p',
      {class: 'note'},
      'Safe step: the largest load up to which every smaller one of the grid reaches the ' +
        'continuous branch, in every direction, analytic tangent. Share: of the plane ',
      `${record.grids[0].axes.join('–')}. `,
      'Order: of the error at 50 digits, with the factor of each iteration where it is linear.'
    )
  );
}
