// The main chart: error against time, one point per formulation and kind, with the Pareto front of each kind.
import {AT_DECADES, Chart, isNarrow} from '../chart.js';
import {KINDS, accuracyOf, front} from '../data/accuracy_data.js';
import {choice, h, swatch, toggles} from '../dom.js';
import {full, nanoseconds, short} from '../format.js';
import {KIND_SHAPES, look} from '../palette.js';
import {bodyLabel, GROUPS} from '../data/solids_data.js';
import {whatLabel} from '../data/speed_data.js';
import {withLabels} from './labels.js';

const WHAT = ['residual', 'residual_tangent'].map((key) => ({key, label: whatLabel(key)}));
const IMPLEMENTATION = [
  {key: 'kernel', label: 'kernel'},
  {key: 'reference', label: 'transcription'}
];
const ERROR = [
  {key: 'modelling', label: 'modelling'},
  {key: 'numerical', label: 'numerical'}
];
const X_TITLE = {
  residual: 'without tangent, ns (less is faster)',
  residual_tangent: 'with tangent, ns (less is faster)'
};
const Y_TITLE = {
  modelling: 'modelling error, relative (less is truer)',
  numerical: 'numerical error, relative (less is truer)',
  solids: 'error of second-order couplings, relative (less is truer)'
};
const KINDS_ORDER = KINDS.map((k) => k.key);

function spec(points, what, error) {
  const fronts = KINDS_ORDER.flatMap((kind) => front(points.filter((p) => p.kind === kind)));
  const rows = points.map((p) => ({
    ...p,
    front: fronts.includes(p) ? 'yes' : 'no',
    shown_value: full(p.value),
    shown_time: `${nanoseconds(p.ns)} ns (spread ${short(100 * p.spread, 1)} %)`
  }));
  const names = [...new Set(points.map((p) => p.formulation))];
  const x = {
    field: 'ns',
    type: 'quantitative',
    scale: {type: 'log', nice: false, padding: 28},
    title: X_TITLE[what],
    axis: {format: '~r', tickCount: 6}
  };
  const y = {
    field: 'error',
    type: 'quantitative',
    scale: {type: 'log', padding: 20},
    title: Y_TITLE[error],
    axis: {labelExpr: 'power10(datum.value)', tickCount: 8, gridOpacity: AT_DECADES, tickOpacity: AT_DECADES}
  };
  const color = {
    field: 'formulation',
    type: 'nominal',
    legend: null,
    scale: {domain: names, range: names.map((n) => look(n).color)}
  };
  return {
    height: isNarrow() ? 380 : 600,
    layer: [
      {
        name: 'front',
        data: {values: fronts},
        mark: {
          type: 'line',
          interpolate: 'step-after',
          strokeWidth: 1.5,
          strokeDash: [5, 4],
          color: 'var(--muted)'
        },
        encoding: {x, y, detail: {field: 'kind'}, order: {field: 'ns'}}
      },
      {
        name: 'points',
        data: {values: rows},
        mark: {type: 'point', size: 110, strokeWidth: 2, opacity: 1},
        encoding: {
          x,
          y,
          color,
          shape: {
            field: 'kind',
            type: 'nominal',
            legend: null,
            scale: {domain: KINDS_ORDER, range: KINDS_ORDER.map((k) => KIND_SHAPES[k])}
          },
          fill: {
            condition: {test: 'datum.floored', value: 'var(--paper)'},
            field: 'formulation',
            type: 'nominal',
            legend: null,
            scale: {domain: names, range: names.map((n) => look(n).color)}
          },
          tooltip: [
            {field: 'formulation', title: 'formulation'},
            {field: 'stands_for', title: 'stands for'},
            {field: 'kind_label', title: 'kind'},
            {field: 'implementation_label', title: 'implementation'},
            {field: 'shown_time', title: 'time'},
            {field: 'shown_value', title: 'error'},
            {field: 'floor', title: 'known to', format: '.2g'},
            {field: 'front', title: 'on the front'},
            {field: 'note', title: 'measured'}
          ]
        }
      }
    ]
  };
}

function footnote(points, missing, error, implementation) {
  const floored = points.filter((p) => p.floored);
  const what = error === 'numerical' ? 'half a unit of rounding' : 'the uncertainty of the truth itself';
  const names = (list) => [...new Set(list.map((m) => m.name ?? m.formulation))].join(', ');
  const slow = implementation === 'kernel' ? points.filter((p) => p.implementation !== 'kernel') : [];
  return [
    slow.length && slow.length < points.length
      ? `No kernel, time of the transcription: ${names(slow)}. `
      : '',
    'Dashed: Pareto front of each kind; no point of that kind is both faster and truer than one on it. ',
    floored.length
      ? `Hollow: the error is below ${what} and is drawn at that floor (${names(floored)}). `
      : '',
    points.length ? `Truth: ${[...new Set(points.map((p) => p.truth))].join('; ')}. ` : '',
    missing.length
      ? h(
          'span',
          {},
          `Not drawn: ${names(missing)}; reasons under `,
          h('a', {href: '#left-out'}, 'Failed or left out'),
          '.'
        )
      : ''
  ];
}

/** The figure; `kind` is the kind shown first.
 * @param {import('../data.js').Results} results
 */
export function accuracyFigure(results, kind) {
  const views = results.solidViews();
  const state = {
    what: 'residual',
    error: 'modelling',
    kinds: new Set([kind]),
    implementation: results.kernels.size ? 'kernel' : 'reference',
    solid: {body: views.bodies[0], group: views.groups[0]}
  };
  if (accuracyOf(results, {what: 'residual', error: 'modelling'}).points.length === 0)
    state.error = 'numerical';
  const chart = new Chart(
    'accuracy',
    'Error against time per evaluation, both logarithmic, one point per formulation and kind of ' +
      'joint. The table below it holds the same numbers.'
  );
  const note = h('figcaption', {'aria-live': 'polite'});

  const draw = () => {
    const {points, missing} = accuracyOf(results, state);
    const solid = state.error === 'solids';
    // The only kind that a body with forces and moments has.
    const kinds = solid ? new Set(['linear_angular']) : state.kinds;
    const shown = points.filter((p) => kinds.has(p.kind));
    legend.hidden = solid;
    solidChoice.hidden = !solid;
    note.replaceChildren(
      ...footnote(
        shown,
        missing.filter((m) => kinds.has(m.kind)),
        state.error,
        state.implementation
      ).filter(Boolean)
    );
    if (shown.length) chart.draw(spec(shown, state.what, state.error), withLabels);
    else chart.say('No formulation has both a time and an error for this choice.');
  };
  const legend = toggles(
    'Kinds of joint shown',
    KINDS.map((k) => ({
      ...k,
      on: state.kinds.has(k.key),
      swatch: swatch({color: 'var(--muted)', shape: KIND_SHAPES[k.key]})
    })),
    (keys) => {
      state.kinds = new Set(keys);
      draw();
    }
  );
  const solidChoice = h(
    'div',
    {class: 'controls', hidden: true},
    choice(
      'Body',
      views.bodies.map((key) => ({key, label: bodyLabel(key)})),
      state.solid.body,
      (body) => {
        state.solid = {...state.solid, body};
        draw();
      }
    ),
    choice(
      'Under',
      GROUPS.filter((g) => views.groups.includes(g.key)),
      state.solid.group,
      (group) => {
        state.solid = {...state.solid, group};
        draw();
      }
    )
  );
  const errors = views.bodies.length ? [...ERROR, {key: 'solids', label: '3D bodies'}] : ERROR;
  const controls = h(
    'div',
    {class: 'controls'},
    legend,
    choice('Time of', WHAT, state.what, (key) => {
      state.what = key;
      draw();
    }),
    results.kernels.size
      ? choice('Implementation', IMPLEMENTATION, state.implementation, (key) => {
          state.implementation = key;
          draw();
        })
      : null,
    choice('Error', errors, state.error, (key) => {
      state.error = key;
      draw();
    }),
    solidChoice
  );
  draw();
  return h('figure', {}, controls, chart.box, note);
}
