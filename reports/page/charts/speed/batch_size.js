// Cost against the number of joints in one call of a batch, from cache to memory.
import {AT_DECADES, Chart, isNarrow} from '../../chart.js';
import {KINDS} from '../../data/accuracy_data.js';
import {choice, h, plainTable, select, swatch, toggles} from '../../dom.js';
import {full, nanoseconds, plural, short} from '../../format.js';
import {ISAS, isaLabel, present, WHAT} from '../../data/speed_data.js';
import {Absent} from '../../parts.js';
import {HUE} from '../../palette.js';
import {candidatesOf, firstState, limitsOf, outputLabel, seriesKey} from './batch_size_data.js';

const HUES = {
  residual: HUE.blue,
  residual_tangent: HUE.vermilion,
  residual_tangent_144: HUE.magenta,
  residual_compressed: HUE.sky,
  product: HUE.green
};
const OTHER = [HUE.gold, HUE.sky, HUE.violet];
const SHAPES = {sse2: 'circle', avx2: 'square', avx2vl: 'diamond', avx512: 'triangle-up'};
const DASHES = {1: [1, 0], 2: [5, 3]};
const hue = (output) => HUES[output] ?? OTHER[output.length % OTHER.length];
const dash = (threads) => DASHES[threads] ?? [2, 3];
function spec(timings, limits) {
  const domain = (key) => [...new Set(timings.map((t) => t[key]))];
  const rows = timings.map((t) => ({
    output: t.output,
    isa: t.isa,
    threads: t.threads,
    joints: t.joints,
    ns: t.ns,
    series: seriesKey(t),
    label: outputLabel(t.output),
    isa_label: isaLabel(t.isa),
    shown: full(t.ns),
    spread: `${short(100 * t.spread, 1)} %`
  }));
  const x = {
    field: 'joints',
    type: 'quantitative',
    scale: {type: 'log', nice: false, padding: 10},
    title: 'joints in one call',
    axis: {labelExpr: 'power10(datum.value)', tickCount: 7, gridOpacity: AT_DECADES, tickOpacity: AT_DECADES}
  };
  const y = {
    field: 'ns',
    type: 'quantitative',
    scale: {type: 'log', padding: 10},
    title: 'time per joint, ns',
    axis: {format: '~r', tickCount: 6, gridOpacity: AT_DECADES, tickOpacity: AT_DECADES}
  };
  const color = {
    field: 'output',
    type: 'nominal',
    legend: null,
    scale: {domain: domain('output'), range: domain('output').map(hue)}
  };
  return {
    height: isNarrow() ? 340 : 440,
    layer: [
      {
        data: {values: limits},
        mark: {type: 'rule', strokeDash: [1, 4], strokeWidth: 1.4},
        encoding: {x, color}
      },
      {
        data: {values: limits},
        mark: {type: 'text', angle: 270, align: 'right', baseline: 'bottom', dy: -2, fontSize: 11},
        encoding: {x, y: {value: 2}, text: {field: 'label'}, color}
      },
      {
        data: {values: rows},
        mark: {type: 'line', strokeWidth: 1.9, strokeJoin: 'round'},
        encoding: {
          x,
          y,
          color,
          detail: {field: 'series'},
          strokeDash: {
            field: 'threads',
            type: 'nominal',
            legend: null,
            scale: {domain: domain('threads'), range: domain('threads').map(dash)}
          }
        }
      },
      {
        data: {values: rows},
        mark: {type: 'point', filled: true, size: 42, opacity: 1},
        encoding: {
          x,
          y,
          color,
          shape: {
            field: 'isa',
            type: 'nominal',
            legend: null,
            scale: {domain: domain('isa'), range: domain('isa').map((i) => SHAPES[i] ?? 'diamond')}
          },
          tooltip: [
            {field: 'label', title: 'what'},
            {field: 'isa_label', title: 'instructions'},
            {field: 'threads'},
            {field: 'joints', format: ','},
            {field: 'shown', title: 'ns per joint'},
            {field: 'spread'}
          ]
        }
      }
    ]
  };
}

function tableOf(timings) {
  const series = [...new Map(timings.map((t) => [seriesKey(t), t])).entries()];
  const sizes = [...new Set(timings.map((t) => t.joints))].sort((a, b) => a - b);
  const at = new Map(timings.map((t) => [`${seriesKey(t)}/${t.joints}`, t.ns]));
  return plainTable(
    'Time per joint by size, ns',
    [{text: 'ns per joint at'}, ...sizes.map((n) => ({text: n.toLocaleString('en'), number: true}))],
    series.map(([key, t]) => [
      `${outputLabel(t.output)}, ${isaLabel(t.isa)}, ${plural(t.threads, 'thread')}`,
      ...sizes.map((n) => nanoseconds(at.get(`${key}/${n}`)))
    ])
  );
}

function choices(all, state, changed) {
  const set = (key) => (value) => {
    state[key] = value;
    changed();
  };
  const of = (key, order = []) =>
    present(
      all.map((t) => t[key]),
      order
    );
  const [formulations, kinds, precisions] = [
    of('formulation', ['invariant']),
    KINDS.filter((k) => all.some((t) => t.kind === k.key)),
    of('precision')
  ];
  return h(
    'div',
    {class: 'controls'},
    formulations.length > 1
      ? select(
          'Joint',
          formulations.map((key) => ({key, label: key})),
          state.formulation,
          set('formulation')
        )
      : h('code', {}, state.formulation),
    kinds.length > 1 ? choice('Kind', kinds, state.kind, set('kind')) : null,
    precisions.length > 1
      ? choice(
          'Precision',
          precisions.map((key) => ({key, label: key})),
          state.precision,
          set('precision')
        )
      : null
  );
}

/** The legend: what is on is drawn. */
function legend(all, state, changed) {
  const group = (label, key, order, text, look) =>
    toggles(
      label,
      present(
        all.map((t) => t[key]),
        order
      ).map((k) => ({key: k, label: text(k), on: state[key].has(k), swatch: swatch(look(k))})),
      (keys) => {
        state[key] = new Set(keys);
        changed();
      }
    );
  return h(
    'div',
    {class: 'controls'},
    group('Outputs shown', 'output', Object.keys(WHAT), outputLabel, (k) => ({
      color: hue(k),
      shape: 'circle'
    })),
    group('Instruction sets shown', 'isa', ISAS, isaLabel, (k) => ({
      color: 'var(--muted)',
      shape: SHAPES[k] ?? 'diamond'
    })),
    group(
      'Threads shown',
      'threads',
      [],
      (k) => plural(k, 'thread'),
      (k) => ({color: 'var(--muted)', dash: dash(k)})
    )
  );
}

/** @param {import('../../data.js').Results} results */
export function batchSizeFigure(results) {
  const all = candidatesOf(results);
  if (!all.length) return new Absent('the results hold no batch that was timed at several sizes');
  const chart = new Chart(
    'batch-size',
    'Time per joint against the number of joints in one call, both logarithmic. The table holds ' +
      'the same numbers.'
  );
  const state = firstState(all);
  const table = h('div');
  const isShown = (t) =>
    ['formulation', 'kind', 'precision'].every((key) => t[key] === state[key]) &&
    ['output', 'isa', 'threads'].every((key) => state[key].has(t[key]));
  const draw = () => {
    const shown = all.filter(isShown).sort((a, b) => a.joints - b.joints);
    table.replaceChildren(shown.length ? tableOf(shown) : '');
    if (shown.length) chart.draw(spec(shown, limitsOf(results, shown)));
    else chart.say('Nothing is timed for this choice.');
  };
  draw();
  return h(
    'figure',
    {},
    choices(all, state, draw),
    legend(all, state, draw),
    chart.box,
    h(
      'figcaption',
      {},
      'All inputs and outputs in separate arrays; what no longer fits into a cache is read from ' +
        'and written to the next. ',
      limitsOf(results, all).length ? 'Dotted: the joints whose data fill a cache.' : ''
    ),
    table
  );
}
