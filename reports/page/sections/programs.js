// What real programs compute: each law, how it is known, how well it meets the program's own answers.
import {h, plainTable} from '../dom.js';
import {plural} from '../format.js';
import {countsOf, rowsOf} from '../data/programs_data.js';
import {Absent} from '../parts.js';

const COLUMNS = [
  {text: 'program'},
  {text: 'version'},
  {text: 'law'},
  {text: 'how known'},
  {text: 'agreement, digits', number: true},
  {text: 'defects, with their sizes'}
];

const aside = (text) => h('span', {class: 'aside'}, text);

/** @param {import('../data/programs_data.js').Row} row */
const cells = (row) => [
  row.program,
  row.version || '–',
  h('code', {}, row.law),
  row.isAgain ? row.known : [row.known, aside(row.source)],
  row.agreement ? h('span', {title: row.details}, row.agreement) : '–',
  row.isAgain ? 'as above' : [row.defects || 'none found', row.facts ? aside(row.facts) : null]
];

/** @param {import('../data.js').Results} results */
export function programsTable(results) {
  if (!results.programs.length)
    return new Absent('no joint of another program was verified with these results');
  const {laws, run} = countsOf(results);
  return [
    plainTable('What real programs compute', COLUMNS, rowsOf(results).map(cells), undefined, true),
    h(
      'p',
      {class: 'note'},
      `${plural(laws, 'law')}, ${plural(run, 'program')} run. `,
      'Agreement: decimal digits to which the law meets the loads that the program itself gave, at the worst of ' +
        'its poses; the answers are kept in reference/data/programs, and single precision ends at five or six. ' +
        '–: the program was not run. Sizes are relative to the moments, the loads, or the power along the path; ' +
        'they are those of generic poses up to 1.3 rad. ',
      h('code', {}, './halfway check --command "PROGRAM"'),
      ' holds a program of your own against all of these laws.'
    )
  ];
}
