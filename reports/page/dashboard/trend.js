// The trend of one figure: search, picture, a cursor over its runs, table, files.
import {button, choice, download, folded, h} from '../dom.js';
import {full, isNumber, plural, short} from '../format.js';
import {chooser} from './chooser.js';
import {amountMark, figureLink, growingTable, nothing, runSlider, runWords} from './pieces.js';
import {svgFile} from './plot.js';
import {logCan, logFits} from './scale.js';
import {legendText, trendChart, valuesOf} from './trend_chart.js';
import {csvOf} from './trend_data.js';
import {amount, fromTo, MARKS, sure, told, verdictText, withUnit} from './words.js';

/** @typedef {import('./dashboard.js').App} App */
/** @typedef {import('./history_data.js').Story} Story */
/** @typedef {import('./trend_data.js').Trend} Trend */

const kRows = 50; // of the table, at first
/** @type {('value' | 'low' | 'high' | 'limit')[]} */
const NUMBERS = ['value', 'low', 'high', 'limit'];
const BETTER = {down: 'smaller is better', up: 'larger is better', none: 'neither way is better'};
const AXES = [
  {key: 'linear', label: 'linear'},
  {key: 'log', label: 'logarithmic'}
];

/** One run in words. @param {App} app @param {Trend} trend @param {number} n */
function readout({history, place}, trend, n) {
  const {commit, title, release, load} = {...history.runs, commit: history.commit(trend.runs[n])};
  const run = trend.runs[n];
  const unit = history.figures.unit[place.figure];
  const [low, high, limit] = [trend.low[n], trend.high[n], trend.limit[n]];
  return [
    `${history.day(run)} ${commit} ${title[run]}: ${withUnit(trend.value[n], unit)}`,
    isNumber(low) && isNumber(high) ? `${short(low, 4)} to ${short(high, 4)}` : '',
    isNumber(limit) ? `limit ${short(limit, 4)}` : '',
    verdictText(trend.verdict[n]),
    release[run] ? `release ${release[run]}` : '',
    isNumber(load[run]) ? `load ${short(load[run])}` : ''
  ]
    .filter(Boolean)
    .join(', ');
}

/** Every run, filled in when it is opened. @param {App} app @param {Trend} trend */
function table(app, trend) {
  const {history, place} = app;
  const known = NUMBERS.filter((key) => trend[key].some(isNumber));
  const isJudged = trend.verdict.some(Boolean);
  const columns = [
    ...['run', 'date'].map((text) => ({text})),
    ...known.map((text) => ({text, number: true})),
    ...(isJudged ? [{text: 'verdict'}] : [])
  ];
  const rowOf = (/** @type {number} */ n) => [
    runWords(app, trend.runs[n]),
    history.day(trend.runs[n]),
    ...known.map((key) => full(trend[key][n])),
    ...(isJudged ? [verdictText(trend.verdict[n])] : [])
  ];
  const label = `Runs of ${history.figures.name[place.figure]}`;
  const box = h('div');
  const fill = () => {
    if (box.hasChildNodes()) return;
    box.append(growingTable({label, columns}, [...trend.runs.keys()].reverse(), rowOf, kRows));
  };
  return folded('As a table', box, fill);
}

/** The changes of the figure in words. @param {App} app @param {Story[]} changes */
const changeList = (app, changes) =>
  h(
    'ul',
    {class: 'marks'},
    changes.map((c) =>
      h(
        'li',
        {},
        amountMark(c),
        ` since `,
        runWords(app, c.run),
        ` (${app.history.day(c.run)}): ${fromTo(c, app.history.figures.unit[c.figure])}, ${sure(c)}. `,
        told(c.text)
      )
    )
  );

/** The picture with its cursor; drawn anew when its width or axis changes. @param {App} app @param {Trend} trend */
function figureOf(app, trend, changes) {
  const {history, place} = app;
  const {figure} = place;
  const name = history.figures.name[figure];
  const values = valuesOf(trend);
  let isLog = logFits(values);
  const box = h('div', {class: 'chart'});
  const say = h('output', {class: 'readout', for: 'cursor'});
  const label = `Trend of ${name} over ${plural(trend.runs.length, 'run')}: last ${withUnit(trend.value.at(-1), history.figures.unit[figure])}. ${changes
    .map((c) => `${MARKS[c.verdict].label} at ${history.commit(c.run)}, ${amount(c)}`)
    .join('; ')}`;
  /** @type {ReturnType<typeof trendChart>} */
  let chart;
  const point = (/** @type {number} */ n) => {
    const words = readout(app, trend, n);
    range.value = String(n);
    range.setAttribute('aria-valuetext', words);
    say.textContent = words;
    chart.point(n);
  };
  const draw = () => {
    chart = trendChart(
      {history, figure, trend, changes, isLog, width: Math.max(box.clientWidth, 280)},
      label
    );
    chart.drawn.addEventListener('pointermove', (event) =>
      point(chart.nearest(event.clientX - chart.drawn.getBoundingClientRect().left))
    );
    box.replaceChildren(chart.drawn);
    point(Number(range.value));
  };
  const last = trend.runs.length - 1;
  const range = runSlider({id: 'cursor', label: 'Run', count: last + 1, at: last}, point);
  const jump = (/** @type {number} */ way) => () => {
    const places = changes.map((c) => trend.runs.indexOf(c.run)).sort((a, b) => way * (a - b));
    const next = places.find((n) => way * (n - Number(range.value)) > 0);
    if (next !== undefined) point(next);
  };
  const axis = choice('Axis', AXES, isLog ? 'log' : 'linear', (key) => {
    isLog = key === 'log';
    draw();
  });
  const safe = name.replace(/[^\w.-]+/g, '_');
  return {
    draw,
    content: h(
      'figure',
      {},
      box,
      range,
      say,
      h('figcaption', {}, legendText(history, figure, trend)),
      changes.length
        ? changeList(app, changes)
        : h('p', {class: 'note'}, 'No change was found in this series.'),
      h(
        'div',
        {class: 'controls'},
        changes.length
          ? h('span', {class: 'toggles'}, button('‹ change', jump(-1)), button('change ›', jump(1)))
          : '',
        logCan(values) ? axis : '',
        download('SVG', `${safe}.svg`, 'image/svg+xml', () => svgFile(chart.drawn)),
        download('CSV', `${safe}.csv`, 'text/csv', () => csvOf(history, figure, trend))
      ),
      table(app, trend)
    )
  };
}

/** @param {App} app */
export function trendSection(app) {
  const {history, place} = app;
  const {box, fill} = chooser(app);
  const shown = h('div', {class: 'drawn', id: 'trend-drawn'});
  let asked = 0;
  /** @type {() => void} */
  let redraw = () => {};
  let width = 0;
  new ResizeObserver(() => {
    if (shown.clientWidth === width) return;
    width = shown.clientWidth;
    redraw();
  }).observe(shown);
  const show = async () => {
    const ticket = ++asked;
    const {figure, series} = place;
    const {name, kind, unit, better, formulation} = history.figures;
    fill();
    const head = [
      h('h3', {id: 'figure-name', tabindex: '-1'}, figureLink(app, figure)),
      h(
        'p',
        {class: 'note'},
        [kind[figure], formulation[figure], unit[figure], BETTER[better[figure]], series.label]
          .filter(Boolean)
          .join(' · ')
      )
    ];
    redraw = () => {};
    try {
      const trend = await app.trend(figure, series.number);
      if (ticket !== asked) return; // another was chosen in the meantime
      if (!trend.value.some(isNumber)) {
        shown.replaceChildren(...head, nothing(`${name[figure]} was never measured in this series.`));
        return;
      }
      const changes = history.changesOf(series.number, (c) => c.figure === figure);
      const {draw, content} = figureOf(app, trend, changes);
      shown.replaceChildren(...head, content);
      draw();
      performance.mark('trend'); // what tests measure
      redraw = draw;
    } catch (error) {
      if (ticket === asked) shown.replaceChildren(...head, nothing(/** @type {Error} */ (error).message));
    }
  };
  return {content: h('div', {}, box, shown), show};
}
