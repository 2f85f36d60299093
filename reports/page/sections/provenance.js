// Where the numbers come from, and the command that makes them again.
import {button, h} from '../dom.js';
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
  const save = () => {
    const link = h('a', {
      href: URL.createObjectURL(new Blob([raw], {type: 'application/json'})),
      download: 'results.json'
    });
    link.click();
    URL.revokeObjectURL(link.href);
  };
  return [
    h(
      'p',
      {},
      'Reproduce with ',
      h('code', {class: 'command'}, results.command),
      ' in a checkout of the commit below. The numbers of this page are inside it: ',
      button('save results.json', save),
      '.'
    ),
    h(
      'dl',
      {class: 'facts'},
      rows.filter(([, v]) => v).flatMap(([k, v]) => [h('dt', {}, k), h('dd', {}, v)])
    )
  ];
}
