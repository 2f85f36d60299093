// Critical moments per formulation and type of moment: divergence or flutter (results.stability.kind).
import {Chart, isNarrow} from '../../chart.js';
import {choice, h, plainTable, swatch, toggles} from '../../dom.js';
import {isNumber, short} from '../../format.js';
import {look} from '../../palette.js';
import {Absent} from '../../parts.js';
import {momentLabel as labelOf} from './moments.js';

const SHAPES = {
  fixed: 'circle',
  follower: 'triangle-up',
  semi_tangential: 'square',
  quasi_tangential: 'diamond',
  dead_couples: 'cross'
};
const SHOWN_FIRST = ['fixed', 'follower', 'semi_tangential'];
const shapeOf = (moment) => SHAPES[moment] ?? 'triangle-down';

/** The rows of one axis and body; divergence, which no body changes, among them. `first` is what happens first. */
function rowsOf(kind, axis, body) {
  const rows = kind.rows.filter(
    (r) => String(r.axis) === axis && (r.inertia === body || r.inertia === 'any')
  );
  const cell = (r) =>
    rows.filter((o) => o.formulation === r.formulation && o.moment === r.moment && isNumber(o.load));
  return rows.map((r) => ({
    ...r,
    label: labelOf(r.moment),
    first: isNumber(r.load) && cell(r).every((o) => o.angle >= r.angle),
    none: cell(r).length === 0,
    shown: isNumber(r.load) ? `${short(r.load, 6)} N·m at ${short(r.angle, 5)} rad` : ''
  }));
}

/** 1, 2, 5 of each decade. */
/** @param {number[]} domain */
const ticks = ([low, high]) =>
  Array.from({length: 60}, (_, i) => [1, 2, 5][i % 3] * 10 ** (Math.floor(i / 3) - 6)).filter(
    (t) => t >= low && t <= high
  );

function dotSpec(kind, rows, moments) {
  const names = [...new Set(kind.rows.map((r) => r.formulation))];
  const found = rows.filter((r) => isNumber(r.load) && r.load > 0 && moments.includes(r.moment));
  const none = rows.filter((r) => r.none && r.kind === 'divergence' && moments.includes(r.moment));
  const [least, most] = [Math.min(...found.map((r) => r.load)), Math.max(...found.map((r) => r.load))];
  const span = most / least;
  const place = most * span ** 0.08; // of "none": beside the largest load, with room for the words
  const domain = [least / (1.1 * span ** 0.03), place * span ** (isNarrow() ? 0.5 : 0.25)];
  const y = {
    field: 'formulation',
    type: 'nominal',
    sort: names,
    scale: {domain: names},
    title: null,
    axis: {
      labelColor: 'var(--ink)',
      labelFontSize: 12,
      ticks: false,
      domain: false,
      grid: true,
      labelLimit: 140,
      labelOverlap: false
    }
  };
  const yOffset = {field: 'moment', type: 'nominal', scale: {domain: moments}};
  const x = {
    field: 'load',
    type: 'quantitative',
    title: 'critical moment, N·m',
    scale: {type: 'log', domain, nice: false},
    axis: {format: '~r', values: ticks(domain)}
  };
  const shape = {
    field: 'moment',
    type: 'nominal',
    legend: null,
    scale: {domain: moments, range: moments.map(shapeOf)}
  };
  const color = {
    field: 'formulation',
    type: 'nominal',
    legend: null,
    scale: {domain: names, range: names.map((n) => look(n).color)}
  };
  const opacity = {condition: {test: 'datum.first', value: 1}, value: 0.3};
  const tooltip = [
    {field: 'formulation'},
    {field: 'label', title: 'moment'},
    {field: 'kind'},
    {field: 'load', format: '.12g', title: 'critical moment, N·m'},
    {field: 'angle', format: '.10g', title: 'rotation, rad'},
    {field: 'inertia', title: 'body'}
  ];
  const marks = (which, mark) => ({
    transform: [{filter: `datum.kind === '${which}'`}],
    mark: {type: 'point', size: isNarrow() ? 45 : 60, ...mark},
    encoding: {x, y, yOffset, shape, color, opacity, tooltip}
  });
  return {
    height: {step: (isNarrow() ? 11 : 12) * moments.length + 8, for: 'position'},
    data: {values: found},
    layer: [
      marks('divergence', {filled: true}),
      marks('flutter', {filled: false, strokeWidth: 2}),
      {
        data: {
          values: none.map((r) => ({
            ...r,
            load: place,
            text: r.end === 'half a turn' ? 'none' : `none to ${short(r.until, 3)} rad`
          }))
        },
        mark: {type: 'text', align: 'left', fontSize: 10, color: 'var(--muted)', dx: -8},
        encoding: {
          x,
          y,
          yOffset,
          text: {field: 'text'},
          tooltip: [
            {field: 'formulation'},
            {field: 'label', title: 'moment'},
            {field: 'until', title: 'searched up to, rad', format: '.6g'},
            {field: 'end', title: 'ends with'}
          ]
        }
      }
    ]
  };
}

function table(kind, rows) {
  const moments = kind.moments.map((m) => m.name);
  const text = (formulation, moment) => {
    const first = rows.find((r) => r.formulation === formulation && r.moment === moment && r.first);
    const any = rows.find((r) => r.formulation === formulation && r.moment === moment);
    if (first)
      return `${short(first.load, 5)} ${first.kind === 'flutter' ? 'F' : 'D'} (${short(first.angle, 4)})`;
    return any ? `none${any.end === 'half a turn' ? '' : ` to ${short(any.until, 4)}`}` : '–';
  };
  return plainTable(
    'Critical moments',
    [{text: 'formulation'}, ...moments.map((m) => ({text: labelOf(m), number: true}))],
    [...new Set(rows.map((r) => r.formulation))].map((f) => [f, ...moments.map((m) => text(f, m))]),
    'First instability: moment in N·m, D divergence or F flutter, rotation in rad in brackets.'
  );
}

/** @param {import('../../data.js').Results} results */
export function criticalLoadsFigure(results) {
  const kind = results.stability?.kind;
  if (!kind?.rows?.length) return new Absent('the results hold no kinds of instability (stability.kind)');
  const chart = new Chart(
    'critical-loads',
    'Critical moment of each formulation as dots on a logarithmic axis, one row for each type of ' +
      'moment; filled for divergence, hollow for flutter.'
  );
  const box = h('div');
  const state = {axis: '1', body: kind.bodies[0].name, moments: SHOWN_FIRST};
  const show = () => {
    const rows = rowsOf(kind, state.axis, state.body);
    box.replaceChildren(table(kind, rows));
    const ordered = kind.moments.map((m) => m.name).filter((m) => state.moments.includes(m));
    if (rows.some((r) => isNumber(r.load) && r.load > 0 && ordered.includes(r.moment)))
      chart.draw(dotSpec(kind, rows, ordered));
    else chart.say('No formulation becomes unstable under these moments.');
  };
  const set = (name) => (value) => {
    state[name] = value;
    show();
  };
  const items = kind.moments.map((m) => ({
    key: m.name,
    label: labelOf(m.name),
    title: m.what,
    on: SHOWN_FIRST.includes(m.name),
    swatch: swatch({color: 'var(--muted)', shape: shapeOf(m.name)})
  }));
  show();
  return h(
    'figure',
    {},
    h(
      'div',
      {class: 'controls'},
      choice(
        'moment about axis',
        ['1', '2', '3'].map((key) => ({key, label: key})),
        state.axis,
        set('axis')
      ),
      choice(
        'inertia of the body',
        kind.bodies.map((b) => ({key: b.name, label: b.name})),
        state.body,
        set('body')
      ),
      toggles('Types of moment', items, set('moments'))
    ),
    chart.box,
    h(
      'figcaption',
      {},
      'The block of C3 turned about one axis. Filled: divergence, a frequency falls to zero; ' +
        'hollow: flutter, two frequencies meet and the motion grows. Pale: comes after another ' +
        'instability. ',
      'Flutter depends on the inertia of the body, divergence does not. “none” is said up to π, ' +
        'or up to where the path ends.'
    ),
    box
  );
}
