// Poses as a drawing needs them: unit quaternions (w, x, y, z), turned, and motions drawn larger than they are.

/** @typedef {number[]} Vector  x, y, z */
/** @typedef {number[]} Quaternion  w, x, y, z */
/** @typedef {{x: Vector, q: Quaternion}} Posed */

/** @param {number[]} seven as the data have it @returns {Posed} */
export const posed = (seven) => ({x: seven.slice(0, 3), q: seven.slice(3)});

/** @param {Quaternion} p @param {Quaternion} q @returns {Quaternion} first q, then p */
export const composed = ([a, b, c, d], [e, f, g, k]) => [
  a * e - b * f - c * g - d * k,
  a * f + b * e + c * k - d * g,
  a * g - b * k + c * e + d * f,
  a * k + b * g - c * f + d * e
];

/** @param {Quaternion} q @returns {Quaternion} */
export const inverted = ([w, x, y, z]) => [w, -x, -y, -z];

/** @param {Quaternion} q @param {Vector} v */
export const turned = (q, v) => composed(composed(q, [0, ...v]), inverted(q)).slice(1);

export const plus = (/** @type {Vector} */ a, /** @type {Vector} */ b) => a.map((x, k) => x + b[k]);
export const scaled = (/** @type {Vector} */ a, /** @type {number} */ s) => a.map((x) => x * s);

/** A point of a body, given in its axes. @param {Posed} pose @param {Vector} p */
export const pointOf = ({x, q}, p) => plus(x, turned(q, p));

/** Angle, rad, 0 to pi, and axis; of no rotation the first axis. @param {Quaternion} q */
export function angleAxis([w, ...v]) {
  const sine = Math.hypot(...v);
  const sign = w < 0 ? -1 : 1;
  return {
    angle: 2 * Math.atan2(sine, Math.abs(w)),
    axis: sine > 0 ? scaled(v, sign / sine) : [1, 0, 0]
  };
}

/** How far a body has moved from rest, in axes of the scene. @param {Posed} rest @param {Posed} pose */
export const motion = (rest, pose) => ({
  shift: plus(pose.x, scaled(rest.x, -1)),
  turn: angleAxis(composed(pose.q, inverted(rest.q)))
});

/** The pose with `times` the motion: a drawing's, not an equilibrium.
 * @param {Posed} rest @param {Posed} pose @param {number} times @returns {Posed}
 */
export function exaggerated(rest, pose, times) {
  if (times === 1) return pose;
  const {shift, turn} = motion(rest, pose);
  const half = (times * turn.angle) / 2;
  const more = [Math.cos(half), ...scaled(turn.axis, Math.sin(half))];
  return {x: plus(rest.x, scaled(shift, times)), q: composed(more, rest.q)};
}
