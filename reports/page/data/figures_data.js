// What the figures of the scenes show, from the results alone: a new scene has its picture without an edit.
import {isNumber, superscript} from '../format.js';

/** @typedef {import('../results').Curve} Curve */
/** @typedef {import('../results').ReferenceCurve} ReferenceCurve */
/** @typedef {import('../data.js').Results} Results */
/** @typedef {{title: string, unit: string}} Axis */

const AXES = {x: '₁', y: '₂', z: '₃'};
const QUANTITIES = {theta: {symbol: 'θ', unit: 'rad'}, u: {symbol: 'u', unit: 'm'}};
/** The linear analysis has no second-order part: every output that has one would differ from it. */
const kNoJoint = 'linearized';
const kMostMarks = 31;

/** Name and unit of an output by its column: theta_x -> θ₁, rad.
 * @param {string} output
 * @returns {Axis}
 */
export function outputAxis(output) {
  const [, quantity, axis] = output.match(/^(theta|u)_([xyz])$/) ?? [];
  if (!quantity) return {title: output.replaceAll('_', ' '), unit: ''};
  const {symbol, unit} = QUANTITIES[/** @type {'theta' | 'u'} */ (quantity)];
  return {title: symbol + AXES[/** @type {'x' | 'y' | 'z'} */ (axis)], unit};
}

/** What the load factor multiplies, where the results say so.
 * @param {import('../results').Scene} scene
 * @returns {Axis}
 */
export const loadAxis = (scene) => ({
  title: scene.load?.title ?? 'load factor',
  unit: scene.load?.unit ?? ''
});

/** "θ₂, rad", or with a power of ten: "θ₂, 10⁻⁷ rad".
 * @param {Axis} axis
 * @param {number} [power]
 */
export function axisTitle({title, unit}, power = 0) {
  const scaled = [power ? `10${superscript(power)}` : '', unit].filter(Boolean).join(' ');
  return scaled ? `${title}, ${scaled}` : title;
}

/** A power of ten for an axis, so that its labels stay short.
 * @param {number[]} numbers
 */
export function powerOf(numbers) {
  const most = Math.max(0, ...numbers.filter(isNumber).map(Math.abs));
  if (!(most > 0) || (most >= 0.1 && most < 1e4)) return 0;
  return Math.floor(Math.log10(most));
}

/** How far the formulations are apart at their last loads, relative to the largest of them.
 * @param {Curve[]} curves
 * @param {string} output
 */
function spreadOf(curves, output) {
  const ends = curves
    .filter((c) => c.formulation !== kNoJoint && c.converged)
    .map((c) => c.rows.at(-1)?.[c.columns.indexOf(output)])
    .filter(isNumber);
  const largest = Math.max(0, ...ends.map(Math.abs));
  return largest > 0 ? (Math.max(...ends) - Math.min(...ends)) / largest : 0;
}

/** Outputs of the curves; the one first in which the formulations differ most, which a scene is there for.
 * @param {Curve[]} curves
 */
export function outputsOf(curves) {
  const names = [...new Set(curves.flatMap((c) => c.columns.slice(1)))];
  const first = names.reduce((a, b) => (spreadOf(curves, b) > spreadOf(curves, a) ? b : a), names[0]);
  return {names, first};
}

/** Every n-th reference point, so that marks stay apart.
 * @template {{rows: unknown[]}} C
 * @param {C} curve
 * @returns {C}
 */
export function thinned(curve) {
  const step = Math.max(1, Math.ceil(curve.rows.length / kMostMarks));
  return {...curve, rows: curve.rows.filter((_, i) => i % step === 0 || i === curve.rows.length - 1)};
}

/** Rows of one output for a chart.
 * @template {{columns: string[], rows: (number | null)[][], formulation: string, source?: string}} C
 * @param {C[]} curves
 * @param {string} output
 * @param {(curve: C) => string} name
 */
export function rowsOf(curves, output, name) {
  return curves.flatMap((curve) => {
    const column = curve.columns.indexOf(output);
    if (column < 0) return [];
    return curve.rows
      .map((row) => ({
        series: name(curve),
        formulation: curve.formulation,
        source: curve.source,
        load: row[0],
        value: row[column]
      }))
      .filter((r) => isNumber(r.load) && isNumber(r.value));
  });
}

/** One figure per scene that was solved, in the order of the results.
 * @param {Results} results
 */
export function figuresOf(results) {
  const described = new Map(results.scenes.map((s) => [s.name, s]));
  const names = new Set([...described.keys(), ...results.curves.map((c) => c.scene)]);
  return [...names].map((name) => {
    const scene = described.get(name) ?? {
      name,
      title: name.replaceAll('_', ' '),
      description: '',
      source: ''
    };
    const curves = results.curves.filter((c) => c.scene === name && c.rows.length > 1);
    return {id: `scene-${name}`, scene, curves, load: loadAxis(scene), outputs: outputsOf(curves)};
  });
}
