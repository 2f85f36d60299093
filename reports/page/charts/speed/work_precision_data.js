// Points of the work-precision figure: error against time in its three views.
import {errorOf, kindLabel} from '../../data/accuracy_data.js';
import {isNumber} from '../../format.js';
import {
  briefOf,
  fastestBatches,
  MARKS,
  makeOf,
  markOf,
  rangeKey,
  rangesOf,
  roundingFloor,
  usable,
  variantLabel
} from '../../data/speed_data.js';
import {bodyLabel, GROUPS} from '../../data/solids_data.js';

const kOwnScene = 'modelling_error';

/** Timings that may be drawn, each the only one of its make.
 * @param {import('../../data.js').Results} results
 */
export const timingsOf = (results, kind, what) =>
  fastestBatches(results.timings.filter((t) => t.kind === kind && t.what === what && usable(t)));

/** @param {import('../../data.js').Results} results */
export const rangesIn = (results, kind, what) => rangesOf(timingsOf(results, kind, what));

/** Scenes with a modelling error for this kind: the paper's own, and 3D bodies under groups of loads.
 * @param {import('../../data.js').Results} results
 */
export function scenesOf(results, kind) {
  const found = results.findings.filter(
    (f) => f.kind === kind && f.verdict !== 'left_out' && f.name.startsWith(`${f.formulation}/`)
  );
  const own = found.find((f) => f.name.endsWith(`/${kOwnScene}`));
  const scenes = own ? [{key: kOwnScene, label: own.parameter || kindLabel(kind)}] : [];
  const views = results.solidViews();
  for (const body of views.bodies) {
    for (const g of GROUPS.filter(({key}) => views.groups.includes(key))) {
      const key = `fe_${body}_${g.key}`;
      if (found.some((f) => f.name.endsWith(`/${key}`)))
        scenes.push({key, label: `3D ${bodyLabel(body)}, ${g.label}`});
    }
  }
  return scenes;
}

function point(t, value, floor, note) {
  const mark = markOf(t);
  return {
    formulation: t.formulation || t.name,
    kind: t.kind,
    mark,
    mark_label: MARKS.find((m) => m.key === mark)?.label ?? mark,
    make: makeOf(t),
    ns: t.ns,
    spread: t.spread,
    value,
    floor,
    error: Math.max(value, floor),
    floored: !(value > floor),
    note,
    brief: briefOf(t),
    short: [
      t.formulation || t.name,
      variantLabel(t.variant),
      t.precision === 'float' && t.variant !== 'float' ? 'float' : ''
    ]
      .filter(Boolean)
      .join(' ')
  };
}

const numerical = (t) =>
  isNumber(t.error) ? [point(t, t.error, roundingFloor(t), 'worst over all poses, against 50 digits')] : [];

function inRange(t, range) {
  const at = t.errors.find((e) => rangeKey(e) === range);
  return at && isNumber(at.error)
    ? [point(t, at.error, roundingFloor(t), 'worst in this range of φ, against 50 digits')]
    : [];
}

/** The cheapest timing of each formulation whose own error stays below the modelling error.
 * @param {import('../../data.js').Results} results
 */
function modelled(results, timings, kind, scene) {
  return results.formulations.flatMap(({name}) => {
    const m = errorOf(results.finding(name, kind, scene), kind);
    if (m.reason !== undefined) return [];
    const size = Math.max(m.value, m.floor);
    const own = timings
      .filter((t) => t.formulation === name && isNumber(t.error) && t.error <= size)
      .sort((a, b) => a.ns - b.ns);
    return own.length ? [point(own[0], m.value, m.floor, m.note)] : [];
  });
}

/** view: 'numerical', 'range' or 'modelling'; marks: the keys of MARKS that may be used.
 * @param {import('../../data.js').Results} results
 */
export function pointsOf(results, {view, kind, what, range, scene, marks}) {
  const timings = timingsOf(results, kind, what).filter((t) => marks.has(markOf(t)));
  const points =
    view === 'modelling'
      ? modelled(results, timings, kind, scene)
      : timings.flatMap((t) => (view === 'range' ? inRange(t, range) : numerical(t)));
  return points.filter((p) => p.error > 0);
}
