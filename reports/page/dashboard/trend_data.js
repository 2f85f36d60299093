// One figure of one series, run by run: what a chart draws, what a table lists. No document here.
import {isNumber} from '../format.js';

/** @typedef {import('./history').FigureBlock} FigureBlock */
/** @typedef {import('./history').Stretch} Stretch */
/** Columns with one entry a run of the series.
 * @typedef {object} Trend
 * @property {number[]} runs
 * @property {(number | null)[]} value
 * @property {(number | null)[]} low
 * @property {(number | null)[]} high
 * @property {(number | null)[]} limit
 * @property {string[]} verdict
 */

/** What is wrong with a figure's block, or ''.
 * @param {import('./history_data.js').History} history
 */
export const blockFault =
  (history) =>
  (/** @type {FigureBlock} */ {s} = {s: []}) => {
    for (const {series, r, v, l, h, limit, verdict} of s ?? []) {
      const runs = r ?? history.series[series]?.runs;
      if (!runs) return `it names the series ${series}, of ${history.series.length}`;
      const bad =
        [v, limit, verdict].find((column) => column && column.length !== runs.length) ??
        [l, h].find((column) => column && column.length > runs.length);
      if (bad) return `${bad.length} values for ${runs.length} runs`;
    }
    return Array.isArray(s) ? '' : 'it holds no values';
  };

/**
 * @param {Stretch | undefined} stretch
 * @param {number[]} runs of the series, rising
 * @param {boolean} holds a value until the next: accuracy and counts
 * @returns {Trend}
 */
export function trendOf(stretch, runs, holds) {
  const columns = {value: stretch?.v, low: stretch?.l, high: stretch?.h, limit: stretch?.limit};
  const at = new Int32Array(runs.length).fill(-1);
  const measured = stretch?.r;
  if (measured) {
    let i = -1;
    runs.forEach((run, n) => {
      while (measured[i + 1] <= run) i++;
      if (holds || measured[i] === run) at[n] = i;
    });
  } else if (stretch) at.forEach((_, n) => (at[n] = n));
  const total = stretch?.v.length ?? 0;
  const spread = (column) => Array.from(at, (i) => column?.[i - total + column.length] ?? null);
  return {
    runs,
    ...{value: spread(columns.value), low: spread(columns.low)},
    ...{high: spread(columns.high), limit: spread(columns.limit)},
    verdict: Array.from(at, (i) => stretch?.verdict?.[i] ?? '')
  };
}

/** Indices to draw so that no extreme is lost: first, least, greatest and last of each of `columns` equal parts.
 * Where there is no value, -1 once.
 * @param {(number | null)[]} values
 * @param {number} columns
 */
export function extremes(values, columns) {
  const {length} = values;
  const step = Math.max(1, length / columns);
  /** @type {number[]} */
  const kept = [];
  for (let c = 0; c * step < length; c++) {
    const from = Math.ceil(c * step);
    const to = Math.min(length, Math.ceil((c + 1) * step));
    const there = [];
    for (let i = from; i < to; i++) if (isNumber(values[i])) there.push(i);
    if (!there.length) {
      if (kept.at(-1) !== -1) kept.push(-1);
      continue;
    }
    const pick = (/** @type {(a: number, b: number) => boolean} */ isBeyond) =>
      there.reduce((best, i) => (isBeyond(Number(values[i]), Number(values[best])) ? i : best));
    const [least, greatest] = [pick((a, b) => a < b), pick((a, b) => a > b)];
    kept.push(...[...new Set([there[0], least, greatest, there[there.length - 1]])].sort((a, b) => a - b));
  }
  return kept;
}

/** @param {number[]} values */
export function median(values) {
  const sorted = Float64Array.from(values).sort();
  const middle = sorted.length >> 1;
  return sorted.length % 2 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
}

/** Medians between the changes: {from, to, value}, positions in the series.
 * @param {Trend} trend
 * @param {{run: number}[]} changes
 */
export function levels({runs, value}, changes) {
  const begins = changes.map((c) => runs.indexOf(c.run)).filter((n) => n > 0);
  const bounds = [0, ...begins.sort((a, b) => a - b), runs.length];
  return bounds.slice(1).flatMap((to, k) => {
    const there = value.slice(bounds[k], to).filter(isNumber);
    return there.length ? [{from: bounds[k], to: to - 1, value: median(there)}] : [];
  });
}

/** Where the value differs from that of the run before. @param {Trend} trend */
export const steps = ({value, limit, verdict}) =>
  [...value.keys()].filter(
    (n) => n === 0 || value[n] !== value[n - 1] || limit[n] !== limit[n - 1] || verdict[n] !== verdict[n - 1]
  );

const quoted = (/** @type {unknown} */ x) => {
  const text = String(x ?? '');
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
};

/** RFC 4180. @param {unknown[][]} rows */
export const csvText = (rows) => rows.map((cells) => `${cells.map(quoted).join(',')}\r\n`).join('');

/** One line a run.
 * @param {import('./history_data.js').History} history @param {number} figure @param {Trend} trend
 */
export function csvOf(history, figure, trend) {
  const {commit, date, title} = history.runs;
  const unit = history.figures.unit[figure];
  const head = ['figure', 'unit', 'commit', 'date', 'title', 'value', 'low', 'high', 'limit', 'verdict'];
  const lines = trend.runs.map((run, n) => [
    history.figures.name[figure],
    unit,
    commit[run],
    new Date(1000 * date[run]).toISOString(),
    title[run],
    ...[trend.value[n], trend.low[n], trend.high[n], trend.limit[n], trend.verdict[n]]
  ]);
  return csvText([head, ...lines]);
}

/** One median for each of `columns` equal parts, in the middle of it: {n, value}, value null where there is none.
 * @param {(number | null)[]} values
 * @param {number} columns
 */
export function medians(values, columns) {
  const step = Math.max(1, values.length / columns);
  return Array.from({length: Math.ceil(values.length / step)}, (_, c) => {
    const from = Math.ceil(c * step);
    const to = Math.min(values.length, Math.ceil((c + 1) * step));
    const there = values.slice(from, to).filter(isNumber);
    return {n: (from + to - 1) / 2, value: there.length ? median(there) : null};
  });
}
