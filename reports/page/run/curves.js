// The curves of a run: a picture for each output, what is under the pointer, files and a table.
import {download, folded, h, plainTable, swatch, toggles} from '../dom.js';
import {full, short} from '../format.js';
import {svgFile} from '../dashboard/plot.js';
import {linesChart} from './lines.js';
import {curvesCsv, fileName} from './run_data.js';
import {outputWords, overWords, placeText} from './words.js';

/** @typedef {import('./run.js').App} App */

/** @param {import('../run').RunFile} run @param {import('./lines.js').Place | undefined} place
 * @param {{name: string, unit: string}} output @param {number} column
 */
function readoutWords(run, place, {name, unit}, column) {
  if (!place) return '';
  const {curve, key} = place.series;
  const error = curve.errors[place.row];
  const known = error === null || error === undefined ? '' : ` ± ${short(error, 1)}`;
  const [factor] = curve.rows[place.row];
  return `${key} at ${placeText(run, factor, 6)}: ${name} = ${short(curve.rows[place.row][column], 8)}${known} ${unit}`;
}

/** One output. @param {App} app @param {number} column */
function panel(app, column) {
  const {run, state} = app;
  const output = run.outputs[column - 1];
  const title = outputWords(output);
  const box = h('div', {class: 'chart'});
  const say = h('p', {class: 'readout', 'aria-live': 'polite'});
  /** @type {ReturnType<typeof linesChart> | undefined} */
  let chart;
  const draw = () => {
    const shown = app.series.filter((s) => s.on);
    const made = linesChart({
      ...{shown, column, title, factorEnd: run.path.factor_end},
      over: run.path.over ? 'time, s' : 'load factor',
      width: Math.max(box.clientWidth, 280)
    });
    chart = made;
    made.drawn.addEventListener('pointermove', (event) => {
      const {left, top} = made.drawn.getBoundingClientRect();
      const place = made.nearest(event.clientX - left, event.clientY - top);
      made.mark(place);
      say.textContent = readoutWords(run, place, output, column);
    });
    made.drawn.addEventListener('pointerleave', () => {
      made.mark(undefined);
      say.textContent = '';
    });
    box.replaceChildren(made.drawn);
    made.point(state.factor);
  };
  const name = fileName(`${run.scene.name}_${output.name}`);
  return {
    draw,
    point: () => chart?.point(state.factor),
    content: h('figure', {}, box, say),
    file: download(output.name, `${name}.svg`, 'image/svg+xml', () => (chart ? svgFile(chart.drawn) : ''))
  };
}

/** The chosen formulation's rows. @param {App} app */
function table({run, chosen}) {
  const {label, rows, errors} = chosen();
  const columns = [
    {text: run.path.over ? 'time, s' : 'load factor', number: true},
    ...run.outputs.map((o) => ({text: `${o.name}, ${o.unit}`, number: true})),
    {text: 'error', number: true}
  ];
  const cells = rows.map((row, i) => [
    ...row.map((x) => h('span', {title: full(x)}, short(x, 6))),
    short(errors[i], 1)
  ]);
  return h(
    'div',
    {class: 'tall'},
    plainTable(`Rows of ${label}`, columns, cells, `${label}; titles have all digits`)
  );
}

/** @param {App} app */
export function curvesSection(app) {
  const {run, series} = app;
  const panels = run.outputs.map((_, i) => panel(app, i + 1));
  const rows = h('div');
  const items = series.map((s) => ({
    ...{key: s.key, label: s.key, on: s.on, swatch: swatch(s.look)},
    title: s.curve.outcome
  }));
  const legend = toggles('Formulations shown', items, (/** @type {string[]} */ keys) => {
    for (const s of series) s.on = keys.includes(s.key);
    for (const p of panels) p.draw();
    app.changed();
  });
  const details = folded('The curves as a table', rows, () => update());
  const update = () => {
    for (const p of panels) p.point();
    rows.replaceChildren(/** @type {HTMLDetailsElement} */ (details).open ? table(app) : '');
  };
  return {
    draw: () => panels.forEach((p) => p.draw()),
    update,
    content: h(
      'div',
      {},
      legend,
      h(
        'div',
        {class: panels.length > 3 ? 'run-panels many' : 'run-panels'},
        panels.map((p) => p.content)
      ),
      h(
        'p',
        {class: 'note'},
        `A symbol ends each line, a cross one that ends early. Upright: the ${overWords(run)} that is drawn as a body.`
      ),
      h(
        'div',
        {class: 'controls run-files'},
        download('CSV of all curves', `${fileName(run.scene.name)}.csv`, 'text/csv', () => curvesCsv(run)),
        h('span', {class: 'label'}, 'SVG of'),
        h(
          'span',
          {class: 'toggles'},
          panels.map((p) => p.file)
        )
      ),
      details
    )
  };
}
