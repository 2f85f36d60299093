// Which formulation? Accuracy against cost, the catalog, how far it holds, what each keeps.
import {accuracyFigure} from '../charts/accuracy.js';
import {formulationsTable} from './formulations_table.js';
import {propertyMatrix} from './matrix.js';
import {rangesTable} from './ranges.js';

/** @type {(results: any, kind: string) => import('../parts.js').PartSpec[]}
 * @param {import('../data.js').Results} results
 */
export const whichParts = (results, kind) => [
  {
    id: 'accuracy',
    title: 'Accuracy against speed, at small angles',
    charts: ['accuracy'],
    build: () => accuracyFigure(results, kind)
  },
  {id: 'ranges', title: 'Up to which load and angle it holds', build: () => rangesTable(results)},
  {id: 'formulations', title: 'The formulations', build: () => formulationsTable(results)},
  {id: 'properties', title: 'What each formulation keeps', build: () => propertyMatrix(results)}
];
