// The picture of one figure's trend: its line, limits, levels between changes, releases, and a cursor.
import {PATHS, svg} from '../dom.js';
import {isNumber, plural} from '../format.js';
import {look} from '../palette.js';
import {frameOf, picture, text, xAxis, yAxis} from './plot.js';
import {evenly, scaleOf} from './scale.js';
import {linePath} from './spark.js';
import {extremes, levels, steps} from './trend_data.js';
import {amount, MARKS} from './words.js';

/** @typedef {import('./history_data.js').History} History */
/** @typedef {import('./history_data.js').Story} Story */
/** @typedef {import('./trend_data.js').Trend} Trend */
/** @typedef {{history: History, figure: number, trend: Trend, changes: Story[], isLog: boolean,
 *   width: number}} Request */

const kHeight = 340;
const kTickWidth = 105; // px for one date
const kLetter = 7.3; // px, about
/** With more runs than this a dot for each would hide the line. */
const kDots = 80;

/** Everything that has to be on the axis. @param {Trend} trend */
export const valuesOf = ({value, low, high, limit}) =>
  [value, low, high, limit].flatMap((v) => v.filter(isNumber));

const px = (/** @type {number} */ v) => v.toFixed(1);

/** @param {(number | null)[]} column */
function stepPath(column, x, y) {
  let isOn = false;
  const parts = column.map((v, n) => {
    const was = isOn;
    isOn = isNumber(v);
    if (!isNumber(v)) return was ? `H${px(x(n - 1))}` : '';
    if (!was) return `M${px(x(n))},${px(y.at(v))}`;
    return v === column[n - 1] ? '' : `H${px(x(n))}V${px(y.at(v))}`;
  });
  return parts.join('') + (isOn ? `H${px(x(column.length - 1))}` : '');
}

/** From low to high, upright; of several runs in one column of pixels the outermost. @param {Trend} trend */
function whiskers({low, high}, x, y, columns) {
  const step = Math.max(1, low.length / columns);
  /** @type {Map<number, {n: number, ends: number[]}>} */
  const byColumn = new Map();
  low.forEach((l, n) => {
    const c = Math.floor(n / step);
    const {ends} = byColumn.get(c) ?? {ends: []};
    const there = [...ends, l, high[n]].filter(isNumber);
    if (there.length) byColumn.set(c, {n, ends: [Math.min(...there), Math.max(...there)]});
  });
  const path = [...byColumn.values()].map(
    ({n, ends: [a, b]}) => `M${px(x(n))},${px(y.at(a))}V${px(y.at(b))}`
  );
  return path.join('');
}

/** Upright marks with words at height `row`, where these do not run into one another.
 * @param {import('./plot.js').Frame} frame @param {number} row
 * @param {{at: number, cls: string, words: string, shape?: string}[]} list
 */
function flags({width, top, bottom}, row, list) {
  let free = -Infinity;
  return list.map(({at, cls, words, shape}) => {
    const length = words.length * kLetter;
    const wanted = shape ? at - length / 2 : at + 4; // without a mark beside the line
    const begins = Math.max(0, Math.min(wanted, width - length));
    const isShown = begins > free + 8;
    if (isShown) free = begins + length;
    return svg(
      'g',
      {class: cls},
      svg('path', {class: 'mark-line', d: `M${at},${top}V${bottom}`}),
      shape ? svg('path', {class: 'mark', d: PATHS[shape], transform: `translate(${at},${top})`}) : [],
      isShown ? text({class: 'flag', x: begins, y: row}, words) : []
    );
  });
}

/** Changes with their commit, and releases. @param {Request} request @param {(n: number) => number} x */
function allFlags({history, trend, changes}, frame, x) {
  const rising = [...changes].sort((a, b) => a.run - b.run);
  const found = rising.map((c) => ({
    at: x(trend.runs.indexOf(c.run)),
    cls: `change ${MARKS[c.verdict].cls}`,
    words: `${MARKS[c.verdict].mark} ${history.commit(c.run)} ${amount(c)}`,
    shape: c.verdict === 'regression' ? 'triangle-up' : 'triangle-down'
  }));
  const released = trend.runs.flatMap((run, n) => {
    const words = history.runs.release[run];
    return words ? [{at: x(n), cls: 'release', words}] : [];
  });
  return [...flags(frame, frame.top + 10, released), ...flags(frame, frame.top - 10, found)];
}

/** Dates below the axis; of several runs of one day the first. @param {Request} request */
function dates({history, trend}, frame, x) {
  const places = evenly(trend.runs.length, Math.floor((frame.right - frame.left) / kTickWidth));
  const ticks = places.map((n) => ({at: x(n), label: history.day(trend.runs[n])}));
  return ticks.filter((t, i) => t.label !== ticks[i - 1]?.label);
}

/** What the line is made of: times as they scatter, everything else as it steps. @param {Request} request */
function lines({history, figure, trend, changes}, frame, x, y) {
  const columns = Math.max(1, Math.round(frame.right - frame.left));
  const color = look(history.figures.formulation[figure] || 'common').color;
  const dot = (/** @type {number} */ n) => {
    const v = trend.value[n];
    const cls = trend.verdict[n] || 'dot';
    return isNumber(v)
      ? svg('circle', {class: `dot ${cls}`, cx: x(n), cy: y.at(v), r: 3.2, style: `--color:${color}`})
      : [];
  };
  const limit = svg('path', {class: 'limit', d: stepPath(trend.limit, x, y)});
  if (history.figures.kind[figure] !== 'time') {
    return [
      limit,
      svg('path', {class: 'line', d: stepPath(trend.value, x, y), style: `--color:${color}`}),
      steps(trend).map(dot)
    ];
  }
  const points = extremes(trend.value, columns).map((n) => {
    const v = trend.value[n];
    return isNumber(v) ? /** @type {[number, number]} */ ([x(n), y.at(v)]) : null;
  });
  const isFew = trend.runs.length <= kDots;
  return [
    svg('path', {class: 'whiskers', d: whiskers(trend, x, y, columns), style: `--color:${color}`}),
    svg('path', {class: isFew ? 'line' : 'line fine', d: linePath(points), style: `--color:${color}`}),
    isFew ? [...trend.runs.keys()].map(dot) : [],
    limit,
    levels(trend, changes).map(({from, to, value}) =>
      svg('path', {class: 'level', d: `M${x(from)},${y.at(value)}H${x(to)}`})
    )
  ];
}

/** What the marks mean that are in the picture. @param {History} history @param {number} figure @param {Trend} trend */
export function legendText({figures, runs}, figure, trend) {
  const isTime = figures.kind[figure] === 'time';
  const spread = trend.low.filter(isNumber).length;
  const marks = [
    isTime ? 'The firm line: medians between changes.' : 'A dot: a change of value, limit or verdict.',
    spread ? `Broad and pale: least to largest repetition, of the last ${plural(spread, 'run')}.` : '',
    trend.limit.some(isNumber) ? 'Dashed: the limit.' : '',
    trend.runs.some((run) => runs.release[run]) ? 'Dotted: releases.' : ''
  ];
  return marks.filter(Boolean).join(' ');
}

/** The picture, the position of a run under a pixel, and a cursor to put on a run.
 * @param {Request} request @param {string} label
 */
export function trendChart(request, label) {
  const {history, figure, trend, isLog, width} = request;
  const frame = frameOf(width, kHeight);
  frame.top = 50; // room for the flags
  const last = Math.max(trend.runs.length - 1, 1);
  const x = (/** @type {number} */ n) => frame.left + ((frame.right - frame.left) * n) / last;
  const y = scaleOf(valuesOf(trend), frame.bottom, frame.top + 14, isLog);
  const unit = history.figures.unit[figure];
  const cursor = svg('path', {class: 'cursor'});
  const drawn = picture(frame, label);
  drawn.append(
    ...yAxis({...frame, top: 26}, y, `${unit || 'value'}${isLog ? ', logarithmic' : ''}`),
    ...xAxis(frame, dates(request, frame, x), 'runs in order'),
    ...lines(request, frame, x, y).flat(2),
    ...allFlags(request, frame, x),
    cursor
  );
  const nearest = (/** @type {number} */ across) =>
    Math.min(
      trend.runs.length - 1,
      Math.max(0, Math.round(((across - frame.left) / (frame.right - frame.left)) * last))
    );
  return {
    drawn,
    nearest,
    point: (/** @type {number} */ n) => cursor.setAttribute('d', `M${x(n)},${frame.top}V${frame.bottom}`)
  };
}
