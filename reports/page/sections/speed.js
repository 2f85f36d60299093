// Speed: what to use, what accuracy costs, how near to the hardware's limit; in order of use.
import {batchSizeFigure} from '../charts/batch_size.js';
import {digitsFigure} from '../charts/digits.js';
import {rooflineFigure} from '../charts/roofline.js';
import {tangentFigure} from '../charts/tangent_methods.js';
import {workPrecisionFigure} from '../charts/work_precision.js';
import {h} from '../dom.js';
import {cheapestTable} from './speed_cheapest.js';
import {competitorsTable, instructionsTable, publishedTable, targetsTable} from './speed_targets.js';

export function speedSection(results, kind) {
  const {machine, compiler} = results.context;
  return h(
    'section',
    {class: 'speed', 'aria-labelledby': 'speed'},
    h('h2', {id: 'speed'}, 'Speed'),
    h(
      'p',
      {class: 'note'},
      `Medians of one run on ${machine}, ${compiler}; every time is of code that was first checked at 50 digits.`
    ),
    cheapestTable(results),
    workPrecisionFigure(results, kind),
    digitsFigure(results),
    tangentFigure(results),
    batchSizeFigure(results),
    rooflineFigure(results),
    h(
      'div',
      {class: 'columns'},
      targetsTable(results),
      publishedTable(results),
      competitorsTable(results),
      instructionsTable(results)
    )
  );
}
