// What each digit costs: the variants of one joint, error over phi beside time.
import {KINDS} from '../../data/accuracy_data.js';
import {choice, h, plainTable, select} from '../../dom.js';
import {isNumber, nanoseconds, short, superscript} from '../../format.js';
import {isAnalytic, phiText, present, rangesOf, usable, variantLabel, WHAT} from '../../data/speed_data.js';
import {Absent} from '../../parts.js';
import {SeriesPanels} from '../series_panels.js';
import {HUE} from '../../palette.js';

const kFirst = 'invariant';
const kExact = 'full double';
const TOLERANCES = [-2, -4, -8];
const WHATS = ['residual', 'residual_tangent'].map((key) => ({key, label: WHAT[key]}));
const number = (key) => Number(key.match(/\d+/)?.[0] ?? 0);
const family = (key) => key.match(/^(order|log)_\d+$/)?.[1] ?? key;
const ORDER = ['order', 'log', 'float', kExact, 'compensated'];
const HUES = {
  order: HUE.vermilion,
  log: HUE.blue,
  float: HUE.magenta,
  compensated: HUE.green,
  [kExact]: 'var(--ink)'
};

const keyOf = (t) =>
  [t.variant, t.precision === 'float' && t.variant !== 'float' ? 'float' : ''].filter(Boolean).join(' ') ||
  kExact;
const isVariant = (t) => t.implementation === 'kernel' && t.kind && isAnalytic(t) && usable(t);

/** Cheapest family first; in a family by order or degree. */
function sorted(keys) {
  const place = (key) => {
    const i = ORDER.indexOf(family(key));
    return i < 0 ? ORDER.length : i;
  };
  return [...keys].sort((a, b) => place(a) - place(b) || number(a) - number(b) || a.localeCompare(b));
}

/** One hue per family: the higher the order, the stronger it is. */
function looksOf(series) {
  const keys = series.map((s) => s.key);
  return Object.fromEntries(
    keys.map((key) => {
      const kin = keys.filter((k) => family(k) === family(key));
      const share = kin.length > 1 ? 45 + Math.round((55 * kin.indexOf(key)) / (kin.length - 1)) : 100;
      const hue = HUES[family(key)] ?? 'var(--muted)';
      return [
        key,
        {
          color: share === 100 ? hue : `color-mix(in oklab, ${hue} ${share}%, var(--paper))`,
          dash: {float: [2, 3], compensated: [7, 3]}[key] ?? [1, 0]
        }
      ];
    })
  );
}

/** @param {import('../../data.js').Results} results */
function seriesOf(results, {formulation, kind, what}) {
  const timings = results.timings.filter(
    (t) => isVariant(t) && t.formulation === formulation && t.kind === kind && t.what === what
  );
  const byKey = new Map(timings.map((t) => [keyOf(t), t]));
  return sorted(byKey.keys()).map((key) => ({key, label: variantLabel(key), timing: byKey.get(key)}));
}

/** The phi up to which no range has an error above the tolerance. */
function goodTo(timing, tolerance) {
  const ranges = rangesOf([timing]);
  if (!ranges.length) return '–';
  const bad = ranges.findIndex((r) =>
    timing.errors.some(
      (e) => e.from === r.from && e.to === r.to && !(isNumber(e.error) && e.error <= tolerance)
    )
  );
  if (bad < 0) return 'all';
  return bad === 0 ? 'nowhere' : `φ < ${phiText(ranges[bad].from)}`;
}

function tableOf(series) {
  const columns = [
    {text: 'variant'},
    {text: 'ns', number: true},
    {text: 'flops', number: true},
    {text: 'worst error', number: true},
    ...TOLERANCES.map((t) => ({text: `10${superscript(t)} for`, number: true}))
  ];
  return plainTable(
    'Variants',
    columns,
    series.map(({label, timing: t}) => [
      label,
      nanoseconds(t.ns),
      t.flops > 0 ? short(t.flops, 3) : '–',
      short(t.error),
      ...TOLERANCES.map((e) => goodTo(t, 10 ** e))
    ])
  );
}

/** Joint, kind and output of what is shown; changed() after each choice. */
function controls(candidates, state, changed) {
  const formulations = present(
    candidates.map((t) => t.formulation),
    [kFirst]
  );
  const kinds = KINDS.filter((k) => candidates.some((t) => t.kind === k.key));
  Object.assign(state, {formulation: formulations[0], kind: kinds[0].key, what: 'residual'});
  const set = (key) => (value) => {
    state[key] = value;
    changed();
  };
  const joint =
    formulations.length > 1
      ? select(
          'Joint',
          formulations.map((key) => ({key, label: key})),
          state.formulation,
          set('formulation')
        )
      : h('code', {}, state.formulation);
  return h(
    'div',
    {class: 'controls'},
    joint,
    choice('Kind', kinds, state.kind, set('kind')),
    choice('Time of', WHATS, state.what, set('what'))
  );
}

/** @param {import('../../data.js').Results} results */
export function digitsFigure(results) {
  const candidates = results.timings.filter((t) => isVariant(t) && t.variant !== '');
  if (!candidates.length) return new Absent('the results hold no timing of a kernel’s variant');
  const panels = new SeriesPanels({
    id: 'digits',
    noun: 'variant',
    looksOf,
    tableOf,
    over: 'phi',
    title: 'time per joint, kernel, ns'
  });
  const box = h('div', {class: 'panels two'}, panels.error.box, panels.time.box);
  /** @type {any} */
  const state = {};
  const draw = () => panels.show(seriesOf(results, state));
  const choices = controls(candidates, state, draw);
  draw();
  return h(
    'figure',
    {},
    choices,
    panels.legend,
    box,
    h(
      'figcaption',
      {},
      'Worst error of each decade of φ, drawn at its middle, against 50 digits; below half a ' +
        'unit of rounding at that floor. Ranges next to π are one point at π.'
    ),
    panels.table
  );
}
