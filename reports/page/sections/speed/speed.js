// How fast? What to use, what accuracy costs, how near to the hardware's limit; in order of use.
import {assemblyFigure} from '../../charts/speed/assembly.js';
import {batchSizeFigure} from '../../charts/speed/batch_size.js';
import {digitsFigure} from '../../charts/stability/digits.js';
import {rooflineFigure} from '../../charts/speed/roofline.js';
import {tangentFigure} from '../../charts/speed/tangent_methods.js';
import {workPrecisionFigure} from '../../charts/speed/work_precision.js';
import {h} from '../../dom.js';
import {signNote, TIMES_NOTE} from '../notes.js';
import {cheapestTable} from './speed_cheapest.js';
import {competitorsTable, instructionsTable, publishedTable, targetsTable} from './speed_targets.js';

/** @type {(results: any) => Node} */
export const speedNote = ({context: {machine, compiler}}) =>
  h(
    'p',
    {class: 'note'},
    `Medians of one run on ${machine}, ${compiler}; every time is of code that was first checked at 50 digits. `,
    TIMES_NOTE,
    signNote()
  );

/** @type {(results: any, kind: string) => import('../../parts.js').PartSpec[]}
 * @param {import('../../data.js').Results} results
 */
export const speedParts = (results, kind) => [
  {id: 'cheapest', title: 'The cheapest sufficient model', build: () => cheapestTable(results)},
  {
    id: 'work-precision',
    title: 'Work and precision',
    charts: ['work-precision'],
    build: () => workPrecisionFigure(results, kind)
  },
  {
    id: 'digits',
    title: 'What each digit costs',
    charts: ['digits-error', 'digits-time'],
    build: () => digitsFigure(results)
  },
  {
    id: 'tangent',
    title: 'The tangent by method',
    charts: ['tangent-error', 'tangent-time'],
    build: () => tangentFigure(results)
  },
  {
    id: 'batch-size',
    title: 'Cost against the number of joints',
    charts: ['batch-size'],
    build: () => batchSizeFigure(results)
  },
  {
    id: 'assembly',
    title: 'From poses to a sparse matrix',
    charts: ['assembly'],
    build: () => assemblyFigure(results)
  },
  {
    id: 'roofline',
    title: 'Share of the hardware’s limit',
    charts: ['roofline'],
    build: () => rooflineFigure(results)
  },
  {id: 'targets', title: 'Targets', half: true, optional: true, build: () => targetsTable(results)},
  {
    id: 'published',
    title: 'Published figures',
    half: true,
    optional: true,
    build: () => publishedTable(results)
  },
  {
    id: 'competitors',
    title: 'Competitors in this run',
    half: true,
    optional: true,
    build: () => competitorsTable(results)
  },
  {
    id: 'instructions',
    title: 'Instructions',
    half: true,
    optional: true,
    build: () => instructionsTable(results)
  }
];
