// How each formulation stands now.
import {kindLabel} from '../data/accuracy_data.js';
import {VERDICTS} from '../data.js';
import {h, plainTable} from '../dom.js';
import {nanoseconds, short} from '../format.js';
import {isOpen} from './history_data.js';
import {formulationName, nameCode} from './pieces.js';
import {COMMON, statesOf} from './state_data.js';
import {amount} from './words.js';

/** @typedef {import('./dashboard.js').App} App */

const COUNTED = ['pass', 'known_failure', 'fail'];

/** @param {string} verdict @param {number} count */
const tallyCell = (verdict, count) =>
  h('span', {class: `verdict mark ${count ? verdict : 'none'}`}, `${VERDICTS[verdict].mark} ${count}`);

/** Time of one kind of joint, with what it lost. @param {App} app @param {number | undefined} figure */
function timeCell({history, place}, figure) {
  if (figure === undefined) return '–';
  const series = place.series.number;
  const value = history.latest[series].value[figure];
  const [worse] = history.changesOf(series, (c) => c.figure === figure && isOpen(c));
  return [
    h(
      'a',
      {href: place.linkTo(figure), 'aria-label': `${history.figures.name[figure]}: ${nanoseconds(value)}`},
      nanoseconds(value)
    ),
    worse ? h('span', {class: 'aside worse'}, `✗ ${amount(worse)}`) : ''
  ];
}

/** Without the formulation, which heads the row. @param {App['history']['figures']} figures @param {number} i */
const shortName = ({name, formulation}, i) =>
  name[i].startsWith(`${formulation[i]}/`) ? name[i].slice(formulation[i].length + 1) : name[i];

/** @param {App} app @param {{figure: number, digits: number} | null} worst */
function worstCell({history, place}, worst) {
  if (!worst) return '–';
  return h(
    'a',
    {href: place.linkTo(worst.figure)},
    `${short(worst.digits)} in `,
    nameCode(shortName(history.figures, worst.figure))
  );
}

/** @param {App} app */
export function stateSection(app) {
  const {history, place, sparks} = app;
  const body = h('div');
  const show = () => {
    const series = place.series.number;
    const kinds = history.pairKinds();
    const columns = [
      {text: 'formulation'},
      {text: 'passes', number: true},
      {text: 'known failures', number: true},
      {text: 'failed', number: true},
      {text: 'most digits lost'},
      ...kinds.map((k) => ({text: `${kindLabel(k)}, ns`, number: true})),
      {text: kinds.length ? `trend of ${kindLabel(kinds[0])}` : 'trend'}
    ];
    const rows = statesOf(history, series).map(({name, tally, worst, times}) => {
      const first = times.get(kinds[0]);
      return [
        name === COMMON ? 'common to all' : formulationName(name),
        ...COUNTED.map((v) => tallyCell(v, tally[v])),
        worstCell(app, worst),
        ...kinds.map((k) => timeCell(app, times.get(k))),
        first === undefined ? '–' : sparks.of(first, series)
      ];
    });
    const run = history.latest[series].run;
    const isTimed = history.pairs.some((p) => history.latest[series].value[p.time] !== null);
    body.replaceChildren(
      plainTable('State of each formulation', columns, rows, undefined, true),
      h(
        'p',
        {class: 'note'},
        `At ${history.commit(run)} of ${history.day(run)}. Digits lost: over this whole history, net of what was gained. `,
        isTimed ? 'Times are per joint; ✗: what they lost and did not regain.' : 'This series holds no times.'
      )
    );
  };
  return {content: body, show};
}
