// Energy in motion: its change over thousands of periods per formulation, the drifts as a table, and the work
// round closed loops over the amplitude. Reads results.stability.energy.
import {AT_DECADES, Chart, isNarrow} from '../chart.js';
import {kindLabel} from '../data.js';
import {choice, h, isolate, plainTable, swatch} from '../dom.js';
import {isNumber, short} from '../format.js';
import {look} from '../palette.js';

const FADED = 0.1;
const FLOOR = 1e-18; // of the loops' axis: an exact 0 has no place on it

const logAxis = (tickCount) => ({
  labelExpr: 'power10(datum.value)',
  tickCount,
  gridOpacity: AT_DECADES,
  tickOpacity: AT_DECADES
});
const unique = (rows) => [...new Set(rows.map((r) => r.formulation))];

/** Lines over a logarithmic plane, one per formulation; `only` is isolated, or null. */
function linesSpec(rows, x, y, only, tooltip, points) {
  const names = unique(rows);
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

/** One point per end of a run before its time. */
function runsSpec(runs, only) {
  const rows = runs.flatMap((r) => {
    let largest = 0;
    return r.samples
      .map(([period, change], i) => {
        largest = Math.max(largest, change);
        return {
          formulation: r.formulation,
          period,
          change: largest,
          stopped: i === r.samples.length - 1 ? r.ending : '',
          nature: r.potential ? 'has a potential' : 'no potential'
        };
      })
      .filter((row) => row.change > 0);
  });
  const x = {
    field: 'period',
    title: 'periods of the slowest mode',
    scale: {type: 'log', nice: false, padding: 8},
    axis: logAxis(7)
  };
  const y = {
    field: 'change',
    title: 'largest energy change until then, relative',
    scale: {type: 'log', padding: 8},
    axis: logAxis(9)
  };
  const tooltip = [
    {field: 'formulation'},
    {field: 'nature', title: 'loads'},
    {field: 'period', format: '.4g'},
    {field: 'change', title: 'energy change', format: '.3g'},
    {field: 'stopped', title: 'ended'}
  ];
  return linesSpec(rows, x, y, only, tooltip, (encoding) => [
    {
      transform: [{filter: "datum.stopped !== ''"}],
      mark: {type: 'point', shape: 'cross', filled: true, size: 110, opacity: 1},
      encoding
    }
  ]);
}

function loopsSpec(loops, only) {
  const rows = loops.flatMap((l) =>
    l.points
      .filter((p) => isNumber(p.relative))
      .map((p) => ({
        formulation: l.formulation,
        amplitude: p.amplitude,
        relative: p.relative,
        shown: Math.max(p.relative, FLOOR),
        slope: isNumber(l.slope) ? short(l.slope, 3) : 'no net work'
      }))
  );
  const x = {
    field: 'amplitude',
    title: 'amplitude of the loop',
    scale: {type: 'log', nice: false, padding: 12},
    axis: {values: [0.0125, 0.025, 0.05, 0.1, 0.2, 0.4, 0.8], format: '~r'}
  };
  const y = {
    field: 'shown',
    title: 'net work over turnover',
    scale: {type: 'log', padding: 8},
    axis: logAxis(9)
  };
  const tooltip = [
    {field: 'formulation'},
    {field: 'amplitude'},
    {field: 'relative', title: 'net work over turnover', format: '.3g'},
    {field: 'slope', title: 'net work ~ amplitude to the'}
  ];
  return linesSpec(rows, x, y, only, tooltip, (encoding) => [
    {mark: {type: 'point', filled: true, size: 22}, encoding}
  ]);
}

function driftTable(runs) {
  const momentum = (value) => (isNumber(value) ? short(value) : '–');
  const order = [...runs].sort((a, b) => a.largest - b.largest);
  return plainTable(
    'Drift of energy and momentum',
    [
      {text: 'formulation'},
      {text: 'potential'},
      {text: 'periods', number: true},
      {text: 'largest energy change', number: true},
      {text: 'trend per period', number: true},
      {text: 'momentum', number: true},
      {text: 'angular momentum', number: true},
      {text: 'ended'}
    ],
    order.map((r) => [
      r.formulation,
      r.potential ? 'yes' : 'no',
      short(r.periods, 4),
      short(r.largest),
      short(r.trend),
      momentum(r.linear),
      `${momentum(r.angular)}${r.balanced ? '' : ' (moments do not balance)'}`,
      r.ending || 'all periods'
    ]),
    'Relative to the energy of the start, and to the momentum that all of it could make.'
  );
}

function slopeTable(loops) {
  const kinds = [...new Set(loops.map((l) => l.kind))];
  const cell = (formulation, kind) => {
    const l = loops.find((o) => o.formulation === formulation && o.kind === kind);
    return isNumber(l?.slope) ? short(l.slope, 4) : 'none';
  };
  return plainTable(
    'Order of the loop work',
    [{text: 'formulation'}, ...kinds.map((k) => ({text: kindLabel(k), number: true}))],
    unique(loops).map((f) => [f, ...kinds.map((k) => cell(f, k))]),
    'Net work ~ amplitude to this power, from 0.0125 to 0.025; none: no net work beyond rounding.'
  );
}

/** A chart whose rows are chosen by one field, with a legend that isolates a formulation. */
class Panel {
  constructor(chart, rows, specOf, tableOf) {
    Object.assign(this, {chart, rows, specOf, tableOf, only: null, table: h('div')});
    this.legend = isolate(
      'Isolate a formulation',
      unique(rows).map((n) => ({key: n, label: n, swatch: swatch(look(n))})),
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

function runsPart(energy) {
  const chart = new Chart(
    'energy-runs',
    'Largest relative energy change so far against the number of periods, one line per formulation, both axes logarithmic.'
  );
  const panel = new Panel(chart, energy.runs, runsSpec, driftTable);
  const of = (scenario) => energy.runs.filter((r) => r.scenario === scenario);
  panel.show(of(energy.scenarios[0].name));
  const {order, steps_per_fastest: steps} = energy.integrator;
  return [
    choice(
      'Bodies',
      energy.scenarios.map((s) => ({key: s.name, label: s.title})),
      energy.scenarios[0].name,
      (key) => panel.show(of(key))
    ),
    panel.legend,
    chart.box,
    h(
      'figcaption',
      {},
      `Symplectic splitting of order ${order}, ${steps} steps in the fastest period. With a potential the change is the integrator’s own and stays bounded; without one it is the joint’s: kinetic energy and the law’s own. `,
      'Of one body on a clamped joint it wanders within bounds; of two free bodies, whose motion is chaotic, it grows: a cross marks where a run had to end.'
    ),
    panel.table
  ];
}

function loopsPart(energy) {
  const chart = new Chart(
    'energy-loops',
    'Net work round a closed loop over the turnover against the amplitude of the loop, one line per formulation, both axes logarithmic.'
  );
  const panel = new Panel(chart, energy.loops, loopsSpec, () => slopeTable(energy.loops));
  const kinds = [...new Set(energy.loops.map((l) => l.kind))];
  const of = (kind) => energy.loops.filter((l) => l.kind === kind);
  panel.show(of(kinds[0]));
  return [
    h('h4', {}, 'Work round closed loops, over the amplitude'),
    choice(
      'Kind',
      kinds.map((k) => ({key: k, label: kindLabel(k)})),
      kinds[0],
      (key) => panel.show(of(key))
    ),
    panel.legend,
    chart.box,
    h(
      'figcaption',
      {},
      'A generic loop of poses, loads in double. A conservative joint shows rounding alone, and at the widest loops what the quadrature leaves: there they pass the singular angle of some measures. The orders are held at 50 digits by loop_order.'
    ),
    panel.table
  ];
}

export function energyFigure(results) {
  const energy = results.stability?.energy;
  const title = h('h3', {}, 'Energy in motion');
  if (!energy?.runs?.length) {
    const chart = new Chart('energy-runs', 'Energy change over the periods.');
    chart.empty('no stability.energy in the results.');
    return h('figure', {id: 'energy'}, title, chart.box);
  }
  return h(
    'figure',
    {id: 'energy', class: 'wide'},
    title,
    runsPart(energy),
    energy.loops?.length ? loopsPart(energy) : null
  );
}
