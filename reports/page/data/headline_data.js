// What the headline says, as numbers: which formulation, up to which angle and load.
import {KINDS, accuracyOf, front} from './accuracy_data.js';
import {isNumber} from '../format.js';
import {degrees, farthest, rangesOf, studyOf} from './ranges_data.js';

/** @typedef {import('../data.js').Results} Results */
/** @typedef {import('./accuracy_data.js').Point} Point */

/** The kind that the page shows first: the one with most measured points, angular before others.
 * @param {Results} results
 */
export function firstKind(results) {
  const {points} = accuracyOf(results, {what: 'residual', error: 'modelling'});
  const count = (/** @type {string} */ kind) => points.filter((p) => p.kind === kind).length;
  return KINDS.map((k) => k.key).reduce((best, kind) => (count(kind) > count(best) ? kind : best), 'angular');
}

/** Where the modelling error was measured: "c2_parallelepiped_small, theta_y at 1 N m" and the angle there.
 * @param {Results} results
 * @param {string} formulation
 * @param {string} kind
 */
export function conditionOf(results, formulation, kind) {
  const where = results.finding(formulation, kind, 'modelling_error')?.parameter ?? '';
  const [, scene, load] = where.match(/^(\w+), \w+ at (.+)$/) ?? [];
  if (!scene) return {where};
  const factor = Number(load.match(/[\d.e+-]+/)?.[0]);
  const curve = results.curves.find((c) => c.scene === scene && c.formulation === formulation);
  return {where, scene, load: load.replace(/^factor .*/, ''), phi: angleOf(curve, factor)};
}

/** Rotation of a curve at a load, degrees.
 * @param {import('../results').Curve | undefined} curve
 * @param {number} factor
 */
function angleOf(curve, factor) {
  const row = curve?.rows.find((r) => isNumber(r[0]) && Math.abs(r[0] / factor - 1) < 1e-9);
  const theta = ['theta_x', 'theta_y', 'theta_z'].map((name) => curve?.columns.indexOf(name) ?? -1);
  const values = theta.filter((i) => i > 0).map((i) => row?.[i]);
  return row && values.length && values.every(isNumber) ? degrees(Math.hypot(...values)) : undefined;
}

/** How far the truest formulations, and the farthest of all, follow the 3D body.
 * @param {Results} results
 * @param {string} kind
 * @param {string[]} truest
 */
export function reachesOf(results, kind, truest) {
  const all = rangesOf(results).filter((r) => r.kind === kind);
  const own = all.filter((r) => r.study === studyOf(all, kind));
  const best = [farthest(own, 'one'), farthest(own, 'five')].map((r) => r?.formulation);
  return {
    shown: own.filter((r) => truest.includes(r.formulation) || best.includes(r.formulation)),
    one: farthest(own, 'one'),
    end: own[0]?.end
  };
}

/** The choice at small angles; undefined where nothing was measured.
 * @param {Results} results
 * @param {string} kind
 */
export function choiceOf(results, kind) {
  const points = accuracyOf(results, {what: 'residual', error: 'modelling'}).points.filter(
    (p) => p.kind === kind
  );
  if (!points.length) return undefined;
  const least = Math.min(...points.map((p) => p.error));
  const [best, ...also] = points.filter((p) => p.error === least).sort((a, b) => a.ns - b.ns);
  const fastest = points.reduce((a, b) => (b.ns < a.ns ? b : a));
  const between = front(points).filter((p) => p !== best && p !== fastest);
  return {best, also, fastest, between, condition: conditionOf(results, best.formulation, kind)};
}
