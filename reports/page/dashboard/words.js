// Changes in words. No document here.
import {isNumber, plural, short} from '../format.js';

/** @typedef {import('./history_data.js').Story} Story */
/** @typedef {import('./history_data.js').History} History */

/** A ratio beyond this is a factor for people, not a percentage. */
const kFactor = 2;

/** @param {number} ratio */
export function ratioText(ratio) {
  if (!(ratio > 0)) return '';
  if (ratio >= kFactor || ratio <= 1 / kFactor) return `× ${short(ratio)}`;
  const percent = 100 * (ratio - 1);
  return `${percent < 0 ? '−' : '+'}${short(Math.abs(percent))} %`;
}

/** How much. @param {Story} c */
export function amount({digits, ratio, verdict}) {
  if (isNumber(digits)) {
    const size = short(Math.abs(digits));
    return `${size} ${size === '1' ? 'digit' : 'digits'} ${verdict === 'regression' ? 'lost' : 'gained'}`;
  }
  return isNumber(ratio) ? ratioText(ratio) : '';
}

/** How sure. @param {Story} c */
export const sure = ({p}) => (isNumber(p) ? (p === 0 ? 'p ≈ 0' : `p = ${short(p, 1)}`) : 'exact');

export const MARKS = {
  regression: {mark: '✗', cls: 'fail', label: 'worse'},
  improvement: {mark: '✓', cls: 'pass', label: 'better'}
};

/** A value with its unit, in as many digits as it is known. @param {unknown} x @param {string} unit */
export const withUnit = (x, unit) =>
  isNumber(x) ? `${short(x, 4)}${unit ? ` ${unit}` : ''}` : 'not measured';

/** Runs of its series from a run to the last, that one included. @param {History} history @param {Story} c */
export const runsSince = (history, {series, run}) =>
  plural(history.series[series].runs.filter((r) => r >= run).length, 'run');
