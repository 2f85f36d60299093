// Energy in motion: its change over thousands of periods per formulation, and the drifts as a table
// (results.stability.energy.runs).
import {Chart} from '../../chart.js';
import {choice, h, plainTable} from '../../dom.js';
import {isNumber, short} from '../../format.js';
import {Absent} from '../../parts.js';
import {linesSpec, logAxis, logChannel, RowsPanel} from '../log_lines.js';

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
  const y = logChannel('change', 'largest energy change until then, relative');
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

/** @param {import('../../data.js').Results} results */
export function energyFigure(results) {
  const energy = results.stability?.energy;
  if (!energy?.runs?.length) return new Absent('the results hold no bodies in motion (stability.energy)');
  const chart = new Chart(
    'energy-runs',
    'Largest relative energy change so far against the number of periods, one line per ' +
      'formulation, both axes logarithmic.'
  );
  const panel = new RowsPanel(chart, energy.runs, runsSpec, driftTable);
  const of = (scenario) => energy.runs.filter((r) => r.scenario === scenario);
  panel.show(of(energy.scenarios[0].name));
  const {order, steps_per_fastest: steps} = energy.integrator;
  return h(
    'figure',
    {},
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
      'Of one body on a clamped joint it wanders within bounds; of two free bodies, whose motion ' +
        'is chaotic, it grows, and of a chain, whose every joint makes some, within a few periods of its slowest ' +
        'mode: a cross marks where a run had to end.'
    ),
    panel.table
  );
}
