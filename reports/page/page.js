// The report page: its questions in reading order, all answered from the results inlined in the page.
import {Results} from './data.js';
import {h, section} from './dom.js';
import {firstKind} from './data/headline_data.js';
import {EVERYTHING, Part, Parts} from './parts.js';
import {headline} from './sections/headline.js';
import {signNote} from './sections/notes.js';
import {numberParts} from './sections/numbers.js';
import {rodParts} from './sections/rods.js';
import {speedNote, speedParts} from './sections/speed/speed.js';
import {stabilityParts} from './sections/stability.js';
import {truthParts} from './sections/truth.js';
import {whichParts} from './sections/which.js';
import {main, start} from './start.js';

/** @typedef {{id: string, title: string, note?: Node, parts: Part[]}} Question */

/**
 * @param {Results} results
 * @param {string} raw
 * @param {string} kind
 * @returns {Question[]}
 */
function questionsOf(results, raw, kind) {
  const parts = (/** @type {import('./parts.js').PartSpec[]} */ specs) => specs.map((spec) => new Part(spec));
  const sign = h('p', {class: 'note'}, signNote());
  return [
    {id: 'which', title: 'Which one?', parts: parts(whichParts(results, kind))},
    {id: 'speed', title: 'How fast?', note: speedNote(results), parts: parts(speedParts(results, kind))},
    {id: 'stability', title: 'Where does it fail?', note: sign, parts: parts(stabilityParts(results))},
    {id: 'rods', title: 'Large rotation: who follows the rod?', parts: parts(rodParts(results))},
    {id: 'truth', title: 'Who is right?', note: sign.cloneNode(true), parts: parts(truthParts(results))},
    {id: 'numbers', title: 'Every number', parts: parts(numberParts(results, raw))}
  ];
}

/** @param {Question} question */
const questionSection = ({id, title, note, parts}) =>
  section(
    id,
    title,
    [
      note ?? '',
      h(
        'div',
        {class: 'parts'},
        parts.map((p) => p.section)
      )
    ],
    `question ${id}`
  );

/** The table of contents, by question.
 * @param {Question[]} questions
 */
function contents(questions) {
  const link = (/** @type {string} */ id, /** @type {string} */ text) => h('a', {href: `#${id}`}, text);
  const entries = (/** @type {Part[]} */ parts) =>
    parts.map((p) => h('li', {}, link(p.spec.id, p.spec.title)));
  return h(
    'nav',
    {class: 'contents', 'aria-label': 'Contents by question'},
    questions.map(({id, title, parts}) =>
      h(
        'details',
        {},
        h('summary', {}, title),
        h('ul', {}, h('li', {}, link(id, `All: ${title}`)), entries(parts))
      )
    ),
    h('a', {class: 'everything', href: EVERYTHING}, 'Draw everything (to search or save the page)')
  );
}

/** @param {string} raw */
function build(raw) {
  const results = new Results(JSON.parse(raw));
  const kind = firstKind(results);
  const questions = questionsOf(results, raw, kind);
  const {commit, date} = results.context;
  document.getElementById('nav')?.append(...questions.map(({id, title}) => h('a', {href: `#${id}`}, title)));
  document.getElementById('subtitle')?.append(` · ${commit} · ${date}`);
  main().append(headline(results, kind), contents(questions), ...questions.map(questionSection));
  new Parts(questions.flatMap((q) => q.parts)).watch();
}

start('The results', () => build(document.getElementById('results')?.textContent ?? ''));
