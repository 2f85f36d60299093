// Formulation x property, with the value in the cell and its story on demand.
import {KINDS, ORACLES, VERDICTS} from '../data.js';
import {choice, h, scrolling} from '../dom.js';
import {full, short} from '../format.js';

const ORDER = ['force_balance', 'moment_balance', 'node_order', 'objectivity', 'tangent', 'symmetry', 'energy_gradient', 'loop_work', 'loop_order',
  'fingerprint_alpha', 'fingerprint_beta', 'rounding', 'rounding_tangent'];
const isProperty = (name) => name !== 'modelling_error' && !name.startsWith('fe_');  // errors have tables of their own

const property = (finding) => finding.name.slice(`${finding.formulation}/${finding.kind}/`.length);

function columnsOf(results, kind) {
  const names = new Set(results.findings.filter((f) => f.formulation && f.kind === kind && f.name.startsWith(`${f.formulation}/${kind}/`)).map(property).filter(isProperty));
  return [...ORDER.filter((n) => names.has(n)), ...[...names].filter((n) => !ORDER.includes(n)).sort()];
}

/** The whole story of a finding in one line. */
export function story(f) {
  const unit = f.unit && f.unit !== '-' ? ` ${f.unit}` : '';
  if (f.verdict === 'left_out') return `left out: ${f.reason}`;
  const held = {at_most: `at most ${short(f.high, 3)}${unit}`, at_least: `at least ${short(f.low, 3)}${unit}`, within: `between ${short(f.low, 3)} and ${short(f.high, 3)}${unit}`,
                equal: `${full(f.expected)}${unit} within ${short(f.high, 2)}`, report: 'nothing, a measured number'}[f.comparison];
  return `${VERDICTS[f.verdict].label}: ${full(f.value)}${unit}, held against ${held}; oracle: ${ORACLES[f.oracle] ?? f.oracle}` +
    (f.uncertainty > 0 ? ` (known to ${short(f.uncertainty)})` : '') + (f.parameter ? `; worst case: ${f.parameter}` : '') + (f.reason ? `; why this limit: ${f.reason}` : '');
}

function cell(finding, detail) {
  if (!finding) return h('td', {class: 'mark none', title: 'not asked of this formulation'}, '');
  const text = finding.verdict === 'left_out' ? VERDICTS.left_out.mark : `${VERDICTS[finding.verdict].mark} ${short(finding.value, 2)}`;
  const show = () => detail.replaceChildren(h('code', {}, finding.name), ' ', story(finding));
  return h('td', {class: `mark ${finding.verdict}`}, h('button', {type: 'button', class: 'cell', title: story(finding), onclick: show, onfocus: show}, text));
}

export function propertyMatrix(results) {
  const place = h('div');
  const detail = h('p', {class: 'detail', 'aria-live': 'polite'}, 'Choose a cell to read its value, its limit, where the limit comes from and the worst case.');
  const draw = (kind) => {
    const columns = columnsOf(results, kind);
    if (!columns.length) { place.replaceChildren(h('p', {class: 'empty'}, 'Nothing was measured for this kind.')); return; }
    const head = h('thead', {}, h('tr', {}, h('th', {scope: 'col'}, 'formulation'), columns.map((c) => h('th', {scope: 'col'}, c.replaceAll('_', ' ')))));
    const body = h('tbody', {}, results.formulations.map((f) => h('tr', {}, h('th', {scope: 'row'}, h('code', {}, f.name)),
      columns.map((c) => cell(results.finding(f.name, kind, c), detail)))));
    place.replaceChildren(scrolling(h('table', {class: 'matrix'}, head, body), 'Property matrix'));
  };
  draw('angular');
  return h('section', {'aria-labelledby': 'properties'}, h('h2', {id: 'properties'}, 'What each formulation keeps'),
    h('div', {class: 'controls'}, choice('Kind of joint', KINDS, 'angular', draw),
      h('p', {class: 'keys'}, Object.entries(VERDICTS).map(([key, v]) => h('span', {class: `key mark ${key}`}, `${v.mark} ${v.label}`)))), place, detail);
}
