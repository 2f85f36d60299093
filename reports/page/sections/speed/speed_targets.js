// Targets of this run, competitors in it, figures that others published, and instruction counts.
import {kindLabel} from '../../data/accuracy_data.js';
import {h, plainTable, scrolling} from '../../dom.js';
import {isNumber, nanoseconds, short} from '../../format.js';
import {Absent} from '../../parts.js';
import {isAnalytic, isCompetitor, ratio, speedOf, usable, whatLabel} from '../../data/speed_data.js';

const HELD = {at_least: 'at least', at_most: 'at most'};

function targetRow(t) {
  const measured = isNumber(t.value);
  const verdict = !measured
    ? ['left_out', '– not measured']
    : t.met
      ? ['pass', '✓ met']
      : ['fail', '✗ missed'];
  return h(
    'tr',
    {},
    h('th', {scope: 'row'}, t.name, t.note ? h('span', {class: 'aside'}, t.note) : null),
    h('td', {class: 'number'}, measured ? short(t.value, 3) : '–'),
    h('td', {class: 'number'}, `${HELD[t.comparison] ?? t.comparison} ${short(t.limit, 3)}`),
    h('td', {class: `mark ${verdict[0]}`}, verdict[1])
  );
}

/** @param {import('../../data.js').Results} results */
export function targetsTable(results) {
  const {targets} = speedOf(results);
  if (!targets.length) return new Absent('the results hold no targets (speed.targets)');
  const head = ['target', 'this run', 'limit', 'verdict'].map((t, i) =>
    h('th', {scope: 'col', class: i === 1 || i === 2 ? 'number' : null}, t)
  );
  return [
    scrolling(
      h(
        'table',
        {class: 'compact narrow targets'},
        h('thead', {}, h('tr', {}, head)),
        h('tbody', {}, targets.map(targetRow))
      ),
      'Targets'
    ),
    h(
      'p',
      {class: 'note'},
      `${targets.filter((t) => isNumber(t.value) && t.met).length} of ${targets.length} met. Ratios are of medians within this run.`
    )
  ];
}

/** Ours of the same kind and output: the same formulation's kernel, else the invariant joint's; of a rotation
 * our own exp or log.
 * @param {import('../../data.js').Results} results
 */
function ours(results, t) {
  const same = results.timings.filter(
    (o) =>
      !isCompetitor(o) &&
      usable(o) &&
      o.kind === t.kind &&
      o.what === t.what &&
      o.precision === 'double' &&
      isAnalytic(o)
  );
  const kernels = same.filter((o) => o.implementation === 'kernel' && o.variant === '');
  return (
    kernels.find((o) => o.formulation === t.formulation) ??
    kernels.find((o) => o.formulation === 'invariant') ??
    same.find((o) => !o.formulation)
  );
}

/** @param {import('../../data.js').Results} results */
export function competitorsTable(results) {
  const title = 'Competitors in this run';
  const timed = results.timings
    .filter(isCompetitor)
    .sort((a, b) => a.what.localeCompare(b.what) || a.ns - b.ns);
  if (!timed.length) return new Absent('no competitor was timed');
  const columns = [
    {text: 'competitor'},
    {text: 'of what'},
    ...['ns', 'ratio to ours', 'ours, ns', 'error'].map((text) => ({text, number: true}))
  ];
  return plainTable(
    title,
    columns,
    timed.map((t) => {
      const own = ours(results, t);
      const what = [
        t.implementation === 'competitor' ? '' : t.formulation,
        t.kind ? kindLabel(t.kind) : '',
        whatLabel(t.what)
      ]
        .filter(Boolean)
        .join(', ');
      return [
        h('code', {}, t.implementation === 'competitor' ? t.variant || t.formulation : t.implementation),
        what,
        t.wrong ? h('span', {title: t.message}, 'wrong') : nanoseconds(t.ns),
        own && usable(t) ? ratio(t.ns / own.ns) : '–',
        own ? h('span', {title: own.name}, nanoseconds(own.ns)) : '–',
        short(t.error)
      ];
    })
  );
}

/** @param {import('../../data.js').Results} results */
export function publishedTable(results) {
  const {published} = speedOf(results);
  if (!published.length) return new Absent('the results hold no published figures (speed.published)');
  const columns = [{text: 'program'}, {text: 'of what'}, {text: 'ns', number: true}];
  const origins = [...new Set(published.map((p) => `${p.machine}, ${p.date}: ${p.source}`))];
  return [
    plainTable(
      'Published figures',
      columns,
      published.map((p) => [`${p.program} ${p.version ?? ''}`.trim(), p.what, nanoseconds(p.ns)])
    ),
    h('p', {class: 'note'}, `Constants, never in a ratio of this run. ${origins.join('; ')}.`)
  ];
}

/** @param {import('../../data.js').Results} results */
export function instructionsTable(results) {
  const {instructions} = speedOf(results);
  if (!instructions.length) return new Absent('no instructions were counted (speed.instructions)');
  return [
    plainTable(
      'Instructions',
      [{text: 'kernel'}, {text: 'per evaluation', number: true}],
      instructions.map((i) => [h('code', {}, i.name), short(i.instructions, 4)])
    ),
    h(
      'p',
      {class: 'note'},
      'Counted by callgrind: free of the noise of times, to be compared from run to run.'
    )
  ];
}
