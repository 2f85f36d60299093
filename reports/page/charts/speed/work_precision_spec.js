// Vega-Lite for the work-precision figure.
import {AT_DECADES, isNarrow} from '../../chart.js';
import {full, nanoseconds, short} from '../../format.js';
import {look} from '../../palette.js';
import {MARKS} from '../../data/speed_data.js';

const Y_TITLE = {
  numerical: 'worst numerical error, relative',
  range: 'numerical error in this range of φ, relative',
  modelling: 'modelling error, relative'
};
const FADED = 0.12;

function rowsOf(points, front, only) {
  const label = (p) => (only ? (p.formulation === only ? p.brief : '') : front.includes(p) ? p.short : '');
  return points.map((p) => ({
    ...p,
    label: label(p),
    front: front.includes(p) ? 'yes' : 'no',
    opacity: !only || p.formulation === only ? 1 : FADED,
    shown_value: full(p.value),
    shown_time: `${nanoseconds(p.ns)} ns (spread ${short(100 * p.spread, 1)} %)`
  }));
}

const TOOLTIP = [
  {field: 'formulation'},
  {field: 'make', title: 'how'},
  {field: 'shown_time', title: 'time'},
  {field: 'shown_value', title: 'error'},
  {field: 'floor', title: 'known to', format: '.2g'},
  {field: 'front', title: 'on the front'},
  {field: 'note', title: 'measured'}
];

/** only: the formulation that is isolated, or null. */
export function workPrecisionSpec(points, front, {view, what}, only) {
  const names = [...new Set(points.map((p) => p.formulation))];
  const colors = {domain: names, range: names.map((n) => look(n).color)};
  const shapes = {domain: MARKS.map((m) => m.key), range: MARKS.map((m) => m.shape)};
  const x = {
    field: 'ns',
    type: 'quantitative',
    scale: {type: 'log', nice: false, padding: isNarrow() ? 16 : 26},
    title: `time per joint, ${what}, ns`,
    axis: {format: '~r', tickCount: 6, gridOpacity: AT_DECADES}
  };
  const y = {
    field: 'error',
    type: 'quantitative',
    scale: {type: 'log', padding: 16},
    title: Y_TITLE[view],
    axis: {labelExpr: 'power10(datum.value)', tickCount: 9, gridOpacity: AT_DECADES, tickOpacity: AT_DECADES}
  };
  return {
    height: isNarrow() ? 380 : 560,
    layer: [
      {
        name: 'front',
        data: {values: front},
        mark: {
          type: 'line',
          interpolate: 'step-after',
          strokeWidth: 1.5,
          strokeDash: [5, 4],
          color: 'var(--muted)'
        },
        encoding: {x, y, order: {field: 'ns'}}
      },
      {
        name: 'points',
        data: {values: rowsOf(points, front, only)},
        mark: {type: 'point', size: isNarrow() ? 60 : 85, strokeWidth: 1.7},
        encoding: {
          x,
          y,
          color: {field: 'formulation', type: 'nominal', legend: null, scale: colors},
          opacity: {field: 'opacity', type: 'quantitative', scale: null, legend: null},
          shape: {field: 'mark', type: 'nominal', legend: null, scale: shapes},
          fill: {
            condition: {test: 'datum.floored', value: 'var(--paper)'},
            field: 'formulation',
            type: 'nominal',
            legend: null,
            scale: colors
          },
          tooltip: TOOLTIP
        }
      }
    ]
  };
}
