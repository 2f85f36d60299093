// The failure atlas: for each way to fail, how far each formulation is safe, and what a user is told beyond.
import {isNumber, percent, short} from '../format.js';

export const TOLERANCES = [
  {key: 1e-3, label: '10⁻³'},
  {key: 1e-6, label: '10⁻⁶'},
  {key: 1e-12, label: '10⁻¹²'}
];
const SMALL = {from: true, largest: 1}; // larger ones fail by their poles, if at all
const SILENT = 'none: the loads are finite and look plausible';

/** Where the line between two points of a log-log series meets the tolerance. */
function crossing(a, b, tolerance) {
  if (!(a.error > 0) || !isNumber(b.error)) return a.x;
  const share = Math.log(tolerance / a.error) / Math.log(b.error / a.error);
  return a.x * (b.x / a.x) ** Math.min(1, Math.max(0, share));
}

/** Points in the order in which they get worse -> {x}, {all: true} or {none: true}. */
function safe(points, tolerance) {
  const bad = points.findIndex((p) => !(isNumber(p.error) && p.error <= tolerance));
  if (bad < 0) return {all: true, x: points.at(-1).x};
  if (bad === 0) return {none: true, x: points[0].x};
  return {x: crossing(points[bad - 1], points[bad], tolerance)};
}

/** One row of a failure from a series over x; `from`: safe from x on, else up to it. */
function seriesRow(formulation, xs, errors, {from = false, largest = Infinity} = {}) {
  const points = xs
    .map((x, i) => ({x, error: errors[i]}))
    .filter((p) => p.x <= largest)
    .sort((a, b) => (from ? b.x - a.x : a.x - b.x));
  return {
    formulation,
    tried: [points[0].x, points.at(-1).x],
    limits: TOLERANCES.map(({key}) => ({tolerance: key, ...safe(points, key)}))
  };
}

/** A series without a point says nothing. */
const hasPoints = (s) => s.x.length > 0;

/** @param {import('../data.js').Results} results */
const defects = (results, what) =>
  (results.stability?.defects ?? [])
    .filter((s) => s.what === what && hasPoints(s))
    .map((s) => seriesRow(s.formulation, s.x, s.error));
/** @param {import('../data.js').Results} results */
const conditioning = (results, what, options = {}) =>
  (results.stability?.range?.conditioning ?? [])
    .filter((s) => s.what === what && hasPoints(s))
    .map((s) => seriesRow(s.formulation, s.x, s.error, options));

/** One limit that no tolerance moves; x undefined: none. */
const limitRow = (formulation, x, largest, message) => ({
  formulation,
  message,
  limits: [isNumber(x) ? {x} : {all: true, x: largest}]
});

/** @param {import('../data.js').Results} results */
function loops(results) {
  return (results.stability?.energy?.loops ?? [])
    .filter((l) => l.kind === 'angular' && l.points.length)
    .map((l) =>
      seriesRow(
        l.formulation,
        l.points.map((p) => p.amplitude),
        l.points.map((p) => (l.slope === null ? 0 : p.relative))
      )
    );
}

/** The first of half a turn, or of a pole on the way, about any axis.
 * @param {import('../data.js').Results} results
 */
function halfTurns(results) {
  const turns = results.stability?.range?.large_rotation ?? [];
  const names = [...new Set(turns.map((l) => l.formulation))];
  return names.map((formulation) => {
    const found = turns
      .filter((l) => l.formulation === formulation)
      .flatMap((l) =>
        l.crossings
          .filter((c) => isNumber(c.phi) && ['jump', 'pole'].includes(c.behaviour))
          .map((c) => ({...c, phi: Number(c.phi), axis: l.axis}))
      )
      .sort((a, b) => a.phi - b.phi)[0];
    return limitRow(
      formulation,
      found?.phi,
      2 * Math.PI,
      found
        ? `${found.behaviour === 'jump' ? `the moment jumps by ${short(found.jump)} |K|φ` : 'the loads grow without bound'} (axis: ${found.axis})`
        : 'nothing up to 2π'
    );
  });
}

/** The first singular point of the straight path, or what ended it.
 * @param {import('../data.js').Results} results
 */
function firstSingular(results) {
  const {curves = [], columns = []} = results.stability?.paths ?? {};
  const load = columns.indexOf('factor');
  const straight = curves.filter((c) => c.load === 'straight');
  const endOf = (c) => c.points.at(-1)?.[load];
  const largest = Math.max(...straight.map(endOf));
  return straight
    .filter((c) => c.branch === straight[0].branch)
    .map((c) => {
      const event = c.events[0];
      const limit = event?.factor ?? (endOf(c) < largest ? endOf(c) : undefined);
      return limitRow(results.series(c), limit, largest, event ? `${event.type}; ${c.outcome}` : c.outcome);
    });
}

/** @param {import('../data.js').Results} results */
function newtonSteps(results) {
  const {maps = [], grids = []} = results.stability?.basins ?? {};
  const grid = grids.find((g) => g.unit !== 'rad') ?? grids[0];
  return maps
    .filter((m) => m.grid === grid?.name && m.tangent === 'analytic')
    .map((m) =>
      limitRow(
        m.formulation,
        isNumber(m.safe_step) && m.safe_step < grid.largest ? m.safe_step : undefined,
        grid.largest,
        `${percent(m.share)} of the map converges to the continuous path`
      )
    );
}

/** Energies that are series end somewhere; the others have no such limit and no row.
 * @param {import('../data.js').Results} results
 */
const convexRanges = (results) =>
  (results.stability?.range?.convexity ?? []).map((c) => limitRow(c.formulation, c.radius, c.radius, c.says));

/** @param {import('../data.js').Results} results */
const refusal = (results, prefix) =>
  (results.stability?.range?.refusals ?? []).find((r) => r.what.startsWith(prefix))?.says || 'none';

/** Every way to fail: rows with the bound of the safe range for each tolerance.
 * @param {import('../data.js').Results} results
 */
export function failuresOf(results) {
  if (!results.stability) return [];
  return [
    {
      key: 'node-order',
      title: 'Nodes listed in the other order',
      axis: 'φ up to, rad',
      log: true,
      first: 'the loads change',
      message: SILENT,
      rows: defects(results, 'node_order')
    },
    {
      key: 'moments',
      title: 'Moments about a point',
      axis: 'φ up to, rad',
      log: true,
      first: 'they do not balance: angular momentum from nowhere',
      message: SILENT,
      rows: defects(results, 'moment_balance')
    },
    {
      key: 'work',
      title: 'Work round a closed loop',
      axis: 'amplitude up to, rad',
      log: true,
      first: 'energy from nowhere, or lost',
      message: SILENT,
      rows: loops(results)
    },
    {
      key: 'half-turn',
      title: 'Half a turn and more',
      axis: 'φ up to, rad',
      first: 'the rotation vector jumps, or an Euler angle has its pole',
      message: 'by the path follower: its outcome names the angle',
      rows: halfTurns(results)
    },
    {
      key: 'convexity',
      title: 'Energies that are series',
      axis: 'φ up to, rad',
      first: 'the energy is convex no more, and unbounded below',
      message: 'refused by name: eval, run and the path follower',
      rows: convexRanges(results)
    },
    {
      key: 'singular',
      title: 'Singular points under a moment about axis 1 (C3)',
      axis: 'moment up to, N·m',
      first: 'a fold or a branching: load stepping stops or changes path',
      message: 'by the path follower: its outcome',
      rows: firstSingular(results)
    },
    {
      key: 'newton',
      title: 'One Newton step from rest (C3)',
      axis: 'moment up to, N·m, any direction',
      log: true,
      first: 'another equilibrium, or none',
      message: 'converged, unless the steps are halved',
      rows: newtonSteps(results)
    },
    {
      key: 'small',
      title: 'Small rotations of turned nodes',
      axis: 'φ from, rad',
      log: true,
      from: true,
      first: 'the difference of two rotations keeps few digits',
      message: SILENT,
      rows: conditioning(results, 'phi/double', SMALL)
    },
    {
      key: 'small-compensated',
      title: 'The same, compensated kernel',
      axis: 'φ from, rad',
      log: true,
      from: true,
      first: 'as before, later',
      message: SILENT,
      rows: conditioning(results, 'phi/compensated', SMALL)
    },
    {
      key: 'ratio',
      title: 'Stiffness ratio, equilibrium',
      axis: 'ratio up to',
      log: true,
      first: 'the soft direction loses digits',
      message: `singular or indefinite only: “${refusal(results, 'singular')}”`,
      rows: conditioning(results, 'ratio_rotated/solve')
    },
    {
      key: 'drift',
      title: 'Matrices that drift from rotations',
      axis: '|R − rotation| up to',
      log: true,
      first: 'strain that is none',
      message: refusal(results, 'quaternion'),
      rows: conditioning(results, 'drift/angular')
    },
    {
      key: 'distance',
      title: 'Far from the origin',
      axis: 'distance up to, m',
      log: true,
      first: 'the difference of two positions keeps few digits',
      message: SILENT,
      rows: conditioning(results, 'distance/linear_angular')
    }
  ].filter((f) => f.rows.length);
}
