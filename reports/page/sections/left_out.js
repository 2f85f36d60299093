// What failed, what ended early, what was left out: each with its reason.
import {accuracyOf} from '../data/accuracy_data.js';
import {h} from '../dom.js';
import {plural} from '../format.js';
import {notRun} from '../data/tally_data.js';
import {story} from './matrix.js';

/** The same reason often holds for many names: one entry per reason. */
function byReason(items) {
  const groups = new Map();
  for (const {what, reason} of items) groups.set(reason, [...(groups.get(reason) ?? []), what]);
  return [...groups.entries()];
}

function group(title, items, none) {
  if (!items.length) return [h('h4', {}, title), h('p', {class: 'note'}, none)];
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
    h('h4', {}, `${title} (${plural(items.length, 'item')})`),
    h(
      'ul',
      {class: 'reasons'},
      byReason(items).map(([reason, list]) => h('li', {}, names(list), h('span', {class: 'reason'}, reason)))
    )
  ];
}

/** @param {import('../data.js').Results} results */
export function leftOut(results) {
  const of = (verdict) => results.findings.filter((f) => f.verdict === verdict);
  const failed = of('fail').map((f) => ({what: f.name, reason: story(f)}));
  const refused = results.timings.filter((t) => t.wrong).map((t) => ({what: t.name, reason: t.message}));
  const omitted = of('left_out').map((f) => ({what: f.name, reason: f.reason}));
  const points = accuracyOf(results, {what: 'residual', error: 'modelling'}).missing.map((m) => ({
    what: `${m.name}/${m.kind}`,
    reason: m.reason
  }));
  return [
    group('Findings that failed', failed, 'Nothing failed.'),
    refused.length ? group('Benchmarks refused', refused, '') : null,
    group('Findings left out', omitted, 'Nothing was left out.'),
    group('Paths and timings not run to the end', notRun(results), 'Everything ran to its end.'),
    group('Points missing from the accuracy chart', points, 'No point is missing.')
  ];
}
