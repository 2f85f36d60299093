// A scene: one output against its load, one line per formulation, with other programs' and our 3D marks.
import {Chart, isNarrow} from '../chart.js';
import {choice, folded, h, swatch, toggles} from '../dom.js';
import {axisTitle, outputAxis, powerOf, rowsOf, thinned} from '../data/figures_data.js';
import {seriesLook} from '../palette.js';
import {Absent} from '../parts.js';
import {isBody, solidLayer, solidSeries} from './solids/solid_marks.js';

/** The paper's own systems are shown first; where a scene has none of them, all are. */
const SHOWN_FIRST = ['attached_a', 'attached_b', 'invariant', 'intrinsic', 'jointc', 'linearized'];

/** axes: {load, output}, each {title, unit}. */
function spec(axes, {lines, marks, solids}, {series, solid}) {
  const power = powerOf([...lines, ...solids].map((r) => r.value));
  const loadPower = powerOf([...lines, ...solids].map((r) => r.load));
  const scaled = (rows) => rows.map((r) => ({...r, x: r.load / 10 ** loadPower, y: r.value / 10 ** power}));
  const looks = series.map((s) => s.look);
  const domain = series.map((s) => s.key);
  const color = {
    field: 'series',
    type: 'nominal',
    legend: null,
    scale: {domain, range: looks.map((l) => l.color)}
  };
  const x = {
    field: 'x',
    type: 'quantitative',
    title: axisTitle(axes.load, loadPower),
    axis: {tickCount: 6, format: ',.4~f'}
  };
  const y = {
    field: 'y',
    type: 'quantitative',
    title: axisTitle(axes.output, power),
    axis: {tickCount: 6, format: ',.4~f'},
    scale: {zero: false}
  };
  const tooltip = [
    {field: 'series', title: 'formulation'},
    {field: 'load', title: axisTitle(axes.load)},
    {field: 'value', title: axisTitle(axes.output), format: '.8g'}
  ];
  /** @type {import('../chart.js').Spec[]} */
  const layers = [
    {
      name: 'lines',
      data: {values: scaled(lines)},
      mark: {type: 'line', strokeWidth: 2.2, clip: true},
      encoding: {
        x,
        y,
        color,
        strokeDash: {
          field: 'series',
          type: 'nominal',
          legend: null,
          scale: {domain, range: looks.map((l) => (l.dash.length ? l.dash : [1, 0]))}
        }
      }
    },
    {
      data: {values: scaled(lines)},
      params: [
        {name: 'near', select: {type: 'point', on: 'pointerover', nearest: true, clear: 'pointerout'}}
      ],
      mark: {type: 'point', filled: true, size: 60},
      encoding: {
        x,
        y,
        color,
        opacity: {condition: {param: 'near', empty: false, value: 1}, value: 0},
        tooltip
      }
    }
  ];
  if (marks.length) {
    layers.push({
      data: {values: scaled(marks)},
      mark: {type: 'point', shape: 'diamond', size: 42, strokeWidth: 1.4, filled: false, opacity: 1},
      encoding: {x, y, color: {...color}, tooltip: [{field: 'source', title: 'source'}, ...tooltip]}
    });
  }
  if (solids.length) {
    layers.push(
      solidLayer(scaled(solids), solid, {
        x,
        y,
        tooltip: [{...tooltip[0], title: 'body, law'}, ...tooltip.slice(1)]
      })
    );
  }
  return {height: isNarrow() ? 260 : 320, layer: layers};
}

/** Curves that stop early, in words. */
function endings(curves, name) {
  const early = curves.filter((c) => !c.converged);
  if (!early.length) return null;
  return h(
    'p',
    {class: 'note'},
    'Ends early: ',
    early.map((c) => `${name(c)} (${c.outcome})`).join('; '),
    '.'
  );
}

/** One figure. panels: [{output, title, unit}]; `scene` is the prefix of its name. */
/** One entry of the legend per curve. */
function seriesOf(curves, name) {
  const keys = [...new Set(curves.map(name))];
  const series = keys.map((key) => {
    const {formulation} = curves.find((c) => name(c) === key);
    const n = keys.filter((k) => k.startsWith(`${formulation} `)).indexOf(key);
    const look = seriesLook(formulation, Math.max(n, 0));
    return {key, formulation, look, label: key, on: SHOWN_FIRST.includes(formulation), swatch: swatch(look)};
  });
  if (!series.some((s) => s.on)) for (const s of series) s.on = true;
  return series;
}

function legendOf({series, solid}, title, changed) {
  for (const s of solid) s.swatch = swatch(s.look);
  return [
    toggles(`Formulations shown in ${title}`, series, changed),
    solid.length
      ? h(
          'div',
          {class: 'controls'},
          h('span', {class: 'label'}, 'bodies'),
          toggles(`Bodies shown in ${title}`, solid, changed)
        )
      : null
  ];
}

/** Where the marks come from. */
function marksNote(references, solid) {
  const sources = [...new Set(references.map((c) => c.source))];
  return [
    sources.length ? `Diamonds: ${sources.join('; ')}. ` : '',
    solid.length
      ? [
          'Open marks without colour: our own 3D finite elements and rods; see ',
          h('a', {href: '#solids'}, 'the bodies'),
          '.'
        ]
      : ''
  ];
}

/** Draws one output of what the legend shows. */
function drawOutput(chart, {curves, load}, {series, solid, references, name}, output) {
  const shown = series.filter((s) => s.on);
  const on = (c) => shown.some((s) => s.key === name(c));
  const marked = (c) => shown.some((s) => s.formulation === c.formulation);
  const lines = rowsOf(curves.filter(on), output, name);
  const marks = rowsOf(references.filter(marked), output, name);
  const solids = rowsOf(
    solid.filter((s) => s.on).map((s) => s.curve),
    output,
    (c) => c.formulation
  );
  if (!lines.length && !solids.length) chart.say('No formulation is selected.');
  else chart.draw(spec({load, output: outputAxis(output)}, {lines, marks, solids}, {series, solid}));
}

/** figure: one of figuresOf(results).
 * @param {import('../data.js').Results} results
 */
export function sceneFigure(results, figure) {
  const {id, scene, curves, outputs, load} = figure;
  if (!curves.length) return new Absent(`no formulation has a path through ${scene.name}`);
  const name = (c) => results.series(c);
  const all = results.referencesOf(scene.name).map(thinned);
  const references = all.filter((c) => !isBody(c));
  const drawn = {series: seriesOf(curves, name), solid: solidSeries(all), references, name};
  const chart = new Chart(
    id,
    `${scene.title}: a component of the motion against ${load.title}, one line per formulation.`
  );
  let output = outputs.first;
  const draw = () => drawOutput(chart, figure, drawn, output);
  const options = outputs.names.map((key) => ({key, label: outputAxis(key).title}));
  const control = choice('Component', options, output, (key) => {
    output = key;
    draw();
  });
  draw();
  return h(
    'figure',
    {},
    options.length > 1 ? h('div', {class: 'controls'}, control) : null,
    legendOf(drawn, scene.title, draw),
    chart.box,
    h('figcaption', {}, scene.source ? `Source: ${scene.source}. ` : '', marksNote(references, drawn.solid)),
    endings(curves, name),
    scene.description ? folded('About this scene', h('p', {class: 'note'}, scene.description)) : null
  );
}
