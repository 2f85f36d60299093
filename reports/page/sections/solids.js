// The 3D truth: our own nonlinear finite elements beside the print, with error bars, cost and pictures.
import {account} from '../chart.js';
import {costFigure} from '../charts/solids_cost.js';
import {newtonFigure} from '../charts/solids_newton.js';
import {shapeFigure} from '../charts/solids_shape.js';
import {h} from '../dom.js';
import {isNumber, short} from '../format.js';
import {bodyLabel, paperXi, solidsOf} from '../solids_data.js';
import {bearingPart} from './solids_bearing.js';
import {formulationErrors} from './solids_formulations.js';
import {printedTables} from './solids_tables.js';
import {xiTable} from './solids_xi.js';

/** Each body's widest error bars, in words. */
function certainty(solids) {
  const widest = (list) => short(Math.max(...list.filter(isNumber)));
  const known = solids.bodies
    .filter((b) => b.compliances?.length && b.xis?.length)
    .map(
      (b) =>
        `${bodyLabel(b.name)} ${widest(b.compliances.map((c) => c.uncertainty / Math.abs(c.value)))} and ` +
        widest(b.xis.map((x) => paperXi(b, x.law)?.uncertainty))
    );
  return known.length ? `Widest error bars of compliance (relative) and ξ: ${known.join('; ')}.` : '';
}

function shapes(solids) {
  if (!solids.shapes.length) {
    account('solids-shapes', 'empty');
    return h('p', {class: 'empty'}, 'No deformed shapes: the results hold none (solids.shapes).');
  }
  return h('div', {class: 'shapes', id: 'solids-shapes'}, solids.shapes.map(shapeFigure));
}

function absent(solids) {
  if (!solids.missing.length) return null;
  return h(
    'p',
    {class: 'note'},
    'Not computed, or computed from other inputs than today’s: ',
    solids.missing.map((m, i) => [i ? '; ' : '', h('code', {}, m.study), ` (${m.what})`]),
    '.'
  );
}

export function solidsSection(results) {
  const solids = solidsOf(results);
  const section = h(
    'section',
    {class: 'solids', 'aria-labelledby': 'solids'},
    h('h2', {id: 'solids'}, 'Three-dimensional truth')
  );
  if (!solids.given) {
    section.append(h('p', {class: 'empty'}, 'Not shown: the results hold no 3D finite elements (solids).'));
    return section;
  }
  section.append(
    h(
      'p',
      {class: 'statement'},
      'Geometrically nonlinear finite elements with rigid end faces, extrapolated over meshes: the reference that the formulations are held against. ',
      certainty(solids)
    ),
    absent(solids) ?? '',
    shapes(solids),
    printedTables(results, solids),
    xiTable(results, solids),
    formulationErrors(results),
    bearingPart(solids),
    h('div', {class: 'figures part'}, costFigure(solids), newtonFigure(solids))
  );
  return section;
}
