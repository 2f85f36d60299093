// Small pictures of a trend, drawn when they come into view or are about to be printed.
import {h, svg} from '../dom.js';
import {isNumber} from '../format.js';
import {logFits, scaleOf} from './scale.js';
import {extremes, median, medians} from './trend_data.js';
import {MARKS} from './words.js';

/** @typedef {import('./dashboard.js').App} App */

const kWidth = 130;
const kHeight = 30;
const kInset = 4;
const kColumns = 60;
/** Times are shown at least this far around their middle: what is only noise should look so. */
const kAround = [0.92, 1.08];

/** A line through pixels; a gap begins anew. @param {([number, number] | null)[]} points */
export const linePath = (points) =>
  points
    .map((p, i) => (p ? `${i && points[i - 1] ? 'L' : 'M'}${p[0].toFixed(1)},${p[1].toFixed(1)}` : ''))
    .join('');

/** @param {import('./trend_data.js').Trend} trend @param {import('./history_data.js').Story[]} changes */
function drawn({runs, value}, changes, isTime) {
  const places = isTime
    ? medians(value, kColumns)
    : extremes(value, kColumns).map((n) => ({n, value: value[n] ?? null}));
  const values = places.map((p) => p.value).filter(isNumber);
  const x = (/** @type {number} */ n) => kInset + ((kWidth - 2 * kInset) * n) / Math.max(runs.length - 1, 1);
  const around = isTime ? kAround.map((f) => f * median(values)) : [];
  const y = scaleOf([...values, ...around], kHeight - kInset, kInset, logFits(values));
  const points = places.map((p) =>
    isNumber(p.value) ? /** @type {[number, number]} */ ([x(p.n), y.at(p.value)]) : null
  );
  const last = points.filter((p) => p !== null).at(-1);
  return svg(
    'svg',
    {
      class: 'plot spark',
      width: kWidth,
      height: kHeight,
      viewBox: `0 0 ${kWidth} ${kHeight}`,
      'aria-hidden': 'true'
    },
    changes.map((c) => {
      const at = x(runs.indexOf(c.run));
      return svg('path', {class: `mark-line ${MARKS[c.verdict].cls}`, d: `M${at},0V${kHeight}`});
    }),
    svg('path', {class: 'line', d: linePath(points)}),
    last ? svg('circle', {class: 'dot', cx: last[0], cy: last[1], r: 2.5}) : []
  );
}

export class Sparks {
  /** @param {App} app */
  constructor(app) {
    this.app = app;
    /** One after another, so that what a reader asks for comes between. */
    this.queue = Promise.resolve();
    /** @type {WeakMap<Element, () => Promise<void>>} */
    this.waiting = new WeakMap();
    this.observer = new IntersectionObserver((entries) => {
      for (const {isIntersecting, target} of entries) if (isIntersecting) this.draw(target);
    });
    window.addEventListener('beforeprint', () => this.all());
  }

  /** On paper nothing comes into view any more. */
  all() {
    for (const box of document.querySelectorAll('.spark-box:empty')) this.draw(box);
  }

  /** @param {Element} box */
  draw(box) {
    this.observer.unobserve(box);
    this.queue = this.queue.then(this.waiting.get(box));
  }

  /** The trend of a figure in a series. @param {number} figure @param {number} series */
  of(figure, series) {
    const {history} = this.app;
    const box = h('span', {class: 'spark-box'});
    this.waiting.set(box, async () => {
      const changes = history.changesOf(series, (c) => c.figure === figure);
      try {
        const trend = await this.app.trend(figure, series);
        box.replaceChildren(drawn(trend, changes, history.figures.kind[figure] === 'time'));
      } catch {
        box.replaceChildren('data damaged'); // the trend itself says more
      }
    });
    this.observer.observe(box);
    return box;
  }
}
