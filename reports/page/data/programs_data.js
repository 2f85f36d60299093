// What real programs compute (results.programs): one row a program that was run, or a law that was read.
import {short} from '../format.js';

/** @typedef {import('../results').Program} Program */
/** @typedef {import('../results').ProgramCase} ProgramCase */
/** `isAgain`: the row above is of the same law.
 * @typedef {{program: string, version: string, law: string, known: string, source: string, agreement: string,
 *   details: string, defects: string, facts: string, isAgain: boolean}} Row */

/** @param {import('../results').ProgramDefect} defect */
export const defectText = ({words, size}) => `${words}: ${short(size)}`;

/** @param {ProgramCase} run */
const detailsOf = ({poses, good_to: goodTo, answers, how}) =>
  `${poses} poses; ${answers === 'live' ? 'live' : 'kept'} answers, good to ${goodTo} digits: ${how}`;

/** @param {Program} law @param {ProgramCase | undefined} run @param {boolean} isAgain @returns {Row} */
const rowOf = (law, run, isAgain) => ({
  program: run?.program ?? law.stands_for,
  version: run?.version ?? '',
  law: law.name,
  known: law.known,
  source: law.source,
  agreement: run ? run.digits.toFixed(1) : '',
  details: run ? detailsOf(run) : '',
  defects: law.defects.map(defectText).join('; '),
  facts: law.facts.join('; '),
  isAgain
});

/** In the order of the results: measured ones first.
 * @param {{programs: Program[]}} results
 * @returns {Row[]}
 */
export const rowsOf = ({programs}) =>
  programs.flatMap((law) =>
    law.cases.length ? law.cases.map((run, i) => rowOf(law, run, i > 0)) : [rowOf(law, undefined, false)]
  );

/** How many programs were run, and how many laws there are.
 * @param {{programs: Program[]}} results
 */
export const countsOf = ({programs}) => ({
  laws: programs.length,
  run: programs.reduce((sum, law) => sum + law.cases.length, 0)
});
