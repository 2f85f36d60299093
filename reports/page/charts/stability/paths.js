// Equilibrium paths by arc length: through folds and branchings, stable solid and unstable dashed.
import {Chart, isNarrow} from '../../chart.js';
import {choice, folded, h, isolate, plainTable, swatch} from '../../dom.js';
import {full, short} from '../../format.js';
import {look} from '../../palette.js';
import {Absent} from '../../parts.js';

const FADED = 0.08;
const EVENT_SHAPES = {fold: 'triangle-up', branching: 'diamond'};
const LOADS = [
  {key: 'skewed', label: 'skewed, as Fig. 4'},
  {key: 'straight', label: 'about axis 1'}
];
const OUTPUTS = [
  {key: 'phi', label: 'φ'},
  {key: 'theta_x', label: 'θ₁'},
  {key: 'theta_y', label: 'θ₂'},
  {key: 'theta_z', label: 'θ₃'}
];

const loadLabel = (key) => LOADS.find((l) => l.key === key)?.label ?? key;

/** Points of the curves as rows; a change of stability begins a new segment at the point they share.
 * @param {import('../../data.js').Results} results
 */
function rowsOf(results, paths, load, output) {
  const [factor, value, phi, sign, negative] = ['factor', output, 'phi', 'sign', 'negative'].map((c) =>
    paths.columns.indexOf(c)
  );
  return paths.curves
    .filter((c) => c.load === load)
    .flatMap((curve, k) => {
      const series = results.series(curve);
      const row = (p, i, segment, stable) => ({
        formulation: curve.formulation,
        series,
        branch: curve.branch,
        i,
        segment: `${k}/${segment}`,
        factor: p[factor],
        value: p[value],
        phi: p[phi],
        stable,
        state:
          p[sign] === 0
            ? 'neutral: a zero eigenvalue'
            : stable
              ? 'stable'
              : `unstable: ${p[negative]} negative`
      });
      let segment = 0;
      return curve.points.flatMap((p, i) => {
        const stable = p[negative] === 0;
        const changed = i > 0 && stable !== (curve.points[i - 1][negative] === 0);
        if (!changed) return [row(p, i, segment, stable)];
        return [row(p, i, segment++, !stable), row(p, i, segment, stable)];
      });
    });
}

/** The singular points, at the value that the curve has there.
 * @param {import('../../data.js').Results} results
 */
function eventRows(results, paths, load, output) {
  const [factor, value, phi] = ['factor', output, 'phi'].map((c) => paths.columns.indexOf(c));
  const near = (curve, e) =>
    curve.points.reduce(
      (best, p) => {
        const distance = Math.abs(p[phi] - e.phi) + Math.abs(p[factor] / e.factor - 1);
        return distance < best.distance ? {distance, value: p[value]} : best;
      },
      {distance: Infinity, value: null}
    ).value;
  return paths.curves
    .filter((c) => c.load === load)
    .flatMap((curve) =>
      curve.events.map((e) => ({
        formulation: curve.formulation,
        series: results.series(curve),
        branch: curve.branch,
        ...e,
        value: output === 'phi' ? e.phi : near(curve, e)
      }))
    );
}

function spec(rows, events, output, only) {
  const names = [...new Set(rows.map((r) => r.formulation))];
  const x = {
    field: 'factor',
    type: 'quantitative',
    title: 'moment, N·m',
    axis: {tickCount: isNarrow() ? 5 : 9}
  };
  const y = {
    field: 'value',
    type: 'quantitative',
    title: `${OUTPUTS.find((o) => o.key === output)?.label}, rad`
  };
  const color = {
    field: 'formulation',
    type: 'nominal',
    legend: null,
    scale: {domain: names, range: names.map((n) => look(n).color)}
  };
  const opacity = only
    ? {opacity: {condition: {test: `datum.formulation === ${JSON.stringify(only)}`, value: 1}, value: FADED}}
    : {};
  const strokeDash = {
    field: 'stable',
    type: 'nominal',
    legend: null,
    scale: {
      domain: [true, false],
      range: [
        [1, 0],
        [4, 4]
      ]
    }
  };
  const shape = {
    field: 'type',
    type: 'nominal',
    legend: null,
    scale: {domain: Object.keys(EVENT_SHAPES), range: Object.values(EVENT_SHAPES)}
  };
  const where = [
    {field: 'series', title: 'formulation'},
    {field: 'branch'},
    {field: 'factor', title: 'moment, N·m', format: '.10g'},
    {field: 'phi', title: 'φ, rad', format: '.8g'}
  ];
  const shownEvents = only ? events.filter((e) => e.formulation === only) : events;
  return {
    height: isNarrow() ? 340 : 460,
    data: {values: rows},
    layer: [
      {
        mark: {type: 'line', strokeWidth: 2, strokeJoin: 'round'},
        encoding: {x, y, color, strokeDash, detail: {field: 'segment'}, order: {field: 'i'}, ...opacity}
      },
      {
        params: [
          {name: 'near', select: {type: 'point', on: 'pointerover', nearest: true, clear: 'pointerout'}}
        ],
        mark: {type: 'point', filled: true, size: 45},
        encoding: {
          x,
          y,
          color,
          opacity: {condition: {param: 'near', empty: false, value: 1}, value: 0},
          tooltip: [...where, {field: 'state'}]
        }
      },
      {
        data: {values: shownEvents},
        mark: {type: 'point', filled: true, size: 90, opacity: 1, stroke: 'var(--ink)', strokeWidth: 1},
        encoding: {
          x,
          y,
          color,
          shape,
          tooltip: [{field: 'type'}, ...where, {field: 'located_to', title: 'located to', format: '.0e'}]
        }
      }
    ]
  };
}

/** @param {import('../../data.js').Results} results */
function eventTable(results, paths) {
  const rows = paths.curves.flatMap((curve) =>
    curve.events.map((e) => [
      results.series(curve),
      loadLabel(curve.load),
      curve.branch,
      e.type,
      full(e.factor),
      full(e.phi),
      short(e.located_to, 1)
    ])
  );
  return plainTable(
    'Singular points',
    [
      {text: 'formulation'},
      {text: 'moment'},
      {text: 'path'},
      {text: 'point'},
      {text: 'N·m', number: true},
      {text: 'φ, rad', number: true},
      {text: 'located to', number: true}
    ],
    rows,
    'Singular points, found by a change of sign along the arc and located at 50 digits'
  );
}

/** @param {import('../../data.js').Results} results */
function endTable(results, paths) {
  const rows = paths.curves.map((c) => [
    results.series(c),
    loadLabel(c.load),
    c.branch,
    String(c.points.length),
    String(c.shortened),
    c.outcome
  ]);
  return plainTable(
    'How each path ends',
    [
      {text: 'formulation'},
      {text: 'moment'},
      {text: 'path'},
      {text: 'points', number: true},
      {text: 'shortened', number: true},
      {text: 'end'}
    ],
    rows,
    'second 1+, 1-: the halves of the path that crosses the primary one at its first branching; ' +
      'shortened: steps tried and refused'
  );
}

/** What load stepping came to: on the path all the way, off it from a load on, or given up. */
function stepCell(s) {
  if (!s) return '–';
  const ended = s.converged ? '' : `gave up after ${short(s.reached, 4)}`;
  const jumped = s.off ? `off from ${short(s.first_off, 4)}` : '';
  return [jumped, ended].filter(Boolean).join(', ') || '✓';
}

/** @param {import('../../data.js').Results} results */
function stepTable(results, paths) {
  const counts = [...new Set(paths.steps.map((s) => s.steps))];
  const rowKeys = [...new Set(paths.steps.map((s) => `${results.series(s)}|${s.solver}`))];
  const rows = rowKeys.map((key) => {
    const own = paths.steps.filter((s) => `${results.series(s)}|${s.solver}` === key);
    return [...key.split('|'), ...counts.map((n) => stepCell(own.find((s) => s.steps === n)))];
  });
  return plainTable(
    'Load stepping',
    [{text: 'formulation'}, {text: 'solver'}, ...counts.map((n) => ({text: `${n} steps`}))],
    rows,
    'Load stepping in whole steps, N·m: ✓ all states on the continuous path; off: from this load ' +
      'on, states that lie elsewhere'
  );
}

/** @param {import('../../data.js').Results} results */
export function pathsFigure(results) {
  const paths = results.stability?.paths;
  if (!paths?.curves?.length) return new Absent('the results hold no equilibrium paths (stability.paths)');
  const chart = new Chart(
    'paths',
    'Rotation over the moment along the equilibrium paths of each formulation; stable parts ' +
      'solid, unstable dashed; folds and branchings marked.'
  );
  const state = {load: 'skewed', output: 'phi', only: null};
  const draw = () =>
    chart.draw(
      spec(
        rowsOf(results, paths, state.load, state.output),
        eventRows(results, paths, state.load, state.output),
        state.output,
        state.only
      )
    );
  const set = (name) => (value) => {
    state[name] = value;
    draw();
  };
  const names = new Map(paths.curves.map((c) => [c.formulation, results.series(c)]));
  const legend = isolate(
    'Isolate a formulation',
    [...names].map(([n, label]) => ({key: n, label, swatch: swatch({color: look(n).color, dash: [1, 0]})})),
    set('only')
  );
  const marks = Object.entries(EVENT_SHAPES).map(([type, shape]) =>
    h('span', {class: 'key'}, swatch({color: 'var(--muted)', shape}), type)
  );
  draw();
  return h(
    'figure',
    {},
    choice('Moment', LOADS, state.load, set('load')),
    choice('Rotation', OUTPUTS, state.output, set('output')),
    legend,
    h(
      'p',
      {class: 'keys'},
      h('span', {class: 'key'}, swatch({color: 'var(--muted)', dash: [1, 0]}), 'stable'),
      h('span', {class: 'key'}, swatch({color: 'var(--muted)', dash: [4, 4]}), 'unstable'),
      marks
    ),
    chart.box,
    h(
      'figcaption',
      {},
      'Equilibria followed by arc length from rest, through folds and, about axis 1, onto both ' +
        'halves of the path that branches off. Unstable: the tangent has a real eigenvalue below ' +
        'zero. ',
      'A change of sign is accepted only when the singular point is found at 50 digits, so that ' +
        'a step cannot change path unnoticed.'
    ),
    folded('Singular points', eventTable(results, paths)),
    folded('How each path ends', endTable(results, paths)),
    folded('Load stepping without guard', stepTable(results, paths))
  );
}
