// Changes in words. No document here.
import {VERDICTS} from '../data.js';
import {isNumber, plural, powerOfTen, short} from '../format.js';

/** @typedef {import('./history_data.js').Story} Story */
/** @typedef {import('./history_data.js').History} History */

/** A ratio beyond this is a factor for people, not a percentage. */
const kFactor = 2;
/** Significant digits of a value. */
const kDigits = 4;

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

/** A chance below this is none that a person weighs. */
const kLeast = 1e-6;

/** How sure. @param {Story} c */
export const sure = ({p}) =>
  !isNumber(p) ? 'exact' : p < kLeast ? `p < ${powerOfTen(kLeast)}` : `p = ${short(p, 1)}`;
export const SURE_NOTE =
  'How sure: exact where a figure has no noise; else p, the chance that noise alone would look like this.';

export const MARKS = {
  regression: {mark: VERDICTS.fail.mark, cls: 'fail', label: 'worse'},
  improvement: {mark: VERDICTS.pass.mark, cls: 'pass', label: 'better'}
};

export const verdictText = (/** @type {string} */ verdict) => VERDICTS[verdict]?.label ?? '';

/** Both values in as many digits as tell them apart, four at least. @param {Story} c @param {string} unit */
export function fromTo({before, after}, unit) {
  const texts = (/** @type {number} */ digits) => [before, after].map((x) => short(x, digits));
  let digits = kDigits;
  while (digits < 17 && before !== after && texts(digits)[0] === texts(digits)[1]) digits++;
  const [from, to] = [before, after].map((x) => (isNumber(x) ? short(x, digits) : 'not measured'));
  return `${from} → ${to}${unit && isNumber(after) ? ` ${unit}` : ''}`;
}

const VALUE = String.raw`(-?[\d.]+(e[-+]?\d+)?|not measured)`;
/** What the amount and both values say already. */
const SAID = new RegExp(String.raw`^(time [-+][\d.]+ %|${VALUE} -> ${VALUE}|[\d.]+ digits (lost|gained))$`);

/** What a change says beside its values, with numbers for people: its verdict, its limit, what else was measured.
 * @param {string} text
 */
export const told = (text) =>
  text
    .split(/[;,] /)
    .filter((part) => !SAID.test(part))
    .map((part) =>
      part
        .replace(/\b\d[\d.]*(e[-+]?\d+)?/g, (number) => short(Number(number), kDigits))
        .replace('known_failure', VERDICTS.known_failure.label)
        .replace('left_out', VERDICTS.left_out.label)
        .replace('->', '→')
    )
    .join('; ');

/** A value with its unit, in as many digits as it is known. @param {unknown} x @param {string} unit */
export const withUnit = (x, unit) =>
  isNumber(x) ? `${short(x, kDigits)}${unit ? ` ${unit}` : ''}` : 'not measured';

/** Runs of its series from a run to the last, that one included. @param {History} history @param {Story} c */
export const runsSince = (history, {series, run}) =>
  plural(history.series[series].runs.filter((r) => r >= run).length, 'run');
