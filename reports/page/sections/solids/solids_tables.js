// Tables 2 and 3 beside ours: the print, a mesh of its kind, the converged value.
import {VERDICTS} from '../../data.js';
import {h, scrolling} from '../../dom.js';
import {isNumber, percent, short} from '../../format.js';
import {printedDigits, withBar} from '../../data/solids_data.js';
import {story} from '../matrix.js';

const TABLES = [
  {table: 'table_2', body: 'block', title: 'Table 2: parallelepiped'},
  {table: 'table_3', body: 'frustum_top', title: 'Table 3: frustum'}
];
const AXES = [1, 2, 3]
  .map((k) => ({axis: `u${k}`, name: `linear_${k}`, label: `linear ${k}`}))
  .concat([1, 2, 3].map((k) => ({axis: `theta${k}`, name: `angular_${k}`, label: `angular ${k}`})));

function mark(finding) {
  if (!finding) return h('td', {class: 'mark none', title: 'no such finding'}, '–');
  if (finding.verdict === 'left_out') return h('td', {class: 'mark left_out', title: finding.reason}, '–');
  return h(
    'td',
    {class: `mark ${finding.verdict}`, title: story(finding)},
    `${VERDICTS[finding.verdict].mark} ${short(finding.value, 2)}`
  );
}

/** @param {import('../../data.js').Results} results */
function row(results, table, body, {axis, name, label}) {
  const paperMesh = results.finding('fe', table, 'paper_mesh', axis);
  const discretisation = results.finding('fe', table, 'discretisation', axis);
  const ours = body.compliances?.find((c) => c.name === name);
  if (!paperMesh && !discretisation) return null;
  // The finding is printed / converged - 1: six digits of the product are the print again.
  const printed =
    ours && discretisation ? printedDigits(ours.value * (1 + (discretisation.value ?? NaN))) : '–';
  return h(
    'tr',
    {},
    h('th', {scope: 'row'}, label),
    h('td', {class: 'number'}, printed),
    mark(paperMesh),
    h(
      'td',
      {class: 'number', title: ours ? `grid convergence, observed order ${short(ours.order, 3)}` : null},
      ours ? withBar(ours.value, ours.uncertainty, true) : '–'
    ),
    h('td', {class: 'number'}, percent(discretisation?.value))
  );
}

/** @param {import('../../data.js').Results} results */
function oneTable(results, solids, {table, body: name, title}) {
  const body = solids.bodies.find((b) => b.name === name);
  const heading = h('h4', {}, title);
  if (!body)
    return h('div', {}, heading, h('p', {class: 'empty'}, `Not shown: the results hold no 3D body ${name}.`));
  const rows = AXES.map((a) => row(results, table, body, a)).filter(Boolean);
  if (!rows.length)
    return h(
      'div',
      {},
      heading,
      h('p', {class: 'empty'}, `Not shown: the results hold no finding fe/${table}/....`)
    );
  const head = [
    'compliance',
    'printed',
    'the paper’s kind of mesh is off by',
    'converged',
    'error of the print'
  ];
  return h(
    'div',
    {},
    heading,
    scrolling(
      h(
        'table',
        {class: 'compact'},
        h(
          'thead',
          {},
          h(
            'tr',
            {},
            head.map((t, i) => h('th', {scope: 'col', class: i && i !== 2 ? 'number' : null}, t))
          )
        ),
        h('tbody', {}, rows)
      ),
      title
    )
  );
}

/** What the print hides, from the findings.
 * @param {import('../../data.js').Results} results
 */
function remarks(results, solids) {
  const items = [];
  const wrong = results.findings
    .filter((f) => f.name.startsWith('fe/table_3/printed_height/') && f.verdict !== 'left_out')
    .map((f) => f.value)
    .filter(isNumber);
  const height = solids.bodies.find((b) => b.name === 'frustum_top')?.geometry?.length;
  if (wrong.length) {
    items.push(
      `The digits of Table 3 are those of a height of ${height} m; with the printed height they are off by ${percent(Math.min(...wrong))} to ${percent(Math.max(...wrong), 3)}.`
    );
  }
  const matrix = results.byName.get('fe/matrix_51/paper_mesh');
  if (matrix && matrix.verdict !== 'left_out') {
    items.push(
      `Matrix (51), all 36 entries on the paper’s kind of mesh: at most ${short(matrix.value)} units of the last printed digit off (${matrix.parameter}).`
    );
  }
  return items;
}

/** @param {import('../../data.js').Results} results */
export function printedTables(results, solids) {
  return [
    h(
      'div',
      {class: 'columns'},
      TABLES.map((t) => oneTable(results, solids, t))
    ),
    h(
      'p',
      {class: 'note'},
      'Compliances in m/N and rad/(N m). The paper’s kind of mesh, hexahedra with incompatible ' +
        'modes, reproduces the print; the last column is what that mesh is off from the converged ' +
        'value. ',
      '±: grid convergence over the meshes of hex20. ',
      remarks(results, solids).join(' ')
    )
  ];
}
