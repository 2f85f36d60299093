// The work-precision figure: what an error costs, for every implementation, precision, variant and method.
import {Chart} from '../../chart.js';
import {front, KINDS} from '../../data/accuracy_data.js';
import {choice, h, isolate, plainTable, select, swatch, toggles} from '../../dom.js';
import {nanoseconds, short} from '../../format.js';
import {look} from '../../palette.js';
import {MARKS, markOf, rangeKey, rangeLabel, usable, WHAT, whatLabel} from '../../data/speed_data.js';
import {Absent} from '../../parts.js';
import {withLabels} from '../labels.js';
import {pointsOf, rangesIn, scenesOf, timingsOf} from './work_precision_data.js';
import {workPrecisionSpec} from './work_precision_spec.js';

const VIEWS = [
  {key: 'numerical', label: 'numerical'},
  {key: 'range', label: 'numerical, by decade of φ'},
  {key: 'modelling', label: 'modelling, by scene'}
];
const WHATS = ['residual', 'residual_tangent'].map((key) => ({key, label: WHAT[key]}));
const COLUMNS = [
  {text: 'formulation'},
  {text: 'how'},
  {text: 'ns', number: true},
  {text: 'error', number: true},
  {text: '◆'}
];
const CAPTION = {
  numerical: 'Worst error over all timed poses, against 50 digits of the same formula.',
  range: 'Worst error of the poses in one range of φ, against 50 digits of the same formula.',
  modelling:
    'How far the formulation is from the truth of the scene, at the time of its cheapest shown ' +
    'implementation whose numerical error does not exceed that.'
};

function tableOf(points, onFront, only) {
  const rows = points
    .filter((p) => !only || p.formulation === only)
    .sort((a, b) => a.ns - b.ns)
    .map((p) => ({
      class: onFront.includes(p) ? 'front' : null,
      cells: [
        h('code', {}, p.formulation),
        p.make,
        nanoseconds(p.ns),
        p.floored ? `< ${short(p.floor)}` : short(p.value),
        onFront.includes(p) ? '◆' : ''
      ]
    }));
  return plainTable('Error and time of each point', COLUMNS, rows);
}

/** Ranges of phi as choices.
 * @param {import('../../data.js').Results} results
 */
const rangeOptions = (results, {kind, what}) =>
  rangesIn(results, kind, what).map((r) => ({key: rangeKey(r), label: `φ ${rangeLabel(r)}`}));

/** Second choice of a view: which range of phi, or which scene.
 * @param {import('../../data.js').Results} results
 */
function detail(results, state, changed) {
  const key = {range: 'range', modelling: 'scene'}[state.view];
  if (!key) return [];
  const options = state.view === 'range' ? rangeOptions(results, state) : scenesOf(results, state.kind);
  if (!options.some((o) => o.key === state[key])) state[key] = options[0]?.key;
  return options.length
    ? [
        select(state.view === 'range' ? 'Range' : 'Scene', options, state[key], (value) => {
          state[key] = value;
          changed();
        })
      ]
    : [];
}

function caption(points, view) {
  const hollow = points.some((p) => p.floored);
  return [
    CAPTION[view],
    ' Left is faster, down is truer. Dashed, and ◆ in the table: Pareto front of what is shown. ',
    hollow
      ? view === 'modelling'
        ? 'Hollow: below the uncertainty of the truth, drawn there. '
        : 'Hollow: below half a unit of rounding, drawn there. '
      : '',
    'A batch stands at its fastest size on one thread. One click on a name isolates a ' +
      'formulation, a second one returns.'
  ];
}

/** The legend by formulation, of what the choice can show. */
function legendOf(points, changed) {
  const names = [...new Set(points.map((p) => p.formulation))];
  return isolate(
    'Isolate a formulation',
    names.map((key) => ({key, label: key, swatch: swatch({color: look(key).color, shape: 'circle'})})),
    changed
  );
}

/** @param {import('../../data.js').Results} results */
function marksIn(results) {
  const keys = new Set(
    results.timings.filter((t) => usable(t) && WHATS.some((w) => w.key === t.what)).map(markOf)
  );
  return MARKS.filter((m) => keys.has(m.key));
}

/** @param {import('../../data.js').Results} results */
export function workPrecisionFigure(results, kind) {
  const kinds = KINDS.filter((k) => WHATS.some((w) => timingsOf(results, k.key, w.key).length));
  if (!kinds.length) return new Absent('the results hold no timing of a joint');
  const chart = new Chart(
    'work-precision',
    'Error against time per joint, both logarithmic, one mark per implementation. The table ' +
      'holds the same numbers.'
  );
  const marks = marksIn(results);
  /** @type {any} */
  const state = {
    view: 'numerical',
    kind: kinds.some((k) => k.key === kind) ? kind : kinds[0].key,
    what: 'residual',
    marks: new Set(marks.map((m) => m.key)),
    only: null
  };
  const [second, legend, table] = [h('span', {class: 'second'}), h('div'), h('div', {class: 'tall'})];
  const note = h('figcaption', {'aria-live': 'polite'});
  const draw = () => {
    const points = pointsOf(results, state);
    const onFront = front(points);
    note.replaceChildren(...caption(points, state.view));
    table.replaceChildren(points.length ? tableOf(points, onFront, state.only) : '');
    if (points.length)
      chart.draw(
        workPrecisionSpec(points, onFront, {...state, what: whatLabel(state.what)}, state.only),
        withLabels
      );
    else chart.say('No timing has an error for this choice.');
  };
  const renew = () => {
    // another list of points: its legend and its second choice begin anew
    state.only = null;
    second.replaceChildren(...detail(results, state, draw));
    legend.replaceChildren(
      legendOf(pointsOf(results, state), (only) => {
        state.only = only;
        draw();
      })
    );
    draw();
  };
  const set = (key) => (value) => {
    state[key] = value;
    renew();
  };
  renew();
  const markItems = marks.map((m) => ({
    key: m.key,
    label: m.label,
    on: true,
    swatch: swatch({color: 'var(--muted)', shape: m.shape})
  }));
  return h(
    'figure',
    {},
    h(
      'div',
      {class: 'controls'},
      choice('Error', VIEWS, state.view, set('view')),
      second,
      choice('Kind', kinds, state.kind, set('kind')),
      choice('Time of', WHATS, state.what, set('what'))
    ),
    toggles('Marks shown', markItems, (keys) => {
      state.marks = new Set(keys);
      renew();
    }),
    legend,
    h('div', {class: 'with-table'}, chart.box, table),
    note
  );
}
