// What failed, what ended early, what was left out: each with its reason.
import {h} from '../dom.js';
import {plural} from '../format.js';
import {story} from './matrix.js';

/** The same reason often holds for many names: one entry per reason. */
function byReason(items) {
  const groups = new Map();
  for (const {what, reason} of items) groups.set(reason, [...(groups.get(reason) ?? []), what]);
  return [...groups.entries()];
}

function group(title, items, none) {
  if (!items.length) return [h('h3', {}, title), h('p', {class: 'note'}, none)];
  const names = (list) => {
    const head = list.slice(0, 4).flatMap((n, i) => [i ? ', ' : '', h('code', {}, n)]);
    if (list.length <= 4) return head;
    return [
      ...head,
      h(
        'details',
        {class: 'inline'},
        h('summary', {}, `and ${list.length - 4} more`),
        list.slice(4).flatMap((n, i) => [i ? ', ' : '', h('code', {}, n)])
      )
    ];
  };
  return [
    h('h3', {}, `${title} (${plural(items.length, 'item')})`),
    h(
      'ul',
      {class: 'reasons'},
      byReason(items).map(([reason, list]) => h('li', {}, names(list), h('span', {class: 'reason'}, reason)))
    )
  ];
}

export function leftOut(results) {
  const failed = [
    ...results.findings.filter((f) => f.verdict === 'fail').map((f) => ({what: f.name, reason: story(f)})),
    ...results.timings
      .filter((t) => t.wrong)
      .map((t) => ({what: t.name, reason: `benchmark refused: ${t.message}`}))
  ];
  const early = results.curves
    .filter((c) => !c.converged)
    .map((c) => ({what: `${c.scene}/${results.series(c)}`, reason: c.outcome}));
  const omitted = [
    ...results.left_out,
    ...results.findings.filter((f) => f.verdict === 'left_out').map((f) => ({what: f.name, reason: f.reason}))
  ];
  const points = results
    .accuracy('residual', 'modelling')
    .missing.map((m) => ({what: `${m.name}/${m.kind}`, reason: m.reason}));
  return h(
    'section',
    {'aria-labelledby': 'left-out'},
    h('h2', {id: 'left-out'}, 'Failed or left out'),
    group('Failed', failed, 'Nothing failed.'),
    group('Curves that end early', early, 'Every curve reached its last load.'),
    group('Points missing from the accuracy chart', points, 'No point is missing.'),
    group('Left out', omitted, 'Nothing was left out.')
  );
}
