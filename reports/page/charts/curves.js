// The paper's figures: one output of a scene against its load, one line per formulation, one or more panels.
import {Chart, isNarrow} from '../chart.js';
import {h, swatch, toggles} from '../dom.js';
import {superscript} from '../format.js';
import {seriesLook} from '../palette.js';
import {SOLID_SOURCE, solidLayer, solidSeries} from './solid_marks.js';

/** Paper's own systems first: these are shown at the start. */
const SHOWN_FIRST = ['attached_a', 'attached_b', 'invariant', 'intrinsic', 'jointc', 'linearized'];
const kMostMarks = 31;

function rowsOf(curves, output, name) {
  return curves.flatMap((curve) => {
    const column = curve.columns.indexOf(output);
    if (column < 0) return [];
    return curve.rows.map((row) => ({
      series: name(curve),
      formulation: curve.formulation,
      source: curve.source,
      load: row[0],
      value: row[column]
    }));
  });
}

/** Every n-th reference point, so that marks stay apart. */
function thinned(curve) {
  const step = Math.max(1, Math.ceil(curve.rows.length / kMostMarks));
  return {...curve, rows: curve.rows.filter((_, i) => i % step === 0 || i === curve.rows.length - 1)};
}

/** A power of ten for the axis title, so that labels stay short. */
function powerOf(numbers) {
  const most = Math.max(...numbers.map(Math.abs), 0);
  if (!(most > 0) || (most >= 0.1 && most < 1e4)) return 0;
  return Math.floor(Math.log10(most));
}

const times = (power) => (power ? `10${superscript(power)} ` : '');

function spec(panel, {lines, marks, solids}, {series, solid}, load) {
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
    title: `${load.title}, ${times(loadPower)}${load.unit}`,
    axis: {tickCount: 6, format: ',.4~f'}
  };
  const y = {
    field: 'y',
    type: 'quantitative',
    title: `${panel.title}, ${times(power)}${panel.unit}`,
    axis: {tickCount: 6, format: ',.4~f'},
    scale: {zero: false}
  };
  const tooltip = [
    {field: 'series', title: 'formulation'},
    {field: 'load', title: `${load.title}, ${load.unit}`},
    {field: 'value', title: `${panel.title}, ${panel.unit}`, format: '.8g'}
  ];
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
  return {height: isNarrow() ? 260 : (panel.height ?? 320), layer: layers};
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
export function curvesFigure(results, {id, scene, title, load, panels, caption}) {
  const name = (c) => results.series(c);
  const curves = results.curvesOf(scene).filter((c) => c.rows.length > 1);
  const all = results.referencesOf(scene).map(thinned);
  const references = all.filter((c) => c.source !== SOLID_SOURCE);
  const solid = solidSeries(all);
  const keys = [...new Set(curves.map(name))];
  const series = keys.map((key) => {
    const formulation = curves.find((c) => name(c) === key).formulation;
    const n = keys.filter((k) => k.startsWith(`${formulation} `)).indexOf(key);
    return {
      key,
      formulation,
      look: seriesLook(formulation, Math.max(n, 0)),
      label: key,
      on: SHOWN_FIRST.includes(formulation)
    };
  });
  if (series.length && !series.some((s) => s.on))
    series.forEach((s) => {
      s.on = true;
    });
  const charts = panels.map(
    (panel) =>
      new Chart(
        panels.length > 1 ? `${id}-${panel.output}` : id,
        `${title}: ${panel.title} against ${load.title}, one line per formulation.`
      )
  );

  const draw = () =>
    panels.forEach((panel, i) => {
      const on = new Set(series.filter((s) => s.on).map((s) => s.key));
      const shown = new Set(series.filter((s) => s.on).map((s) => s.formulation));
      const lines = rowsOf(
        curves.filter((c) => on.has(name(c))),
        panel.output,
        name
      );
      const marks = rowsOf(
        references.filter((c) => shown.has(c.formulation)),
        panel.output,
        name
      );
      const solids = rowsOf(
        solid.filter((s) => s.on).map((s) => s.curve),
        panel.output,
        (c) => c.formulation
      );
      if (curves.length === 0) charts[i].empty(`no curve of scene ${scene} in the results.`);
      else if (lines.length + solids.length === 0) charts[i].say('No formulation is selected.');
      else charts[i].draw(spec(panel, {lines, marks, solids}, {series, solid}, load));
    });
  for (const s of [...series, ...solid]) s.swatch = swatch(s.look);
  const sources = [...new Set(references.map((c) => c.source))];
  const legend = [
    toggles(`Formulations shown in ${title}`, series, draw),
    solid.length
      ? h(
          'div',
          {class: 'controls'},
          h('span', {class: 'label'}, SOLID_SOURCE),
          toggles(`3D finite elements shown in ${title}`, solid, draw)
        )
      : null
  ];
  draw();
  return h(
    'figure',
    {id},
    h('h3', {}, title),
    legend,
    h(
      'div',
      {class: panels.length > 1 ? 'panels' : ''},
      charts.map((c) => c.box)
    ),
    h(
      'figcaption',
      {},
      caption,
      sources.length ? ` Diamonds: ${sources.join('; ')}.` : '',
      solid.length
        ? [
            ' Open marks without colour: our own 3D finite elements, geometrically nonlinear; see ',
            h('a', {href: '#solids'}, 'Three-dimensional truth'),
            '.'
          ]
        : ''
    ),
    endings(curves, name)
  );
}
