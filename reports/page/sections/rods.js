// Large rotation: who follows the rod?
import {chainOrderFigure, chainWorkFigure, orderTable, tangentTable} from '../charts/rods/chains.js';
import {followFigure} from '../charts/rods/follow.js';
import {reachFigure} from '../charts/rods/reach.js';
import {crossed, rodName} from '../data/rods_data.js';
import {h, plainTable} from '../dom.js';
import {isNumber, percent, short} from '../format.js';
import {Absent} from '../parts.js';

/** @typedef {import('../data.js').Results} Results */

const formulation = {text: 'formulation'};
const numbers = (/** @type {string[]} */ titles) => titles.map((text) => ({text, number: true}));

/** @param {Results} results */
function randomTables(results) {
  const random = results.rods.random ?? [];
  if (!random.length) return new Absent('the results hold no random moments (rods.random)');
  const cell = (/** @type {import('../results').MedianError} */ row) =>
    isNumber(row.median) ? percent(row.median) : `${row.lost} of ${row.of} lost`;
  const table = (/** @type {string} */ drawn, /** @type {string} */ title, /** @type {string} */ note) => {
    const columns = random.filter((r) => r.drawn === drawn);
    const heads = columns.map((c) => `${rodName(c.stiffness)}, ${c.size} rad`);
    return plainTable(title, [formulation, ...numbers(heads)], crossed(columns, cell), note);
  };
  return h(
    'div',
    {},
    table(
      'moment',
      'Moments of random direction',
      'Median of the turn between the ends of joint and rod over the turn of the rod, for rods of these stiffness ' +
        'ratios at |K⁻¹m| = 0.2 and 1 rad. The moment has a random direction, so that the soft axis turns most. Of ' +
        'rod4 and rod34 the errors are those of their equations: what solves refuses them beyond their convex range.'
    ),
    table(
      'turn',
      'Turns of random direction',
      'The same where the turn K⁻¹m has a random direction, which takes large moments about the stiff axes: what ' +
        'one joint cannot do at a ratio of 36 or 100 shows here.'
    )
  );
}

/** @param {Results} results */
function semiTangentialTable(results) {
  const columns = results.rods.semi_tangential ?? [];
  if (!columns.length)
    return new Absent('the results hold no critical moments of rods (rods.semi_tangential)');
  const heads = columns.map((c) => `${rodName(c.stiffness)}: rod ${short(c.rod, 4)} N·m`);
  return plainTable(
    'Critical moment of one joint over that of the rod',
    [formulation, ...numbers(heads)],
    crossed(columns, (row) => (isNumber(row.ratio) ? short(row.ratio, 3) : 'none')),
    'A semi-tangential moment about the axis of the rod is conservative, so that rod and joint both have a critical ' +
      'one. 1 is right. A strip buckles laterally by a term of its energy, of fourth order in the rotation, that ' +
      'rod4 and rod34 alone have.'
  );
}

/** @param {Results} results */
function forceTable(results) {
  const columns = results.rods.force ?? [];
  if (!columns.length) return new Absent('the results hold no forces on rods (rods.force)');
  const at = (/** @type {import('../results').EndForce} */ c) => c.force.indexOf(0.1);
  const cell = (/** @type {any} */ row, /** @type {import('../results').EndForce} */ c) =>
    `${percent(row.error[at(c)])} (${isNumber(row.order) ? (Math.round(10 * row.order) / 10 + 0).toFixed(1) : '–'})`;
  const heads = columns.map((c) => `force on the ${c.where === 'tip' ? 'tip' : 'special point'}`);
  return plainTable(
    'A dead force on a slender rod',
    [formulation, ...numbers(heads)],
    crossed(columns, cell),
    'Error of the rotation at 0.1 EI/L², and the power of the load with which it grows: 0 is an error that stays ' +
      'however small the load. At the special point, mid-length, the rotation begins at second order: a law at a ' +
      'node misses it. At the tip every law lacks the rod’s cubic terms. The rod is 10⁷ times stiffer along its axis ' +
      'than across: fasse, whose axial stiffness acts along both nodes’ axes, locks.'
  );
}

/** @type {(results: Results) => import('../parts.js').PartSpec[]} */
export const rodParts = (results) => [
  {
    id: 'rod-reach',
    title: 'How far one joint stays with the rod',
    charts: ['rod-reach'],
    half: true,
    build: () => reachFigure(results)
  },
  {
    id: 'rod-follow',
    title: 'Its error on the way',
    charts: ['rod-follow'],
    half: true,
    build: () => followFigure(results)
  },
  {id: 'rod-random', title: 'Moments of any direction', build: () => randomTables(results)},
  {
    id: 'rod-critical',
    title: 'Buckling that a rod has',
    half: true,
    build: () => semiTangentialTable(results)
  },
  {id: 'rod-force', title: 'Forces', half: true, build: () => forceTable(results)},
  {
    id: 'chain-order',
    title: 'Chains of joints: how fast they tend to the rod',
    charts: ['chain-order'],
    half: true,
    build: () => chainOrderFigure(results)
  },
  {
    id: 'chain-work',
    title: 'Chains: error against time',
    charts: ['chain-work'],
    half: true,
    build: () => chainWorkFigure(results)
  },
  {id: 'chain-orders', title: 'Observed orders', half: true, build: () => orderTable(results)},
  {id: 'chain-tangents', title: 'What a wrong tangent costs', build: () => tangentTable(results)}
];
