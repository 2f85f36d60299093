// The trend of one figure: search, picture, a cursor over its runs, table, files.
import {choice, h, plainTable} from '../dom.js';
import {isNumber, plural, short} from '../format.js';
import {amountMark, figureLink, runWords} from './changes.js';
import {chooser} from './chooser.js';
import {svgFile} from './plot.js';
import {logCan, logFits} from './scale.js';
import {trendChart, valuesOf} from './trend_chart.js';
import {csvOf} from './trend_data.js';
import {amount, MARKS, sure, withUnit} from './words.js';

/** @typedef {import('./dashboard.js').App} App */
/** @typedef {import('./history_data.js').Story} Story */
/** @typedef {import('./trend_data.js').Trend} Trend */

const kRows = 50; // of the table, at first
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
    trend.verdict[n].replace('_', ' '),
    release[run] ? `release ${release[run]}` : '',
    isNumber(load[run]) ? `load ${short(load[run])}` : ''
  ]
    .filter(Boolean)
    .join(', ');
}

/** A file that the reader keeps. @param {string} name @param {string} type @param {() => string} content */
const download = (label, name, type, content) =>
  h(
    'button',
    {
      type: 'button',
      class: 'plain',
      onclick: () => {
        const href = URL.createObjectURL(new Blob([content()], {type}));
        h('a', {href, download: name}).click();
        setTimeout(() => URL.revokeObjectURL(href));
      }
    },
    label
  );

/** @param {App} app @param {Trend} trend */
function table(app, trend) {
  const {history, place} = app;
  const columns = [
    {text: 'run'},
    {text: 'date'},
    {text: 'value', number: true},
    {text: 'low', number: true},
    {text: 'high', number: true},
    {text: 'limit', number: true},
    {text: 'verdict'}
  ].filter(
    ({text}) =>
      !['low', 'high', 'limit', 'verdict'].includes(text) || trend[text].some((v) => v !== null && v !== '')
  );
  const cell = (n) => ({
    ...{
      run: runWords(app, trend.runs[n]),
      date: history.day(trend.runs[n]),
      verdict: trend.verdict[n].replace('_', ' ')
    },
    ...{value: short(trend.value[n], 4), low: short(trend.low[n], 4), high: short(trend.high[n], 4)},
    limit: short(trend.limit[n], 4)
  });
  const newest = [...trend.runs.keys()].reverse();
  const box = h('div');
  const draw = (/** @type {number} */ count) =>
    box.replaceChildren(
      plainTable(
        `Runs of ${history.figures.name[place.figure]}`,
        columns,
        newest.slice(0, count).map((n) => columns.map((c) => cell(n)[c.text]))
      ),
      count < newest.length
        ? h(
            'button',
            {type: 'button', class: 'plain', onclick: () => draw(newest.length)},
            `Show all ${newest.length} runs`
          )
        : ''
    );
  const details = h(
    'details',
    {class: 'more', ontoggle: () => details.open && !box.hasChildNodes() && draw(kRows)},
    h('summary', {}, 'As a table'),
    box
  );
  return details;
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
        ` (${app.history.day(c.run)}): ${short(c.before, 4)} → ${withUnit(c.after, app.history.figures.unit[c.figure])}, ${sure(c)}. `,
        c.text
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
  const range = h('input', {
    type: 'range',
    class: 'over-runs',
    id: 'cursor',
    min: 0,
    max: trend.runs.length - 1,
    value: trend.runs.length - 1,
    'aria-label': 'Run'
  });
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
  range.addEventListener('input', () => point(Number(range.value)));
  const jump = (/** @type {number} */ way) => () => {
    const places = changes.map((c) => trend.runs.indexOf(c.run)).sort((a, b) => way * (a - b));
    const next = places.find((n) => way * (n - Number(range.value)) > 0);
    if (next !== undefined) point(next);
  };
  const button = (text, way) => h('button', {type: 'button', class: 'plain', onclick: jump(way)}, text);
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
      changes.length
        ? changeList(app, changes)
        : h('p', {class: 'note'}, 'No change was found in this series.'),
      h(
        'div',
        {class: 'controls'},
        changes.length ? h('span', {class: 'toggles'}, button('‹ change', -1), button('change ›', 1)) : '',
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
        shown.replaceChildren(
          ...head,
          h('p', {class: 'empty'}, `${name[figure]} was never measured in this series.`)
        );
        return;
      }
      const changes = history.changesOf(series.number, (c) => c.figure === figure);
      const {draw, content} = figureOf(app, trend, changes);
      shown.replaceChildren(...head, content);
      draw();
      performance.mark('trend'); // what tests measure
      redraw = draw;
    } catch (error) {
      if (ticket === asked)
        shown.replaceChildren(...head, h('p', {class: 'empty'}, /** @type {Error} */ (error).message));
    }
  };
  return {content: h('div', {}, box, shown), show};
}
