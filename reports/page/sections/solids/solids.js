// The 3D truth: our own nonlinear finite elements beside the print, with error bars, cost and pictures.
import {shapeFigure} from '../../charts/solids/solids_shape.js';
import {h} from '../../dom.js';
import {isNumber, short} from '../../format.js';
import {Absent} from '../../parts.js';
import {bodyLabel, paperXi} from '../../data/solids_data.js';

/** Each body's widest error bars, in words.
 * @param {ReturnType<typeof import('../../data/solids_data.js').solidsOf>} solids
 */
function certainty(solids) {
  const widest = (list) => short(Math.max(...list.filter(isNumber)));
  const known = solids.bodies
    .filter((b) => b.compliances?.length && b.xis?.length)
    .map((b) => {
      const relative = (b.compliances ?? []).map((c) => (c.uncertainty ?? NaN) / Math.abs(c.value ?? NaN));
      const xis = (b.xis ?? []).map((x) => paperXi(b, x.law)?.uncertainty);
      return `${bodyLabel(b.name)} ${widest(relative)} and ${widest(xis)}`;
    });
  return known.length ? `Widest error bars of compliance (relative) and ξ: ${known.join('; ')}.` : '';
}

/** @param {ReturnType<typeof import('../../data/solids_data.js').solidsOf>} solids */
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

/** @param {ReturnType<typeof import('../../data/solids_data.js').solidsOf>} solids */
export function bodiesPart(solids) {
  if (!solids.given) return new Absent('the results hold no 3D finite elements (solids)');
  return [
    h(
      'p',
      {class: 'statement'},
      'Geometrically nonlinear finite elements with rigid end faces, extrapolated over meshes: ' +
        'the reference that ',
      'the formulations are held against. ',
      certainty(solids)
    ),
    absent(solids),
    h('div', {class: 'shapes'}, solids.shapes.map(shapeFigure))
  ];
}
