// Every number: all findings, what failed or was left out, how to read them, where they come from.
import {findingsTable} from './findings_table.js';
import {leftOut} from './left_out.js';
import {provenance} from './provenance.js';
import {reading} from './reading.js';

/** @type {(results: any, raw: string) => import('../parts.js').PartSpec[]}
 * @param {import('../data.js').Results} results
 */
export const numberParts = (results, raw) => [
  {id: 'reading', title: 'How to read this', build: () => reading()},
  {id: 'left-out', title: 'Failed or left out', build: () => leftOut(results)},
  {id: 'findings', title: 'Every finding', build: () => findingsTable(results)},
  {id: 'provenance', title: 'Where this comes from', build: () => provenance(results, raw)}
];
