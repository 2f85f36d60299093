// Table 1 of the paper beside ours.
import {h, scrolling} from '../dom.js';
import {full, isNumber, short} from '../format.js';
import {Absent} from '../parts.js';

const kScene = 'c1_skewed_torque';
const OUTPUTS = {theta_x: 'θx', theta_y: 'θy', theta_z: 'θz'};

/** How far ours is from the print, in units of its last digit: half a unit is rounding. */
function agreement(ours, text, corrected) {
  const decimals = (text.split('.')[1] ?? '').length;
  const units = Math.abs(ours - Number(text)) * 10 ** decimals;
  if (units <= 0.5 + 1e-6)
    return {verdict: 'pass', text: `✓ every printed digit${corrected ? ', once corrected' : ''}`};
  if (units <= 1) return {verdict: 'known_failure', text: `≈ within one of the last digit (${short(units)})`};
  return {verdict: 'fail', text: `✗ off by ${short(units)} of the last digit`};
}

/** @param {import('../data.js').Results} results */
function row(results, entry, erratumNumber) {
  const finding = results.byName.get(`${kScene}/${entry.formulation}/${entry.output}@1`);
  const ours = finding && isNumber(finding.value) ? finding.value : undefined;
  const right = entry.corrected ?? entry.printed;
  const cells = [
    h(
      'td',
      {class: 'number'},
      entry.printed,
      entry.erratum
        ? h(
            'sup',
            {},
            h(
              'a',
              {href: `#erratum-${erratumNumber}`, 'aria-label': `erratum ${erratumNumber}`},
              `†${erratumNumber}`
            )
          )
        : ''
    )
  ];
  if (ours === undefined)
    return [
      ...cells,
      h('td', {class: 'number none'}, '–'),
      h('td', {class: 'number none'}, '–'),
      h('td', {class: 'none'}, finding?.reason ?? 'no such finding')
    ];
  const {verdict, text} = agreement(ours, right, right !== entry.printed);
  return [
    ...cells,
    h('td', {class: 'number'}, full(ours)),
    h('td', {class: 'number'}, short(ours - Number(right), 2)),
    h('td', {class: `mark ${verdict}`}, text)
  ];
}

/** @param {import('../data.js').Results} results */
export function table1(results) {
  const entries = results.paper?.table1 ?? [];
  if (!entries.length) return new Absent('the results hold no printed table (paper.table1)');
  const errata = [...new Set(entries.map((e) => e.erratum).filter(Boolean))];
  const columns = [...new Set(entries.map((e) => e.column))];
  const body = columns.map((column) =>
    h(
      'tbody',
      {},
      entries
        .filter((e) => e.column === column)
        .map((entry, i, all) =>
          h(
            'tr',
            {},
            i === 0
              ? h(
                  'th',
                  {scope: 'rowgroup', rowspan: all.length},
                  column,
                  h('br'),
                  h('code', {}, entry.formulation)
                )
              : null,
            h('th', {scope: 'row'}, OUTPUTS[entry.output] ?? entry.output),
            row(results, entry, errata.indexOf(entry.erratum) + 1)
          )
        )
    )
  );
  const head = h(
    'thead',
    {},
    h(
      'tr',
      {},
      ['column of the paper', 'component', 'printed, rad', 'ours, rad', 'ours − right', 'agreement'].map(
        (t, i) => h('th', {scope: 'col', class: i > 1 && i < 5 ? 'number' : null}, t)
      )
    )
  );
  return [
    h(
      'p',
      {class: 'note'},
      'K = diag(1, 10, 100) N·m/rad under m = (0, sin 0.01, cos 0.01) N·m. The difference is to ' +
        'the print, or to its correction where an erratum is marked †.'
    ),
    scrolling(h('table', {}, head, body), 'Table 1'),
    errata.length
      ? h(
          'ol',
          {class: 'errata note'},
          errata.map((e, i) => h('li', {id: `erratum-${i + 1}`}, e))
        )
      : ''
  ];
}
