// Pieces of page that several sections show.
import {button, h, plainTable, swatch} from '../dom.js';
import {look} from '../palette.js';
import {amount, MARKS} from './words.js';

/** @typedef {import('./dashboard.js').App} App */
/** @typedef {import('./history_data.js').Story} Story */

const symbolOf = (/** @type {string} */ formulation) => swatch({...look(formulation), dash: undefined});

/** A name that breaks behind its slashes and underscores first. @param {string} name */
export const nameCode = (name) =>
  h(
    'code',
    {},
    name.split(/(?<=[/_])/).flatMap((part, i) => (i ? [h('wbr'), part] : [part]))
  );

/** A formulation with its symbol. @param {string} name */
export const formulationName = (name) => h('span', {class: 'name'}, symbolOf(name), nameCode(name));

/** A figure's name as a link to its trend, with the symbol of its formulation.
 * @param {App} app @param {number} figure
 */
export function figureLink({history, place}, figure) {
  const {name, formulation} = history.figures;
  const link = h('a', {href: place.linkTo(figure)}, nameCode(name[figure]));
  return h('span', {class: 'name'}, formulation[figure] ? symbolOf(formulation[figure]) : '', link);
}

/** Commit and title of a run. @param {App} app @param {number} run */
export const runWords = ({history}, run) => [
  h('code', {}, history.commit(run)),
  ` ${history.runs.title[run]}`,
  history.runs.release[run] ? `, release ${history.runs.release[run]}` : ''
];

/** How much, in the colour and with the sign of a verdict. @param {Story} c */
export function amountMark(c) {
  const {cls, mark, label} = MARKS[c.verdict];
  return h('span', {class: `verdict mark ${c.mended ? 'none' : cls}`}, `${mark} ${amount(c) || label}`);
}

/** What there is to say instead of a picture. @param {any[]} words */
export const nothing = (...words) => h('p', {class: 'empty'}, words);

/** A table whose first rows are there at once, and a button for the others.
 * @param {{label: string, columns: object[], cards?: boolean}} how
 * @param {any[]} items @param {(item: any) => any} rowOf @param {number} first
 */
export function growingTable({label, columns, cards}, items, rowOf, first) {
  const box = h('div');
  const draw = (/** @type {number} */ count) => {
    const rest = items.length - count;
    box.replaceChildren(
      plainTable(label, columns, items.slice(0, count).map(rowOf), undefined, cards),
      rest > 0 ? button(`Show ${rest} more`, () => draw(items.length)) : ''
    );
  };
  draw(first);
  return box;
}

/** A slider over runs, below a chart.
 * @param {{id: string, label: string, count: number, at: number}} how @param {(n: number) => void} moved
 */
export function runSlider({id, label, count, at}, moved) {
  const ends = {min: 0, max: count - 1, value: at};
  const range = h('input', {type: 'range', class: 'over-runs', id, 'aria-label': label, ...ends});
  range.addEventListener('input', () => moved(Number(range.value)));
  return range;
}
