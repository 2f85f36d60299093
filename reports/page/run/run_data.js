// What the page of a run is drawn from: look-ups and choices, without a document.
import {hashOf, seriesLook} from '../palette.js';
import {motion, posed} from './poses.js';

/** @typedef {import('../run').RunFile} RunFile */
/** @typedef {import('../run').RunCurve} RunCurve */
/** @typedef {import('../palette.js').Look} Look */
/** @typedef {{key: string, curve: RunCurve, look: Look, on: boolean}} Series */

/** One series a curve, in the order of the run. At first one of each group of equal answers is shown, and those that
 * end early: the others would lie on top of them. The linear analysis is far off where there is much to see.
 * @param {RunFile} run @returns {Series[]}
 */
export function seriesOfRun(run) {
  const chosen = run.curves.findIndex((c) => c.label === firstChosen(run));
  const first = run.comparison.groups.map(({curves}) => (curves.includes(chosen) ? chosen : curves[0]));
  const shown = new Set([...first, ...run.comparison.ended.flatMap((e) => e.curves)]);
  return run.curves.map((curve, i) => {
    const earlier = run.curves.slice(0, i).filter((c) => c.formulation === curve.formulation).length;
    const isAside = curve.formulation === 'linearized' && run.curves.length > 1;
    return {
      key: curve.label,
      curve,
      look: seriesLook(curve.formulation, earlier),
      on: shown.has(i) && !isAside
    };
  });
}

/** The curve whose bodies are drawn first. @param {RunFile} run */
export function firstChosen({curves}) {
  const drawable = curves.filter((c) => c.poses.length > 1);
  const best = drawable.find((c) => c.formulation === 'invariant') ?? drawable.find((c) => c.converged);
  return (best ?? drawable[0] ?? curves[0])?.label ?? '';
}

/** The row of a curve that is nearest to a load factor; of several the last. @param {RunCurve} curve */
export function rowNear({rows}, /** @type {number} */ factor) {
  const off = rows.map(([f]) => Math.abs(f - factor));
  return off.lastIndexOf(Math.min(...off));
}

/** Does the load factor rise all the way? By arc length it may fall. @param {RunCurve} curve */
export const isRising = ({rows}) => rows.every(([f], i) => i === 0 || f >= rows[i - 1][0]);

/** The row of another curve to be drawn beside a row of the chosen one: where it was at that load factor, and none
 * beyond its end or where the path turns back. @param {RunCurve} curve @param {number} factor
 */
export function rowBeside(curve, factor) {
  if (!isRising(curve) || !curve.rows.length) return -1;
  const reached = /** @type {number[]} */ (curve.rows.at(-1))[0];
  return factor > reached * (1 + 1e-9) ? -1 : rowNear(curve, factor);
}

/** Largest distance of the points that the drawing has at rest from the first of them, m; 0 where they are one.
 * @param {RunFile} run
 */
export function restSize({bodies, joints, loads}) {
  const points = bodies.map((b) => posed(b.rest).x);
  const far = points.map((p) => Math.hypot(...p.map((x, k) => x - points[0][k])));
  const arms = [...joints.flatMap((j) => [j.a.o, j.b.o]), ...loads.map((l) => l.point)];
  return Math.max(0, ...far, ...arms.map((o) => Math.hypot(...o)));
}

const greatest = (/** @type {number[]} */ list) => list.reduce((a, b) => Math.max(a, b), 0);

/** The largest rotation, rad, and displacement, m, of a body in any row. @param {RunFile} run */
export function largestMotion({bodies, curves}) {
  const rest = bodies.map((b) => posed(b.rest));
  const all = curves.flatMap((c) => c.poses.flatMap((row) => row.map((p, i) => motion(rest[i], posed(p)))));
  return {
    turn: greatest(all.map((m) => m.turn.angle)),
    shift: greatest(all.map((m) => Math.hypot(...m.shift)))
  };
}

/** A length that the drawing is in proportion to, and how many times larger motions are drawn: 1 where they can be
 * seen, else 1, 2 or 5 times a power of ten. @param {RunFile} run
 */
export function proportions(run) {
  const {turn, shift} = largestMotion(run);
  const length = restSize(run) || 2 * shift || 1;
  const seen = Math.max(turn, shift / length);
  if (seen >= 0.1 || seen === 0) return {length, times: 1};
  const wanted = 0.5 / seen;
  const power = 10 ** Math.floor(Math.log10(wanted));
  return {
    length,
    times: Number(((wanted >= 5 * power ? 5 : wanted >= 2 * power ? 2 : 1) * power).toPrecision(1))
  };
}

/** What a load is multiplied with at a time: straight between its times, and as at the nearest beyond them.
 * @param {import('../run').RunLoad} load @param {number} time
 */
export function multiplierAt({times = [], factors = []}, time) {
  if (!times.length) return 1;
  const after = times.findIndex((t) => t > time);
  if (after <= 0) return /** @type {number} */ (factors.at(after));
  const [t, u] = times.slice(after - 1, after + 1);
  const [f, g] = factors.slice(after - 1, after + 1);
  return f + ((g - f) * (time - t)) / (u - t);
}

/** What of the loads that hold the bodies does not balance: the sums of forces, and of moments about the origin.
 * @param {number[][]} holding @param {number[][]} poses
 */
export function unbalanced(holding, poses) {
  const sum = [0, 0, 0, 0, 0, 0];
  holding.forEach((load, i) => {
    const [x, y, z] = poses[i];
    const [fx, fy, fz] = load;
    const about = [0, 0, 0, y * fz - z * fy, z * fx - x * fz, x * fy - y * fx];
    load.forEach((value, k) => {
      sum[k] += value + about[k];
    });
  });
  return sum;
}

/** As curve.csv has it, without errors where there are none. @param {RunFile} run */
export function curvesCsv({outputs, curves, path}) {
  const head = ['formulation', path.over ?? 'factor', ...outputs.map((o) => o.name), 'error'];
  const rows = curves.flatMap((c) => c.rows.map((row, i) => [c.label, ...row, c.errors[i] ?? '']));
  return [head, ...rows].map((row) => row.join(',')).join('\r\n') + '\r\n';
}

/** A name for a file. @param {string} text */
export const fileName = (text) => text.replace(/[^\w.-]+/g, '_') || `scene_${hashOf(text)}`;
