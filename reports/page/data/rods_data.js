// Who follows the rod at large rotation: rows of charts and tables from results.rods.
import {isNumber} from '../format.js';
import {degrees} from './ranges_data.js';

/** @typedef {import('../results').Rods} Rods */
/** @typedef {{formulation: string, tolerance: string, degrees: number, moment: number, isWhole: boolean}} Reach */

/** How far each joint stays with the rod, the farthest within the tighter tolerance first.
 * @param {Rods} rods
 * @returns {Reach[]}
 */
export function reachRows(rods) {
  const skew = rods.skew;
  if (!skew) return [];
  const last = skew.moment.at(-1);
  const reachOf = (/** @type {any} */ curve, /** @type {number} */ i) => curve.within[i].angle;
  const sorted = skew.curves.toSorted(
    (a, b) => reachOf(b, 0) - reachOf(a, 0) || reachOf(b, 1) - reachOf(a, 1)
  );
  return sorted.flatMap((curve) =>
    curve.within.map((w) => ({
      formulation: curve.formulation,
      tolerance: `${100 * w.tolerance} %`,
      degrees: degrees(w.angle),
      moment: w.moment,
      isWhole: w.moment === last
    }))
  );
}

/** Error over the rod's rotation, up to where a joint has no equilibrium any more.
 * @param {Rods} rods
 * @returns {{formulation: string, degrees: number, moment: number, error: number}[]}
 */
export function followRows(rods) {
  const skew = rods.skew;
  if (!skew) return [];
  // The rod turns back at the largest moments: a line over its rotation ends there.
  const turned = skew.angle.findIndex((angle, i) => i > 0 && angle < skew.angle[i - 1]);
  const count = turned < 0 ? skew.angle.length : turned;
  return skew.curves.flatMap((curve) => {
    const lost = curve.error.findIndex((e) => !isNumber(e));
    const upTo = lost < 0 ? count : Math.min(lost, count);
    return curve.error.slice(0, upTo).map((error, i) => ({
      formulation: curve.formulation,
      degrees: degrees(skew.angle[i]),
      moment: skew.moment[i],
      error: Number(error)
    }));
  });
}

/** A word of the record for people: `c3` is the rod of C3. @param {string} stiffness */
export const rodName = (stiffness) =>
  stiffness === 'c3'
    ? 'C3'
    : stiffness.startsWith('strip_')
      ? `strip, GJ ${stiffness.slice(6)} EI₂`
      : stiffness.replaceAll(':', ' : ');

/** One row per formulation, one cell per column, from lists that each have rows of formulations.
 * @template {{rows: {formulation: string}[]}} T
 * @param {T[]} columns
 * @param {(row: any, column: T) => string} cell
 */
export function crossed(columns, cell) {
  const names = [...new Set(columns.flatMap((c) => c.rows.map((r) => r.formulation)))];
  return names.map((name) => [
    name,
    ...columns.map((c) => {
      const row = c.rows.find((r) => r.formulation === name);
      return row ? cell(row, c) : '–';
    })
  ]);
}

/** Words of the scenes of chains. @type {Record<string, string>} */
const CHAINS = {
  straight_anisotropic: 'straight, anisotropic',
  straight_slender: 'straight, slender',
  precurved_anisotropic: 'curved, anisotropic',
  bend_45_st_venant: '45° bend'
};
/** @param {string} rod */
export const chainName = (rod) => CHAINS[rod] ?? rod.replaceAll('_', ' ');

/** A row per number of links that was solved.
 * @param {Rods} rods
 * @returns {{formulation: string, rod: string, links: number, error: number, ms: number, iterations: number,
 *   order: number | null}[]}
 */
export const chainRows = (rods) =>
  (rods.chains?.orders ?? []).flatMap((of) =>
    of.points
      .filter((p) => isNumber(p.error) && isNumber(p.ms))
      .map((p) => ({
        ...{
          formulation: of.formulation,
          rod: of.rod,
          links: p.links,
          error: Number(p.error),
          ms: Number(p.ms)
        },
        ...{iterations: p.iterations, order: of.order}
      }))
  );
