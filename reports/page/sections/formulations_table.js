// One line per formulation: what it is, how true, how fast, what it keeps.
import {KINDS, modellingOf} from '../data/accuracy_data.js';
import {holds, VERDICTS} from '../data.js';
import {h, scrolling, swatch} from '../dom.js';
import {nanoseconds, short} from '../format.js';
import {look} from '../palette.js';
import {implementationLabel} from '../data/speed_data.js';
import {signNote, TIMES_NOTE} from './notes.js';

const SHORT = {angular: 'ang.', linear: 'lin.', linear_angular: 'l/a'};

/** @param {import('../data.js').Results} results */
function errorCell(results, name, kind) {
  const m = modellingOf(results, name, kind);
  if (m.reason !== undefined) return h('td', {class: 'number none', title: m.reason}, '–');
  const floored = !(m.value > m.floor);
  return h(
    'td',
    {class: 'number', title: floored ? `${short(m.value, 3)}, below the uncertainty of the truth` : m.note},
    floored ? `< ${short(m.floor)}` : short(m.value)
  );
}

/** Of the kernel; T: where there is none, of the transcription.
 * @param {import('../data.js').Results} results
 */
function timeCell(results, name, kind) {
  const timing = results.preferred(name, kind, 'residual');
  if (!timing) return h('td', {class: 'number none', title: 'not timed'}, '–');
  if (timing.wrong) return h('td', {class: 'number fail', title: timing.message}, 'wrong');
  const title = `${implementationLabel(timing.implementation)}, spread ${short(100 * timing.spread, 1)} %`;
  const mark = timing.implementation === 'kernel' ? '' : ' T';
  return h('td', {class: 'number', title}, nanoseconds(timing.ns), mark);
}

/** Yes, or no with the kinds that fail and their values; over all kinds that were measured.
 * @param {import('../data.js').Results} results
 */
function propertyCell(results, name, property) {
  const measured = KINDS.flatMap((kind) => {
    const finding = results.finding(name, kind.key, property);
    return finding && holds(finding) ? [{kind, finding}] : [];
  });
  if (!measured.length) return h('td', {class: 'mark none', title: 'not measured'}, '–');
  const broken = measured.filter((m) => holds(m.finding) === 'no');
  if (!broken.length) return h('td', {class: 'mark pass', title: 'holds for every kind measured'}, '✓ yes');
  const failed = broken.some((m) => m.finding.verdict === 'fail');
  const text =
    broken.length === measured.length ? 'no' : `not ${broken.map((m) => SHORT[m.kind.key]).join(', ')}`;
  const title = broken
    .map((m) => `${m.kind.label}: ${short(m.finding.value, 3)} (${VERDICTS[m.finding.verdict].label})`)
    .join('\n');
  return h(
    'td',
    {class: `mark ${failed ? 'fail' : 'known_failure'}`, title},
    `${failed ? '✗' : '≈'} ${text}`
  );
}

/** @param {import('../data.js').Results} results */
export function formulationsTable(results) {
  const head = h(
    'thead',
    {},
    h(
      'tr',
      {},
      h('th', {scope: 'col', rowspan: 2}, 'formulation'),
      h('th', {scope: 'colgroup', colspan: 3}, 'modelling error at small angles'),
      h('th', {scope: 'colgroup', colspan: 3}, 'ns, without tangent'),
      h(
        'th',
        {scope: 'col', rowspan: 2, title: 'exchanging nodes a and b changes nothing'},
        'node order free'
      ),
      h('th', {scope: 'col', rowspan: 2, title: 'no work round a closed loop'}, 'conser­vative'),
      h('th', {scope: 'col', rowspan: 2, title: 'the moments on the two nodes balance'}, 'moments balance')
    ),
    h(
      'tr',
      {},
      [0, 1].flatMap(() => Object.values(SHORT).map((t) => h('th', {scope: 'col', class: 'number'}, t)))
    )
  );
  const body = h(
    'tbody',
    {},
    results.formulations.map((f) =>
      h(
        'tr',
        {},
        h(
          'th',
          {scope: 'row'},
          h(
            'span',
            {class: 'name'},
            swatch({color: look(f.name).color, shape: 'circle'}),
            h('code', {}, f.name)
          ),
          h('span', {class: 'about'}, f.stands_for, f.needs_xi ? `; here ξ = ${f.probe_xi}` : '')
        ),
        KINDS.map((k) => errorCell(results, f.name, k.key)),
        KINDS.map((k) => timeCell(results, f.name, k.key)),
        propertyCell(results, f.name, 'node_order'),
        propertyCell(results, f.name, 'loop_work'),
        propertyCell(results, f.name, 'moment_balance')
      )
    )
  );
  return [
    scrolling(h('table', {class: 'compact formulations'}, head, body), 'Table of formulations'),
    h(
      'p',
      {class: 'note'},
      '≈: measured, known and held in a band. <: below the uncertainty of the truth. l/a: linear/angular. ',
      '–: not measured; the reason is under ',
      h('a', {href: '#left-out'}, 'Failed or left out'),
      '. ',
      'Times are of the kernel; T: of the transcription, where there is no kernel. ',
      TIMES_NOTE,
      signNote()
    )
  ];
}
