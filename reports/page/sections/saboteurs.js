// What each sort of checks was seen to fail for: a check that cannot fail proves nothing.
import {h, plainTable} from '../dom.js';
import {Absent} from '../parts.js';

const kShown = 4; // wrong twins of a row; the rest unfold

const names = (list) => list.flatMap((name, i) => [i ? ', ' : '', h('code', {}, name)]);

/** @param {string[]} caught */
const catches = (caught) =>
  caught.length <= kShown
    ? names(caught)
    : [
        ...names(caught.slice(0, kShown)),
        h(
          'details',
          {class: 'inline'},
          h('summary', {}, `and ${caught.length - kShown} more`),
          names(caught.slice(kShown))
        )
      ];

/** @param {import('../data.js').Results} results */
export function saboteursTable(results) {
  const rows = results.saboteurs;
  if (!rows.length) return new Absent('no check of this run met a saboteur');
  return plainTable(
    'What each sort of checks was seen to fail for',
    [{text: 'check'}, {text: 'speaks for', number: true}, {text: 'sees'}, {text: 'fails for'}],
    rows.map((row) => [
      h('code', {}, row.check),
      String(row.siblings),
      row.sees.join(', ') || 'no formulation',
      row.wrong.length ? row.wrong.join('; ') : row.caught_by.length ? catches(row.caught_by) : 'left out'
    ])
  );
}
