// Who is right? The print, other programs and our own 3D bodies.
import {sceneFigure} from '../charts/scene.js';
import {costFigure} from '../charts/solids/solids_cost.js';
import {newtonFigure} from '../charts/solids/solids_newton.js';
import {figuresOf} from '../data/figures_data.js';
import {solidsOf} from '../data/solids_data.js';
import {programsTable} from './programs.js';
import {saboteursTable} from './saboteurs.js';
import {bodiesPart} from './solids/solids.js';
import {bearingPart} from './solids/solids_bearing.js';
import {formulationErrors} from './solids/solids_formulations.js';
import {printedTables} from './solids/solids_tables.js';
import {xiTable} from './solids/solids_xi.js';
import {table1} from './table1.js';

/** @type {(results: any) => import('../parts.js').PartSpec[]}
 * @param {import('../data.js').Results} results
 */
const sceneParts = (results) =>
  figuresOf(results).map((figure) => ({
    id: figure.id,
    title: figure.scene.title,
    charts: [figure.id],
    half: true,
    build: () => sceneFigure(results, figure)
  }));

/** @type {(results: any) => import('../parts.js').PartSpec[]}
 * @param {import('../data.js').Results} results
 */
function solidParts(results) {
  const solids = solidsOf(results);
  return [
    {
      id: 'solids',
      title: 'The bodies in three dimensions',
      charts: solids.shapes.map((s) => `solids-shape-${s.name}`),
      build: () => bodiesPart(solids)
    },
    {
      id: 'solids-tables',
      title: 'Tables 2 and 3, beside the print',
      build: () => printedTables(results, solids)
    },
    {id: 'solids-xi', title: 'ξ of each body and material law', build: () => xiTable(results, solids)},
    {
      id: 'solids-formulations',
      title: 'Formulations against the 3D bodies',
      build: () => formulationErrors(results)
    },
    {
      id: 'solids-bearing',
      title: 'The bearing of Table 4: which geometry, which ξ?',
      charts: ['solids-bearing'],
      build: () => bearingPart(solids)
    },
    {
      id: 'solids-cost',
      title: 'What accuracy costs in three dimensions',
      charts: ['solids-cost'],
      half: true,
      build: () => costFigure(solids)
    },
    {
      id: 'solids-newton',
      title: 'What a nonlinear solve costs',
      charts: ['solids-newton-seconds', 'solids-newton-megabytes'],
      half: true,
      build: () => newtonFigure(solids)
    }
  ];
}

/** @type {(results: any) => import('../parts.js').PartSpec[]}
 * @param {import('../data.js').Results} results
 */
export const truthParts = (results) => [
  {id: 'table1', title: 'Table 1: the skewed torque, beside the print', build: () => table1(results)},
  ...sceneParts(results),
  ...solidParts(results),
  {
    id: 'programs',
    title: 'What real programs compute',
    optional: true,
    build: () => programsTable(results)
  },
  {
    id: 'saboteurs',
    title: 'What each check was seen to fail for',
    optional: true,
    build: () => saboteursTable(results)
  }
];
