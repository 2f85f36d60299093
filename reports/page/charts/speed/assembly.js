// From poses to a sparse matrix: time per joint of each way, in cache and from memory.
import {AT_DECADES, Chart} from '../../chart.js';
import {KINDS} from '../../data/accuracy_data.js';
import {h, plainTable, swatch} from '../../dom.js';
import {full, nanoseconds, short} from '../../format.js';
import {HUE} from '../../palette.js';
import {Absent} from '../../parts.js';
import {rowsOf} from './assembly_data.js';

const HUES = {angular: HUE.gold, linear: HUE.sky, linear_angular: HUE.vermilion};
const PLACES = ['in cache', 'from memory'];
const SHAPES = ['circle', 'square'];

function spec(rows) {
  const kinds = KINDS.map((k) => k.key);
  const ways = [...new Set(rows.map((r) => r.way))];
  return {
    height: 30 * ways.length,
    data: {values: rows.map((r) => ({...r, shown: full(r.ns), varies: `${short(100 * r.spread, 1)} %`}))},
    mark: {type: 'point', filled: true, size: 70, opacity: 1},
    encoding: {
      y: {field: 'way', type: 'nominal', sort: ways, title: null, axis: {labelLimit: 260}},
      x: {
        field: 'ns',
        type: 'quantitative',
        scale: {type: 'log', padding: 10},
        title: 'time per joint, ns',
        axis: {format: '~r', tickCount: 6, gridOpacity: AT_DECADES, tickOpacity: AT_DECADES}
      },
      color: {
        field: 'kind',
        type: 'nominal',
        legend: null,
        scale: {domain: kinds, range: kinds.map((k) => HUES[k])}
      },
      shape: {field: 'place', type: 'nominal', legend: null, scale: {domain: PLACES, range: SHAPES}},
      tooltip: [
        {field: 'way'},
        {field: 'kind_label', title: 'kind'},
        {field: 'place', title: 'matrix'},
        {field: 'joints', format: ','},
        {field: 'shown', title: 'ns per joint'},
        {field: 'varies', title: 'spread'},
        {field: 'isa', title: 'instructions'}
      ]
    }
  };
}

function tableOf(rows) {
  const columns = PLACES.flatMap((place) =>
    KINDS.map((k) => ({place, kind: k.key, text: `${k.label}, ${place}`, number: true}))
  ).filter((c) => rows.some((r) => r.place === c.place && r.kind === c.kind));
  return plainTable(
    'From poses to a sparse matrix, ns a joint',
    [{text: 'way'}, ...columns],
    [...new Set(rows.map((r) => r.way))].map((way) => [
      way,
      ...columns.map((c) => {
        const row = rows.find((r) => r.way === way && r.place === c.place && r.kind === c.kind);
        return row ? nanoseconds(row.ns) : '–';
      })
    ])
  );
}

const entry = (text, look) => h('span', {class: 'name'}, swatch(look), h('span', {}, text));

/** @param {import('../../data.js').Results} results */
export function assemblyFigure(results) {
  const rows = rowsOf(results);
  if (!rows.length) return new Absent('no assembly was timed');
  const chart = new Chart('assembly', 'Time per joint from poses to a sparse matrix, by way.');
  chart.draw(spec(rows));
  const sizes = [...new Set(rows.map((r) => r.joints))].sort((a, b) => a - b);
  return h(
    'figure',
    {},
    h(
      'div',
      {class: 'controls'},
      KINDS.map((k) => entry(k.label, {color: HUES[k.key], shape: 'circle'})),
      PLACES.map((place, i) => entry(place, {color: 'var(--muted)', shape: SHAPES[i]}))
    ),
    chart.box,
    tableOf(rows),
    h(
      'figcaption',
      {},
      `Joints of a lattice, two a node, one law for all: ${sizes.map((n) => n.toLocaleString('en')).join(' and ')} joints. ` +
        'From the poses of the nodes to residual and matrix, zeroing included; blocks of 6 × 6 for linear and full ' +
        'joints, of 3 × 3 for angular ones. Textbook and MBDyn’s way are transcriptions in Eigen.'
    )
  );
}
