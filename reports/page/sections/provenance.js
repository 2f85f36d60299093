// Where the numbers come from, and the command that makes them again.
import {download, h} from '../dom.js';
import {seconds} from '../format.js';

/** @param {import('../data.js').Results} results */
export function provenance(results, raw) {
  const c = results.context;
  const rows = [
    ['machine', c.machine],
    ['compiler', c.compiler],
    ['flags', c.flags],
    ['build type', c.build_type],
    ['commit', c.commit],
    ['date', c.date],
    ...Object.entries(results.durations).map(([stage, s]) => [`time: ${stage}`, seconds(s)])
  ];
  return [
    h(
      'p',
      {},
      'Reproduce with ',
      h('code', {class: 'command'}, results.command),
      ' in a checkout of the commit below. The numbers of this page are inside it: ',
      download('save results.json', 'results.json', 'application/json', () => raw),
      '.'
    ),
    h(
      'dl',
      {class: 'facts'},
      rows.filter(([, v]) => v).flatMap(([k, v]) => [h('dt', {}, k), h('dd', {}, v)])
    )
  ];
}
