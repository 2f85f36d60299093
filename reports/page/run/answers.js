// What a run says first: the scene, who agrees, who ends early and why, and what was left out.
import {h, plainTable, swatch} from '../dom.js';
import {full, short} from '../format.js';
import {
  chainWords,
  dampingWords,
  endWords,
  kindWords,
  lawWords,
  loadWords,
  motionWords,
  nodeWords,
  overWords,
  placeText
} from './words.js';

/** @typedef {import('./run.js').App} App */

/** Formulations with their looks. @param {App} app @param {number[]} places */
const named = ({series}, places) =>
  h(
    'span',
    {class: 'run-names'},
    places.map((i) => h('span', {class: 'name'}, swatch(series[i].look), h('code', {}, series[i].key)))
  );

/** @param {App} app */
function groups(app) {
  const {run} = app;
  if (!run.comparison.groups.length)
    return h('p', {class: 'empty'}, `No formulation reaches the last ${overWords(run)}.`);
  const columns = [
    {text: 'formulations'},
    ...run.outputs.map((o) => ({text: `${o.name}, ${o.unit}`, number: true})),
    {text: 'error', number: true},
    {text: 'within', number: true}
  ];
  const rows = run.comparison.groups.map(({curves, answer, apart, error}) => [
    named(app, curves),
    ...answer.map((x) => h('span', {title: full(x)}, short(x, 5))),
    error === null ? '–' : short(error, 1),
    curves.length > 1 ? `${short(100 * apart, 1)} %` : '–'
  ]);
  const agree = short(100 * run.comparison.agree, 2);
  return plainTable(
    `Answers at the last ${overWords(run)}`,
    columns,
    rows,
    `Answers at ${placeText(run, run.path.factor_end, 5)}, one row for those within ${agree} % of one another`,
    true
  );
}

/** A line for each cause. @param {App} app */
export function endedLines({run, series}) {
  const {ended} = run.comparison;
  if (!ended.length) return '';
  const one = (/** @type {number} */ i) => [
    h('span', {class: 'name run-inline'}, swatch(series[i].look), h('code', {}, series[i].key)),
    ` at ${short(run.curves[i].rows.at(-1)?.[0] ?? 0, 6)}`
  ];
  return h(
    'ul',
    {class: 'run-ended', 'aria-label': 'Who ends early, where and why'},
    ended.map(({cause, curves}) =>
      h(
        'li',
        {},
        curves.map((i, n) => [n ? ', ' : '', one(i)]),
        `: ${cause}`
      )
    )
  );
}

/** First critical moments. @param {App} app */
function critical({run, series}) {
  if (!run.critical_axis) return '';
  const found = run.curves
    .map((c, i) => ({moment: c.critical_moment, series: series[i]}))
    .filter((c) => c.moment !== undefined)
    .sort((a, b) => Number(a.moment) - Number(b.moment));
  const none = run.curves
    .filter((c) => c.critical_moment === undefined && c.formulation !== 'linearized')
    .map((c) => c.label);
  return [
    plainTable(
      'Critical moments',
      [
        {text: 'formulation'},
        {text: `critical moment about joint axis ${run.critical_axis}, N m`, number: true}
      ],
      found.map((c) => [
        h('span', {class: 'name'}, swatch(c.series.look), h('code', {}, c.series.key)),
        h('span', {title: full(c.moment)}, short(c.moment, 5))
      ])
    ),
    none.length ? h('p', {class: 'note'}, `None below half a turn: ${none.join(', ')}.`) : ''
  ];
}

/** @param {App} app */
export const answersSection = (app) => groups(app);

/** @param {App} app */
export const criticalPart = (app) => critical(app);

const term = (name, ...words) => [h('dt', {}, name), h('dd', {}, ...words)];
const lines = (/** @type {string[]} */ list) => list.map((text) => h('div', {}, text));

/** What was solved. @param {App} app */
export function sceneFacts({run}) {
  const {joints, chain, loads, path, notes, scene, bodies} = run;
  const isOne = joints.length === 1;
  const joint = joints.flatMap((j) => {
    const of = isOne ? '' : ` ${j.name}`;
    const ends = [j.a, j.b].map((e) => `On ${nodeWords(bodies[e.body].name)}: ${endWords(e)}.`);
    return [
      term(`joint${of}`, kindWords(j, isOne)),
      term(`law${of}`, lawWords(j)),
      j.damping ? term(`damping${of}`, dampingWords(j)) : '',
      term(`ends${of}`, lines(ends))
    ];
  });
  return h(
    'dl',
    {class: 'facts'},
    joint,
    chain ? term('chain', lines(chainWords(chain))) : '',
    loads.length
      ? term('loads', lines(loadWords(run).map((text) => `${text[0].toUpperCase()}${text.slice(1)}.`)))
      : '',
    run.motions?.length ? term('motions', lines(motionWords(run).map((text) => `${text}.`))) : '',
    term(
      overWords(run),
      path.over
        ? `From 0 to ${short(path.factor_end, 5)} s.`
        : loads.length && !run.motions
          ? `From 0 to ${short(path.factor_end, 5)}; it multiplies the loads above.`
          : `From 0 to ${short(path.factor_end, 5)}.`
    ),
    notes.length ? term('read', lines(notes)) : '',
    scene.description ? term('about', scene.description) : '',
    scene.source ? term('source', scene.source) : '',
    term('again', h('code', {class: 'command'}, run.command))
  );
}

/** @param {App} app */
export function leftOutSection({run}) {
  if (!run.left_out.length)
    return h('p', {class: 'note'}, 'Nothing: every formulation that was asked for was run.');
  return h(
    'ul',
    {class: 'reasons'},
    run.left_out.map((l) => h('li', {}, h('code', {}, l.formulation), h('span', {class: 'reason'}, l.reason)))
  );
}
