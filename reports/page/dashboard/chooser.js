// Which figure: search and filters over all of them.
import {VERDICTS} from '../data.js';
import {h, select} from '../dom.js';
import {plural} from '../format.js';

/** @typedef {import('./dashboard.js').App} App */

const VERDICT_OPTIONS = [
  {key: '', label: 'all'},
  ...Object.entries(VERDICTS)
    .filter(([key]) => key !== 'left_out')
    .map(([key, {label}]) => ({key, label}))
];
const kListed = 200; // figures; the search finds the others

/** Search and filters over the figures. @param {App} app */
export function chooser(app) {
  const {history, place} = app;
  const wanted = {words: '', kind: '', formulation: '', verdict: ''};
  const count = h('span', {class: 'note', 'aria-live': 'polite'});
  const list = h('select', {
    size: 8,
    class: 'figures',
    'aria-label': 'Figures',
    onchange: () => app.go({figure: Number(list.value)})
  });
  let listed = '';
  const fill = () => {
    const {name} = history.figures;
    const key = JSON.stringify([wanted, place.series.number]);
    const known = [...list.options].find((o) => Number(o.value) === place.figure);
    if (key === listed && known) {
      known.selected = true;
      return;
    }
    listed = key;
    const found = history.find({...wanted, series: place.series.number});
    const first = found.slice(0, kListed);
    const isFar = found.includes(place.figure) && !first.includes(place.figure);
    const shown = isFar ? [place.figure, ...first] : first;
    list.replaceChildren(
      ...shown.map((i) => h('option', {value: i, selected: i === place.figure, title: name[i]}, name[i]))
    );
    const part = first.length < found.length ? `, the first ${first.length} listed` : '';
    count.textContent = `${found.length} of ${plural(name.length, 'figure')}${part}`;
  };
  const change = (/** @type {keyof typeof wanted} */ key) => (/** @type {string} */ value) => {
    wanted[key] = value;
    fill();
  };
  const options = (all, names) => [
    {key: '', label: all},
    ...[...new Set(names)].filter(Boolean).map((n) => ({key: n, label: n}))
  ];
  const search = h('input', {
    type: 'search',
    id: 'search',
    placeholder: 'words of the name',
    oninput: () => change('words')(search.value),
    onkeydown: (/** @type {KeyboardEvent} */ e) => {
      if (e.key === 'Enter' && list.options.length) app.go({figure: Number(list.options[0].value)});
    }
  });
  const box = h(
    'div',
    {},
    h(
      'div',
      {class: 'controls'},
      h('label', {for: 'search'}, 'Search ', search),
      select('Kind', options('all', history.figures.kind), '', change('kind')),
      select('Formulation', options('all', history.figures.formulation), '', change('formulation')),
      select('Verdict now', VERDICT_OPTIONS, '', change('verdict')),
      count
    ),
    list
  );
  return {box, fill};
}
