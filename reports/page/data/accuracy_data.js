// Points of error against time: one per formulation and kind of joint, and why a point is missing.
import {isNumber, short} from '../format.js';
import {implementationLabel} from './speed_data.js';

/** @typedef {import('../data.js').Results} Results */
/** @typedef {import('../results').Finding} Finding */
/** @typedef {import('../results').Timing} Timing */
/** @typedef {import('../results').Formulation} Formulation */
/** @typedef {{body: string, group: string}} SolidChoice */
/** @typedef {{value: number, floor: number, note: string, truth?: string, reason?: undefined}} Measured */
/** @typedef {{reason: string, value?: undefined, floor?: undefined, note?: undefined}} Unknown */
/** @typedef {Measured & {formulation: string, label: string, stands_for: string, kind: string, kind_label: string,
 *   implementation: string, implementation_label: string, ns: number, spread: number | null, error: number,
 *   floored: boolean}} Point */
/** @typedef {{name: string, kind: string, reason: string}} Missing */

export const KINDS = [
  {key: 'angular', label: 'angular'},
  {key: 'linear', label: 'linear'},
  {key: 'linear_angular', label: 'linear/angular'}
];
/** @param {string} key */
export const kindLabel = (key) => KINDS.find((k) => k.key === key)?.label ?? key;

/** A finding as an error with the uncertainty of its truth; or why it is none.
 * @param {Finding | undefined} f
 * @param {string} kind
 * @returns {Measured | Unknown}
 */
export function errorOf(f, kind) {
  if (!f) return {reason: 'no modelling error measured'};
  if (f.verdict === 'left_out') return {reason: f.reason};
  if (!isNumber(f.value)) return {reason: 'its modelling error is not a number'};
  const floor = isNumber(f.uncertainty) ? f.uncertainty : 0;
  if (!(Math.max(f.value, floor) > 0)) {
    return {reason: 'its error and the uncertainty of the truth are both 0: no place on a log axis'};
  }
  const where = [f.parameter, f.reason].filter(Boolean).join('; ');
  const truth = `${kindLabel(kind)}: ${where}${floor > 0 ? `, known to ${short(floor)}` : ''}`;
  return {value: f.value, floor, note: where, truth};
}

/** @param {Timing | undefined} timing @returns {Measured | Unknown} */
function numericalOf(timing) {
  if (!isNumber(timing?.error)) return {reason: 'no numerical error measured'};
  const truth = 'the same formula at 50 digits';
  return {value: timing.error, floor: 2 ** -54, note: 'against 50 digits of the same formula', truth};
}

/** @param {Results} results @param {string} name @param {string} kind */
export const modellingOf = (results, name, kind) =>
  errorOf(results.finding(name, kind, 'modelling_error'), kind);

/** Error of the second-order couplings against the 3D body's.
 * @param {Results} results
 * @param {string} name
 * @param {string} kind
 * @param {SolidChoice} solid
 * @returns {Measured | Unknown}
 */
export function solidErrorOf(results, name, kind, {body, group}) {
  const f = results.finding(name, kind, `fe_${body}_${group}`);
  const measured = errorOf(f, kind);
  return measured.reason === undefined ? {...measured, truth: f?.reason} : measured;
}

/** @param {Timing | undefined} timing */
function untimed(timing) {
  if (timing?.wrong) return `benchmark refused it: ${timing.message}`;
  return isNumber(timing?.ns) && timing.ns > 0 ? '' : 'not timed';
}

/**
 * @param {Formulation} formulation
 * @param {string} kind
 * @param {Timing} timing
 * @param {Measured} measured
 * @param {boolean} isProbed at its probe_xi, which the label then names
 * @returns {Point}
 */
function pointOf({name, stands_for, probe_xi: xi}, kind, timing, measured, isProbed) {
  return {
    ...measured,
    formulation: name,
    label: isProbed ? `${name} ξ = ${xi}` : name,
    stands_for,
    kind,
    kind_label: kindLabel(kind),
    implementation: timing.implementation,
    implementation_label: implementationLabel(timing.implementation),
    ns: Number(timing.ns),
    spread: timing.spread,
    error: Math.max(measured.value, measured.floor),
    floored: !(measured.value > measured.floor)
  };
}

/** What: of which output the time is; error: 'modelling', 'numerical' or 'solids', which needs `solid`.
 * @param {Results} results
 * @param {{what: string, error: string, solid?: SolidChoice, implementation?: string}} choice
 * @returns {{points: Point[], missing: Missing[]}}
 */
export function accuracyOf(results, {what, error, solid, implementation = 'kernel'}) {
  /** @type {Point[]} */
  const points = [];
  /** @type {Missing[]} */
  const missing = [];
  for (const formulation of results.formulations) {
    const {name, needs_xi: isFree} = formulation;
    for (const {key: kind} of KINDS) {
      const timing =
        implementation === 'kernel' ? results.preferred(name, kind, what) : results.timing(name, kind, what);
      const measured =
        error === 'numerical'
          ? numericalOf(timing)
          : error === 'solids' && solid
            ? solidErrorOf(results, name, kind, solid)
            : modellingOf(results, name, kind);
      const reason = untimed(timing) || measured.reason;
      if (reason) missing.push({name, kind, reason});
      else {
        const own = pointOf(
          formulation,
          kind,
          /** @type {Timing} */ (timing),
          /** @type {Measured} */ (measured),
          isFree && error !== 'solids'
        );
        points.push(own);
      }
    }
  }
  return {points, missing};
}

/** Points that no other point of the list beats in both time and error, by time.
 * @template {{ns: number, error: number}} P
 * @param {P[]} points
 */
export function front(points) {
  let best = Infinity;
  return [...points]
    .sort((a, b) => a.ns - b.ns || a.error - b.error)
    .filter((p) => {
      const isBetter = p.error < best;
      if (isBetter) best = p.error;
      return isBetter;
    });
}
