// Sentences that must read the same wherever they stand.
import {h} from '../dom.js';

/** The sign of loads, for every place that shows some. */
export const signNote = () =>
  h('span', {class: 'sign'}, 'q = dU/dx: internal loads; add −q to the equations of motion.');

/** What a time is of, where a table or chart says it in short. */
export const TIMES_NOTE =
  'Kernel: the branch-free text that a solver would use; transcription: the readable one, in Eigen. ' +
  'Without tangent: loads alone; with tangent: loads and their derivatives. ';
