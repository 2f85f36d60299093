// Formulation x property, with the value in the cell and its story on demand.
import {KINDS} from '../data/accuracy_data.js';
import {ORACLES, VERDICTS} from '../data.js';
import {choice, folded, h, scrolling} from '../dom.js';
import {full, short} from '../format.js';

const ORDER = [
  'force_balance',
  'moment_balance',
  'node_order',
  'objectivity',
  'tangent',
  'symmetry',
  'energy_gradient',
  'loop_work',
  'loop_order',
  'fingerprint_alpha',
  'fingerprint_beta',
  'rounding',
  'rounding_tangent'
];
const kColumns = 10;
const isProperty = (name) => name !== 'modelling_error' && !name.startsWith('fe_'); // errors have tables of their own

const property = (finding) => finding.name.slice(`${finding.formulation}/${finding.kind}/`.length);

/** @param {import('../data.js').Results} results */
function columnsOf(results, kind) {
  const names = new Set(
    results.findings
      .filter((f) => f.formulation && f.kind === kind && f.name.startsWith(`${f.formulation}/${kind}/`))
      .map(property)
      .filter(isProperty)
  );
  return [...ORDER.filter((n) => names.has(n)), ...[...names].filter((n) => !ORDER.includes(n)).sort()];
}

/** The whole story of a finding in one line. */
export function story(f) {
  const unit = f.unit && f.unit !== '-' ? ` ${f.unit}` : '';
  if (f.verdict === 'left_out') return `left out: ${f.reason}`;
  const held = {
    at_most: `at most ${short(f.high, 3)}${unit}`,
    at_least: `at least ${short(f.low, 3)}${unit}`,
    within: `between ${short(f.low, 3)} and ${short(f.high, 3)}${unit}`,
    equal: `${full(f.expected)}${unit} within ${short(f.high, 2)}`,
    report: 'nothing, a measured number'
  }[f.comparison];
  return (
    `${VERDICTS[f.verdict].label}: ${full(f.value)}${unit}, held against ${held}; oracle: ${ORACLES[f.oracle] ?? f.oracle}` +
    (f.uncertainty > 0 ? ` (known to ${short(f.uncertainty)})` : '') +
    (f.parameter ? `; worst case: ${f.parameter}` : '') +
    (f.reason ? `; why this limit: ${f.reason}` : '')
  );
}

function cell(finding, detail) {
  if (!finding) return h('td', {class: 'mark none', title: 'not asked of this formulation'}, '');
  const text =
    finding.verdict === 'left_out'
      ? VERDICTS.left_out.mark
      : `${VERDICTS[finding.verdict].mark} ${short(finding.value, 2)}`;
  const show = () => detail.replaceChildren(h('code', {}, finding.name), ' ', story(finding));
  return h(
    'td',
    {class: `mark ${finding.verdict}`},
    h('button', {type: 'button', class: 'cell', title: story(finding), onclick: show, onfocus: show}, text)
  );
}

/** As many columns as are read without moving the table.
 * @param {string[]} columns
 */
const inGroups = (columns) =>
  Array.from({length: Math.ceil(columns.length / kColumns)}, (_, i) =>
    columns.slice(i * kColumns, (i + 1) * kColumns)
  );

/** @param {import('../data.js').Results} results */
function matrixOf(results, kind, columns, detail) {
  const head = h(
    'thead',
    {},
    h(
      'tr',
      {},
      h('th', {scope: 'col'}, 'formulation'),
      columns.map((c) => h('th', {scope: 'col'}, c.replaceAll('_', ' ')))
    )
  );
  const row = ({name}) =>
    h(
      'tr',
      {},
      h('th', {scope: 'row'}, h('code', {}, name)),
      columns.map((c) => cell(results.finding(name, kind, c), detail))
    );
  return h('table', {class: 'matrix'}, head, h('tbody', {}, results.formulations.map(row)));
}

/** @param {import('../data.js').Results} results */
export function propertyMatrix(results) {
  const place = h('div');
  const detail = h(
    'p',
    {class: 'detail', 'aria-live': 'polite'},
    'Choose a cell to read its value, its limit, where the limit comes from and the worst case.'
  );
  const draw = (kind) => {
    const columns = columnsOf(results, kind);
    if (!columns.length) {
      place.replaceChildren(h('p', {class: 'empty'}, 'Nothing was measured for this kind.'));
      return;
    }
    const tables = inGroups(columns).map((group, i) =>
      scrolling(matrixOf(results, kind, group, detail), `Property matrix, part ${i + 1}`)
    );
    place.replaceChildren(
      tables[0],
      tables.length > 1 ? folded('Every other property', tables.slice(1)) : ''
    );
  };
  draw('angular');
  return [
    h(
      'div',
      {class: 'controls'},
      choice('Kind of joint', KINDS, 'angular', draw),
      h(
        'p',
        {class: 'keys'},
        Object.entries(VERDICTS).map(([key, v]) =>
          h('span', {class: `key mark ${key}`}, `${v.mark} ${v.label}`)
        )
      )
    ),
    place,
    detail
  ];
}
