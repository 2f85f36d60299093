// How far each formulation follows the nonlinear 3D body: loads from the findings fe_range_*, degrees by the
// stored 3D curve of the same study.
import {isNumber} from '../format.js';

/** @typedef {import('../data.js').Results} Results */
/** @typedef {import('../results').Finding} Finding */
/** Phi in degrees; whole: to the curve's end.
 * @typedef {{load: number, phi: number | undefined, isWhole: boolean}} Reach */
/** @typedef {{formulation: string, kind: string, study: string, unit: string, one: Reach, five: Reach, end: Reach,
 *   finding: Finding}} Range */

const NAME = /^(.+)\/(\w+)\/fe_range_(\w+)$/;
const FIVE = /within 5 % up to ([\d.e+-]+)/;
const END = /phi = ([\d.]+) rad at ([\d.e+-]+)/;
/** The material law that the ranges were measured against. */
const kLaw = 'cauchy_log';
const kAlmost = 1 - 1e-9;

/** @param {number} radians */
export const degrees = (radians) => (radians * 180) / Math.PI;

/** Load over the curve's end -> angle, by linear interpolation from rest.
 * @param {{rows: (number | null)[][]}} curve whose columns are factor, theta_x, theta_y, theta_z, ...
 * @param {number} share
 */
export function angleAt(curve, share) {
  const points = curve.rows.map((row) => ({
    load: Number(row[0]),
    phi: Math.hypot(...row.slice(1, 4).map(Number))
  }));
  const last = points.at(-1);
  if (!last || !(last.load > 0) || !isNumber(share)) return undefined;
  const load = share * last.load;
  let before = {load: 0, phi: 0};
  for (const point of points) {
    if (load <= point.load && point.load > before.load) {
      return before.phi + ((point.phi - before.phi) * (load - before.load)) / (point.load - before.load);
    }
    before = point;
  }
  return share <= 1 / kAlmost ? last.phi : undefined;
}

/**
 * @param {number} load
 * @param {number} end
 * @param {{rows: (number | null)[][]} | undefined} curve
 * @returns {Reach}
 */
function reachOf(load, end, curve) {
  const phi = curve && angleAt(curve, load / end);
  return {load, phi: phi === undefined ? undefined : degrees(phi), isWhole: load >= end * kAlmost};
}

/** One record per finding that has a value; the others say why in their reason.
 * @param {Results} results
 * @returns {Range[]}
 */
export function rangesOf(results) {
  return results.findings.flatMap((finding) => {
    const [, formulation, kind, study] = finding.name.match(NAME) ?? [];
    const five = Number(finding.parameter?.match(FIVE)?.[1]);
    const end = Number(finding.parameter?.match(END)?.[2]);
    if (!study || !isNumber(finding.value) || !isNumber(five) || !(end > 0)) return [];
    const curve = results.paper?.reference_curves?.find(
      (c) => c.scene === `range_${study}` && c.formulation.endsWith(`, ${kLaw}`)
    );
    const reach = (/** @type {number} */ load) => reachOf(load, end, curve);
    return [
      {
        formulation,
        kind,
        study,
        unit: finding.unit,
        one: reach(finding.value),
        five: reach(five),
        end: reach(end),
        finding
      }
    ];
  });
}

/** The study that a kind of joint is held against first.
 * @param {Range[]} ranges
 * @param {string} kind
 */
export const studyOf = (ranges, kind) => ranges.find((r) => r.kind === kind)?.study;

/** The formulation of a study that reaches farthest.
 * @param {Range[]} ranges of one study
 * @param {'one' | 'five'} within
 * @returns {Range | undefined}
 */
export const farthest = (ranges, within) => [...ranges].sort((a, b) => b[within].load - a[within].load)[0];
