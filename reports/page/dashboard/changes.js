// What got worse, since when, and how sure that is.
import {choice, h} from '../dom.js';
import {full, isNumber, plural} from '../format.js';
import {isOpen} from './history_data.js';
import {amountMark, figureLink, growingTable, nothing, runWords} from './pieces.js';
import {SHOWN} from './place.js';
import {amount, fromTo, runsSince, sure, SURE_NOTE, told} from './words.js';

/** @typedef {import('./dashboard.js').App} App */
/** @typedef {import('./history_data.js').Story} Story */

const kFirst = 12; // rows; a button shows the others
const COLUMNS = [
  {text: 'figure'},
  {text: 'how much'},
  {text: 'from → to'},
  {text: 'since'},
  {text: 'how sure'},
  {text: 'trend'}
];

/** @param {App} app @param {Story} c */
function row(app, c) {
  const {history, sparks} = app;
  const unit = history.figures.unit[c.figure];
  const mended = c.mended
    ? h('span', {class: 'aside'}, 'better again since ', runWords(app, c.mended.run))
    : null;
  const cells = [
    figureLink(app, c.figure),
    [
      amountMark(c),
      history.fails(c) ? h('span', {class: 'aside worse'}, 'fails now') : null,
      h('span', {class: 'aside', title: c.text}, told(c.text))
    ],
    h('span', {title: `${full(c.before)} → ${full(c.after)}`}, fromTo(c, unit)),
    [
      runWords(app, c.run),
      h('span', {class: 'aside'}, `${history.day(c.run)}, ${runsSince(history, c)} with it`),
      mended
    ],
    h('span', {class: 'whole', title: isNumber(c.p) ? `p = ${full(c.p)}` : null}, sure(c)),
    sparks.of(c.figure, c.series)
  ];
  return cells;
}

/** A table of changes, the first ones at once. @param {App} app @param {string} label @param {Story[]} list */
export const changesTable = (app, label, list) =>
  growingTable({label, columns: COLUMNS, cards: true}, list, (c) => row(app, c), kFirst);

/** The one sentence of the page. @param {App} app */
function answer(app) {
  const {history, place} = app;
  const open = history.open(place.series.number);
  const days = `${plural(place.series.runs.length, 'run')}, the last of ${history.day(place.series.runs.at(-1) ?? 0)}`;
  if (place.series.runs.length < 2) {
    return [
      `One run so far (${history.day(place.series.runs[0])}): from the second on, this says what got worse.`
    ];
  }
  if (!open.length)
    return [h('strong', {}, 'Nothing got worse'), `, as far as this history knows (${days}).`];
  const [worst] = open;
  const failing = open.filter((c) => history.fails(c)).length;
  const fails = failing ? `, ${failing} of them ${failing === 1 ? 'fails' : 'fail'} now` : '';
  return [
    h('strong', {}, `${plural(open.length, 'figure')} got worse${fails}`),
    ` (${days}). The ${failing ? 'first' : 'newest'}: `,
    figureLink(app, worst.figure),
    ` ${amount(worst) || 'worse'} since `,
    runWords(app, worst.run),
    ` (${history.day(worst.run)}; ${sure(worst)}).`
  ];
}

/** Regressions that other machines have. @param {App} app */
function elsewhere({history, place}) {
  const others = history.series.filter((s) => s !== place.series && history.open(s.number).length);
  if (!others.length) return '';
  const links = others.map((s) =>
    h(
      'li',
      {},
      h('a', {href: `${place.hash({series: s.key, run: ''})}`}, s.label),
      `: ${history.open(s.number).length} worse`
    )
  );
  return h('div', {class: 'note'}, 'Also elsewhere: ', h('ul', {class: 'others'}, links));
}

const NONE = {
  regression: 'Nothing got worse in this series.',
  improvement: 'Nothing got better in this series.',
  all: 'Nothing changed in this series.'
};

/** @param {App} app */
export function changesSection(app) {
  const {history, place} = app;
  const box = h('div');
  const wanted = (/** @type {Story} */ c) => place.show === 'all' || c.verdict === place.show;
  const list = () => {
    const found = history.changesOf(place.series.number, wanted);
    box.replaceChildren(
      ...(found.length
        ? [changesTable(app, 'Changes', found), h('p', {class: 'note'}, SURE_NOTE)]
        : [nothing(NONE[place.show])])
    );
  };
  const body = h('div');
  const show = () => {
    const all = history.changesOf(place.series.number);
    const mended = all.filter((c) => c.mended).length;
    const counts = {
      regression: all.filter((c) => c.verdict === 'regression').length,
      improvement: all.filter((c) => c.verdict === 'improvement').length,
      all: all.length
    };
    const options = Object.entries(SHOWN).map(([key, label]) => ({key, label: `${label} (${counts[key]})`}));
    body.replaceChildren(
      h('p', {class: 'answer'}, answer(app)),
      elsewhere(app),
      h(
        'div',
        {class: 'controls'},
        choice('Show what got', options, place.show, (key) => {
          place.show = key;
          place.write();
          list();
        }),
        mended
          ? h('span', {class: 'note'}, `${all.filter(isOpen).length} still worse, ${mended} better again`)
          : ''
      ),
      box
    );
    list();
  };
  return {content: body, show};
}
