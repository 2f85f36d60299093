// Accuracy against speed, run by run. No document here.
import {isNumber} from '../format.js';
import {ends} from './scale.js';
import {csvText} from './trend_data.js';

/** @typedef {import('./trend_data.js').Trend} Trend */
/** @typedef {{formulation: string, time: Trend, error: Trend}} Measured */
/** @typedef {{formulation: string, ns: number, error: number}} Point */

/** The last value at a run or before it: not every run measures everything. @param {(number | null)[]} column */
function lastUpTo(column, n) {
  for (let i = n; i >= 0; i--) if (isNumber(column[i])) return column[i];
  return null;
}

/** @param {Measured[]} measured @param {number} n position of a run in its series @returns {Point[]} */
export const pointsAt = (measured, n) =>
  measured.flatMap(({formulation, time, error}) => {
    const ns = lastUpTo(time.value, n);
    const e = lastUpTo(error.value, n);
    return isNumber(ns) && isNumber(e) ? [{formulation, ns, error: e}] : [];
  });

/** Every run of the series, one line a formulation.
 * @param {import('./history_data.js').History} history @param {number[]} runs @param {Measured[]} measured
 */
export function pointsCsv({runs: {commit, date}}, runs, measured) {
  const lines = runs.flatMap((run, n) =>
    pointsAt(measured, n).map((p) => [
      commit[run],
      new Date(1000 * date[run]).toISOString(),
      ...[p.formulation, p.ns, p.error]
    ])
  );
  return csvText([['commit', 'date', 'formulation', 'ns', 'error'], ...lines]);
}

/** All values of an axis, and where a zero is drawn on a logarithmic one: a decade below the least.
 * @param {Measured[]} measured
 */
export function extents(measured) {
  const of = (/** @type {'time' | 'error'} */ key) =>
    measured.flatMap((m) => m[key].value.filter(isNumber).filter((v) => v > 0));
  const [ns, error] = [of('time'), of('error')].map(ends);
  const hasZero = measured.some((m) => m.error.value.includes(0));
  const floor = Number.isFinite(error[0]) ? error[0] / 10 : 1e-17;
  const errors = [hasZero ? floor : error[0], error[1]].filter(Number.isFinite);
  return {ns: ns.filter(Number.isFinite), error: errors.length ? errors : [floor, 1], floor, hasZero};
}

/** Places for labels beside their points that overlap neither one another nor another point; null where there is none.
 * @param {{x: number, y: number, width: number}[]} points @param {import('./plot.js').Frame} frame
 */
export function placed(points, frame) {
  const kHeight = 14;
  const kGap = 8;
  const taken = points.map(({x, y}) => ({x: x - 5, y: y - 5, width: 10, height: 10}));
  const free = (a) =>
    a.x >= frame.left &&
    a.x + a.width <= frame.right &&
    a.y >= frame.top &&
    a.y + a.height <= frame.bottom &&
    taken.every(
      (b) => a.x >= b.x + b.width || b.x >= a.x + a.width || a.y >= b.y + b.height || b.y >= a.y + a.height
    );
  return points.map(({x, y, width}) => {
    const middle = y - kHeight / 2;
    const tries = [
      [x + kGap, middle],
      [x - kGap - width, middle],
      [x - width / 2, y - kGap - kHeight],
      [x - width / 2, y + kGap]
    ];
    const box = tries.map(([bx, by]) => ({x: bx, y: by, width, height: kHeight})).find(free);
    if (box) taken.push(box);
    return box ? {x: box.x, y: box.y + 11} : null;
  });
}
