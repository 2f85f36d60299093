// Up to which load each formulation follows the nonlinear 3D curve.
import {h, scrolling} from '../dom.js';
import {short} from '../format.js';

const RANGE = /^(.+)\/(\w+)\/fe_range_(\w+)$/;

/** Finding of the load within 1 %; the load within 5 % is in its `parameter`. */
function rangeCell(finding) {
  if (!finding) return h('td', {class: 'number none'}, '–');
  if (finding.verdict === 'left_out') return h('td', {class: 'number none', title: finding.reason}, '–');
  const five = finding.parameter.match(/within 5 % up to ([^;,]+)/)?.[1];
  return h(
    'td',
    {class: 'number', title: `${finding.parameter}. ${finding.reason}`},
    short(finding.value, 3),
    five ? ` / ${short(Number(five), 3)}` : ''
  );
}

/** Undefined when the results hold no such finding. */
export function rangeTable(results) {
  const found = results.findings
    .map((f) => ({finding: f, parts: f.name.match(RANGE)}))
    .filter((f) => f.parts);
  if (!found.length) return undefined;
  const studies = [...new Set(found.map((f) => f.parts[3]))];
  const of = (name, study) => found.find((f) => f.parts[1] === name && f.parts[3] === study)?.finding;
  const unit = (study) => found.find((f) => f.parts[3] === study && f.finding.unit)?.finding.unit;
  return scrolling(
    h(
      'table',
      {class: 'compact narrow'},
      h(
        'caption',
        {},
        'Load up to which θ₂ is within 1 % / 5 % of the 3D curve; 0: not even at its first load'
      ),
      h(
        'thead',
        {},
        h(
          'tr',
          {},
          h('th', {scope: 'col'}, 'formulation'),
          studies.map((s) =>
            h('th', {scope: 'col', class: 'number wrap'}, `${s.replaceAll('_', ' under ')}, ${unit(s)}`)
          )
        )
      ),
      h(
        'tbody',
        {},
        results.formulations.map((f) =>
          h(
            'tr',
            {},
            h('th', {scope: 'row'}, h('code', {}, f.name)),
            studies.map((s) => rangeCell(of(f.name, s)))
          )
        )
      )
    ),
    'Ranges of load'
  );
}
