// Every finding, searchable.
import {VERDICTS} from '../data.js';
import {button, h, scrolling} from '../dom.js';
import {short} from '../format.js';
import {tallyOf} from '../data/tally_data.js';
import {story} from './matrix.js';

const kFirst = 60; // rows: the search finds the others

/** @param {import('../data.js').Results} results */
export function findingsTable(results) {
  const state = {text: '', verdict: '', all: false};
  const place = h('tbody');
  const count = h('p', {class: 'note', 'aria-live': 'polite'});
  const haystacks = new Map(
    results.findings.map((f) => [f, `${f.name} ${f.subject} ${f.reason} ${f.parameter}`.toLowerCase()])
  );

  const draw = () => {
    const words = state.text.toLowerCase().split(/\s+/).filter(Boolean);
    const found = results.findings.filter(
      (f) =>
        (!state.verdict || f.verdict === state.verdict) && words.every((w) => haystacks.get(f)?.includes(w))
    );
    const shown = state.all ? found : found.slice(0, kFirst);
    place.replaceChildren(
      ...shown.map((f) =>
        h(
          'tr',
          {},
          h('th', {scope: 'row'}, h('code', {}, f.name)),
          h('td', {class: `mark ${f.verdict}`}, `${VERDICTS[f.verdict].mark} ${VERDICTS[f.verdict].label}`),
          h('td', {class: 'number'}, f.verdict === 'left_out' ? '–' : short(f.value, 4)),
          h('td', {}, f.unit),
          h('td', {class: 'prose'}, story(f))
        )
      )
    );
    count.replaceChildren(
      `${found.length} of ${results.findings.length} findings${shown.length < found.length ? `, the first ${shown.length} shown. ` : ''}`
    );
    if (shown.length === found.length) return;
    const all = button('Show all', () => {
      state.all = true;
      draw();
    });
    count.append(all);
  };
  const search = h('input', {
    type: 'search',
    id: 'search',
    placeholder: 'words of the name, the reason or the worst case',
    oninput: (e) => {
      state.text = e.target.value;
      state.all = false;
      draw();
    }
  });
  const tally = tallyOf(results.findings);
  const verdict = h(
    'select',
    {
      id: 'verdict',
      onchange: (e) => {
        state.verdict = e.target.value;
        draw();
      }
    },
    h('option', {value: ''}, 'all verdicts'),
    Object.entries(VERDICTS).map(([key, v]) => h('option', {value: key}, `${v.label} (${tally[key]})`))
  );
  draw();
  return [
    h(
      'div',
      {class: 'controls'},
      h('label', {for: 'search'}, 'Search ', search),
      h('label', {for: 'verdict'}, 'Verdict ', verdict)
    ),
    count,
    scrolling(
      h(
        'table',
        {class: 'compact'},
        h(
          'thead',
          {},
          h(
            'tr',
            {},
            ['finding', 'verdict', 'value', 'unit', 'story'].map((t) => h('th', {scope: 'col'}, t))
          )
        ),
        place
      ),
      'All findings'
    )
  ];
}
