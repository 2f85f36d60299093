// Accuracy against speed of each formulation, at any run.
import {kindLabel, KINDS} from '../data/accuracy_data.js';
import {choice, download, h, PATHS, plainTable, svg} from '../dom.js';
import {full, plural, short} from '../format.js';
import {look} from '../palette.js';
import {formulationName, nothing, runSlider, runWords} from './pieces.js';
import {frameOf, picture, svgFile, text, xAxis, xTicks, yAxis} from './plot.js';
import {evenly, scaleOf} from './scale.js';
import {extents, placed, pointsAt, pointsCsv} from './scatter_data.js';

/** @typedef {import('./dashboard.js').App} App */
/** @typedef {import('./scatter_data.js').Measured} Measured */

const kHeight = 400;
const kLetter = 7; // px, about
const kMultiples = 4; // pictures on paper

/** One picture: where each formulation stood at run n, and where it stood at run `from`.
 * @param {Measured[]} measured
 */
function scatterChart(measured, n, from, width, label) {
  const frame = frameOf(width, kHeight);
  const {ns, error, floor} = extents(measured);
  const x = scaleOf(ns, frame.left, frame.right, true);
  const y = scaleOf(error, frame.bottom, frame.top, true);
  const spot = (p) => ({
    x: x.at(p.ns),
    y: y.at(Math.max(p.error, floor)),
    width: p.formulation.length * kLetter
  });
  const now = pointsAt(measured, n);
  const spots = now.map(spot);
  const before = new Map(pointsAt(measured, from).map((p) => [p.formulation, spot(p)]));
  const labels = placed(spots, frame);
  const drawn = picture(frame, label);
  drawn.append(
    ...yAxis(frame, y, 'error, logarithmic'),
    ...xAxis(frame, xTicks(x), 'ns per joint, logarithmic'),
    ...now.flatMap((p, i) => {
      const {color, shape} = look(p.formulation);
      const was = before.get(p.formulation);
      const at = spots[i];
      return [
        was
          ? svg('path', {class: 'trail', d: `M${was.x},${was.y}L${at.x},${at.y}`, style: `--color:${color}`})
          : [],
        svg('path', {
          class: 'point',
          d: PATHS[shape],
          transform: `translate(${at.x},${at.y})`,
          style: `--color:${color}`
        }),
        labels[i] ? text({class: 'name', ...labels[i]}, p.formulation) : []
      ].flat();
    })
  );
  return drawn;
}

/** @param {Measured[]} measured */
function pointsTable(measured, n) {
  const rows = pointsAt(measured, n).sort((a, b) => a.error - b.error);
  return plainTable(
    'Accuracy and speed at this run',
    [{text: 'formulation'}, {text: 'error', number: true}, {text: 'ns', number: true}],
    rows.map((p) => [
      formulationName(p.formulation),
      h('span', {title: full(p.error)}, short(p.error, 3)),
      h('span', {title: full(p.ns)}, short(p.ns, 3))
    ])
  );
}

/** The picture, its slider, its table, and pictures of several runs on paper.
 * @param {App} app @param {Measured[]} measured
 */
function figureOf(app, measured) {
  const {history, place} = app;
  const {runs} = place.series;
  const box = h('div', {class: 'chart'});
  const table = h('div');
  const say = h('output', {class: 'readout', for: 'when'});
  const asked = runs.findIndex((run) => history.runs.commit[run] === place.run);
  const first = Math.max(
    0,
    runs.findIndex((run) => run >= (history.release?.run ?? 0))
  );
  const label = (/** @type {number} */ n) =>
    `Error against time of ${plural(measured.length, 'formulation')}, ${kindLabel(place.kind)}, at ${history.commit(runs[n])} of ${history.day(runs[n])}`;
  /** @type {SVGElement} */
  let drawn;
  const draw = () => {
    const n = Number(range.value);
    range.setAttribute('aria-valuetext', `${history.day(runs[n])}, ${history.commit(runs[n])}`);
    say.replaceChildren(`${history.day(runs[n])}, `, ...runWords(app, runs[n]));
    drawn = scatterChart(measured, n, first, Math.max(box.clientWidth, 280), label(n));
    box.replaceChildren(drawn);
    table.replaceChildren(pointsTable(measured, n));
  };
  const at = asked < 0 ? runs.length - 1 : asked;
  const range = runSlider({id: 'when', label: 'Run shown', count: runs.length, at}, (n) => {
    place.run = n === runs.length - 1 ? '' : history.runs.commit[runs[n]];
    place.write();
    draw();
  });
  const paper = h('div', {class: 'multiples paper'});
  const print = () =>
    paper.replaceChildren(
      ...evenly(runs.length, kMultiples).map((n) =>
        h('figure', {}, h('figcaption', {}, label(n)), scatterChart(measured, n, first, 480, label(n)))
      )
    );
  const name = `accuracy_speed_${place.kind}`;
  const files = h(
    'div',
    {class: 'controls'},
    download('SVG', `${name}.svg`, 'image/svg+xml', () => svgFile(drawn)),
    download('CSV', `${name}.csv`, 'text/csv', () => pointsCsv(history, runs, measured))
  );
  const since = history.release ? `release ${history.release.name}` : 'the first run';
  const content = h(
    'figure',
    {},
    h('div', {class: 'with-table'}, h('div', {}, box, range, say), table),
    h(
      'figcaption',
      {},
      `Lower left is better. Lines: the way since ${since}. ${extents(measured).hasZero ? 'An error of zero is drawn at the lower edge.' : ''}`
    ),
    files,
    paper
  );
  return {content, draw, print};
}

/** @param {App} app */
export function scatterSection(app) {
  const {history, place} = app;
  const body = h('div');
  let print = () => {};
  let redraw = () => {};
  window.addEventListener('beforeprint', () => print());
  const measure = async () => {
    const pairs = history.pairs.filter((p) => p.kind === place.kind);
    const series = place.series.number;
    const measured = await Promise.all(
      pairs.map(async ({formulation, time, error}) => ({
        formulation,
        time: await app.trend(time, series),
        error: await app.trend(error, series)
      }))
    );
    return measured.filter((m) => [m.time, m.error].every((t) => t.value.some((v) => v !== null)));
  };
  const fill = async () => {
    const {series, kind} = place;
    const measured = await measure();
    if (series !== place.series || kind !== place.kind) return; // chosen anew in the meantime
    if (!measured.length) {
      body.replaceChildren(nothing('This series holds no formulation with both a time and an error.'));
      return;
    }
    const figure = figureOf(app, measured);
    const kinds = KINDS.filter(({key}) => history.pairs.some((p) => p.kind === key));
    const control = choice('Joint', kinds, kind, (key) => {
      place.kind = key;
      place.write();
      void show();
    });
    body.replaceChildren(kinds.length > 1 ? h('div', {class: 'controls'}, control) : '', figure.content);
    figure.draw();
    ({print, draw: redraw} = figure);
  };
  const show = () => fill().catch((error) => body.replaceChildren(nothing(error.message)));
  window.addEventListener('resize', () => redraw());
  return {content: body, show};
}
