// How far each formulation's second-order couplings are from each 3D body's, beside its cost.
import {h, scrolling} from '../dom.js';
import {nanoseconds, short} from '../format.js';
import {bodyLabel, GROUPS} from '../solids_data.js';
import {rangeTable} from './solids_ranges.js';

const kKind = 'linear_angular';

function cell(results, name, body, group) {
  const m = results.solidError(name, kKind, {body, group});
  if (m.reason) return h('td', {class: 'number none', title: m.reason}, '–');
  return h(
    'td',
    {class: 'number', title: m.note},
    m.value > m.floor ? short(m.value) : `< ${short(m.floor)}`
  );
}

export function formulationErrors(results) {
  const part = h(
    'div',
    {class: 'part', id: 'solids-formulations'},
    h('h3', {}, 'Formulations against the 3D bodies')
  );
  const {bodies, groups} = results.solidViews();
  if (!bodies.length) {
    part.append(
      h(
        'p',
        {class: 'empty'},
        'Not shown: the results hold no finding <formulation>/linear_angular/fe_<body>_<loads>.'
      )
    );
    return part;
  }
  const shown = GROUPS.filter((g) => groups.includes(g.key));
  const head = h(
    'thead',
    {},
    h(
      'tr',
      {},
      h('th', {scope: 'col', rowspan: 2}, 'formulation'),
      h('th', {scope: 'col', rowspan: 2, class: 'number'}, 'residual, ns'),
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
    return t && !t.wrong ? nanoseconds(t.ns) : '–';
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
    'Relative error of the second-order couplings, the motion by the product of two loads, of a linear/angular joint that has the body’s own compliance. 1: as far off as a joint without any; a free ξ is the best one. ',
    'As a picture: ',
    h('a', {href: '#accuracy'}, 'Accuracy against speed'),
    ', error “3D bodies”. –: left out; the reason is under ',
    h('a', {href: '#left-out'}, 'Failed or left out'),
    '.'
  );
  const errors = scrolling(
    h(
      'table',
      {class: 'compact narrow'},
      h('caption', {}, 'Error of the second-order couplings'),
      head,
      body
    ),
    'Formulations against the 3D bodies'
  );
  part.append(h('div', {class: 'beside'}, errors, rangeTable(results) ?? ''), note);
  return part;
}
