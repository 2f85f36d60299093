// Roofline: flops per ns against flops per byte of every batch kernel, under the peaks and bandwidths of this run.
import {AT_DECADES, Chart, isNarrow} from '../../chart.js';
import {KINDS} from '../../data/accuracy_data.js';
import {choice, h, plainTable, swatch} from '../../dom.js';
import {percent, short} from '../../format.js';
import {ISAS, isaLabel, present, speedOf, whatLabel} from '../../data/speed_data.js';
import {Absent} from '../../parts.js';
import {inMemory, isRoofed, kernelsOf, linesOf} from './roofline_data.js';
import {HUE} from '../../palette.js';

const HUES = {
  scalar: 'var(--muted)',
  sse2: HUE.green,
  avx2: HUE.gold,
  avx2vl: HUE.sky,
  avx512: HUE.blue
};
const SHAPES = {
  residual: 'circle',
  residual_tangent: 'square',
  residual_tangent_144: 'triangle-up',
  residual_compressed: 'diamond',
  product: 'diamond'
};
const PLACES = [
  {key: 'cache', label: 'cache'},
  {key: 'memory', label: 'memory'}
];

function spec(points, {flat, slanted}) {
  const isas = ISAS.filter((i) => [...points, ...flat].some((p) => p.isa === i));
  const axis = {format: '~r', tickCount: 5, gridOpacity: AT_DECADES, tickOpacity: AT_DECADES};
  const x = {
    field: 'x',
    type: 'quantitative',
    scale: {type: 'log', nice: false},
    title: 'flops per byte',
    axis
  };
  const y = {
    field: 'y',
    type: 'quantitative',
    scale: {type: 'log', nice: false, padding: 16},
    title: 'flops per ns',
    axis
  };
  const color = {
    field: 'isa',
    type: 'nominal',
    legend: null,
    scale: {domain: isas, range: isas.map((i) => HUES[i])}
  };
  const whats = [...new Set(points.map((p) => p.what))];
  const shape = {
    field: 'what',
    type: 'nominal',
    legend: null,
    scale: {domain: whats, range: whats.map((w) => SHAPES[w] ?? 'cross')}
  };
  // First: a line behind the label stays legible.
  const halo = {stroke: 'var(--paper)', strokeWidth: 4, strokeJoin: 'round'};
  const text = (rows, end, align, ink) =>
    [halo, {color: ink}].map((look) => ({
      data: {values: rows},
      mark: {
        type: 'text',
        align,
        baseline: 'bottom',
        dy: -4,
        dx: align === 'left' ? 4 : 0,
        fontSize: 11,
        ...look
      },
      encoding: {x: {...x, field: end}, y, text: {field: 'label'}}
    }));
  return {
    height: isNarrow() ? 360 : 460,
    layer: [
      {
        data: {values: slanted},
        mark: {type: 'rule', strokeWidth: 1.3, strokeDash: [5, 4], color: 'var(--muted)'},
        encoding: {x, y, x2: {field: 'x2'}, y2: {field: 'y2'}}
      },
      {
        data: {values: flat},
        mark: {type: 'rule', strokeWidth: 1.6},
        encoding: {x, y, x2: {field: 'x2'}, color}
      },
      ...text(flat, 'x2', 'right', 'var(--ink)'),
      ...text(slanted, 'x', 'left', 'var(--muted)'),
      {
        data: {values: points.map((p) => ({...p, x: p.intensity, y: p.rate}))},
        mark: {type: 'point', size: 75, strokeWidth: 1.8, opacity: 1},
        encoding: {
          x,
          y,
          color,
          shape,
          tooltip: [
            {field: 'formulation'},
            {field: 'what_label', title: 'what'},
            {field: 'isa_label', title: 'instructions'},
            {field: 'joints', format: ','},
            {field: 'rate', title: 'flops per ns', format: '.3g'},
            {field: 'intensity', title: 'flops per byte', format: '.3g'},
            {field: 'share', title: 'of the limit'}
          ]
        }
      }
    ]
  };
}

function tableOf(points) {
  const columns = [
    {text: 'formulation'},
    {text: 'what'},
    {text: 'instructions'},
    ...['joints', 'ns', 'flops', 'flops/byte', 'flops/ns', 'of peak', 'of ports', 'of limit'].map((text) => ({
      text,
      number: true
    }))
  ];
  return plainTable(
    'Share of the limit',
    columns,
    points.map((p) => [
      h('code', {}, p.formulation),
      p.what_label,
      p.isa_label,
      p.joints.toLocaleString('en'),
      short(p.ns, 3),
      short(p.flops, 3),
      short(p.intensity),
      short(p.rate, 3),
      percent(p.of_peak),
      percent(p.of_ports),
      p.share
    ])
  );
}

function legendOf(points) {
  const key = (look, text) => h('span', {class: 'key'}, swatch(look), text);
  return [
    ...ISAS.filter((i) => points.some((p) => p.isa === i)).map((i) =>
      key({color: HUES[i], dash: [1, 0]}, isaLabel(i))
    ),
    ...present(
      points.map((p) => p.what),
      Object.keys(SHAPES)
    ).map((w) => key({color: 'var(--muted)', shape: SHAPES[w] ?? 'cross'}, whatLabel(w)))
  ];
}

/** @param {import('../../data.js').Results} results */
export function rooflineFigure(results) {
  const all = results.timings.filter(isRoofed);
  if (!all.length) return new Absent('the results hold no batch with counted flops');
  const chart = new Chart(
    'roofline',
    'Flops per ns against flops per byte of each batch kernel, both logarithmic, under the ' +
      'measured peaks and bandwidths. The table holds the same numbers.'
  );
  const speed = speedOf(results);
  const kinds = KINDS.filter((k) => all.some((t) => t.kind === k.key));
  const precisions = present(all.map((t) => t.precision));
  const state = {kind: kinds[0].key, precision: precisions[0], place: 'cache'};
  const [table, legend] = [h('div', {class: 'tall'}), h('p', {class: 'keys'})];
  const draw = () => {
    const points = kernelsOf(all, speed, state);
    const placed = points.filter((p) => (p.intensity ?? 0) > 0);
    legend.replaceChildren(...legendOf(placed));
    table.replaceChildren(points.length ? tableOf(points) : '');
    if (placed.length)
      chart.draw(spec(placed, linesOf(speed, placed, state.precision, isNarrow() ? 12 : 2.5)));
    else
      chart.say(
        points.length
          ? 'The bytes of these kernels were not counted: the table has their share of the peak.'
          : 'No kernel is timed for this choice.'
      );
  };
  const set = (key) => (value) => {
    state[key] = value;
    draw();
  };
  draw();
  return h(
    'figure',
    {},
    h(
      'div',
      {class: 'controls'},
      choice('Kind', kinds, state.kind, set('kind')),
      precisions.length > 1
        ? choice(
            'Precision',
            precisions.map((key) => ({key, label: key})),
            state.precision,
            set('precision')
          )
        : null,
      all.some(inMemory) ? choice('Data in', PLACES, state.place, set('place')) : null
    ),
    legend,
    chart.box,
    h(
      'figcaption',
      {},
      'Flops are counted per evaluation, peaks and bandwidths measured in the same process, one ' +
        'thread. Of ports: the shortest time of the multiplications, alone or fused with a sum, over ' +
        'the time; the peak, of multiply-adds alone, no joint can reach. Multiplications count as ' +
        'written: where a compiler finds two to be one, the share looks larger. Limit: the least of the ' +
        'peak of the instruction set and the largest bandwidth of ' +
        'the cache, or of the memory, times flops per byte. ',
      speed.peaks.length ? '' : 'No peak was measured in this run.'
    ),
    table
  );
}
