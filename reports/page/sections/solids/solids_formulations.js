// How far each formulation's second-order couplings are from each 3D body's, beside its cost.
import {solidErrorOf} from '../../data/accuracy_data.js';
import {h, scrolling} from '../../dom.js';
import {nanoseconds, short} from '../../format.js';
import {bodyLabel, GROUPS} from '../../data/solids_data.js';
import {Absent} from '../../parts.js';

const kKind = 'linear_angular';

/** @param {import('../../data.js').Results} results */
function cell(results, name, body, group) {
  const m = solidErrorOf(results, name, kKind, {body, group});
  if (m.reason !== undefined) return h('td', {class: 'number none', title: m.reason}, '–');
  return h(
    'td',
    {class: 'number', title: m.note},
    m.value > m.floor ? short(m.value) : `< ${short(m.floor)}`
  );
}

/** @param {import('../../data.js').Results} results */
export function formulationErrors(results) {
  const {bodies, groups} = results.solidViews();
  if (!bodies.length) {
    return new Absent('the results hold no finding <formulation>/linear_angular/fe_<body>_<loads>');
  }
  const shown = GROUPS.filter((g) => groups.includes(g.key));
  const head = h(
    'thead',
    {},
    h(
      'tr',
      {},
      h('th', {scope: 'col', rowspan: 2}, 'formulation'),
      h('th', {scope: 'col', rowspan: 2, class: 'number'}, 'ns, kernel or T, without tangent'),
      bodies.map((b) => h('th', {scope: 'colgroup', colspan: shown.length, class: 'number'}, bodyLabel(b)))
    ),
    h(
      'tr',
      {},
      bodies.flatMap(() => shown.map((g) => h('th', {scope: 'col', class: 'number'}, g.label)))
    )
  );
  const time = (name) => {
    const t = results.preferred(name, kKind, 'residual');
    if (!t || t.wrong) return '–';
    return `${nanoseconds(t.ns)}${t.implementation === 'kernel' ? '' : ' T'}`;
  };
  const body = h(
    'tbody',
    {},
    results.formulations.map((f) =>
      h(
        'tr',
        {},
        h('th', {scope: 'row'}, h('code', {}, f.name)),
        h('td', {class: 'number'}, time(f.name)),
        bodies.flatMap((b) => shown.map((g) => cell(results, f.name, b, g.key)))
      )
    )
  );
  const note = h(
    'p',
    {class: 'note'},
    'Relative error of the second-order couplings, the motion by the product of two loads, of a ' +
      'linear/angular joint that has the body’s own compliance. 1: as far off as a joint without ' +
      'any; a free ξ is the best one. T: time of the transcription, where there is no kernel. ',
    'As a picture: ',
    h('a', {href: '#accuracy'}, 'Accuracy against speed'),
    ', error “3D bodies”. –: left out; the reason is under ',
    h('a', {href: '#left-out'}, 'Failed or left out'),
    '.'
  );
  const table = scrolling(
    h(
      'table',
      {class: 'compact narrow'},
      h('caption', {}, 'Error of the second-order couplings'),
      head,
      body
    ),
    'Formulations against the 3D bodies'
  );
  return [table, note];
}
