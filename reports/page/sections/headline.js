// The answer in words, made from the data.
import {front, KINDS, kindLabel} from '../data.js';
import {h} from '../dom.js';
import {nanoseconds, plural, short} from '../format.js';

/** The kind that the page shows first: the one with most measured points, angular before others. */
export function firstKind(results) {
  const {points} = results.accuracy('residual', 'modelling');
  const count = (kind) => points.filter((p) => p.kind === kind).length;
  return KINDS.map((k) => k.key).reduce((best, kind) => (count(kind) > count(best) ? kind : best), 'angular');
}

const code = (name) => h('code', {}, name);
const list = (names) =>
  names.flatMap((n, i) => [i ? (i === names.length - 1 ? ' and ' : ', ') : '', code(n)]);
const error = (p) =>
  p.floored
    ? `an error below ${short(p.floor)}, the uncertainty of the truth`
    : `an error of ${short(p.error)}`;

function answer(results, kind) {
  const points = results.accuracy('residual', 'modelling').points.filter((p) => p.kind === kind);
  if (!points.length)
    return [
      'No modelling error was measured in this run: the chart shows the numerical error of each formulation against its cost.'
    ];
  const least = Math.min(...points.map((p) => p.error));
  const truest = points.filter((p) => p.error === least).sort((a, b) => a.ns - b.ns);
  const fastest = points.reduce((a, b) => (b.ns < a.ns ? b : a));
  const best = truest[0];
  const also = truest.slice(1).map((p) => p.formulation);
  const sentence = [
    `As ${kind === 'angular' ? 'an' : 'a'} ${kindLabel(kind)} joint, `,
    code(best.formulation),
    ` comes closest to the truth: ${error(best)}, at ${nanoseconds(best.ns)} ns per residual${best.implementation === 'kernel' ? ' of its kernel' : ''}. `
  ];
  if (also.length) sentence.push('No worse: ', ...list(also), '. ');
  if (fastest.formulation === best.formulation) return [...sentence, 'It is also the fastest.'];
  const times = fastest.error / best.error;
  sentence.push(
    'The fastest, ',
    code(fastest.formulation),
    `, takes ${nanoseconds(fastest.ns)} ns and has ${error(fastest)}`,
    times > 1.05 ? `, ${short(times)} times as much. ` : '. '
  );
  const between = front(points)
    .map((p) => p.formulation)
    .filter((n) => n !== best.formulation && n !== fastest.formulation);
  if (between.length) sentence.push('Between the two no formulation beats ', ...list(between), '.');
  return sentence;
}

function counts(results) {
  const failed = results.count('fail') + results.timings.filter((t) => t.wrong).length;
  const item = (cls, mark, text) =>
    h('li', {class: cls}, h('span', {'aria-hidden': 'true'}, mark), ` ${text}`);
  return h(
    'ul',
    {class: 'counts', 'aria-label': 'Verdicts'},
    item('pass', '✓', `${results.count('pass')} passed`),
    h(
      'li',
      {class: failed ? 'fail' : 'none'},
      h('a', {href: '#left-out'}, h('span', {'aria-hidden': 'true'}, '✗'), ` ${failed} failed`)
    ),
    item(
      'known_failure',
      '≈',
      `${plural(results.count('known_failure'), 'known failure')}, inside its band`.replace(
        'failures, inside its band',
        'failures, inside their bands'
      )
    ),
    h(
      'li',
      {class: 'left_out'},
      h(
        'a',
        {href: '#left-out'},
        h('span', {'aria-hidden': 'true'}, '–'),
        ` ${results.count('left_out') + results.left_out.length} left out`
      )
    )
  );
}

export function headline(results, kind) {
  return h(
    'section',
    {class: 'headline', 'aria-labelledby': 'answer'},
    h('h1', {id: 'answer'}, 'Which formulation is how accurate, at what cost?'),
    h('p', {class: 'answer'}, answer(results, kind)),
    counts(results)
  );
}
