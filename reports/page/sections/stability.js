// Where methods fail, and how: the atlas first, then each failure's own chart.
import {atlasFigure} from '../charts/atlas.js';
import {basinsFigure} from '../charts/basins.js';
import {criticalLoadsFigure} from '../charts/critical_loads.js';
import {energyFigure} from '../charts/energy.js';
import {pathsFigure} from '../charts/paths.js';
import {rangeFigure} from '../charts/range.js';
import {h} from '../dom.js';

export function stabilitySection(results) {
  return h(
    'section',
    {class: 'stability', 'aria-labelledby': 'stability'},
    h('h2', {id: 'stability'}, 'Where methods fail'),
    atlasFigure(results),
    h(
      'div',
      {class: 'figures'},
      pathsFigure(results),
      criticalLoadsFigure(results),
      energyFigure(results),
      basinsFigure(results)
    ),
    rangeFigure(results)
  );
}
