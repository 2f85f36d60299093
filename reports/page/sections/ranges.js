// How far each formulation follows the nonlinear 3D bodies, in loads and degrees.
import {h, scrolling} from '../dom.js';
import {short} from '../format.js';
import {Absent} from '../parts.js';
import {farthest, rangesOf} from '../data/ranges_data.js';
import {signNote} from './notes.js';

const unitText = (unit) => unit.replace('N m', 'N·m');
const studyLabel = (study) => study.replaceAll('_', ' under ');

function reachCell(reach, title) {
  const load = `${reach.isWhole ? '≥ ' : ''}${short(reach.load, 3)}`;
  return h(
    'td',
    {class: 'number', title},
    load,
    reach.phi === undefined || reach.load === 0 ? '' : ` (${short(reach.phi, 2)}°)`
  );
}

function cells(range) {
  if (!range) return ['–', '–'].map((text) => h('td', {class: 'number none'}, text));
  const title = `${range.finding.parameter}. ${range.finding.reason}`;
  return [reachCell(range.one, title), reachCell(range.five, title)];
}

/** The best of each study, in words: beyond it no law is within 1 %. */
function limitOf(ranges, study) {
  const own = ranges.filter((r) => r.study === study);
  const {one, end, formulation} = /** @type {import('../data/ranges_data.js').Range} */ (
    farthest(own, 'one')
  );
  const angle = (reach) => (reach.phi === undefined || reach.load === 0 ? '' : `, ${short(reach.phi, 2)}°`);
  const load = (reach) => `${short(reach.load, 3)} ${unitText(own[0].unit)}${angle(reach)}`;
  const ended = `the 3D curve ends at ${load(end)}`;
  return one.isWhole
    ? `${studyLabel(study)}: ${formulation} is within 1 % to the end (${ended}).`
    : `${studyLabel(study)}: beyond ${load(one)} (${formulation}) no law is within 1 %; ${ended}.`;
}

/** @param {import('../data.js').Results} results */
export function rangesTable(results) {
  const ranges = rangesOf(results);
  if (!ranges.length)
    return new Absent('the results hold no finding <formulation>/<kind>/fe_range_<body>_<load>');
  const studies = [...new Set(ranges.map((r) => r.study))];
  const unit = (study) => unitText(ranges.find((r) => r.study === study)?.unit ?? '');
  const head = h(
    'thead',
    {},
    h(
      'tr',
      {},
      h('th', {scope: 'col', rowspan: 2}, 'formulation'),
      studies.map((s) =>
        h('th', {scope: 'colgroup', colspan: 2, class: 'number'}, `${studyLabel(s)}, ${unit(s)}`)
      )
    ),
    h(
      'tr',
      {},
      studies.flatMap(() =>
        ['within 1 %', 'within 5 %'].map((t) => h('th', {scope: 'col', class: 'number'}, t))
      )
    )
  );
  const row = ({name}) =>
    h(
      'tr',
      {},
      h('th', {scope: 'row'}, h('code', {}, name)),
      studies.flatMap((s) => cells(ranges.find((r) => r.formulation === name && r.study === s)))
    );
  return [
    scrolling(
      h('table', {class: 'compact narrow'}, head, h('tbody', {}, results.formulations.map(row))),
      'Ranges of load and angle'
    ),
    h(
      'p',
      {class: 'note'},
      'Load, and rotation of the 3D body in brackets, up to which the coupling θ₂ is within 1 % ' +
        'or 5 % of the body’s; ',
      '0: not even at its first load; ≥: to the end of the 3D curve. ',
      studies.map((s) => limitOf(ranges, s)).join(' '),
      ' ',
      signNote()
    )
  ];
}
