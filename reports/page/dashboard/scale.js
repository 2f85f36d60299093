// Axes: from values to pixels, with ticks that people read. No document here.

/** @typedef {{at: (x: number) => number, ticks: number[], isLog: boolean}} Scale */

const kTicks = 6;
/** A logarithmic axis fits where the values span more than this. */
const kLogFrom = 20;
/** Free space above and below the values, as a share of the axis. */
const kMargin = 0.06;

/** 1, 2 or 5 times a power of ten, near to `rough`. @param {number} rough */
function niceStep(rough) {
  const power = 10 ** Math.floor(Math.log10(rough));
  return power * ([1, 2, 5].find((m) => m * power >= rough) ?? 10);
}

/** @param {number} low @param {number} high */
function linearTicks(low, high) {
  const step = niceStep((high - low) / kTicks);
  const first = Math.ceil(low / step);
  const count = Math.floor(high / step) - first + 1;
  return Array.from({length: Math.max(count, 0)}, (_, i) => Number(((first + i) * step).toPrecision(12)));
}

/** Decades, every n-th where there are many; inside of a decade 1, 2, 5, or even steps.
 * @param {number} low @param {number} high
 */
function logTicks(low, high) {
  const first = Math.ceil(Math.log10(low));
  const last = Math.floor(Math.log10(high));
  if (last - first < 1) {
    const near = [first - 1, first, first + 1].flatMap((e) => [1, 2, 5].map((m) => m * 10 ** e));
    const inside = near.filter((t) => t >= low && t <= high);
    return inside.length > 2 ? inside : linearTicks(low, high);
  }
  const every = Math.ceil((last - first + 1) / kTicks);
  const count = Math.floor((last - first) / every) + 1;
  return Array.from({length: count}, (_, i) => Number(`1e${first + i * every}`));
}

/** Least and greatest. @param {number[]} values */
export const ends = (values) =>
  values.reduce(([a, b], x) => [Math.min(a, x), Math.max(b, x)], [Infinity, -Infinity]);

/** @param {number[]} values */
export function logFits(values) {
  const [low, high] = ends(values);
  return low > 0 && high / low > kLogFrom;
}

/** @param {number[]} values */
export const logCan = (values) => values.length > 0 && ends(values)[0] > 0;

/** An axis that shows all values, from pixel a to pixel b.
 * @param {number[]} values @param {number} a @param {number} b @param {boolean} isLog
 * @returns {Scale}
 */
export function scaleOf(values, a, b, isLog) {
  const forth = isLog ? Math.log10 : (/** @type {number} */ x) => x;
  const back = isLog ? (/** @type {number} */ x) => 10 ** x : (/** @type {number} */ x) => x;
  let [low, high] = values.length ? ends(values).map(forth) : [0, 1];
  // One value alone: room on both sides, as much as the value where it is large.
  const room = (high - low || (isLog ? 1 : Math.abs(high) || 1)) * kMargin;
  low -= room;
  high += room;
  const at = (/** @type {number} */ x) => a + ((forth(x) - low) / (high - low)) * (b - a);
  return {at, isLog, ticks: isLog ? logTicks(back(low), back(high)) : linearTicks(low, high)};
}

/** At most `most` positions of n, evenly, the first and last as well. @param {number} n @param {number} most */
export function evenly(n, most) {
  const count = Math.min(n, Math.max(most, 1));
  const last = Math.max(count - 1, 1);
  return Array.from({length: count}, (_, i) => Math.round((i * (n - 1)) / last));
}
