// Lines over a logarithmic plane, one per formulation, one of which can be isolated.
import {AT_DECADES, isNarrow} from '../chart.js';
import {h, isolate, swatch} from '../dom.js';
import {look} from '../palette.js';

const FADED = 0.1;

export const logAxis = (tickCount) => ({
  labelExpr: 'power10(datum.value)',
  tickCount,
  gridOpacity: AT_DECADES,
  tickOpacity: AT_DECADES
});
/** The channel of errors and their like. */
export const logChannel = (field, title) => ({
  field,
  title,
  scale: {type: 'log', padding: 8},
  axis: logAxis(9)
});
export const namesOf = (rows) => [...new Set(rows.map((r) => r.formulation))];

/** `only` is isolated, or null. */
export function linesSpec(rows, x, y, only, tooltip, points) {
  const names = namesOf(rows);
  const color = {
    field: 'formulation',
    type: 'nominal',
    legend: null,
    scale: {domain: names, range: names.map((n) => look(n).color)}
  };
  const strokeDash = {
    field: 'formulation',
    type: 'nominal',
    legend: null,
    scale: {domain: names, range: names.map((n) => (look(n).dash.length ? look(n).dash : [1, 0]))}
  };
  const faded = only
    ? {opacity: {condition: {test: `datum.formulation === ${JSON.stringify(only)}`, value: 1}, value: FADED}}
    : {};
  const axes = {x: {type: 'quantitative', ...x}, y: {type: 'quantitative', ...y}};
  const near = {
    params: [{name: 'near', select: {type: 'point', on: 'pointerover', nearest: true, clear: 'pointerout'}}],
    mark: {type: 'point', filled: true, size: 50},
    encoding: {
      ...axes,
      color,
      opacity: {condition: {param: 'near', empty: false, value: 1}, value: 0},
      tooltip
    }
  };
  return {
    height: isNarrow() ? 320 : 400,
    data: {
      values: only
        ? rows.filter((r) => r.formulation === only).concat(rows.filter((r) => r.formulation !== only))
        : rows
    },
    layer: [
      {
        mark: {type: 'line', strokeWidth: 2, strokeJoin: 'round', clip: true},
        encoding: {...axes, color, strokeDash, detail: {field: 'formulation'}, ...faded}
      },
      ...points({...axes, color, ...faded}),
      near
    ]
  };
}

/** A chart whose rows are chosen by one field, with a legend that isolates a formulation. */
export class RowsPanel {
  constructor(chart, rows, specOf, tableOf) {
    this.chart = chart;
    this.rows = rows;
    this.specOf = specOf;
    this.tableOf = tableOf;
    this.only = null;
    this.table = h('div');
    this.legend = isolate(
      'Isolate a formulation',
      namesOf(rows).map((n) => ({key: n, label: n, swatch: swatch(look(n))})),
      (only) => {
        this.only = only;
        this.draw();
      }
    );
  }

  show(rows) {
    this.rows = rows;
    this.table.replaceChildren(this.tableOf(rows));
    this.draw();
  }

  draw() {
    this.chart.draw(this.specOf(this.rows, this.only));
  }
}
