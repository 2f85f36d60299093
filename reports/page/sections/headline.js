// The answer in words, made from the data, with the angle and the load up to which it holds.
import {kindLabel} from '../data/accuracy_data.js';
import {h, plainTable} from '../dom.js';
import {nanoseconds, plural, short} from '../format.js';
import {choiceOf, reachesOf} from '../data/headline_data.js';
import {implementationLabel} from '../data/speed_data.js';
import {notRun, tallyOf} from '../data/tally_data.js';
import {signNote} from './notes.js';

const code = (name) => h('code', {}, name);
const list = (names) =>
  names.flatMap((n, i) => [i ? (i === names.length - 1 ? ' and ' : ', ') : '', code(n)]);
const error = (p) =>
  p.floored
    ? `an error below ${short(p.floor)}, the uncertainty of the truth`
    : `an error of ${short(p.error)}`;
const cost = (p) => `${nanoseconds(p.ns)} ns (${implementationLabel(p.implementation)}, without tangent)`;
const angle = (phi) => (phi === undefined ? '' : `${short(phi, phi < 1 ? 1 : 2)}°`);
const unitText = (text) => text.replace('N m', 'N·m');

/** "at small angles (φ = 0.09°, 1 N·m)", or where it was measured, in the finding's own words. */
function smallAngles({phi, load, where}) {
  if (phi === undefined) return where ? `at small angles (${where}) ` : 'at small angles ';
  const said = [`φ = ${angle(phi)}`, unitText(load ?? '')].filter(Boolean).join(', ');
  return `at small angles (${said}) `;
}

function answer({best, also, fastest, between, condition}, kind) {
  const sentence = [
    `As ${kind === 'angular' ? 'an' : 'a'} ${kindLabel(kind)} joint, `,
    h('strong', {}, smallAngles(condition)),
    code(best.formulation),
    ` comes closest to the truth: ${error(best)}, at ${cost(best)}. `
  ];
  if (also.length) sentence.push('No worse there: ', ...list(also.map((p) => p.formulation)), '. ');
  if (fastest === best) return [...sentence, 'It is also the fastest.'];
  const times = fastest.error / best.error;
  sentence.push(
    'The fastest, ',
    code(fastest.formulation),
    `, takes ${cost(fastest)} and has ${error(fastest)}`,
    times > 1.05 ? `, ${best.floored ? 'at least ' : ''}${short(times)} times as much. ` : '. '
  );
  if (between.length) {
    sentence.push('Between the two no formulation beats ', ...list(between.map((p) => p.formulation)), '.');
  }
  return sentence;
}

const reachText = (reach, unit) =>
  `${reach.isWhole ? '≥ ' : ''}${short(reach.load, 3)} ${unitText(unit)}${reach.phi === undefined ? '' : ` (${angle(reach.phi)})`}`;

/** How far the words above hold: the same formulations against the nonlinear 3D body. */
function limits({shown, one, end}) {
  if (!one || !end) return [h('p', {class: 'answer'}, 'At larger angles nothing was measured in this run.')];
  const isWhole = one.one.isWhole;
  const beyond = isWhole
    ? ''
    : `Beyond ${angle(one.one.phi)} no law is within 1 % of this body, so none is at 30°; its curve ends at ${angle(end.phi)}.`;
  return [
    h(
      'p',
      {class: 'answer'},
      h('strong', {}, 'At larger angles '),
      'the coupling θ₂ of the nonlinear 3D body is followed this far. ',
      beyond,
      ' ',
      h('a', {href: '#ranges'}, 'All formulations and bodies'),
      '.'
    ),
    plainTable(
      'How far the formulations follow the 3D body',
      [{text: 'formulation'}, {text: 'within 1 %', number: true}, {text: 'within 5 %', number: true}],
      shown.map((r) => [code(r.formulation), reachText(r.one, r.unit), reachText(r.five, r.unit)])
    )
  ];
}

/** One item of the counts; href: where its reasons stand. */
function count(cls, mark, text, href) {
  const words = [h('span', {'aria-hidden': 'true'}, mark), ` ${text}`];
  return h('li', {class: cls}, href ? h('a', {href}, words) : words);
}

/** @param {import('../data.js').Results} results */
function counts(results) {
  const {pass, fail, known_failure: known, left_out: leftOut} = tallyOf(results.findings);
  const refused = results.timings.filter((t) => t.wrong).length;
  const others = notRun(results).length;
  const where = '#left-out';
  return h(
    'ul',
    {class: 'counts', 'aria-label': 'Verdicts of the findings'},
    count('pass', '✓', `${plural(pass, 'finding')} passed`),
    count(fail ? 'fail' : 'none', '✗', `${fail} failed`, where),
    count(
      'known_failure',
      '≈',
      `${plural(known, 'known failure')} inside ${known === 1 ? 'its band' : 'their bands'}`
    ),
    count('left_out', '–', `${plural(leftOut, 'finding')} left out`, where),
    refused ? count('fail', '✗', `${plural(refused, 'benchmark')} refused`, where) : null,
    others
      ? count(
          'left_out',
          '–',
          `${plural(others, 'path or timing', 'paths and timings')} not run to the end`,
          where
        )
      : null
  );
}

/** @param {import('../data.js').Results} results */
export function headline(results, kind) {
  const choice = choiceOf(results, kind);
  const words = choice
    ? answer(choice, kind)
    : 'No modelling error was measured in this run: the chart shows the numerical error of each ' +
      'formulation against its cost.';
  const truest = choice ? [choice.best, ...choice.also].map((p) => p.formulation) : [];
  return h(
    'section',
    {class: 'headline', 'aria-labelledby': 'answer'},
    h('h1', {id: 'answer'}, 'Which formulation is how accurate, at what cost?'),
    h(
      'div',
      {class: 'lead'},
      h('p', {class: 'answer'}, words),
      h('div', {}, limits(reachesOf(results, kind, truest)))
    ),
    counts(results),
    h('p', {class: 'note'}, signNote())
  );
}
