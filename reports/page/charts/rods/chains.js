// Chains of joints against the rod: error over the number of links, or over the time of one solution
// (results.rods.chains.orders).
import {Chart} from '../../chart.js';
import {chainName, chainRows} from '../../data/rods_data.js';
import {choice, h, plainTable} from '../../dom.js';
import {isNumber, short} from '../../format.js';
import {Absent} from '../../parts.js';
import {linesSpec, logAxis, logChannel, namesOf, RowsPanel} from '../log_lines.js';

const ACROSS = {
  links: {title: 'links of the chain', axis: {values: [8, 16, 32, 64, 128, 256]}},
  ms: {title: 'time of one solution, ms', axis: logAxis(9)}
};

const specOver = (across) => (rows, only) => {
  const x = {
    field: across,
    title: ACROSS[across].title,
    scale: {type: 'log', nice: false, padding: 12},
    axis: ACROSS[across].axis
  };
  const y = logChannel('error', 'distance of the tip from the rod’s, over L');
  const tooltip = [
    {field: 'formulation'},
    {field: 'links'},
    {field: 'error', format: '.3g'},
    {field: 'ms', title: 'ms', format: '.3g'},
    {field: 'iterations'},
    {field: 'order', title: 'observed order', format: '.3f'}
  ];
  return linesSpec(rows, x, y, only, tooltip, (encoding) => [
    {mark: {type: 'point', filled: true, size: 22}, encoding}
  ]);
};

/**
 * @param {import('../../data.js').Results} results
 * @param {'links' | 'ms'} across
 */
function chainFigure(results, across, id, label, caption) {
  const rows = chainRows(results.rods);
  if (!rows.length) return new Absent('the results hold no chains (rods.chains)');
  const rods = [...new Set(rows.map((r) => r.rod))];
  const panel = new RowsPanel(new Chart(id, label), rows, specOver(across), () => '');
  const of = (rod) => rows.filter((r) => r.rod === rod);
  panel.show(of(rods[0]));
  return h(
    'figure',
    {},
    choice(
      'Rod',
      rods.map((key) => ({key, label: chainName(key)})),
      rods[0],
      (rod) => panel.show(of(rod))
    ),
    panel.legend,
    panel.chart.box,
    h('figcaption', {}, caption)
  );
}

/** @param {import('../../data.js').Results} results */
export const chainOrderFigure = (results) =>
  chainFigure(
    results,
    'links',
    'chain-order',
    'Distance of a chain’s tip from the rod’s over the number of links, one line per formulation, logarithmic.',
    'A rod as N rigid links with a joint at the middle of each. A law of the half-way frame tends to the rod with ' +
      '1/N², a law at a node with 1/N, too stiff at one node and too soft at the other; a rod’s own energy with ' +
      '1/N⁴ where the rod is straight and slender.'
  );

/** @param {import('../../data.js').Results} results */
export const chainWorkFigure = (results) =>
  chainFigure(
    results,
    'ms',
    'chain-work',
    'Distance of a chain’s tip from the rod’s over the time of one solution, one line per formulation, logarithmic.',
    'The same chains over the processor time of one solution from rest, all load at once. Each was solved once: ' +
      'times are good to a factor of two.'
  );

/** @param {import('../../data.js').Results} results */
export function orderTable(results) {
  const orders = results.rods.chains?.orders ?? [];
  if (!orders.length) return new Absent('the results hold no chains (rods.chains)');
  const rods = [...new Set(orders.map((o) => o.rod))];
  const cell = (formulation, rod) => {
    const o = orders.find((x) => x.formulation === formulation && x.rod === rod);
    if (!o || !isNumber(o.order)) return '–';
    return `${o.order.toFixed(3)} ± ${short(o.order_bar, 1)}`;
  };
  return plainTable(
    'Observed orders of chains',
    [{text: 'formulation'}, ...rods.map((r) => ({text: chainName(r), number: true}))],
    namesOf(orders).map((f) => [f, ...rods.map((r) => cell(f, r))]),
    'Power of 1/N with which the tip tends to the rod’s, from 128 to 256 links; ±: its change from the doubling ' +
      'before, and what the digits of the rod leave open.'
  );
}

/** @param {import('../../data.js').Results} results */
export function tangentTable(results) {
  const all = results.rods.chains?.tangents ?? [];
  if (!all.length) return new Absent('the results hold no tangents of chains (rods.chains)');
  const names = all[0].costs.map((c) => c.tangent);
  const cell = (c) =>
    !c ? '–' : c.converged ? `${c.iterations} in ${c.load_steps}, ${short(c.ms, 2)} ms` : 'does not arrive';
  return plainTable(
    'What a wrong tangent costs',
    [{text: 'formulation'}, ...names.map((n) => ({text: n.replaceAll('_', ' '), number: true}))],
    all.map((t) => [t.formulation, ...names.map((n) => cell(t.costs.find((c) => c.tangent === n)))]),
    'The same chain of 64 links, straight and anisotropic, solved by Newton with the exact tangent and with others: ' +
      'iterations in load steps (the fewest of 1, 4, 16, 64, 256 that arrive), and the time. attached: the tangent ' +
      'of attached_a, which is what MBDyn’s invariant joints take.'
  );
}
