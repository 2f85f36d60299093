// What is drawn of a run in three dimensions: bodies, ends, loads, trails as lines, faces, words. No document here.
import {composed, exaggerated, plus, pointOf, posed, scaled, turned} from './poses.js';
import {largestMotion, multiplierAt, proportions, restSize, rowBeside} from './run_data.js';

/** @typedef {import('./poses.js').Vector} Vector */
/** @typedef {import('./poses.js').Posed} Posed */
/** @typedef {import('../run').RunFile} RunFile */
/** @typedef {import('../run').RunCurve} RunCurve */
/** @typedef {import('./run_data.js').Series} Series */
/** @typedef {{points: Vector[], cls: string, color?: string, isFace?: boolean, text?: string}} Piece */
/** @typedef {{length: number, half: Vector, axis: number, times: number}} Sizes
 *   of the scene, of a body's box, of axes, m; and how many times larger motions are drawn */

const UNITS = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1]
];
/** Sides of a box that looks the same in no two positions. */
const SIDES = [1, 0.7, 0.42];
/** Corners of the faces of a box, counter-clockwise from outside. */
const FACES = [
  ['+--', '++-', '+++', '+-+'],
  ['---', '--+', '-++', '-+-'],
  ['-+-', '-++', '+++', '++-'],
  ['---', '+--', '+-+', '--+'],
  ['--+', '+-+', '+++', '-++'],
  ['---', '-+-', '++-', '+--']
];

/** @param {RunFile} run @returns {Sizes} */
export function sizesOf(run) {
  const {length, times} = proportions(run);
  const isPoint = restSize(run) === 0 && !(largestMotion(run).shift > 0);
  const box = run.chain ? 0.05 : isPoint ? 0.5 : 0.22;
  const half = run.chain ? [0.008, 0.05, 0.05] : scaled(SIDES, box);
  return {length, times, half: scaled(half, length), axis: (run.chain ? 0.12 : 1.9 * box) * length};
}

/** @param {Posed} pose @param {Vector} half @param {string} cls @param {string} [color] @returns {Piece[]} */
const box = (pose, half, cls, color) =>
  FACES.map((face) => ({
    ...{cls, color, isFace: true},
    points: face.map((corner) =>
      pointOf(
        pose,
        half.map((h, k) => (corner[k] === '+' ? h : -h))
      )
    )
  }));

/** Three axes of a pose, each from where it leaves a box, with a name.
 * @param {Posed} pose @param {number} length @param {Vector} from
 * @param {{cls: string, color?: string, names: string[]}} how
 * @returns {Piece[]}
 */
function axes(pose, length, from, {cls, color, names}) {
  return UNITS.flatMap((unit, k) => {
    const at = (/** @type {number} */ far) => pointOf(pose, scaled(unit, far));
    const name = names[k] ? [{cls: 'word', color, points: [at(length * 1.13)], text: names[k]}] : [];
    return [{cls, color, points: [at(from[k]), at(length)]}, ...name];
  });
}

/** Two unit vectors across a direction. @param {Vector} d unit */
function across(d) {
  const most = Math.abs(d[0]) < 0.8 ? [1, 0, 0] : [0, 1, 0];
  const cross = (/** @type {Vector} */ a, /** @type {Vector} */ b) => [
    a[1] * b[2] - a[2] * b[1],
    a[2] * b[0] - a[0] * b[2],
    a[0] * b[1] - a[1] * b[0]
  ];
  const u = cross(d, most);
  const first = scaled(u, 1 / Math.hypot(...u));
  return [first, cross(d, first)];
}

/** @param {Vector} tip @param {Vector} d unit @param {number} size @returns {Piece[]} */
const head = (tip, d, size) =>
  across(d).map((u) => {
    const back = plus(tip, scaled(d, -size));
    const side = scaled(u, size * 0.42);
    return {cls: 'load head', isFace: true, points: [tip, plus(back, side), plus(back, scaled(side, -1))]};
  });

/** The arrow of a moment: it turns about the shaft the way that the ring shows. */
function ring(at, d, radius) {
  const [u, v] = across(d);
  const point = (/** @type {number} */ t) =>
    plus(at, plus(scaled(u, radius * Math.cos(t)), scaled(v, radius * Math.sin(t))));
  const steps = Array.from({length: 25}, (_, i) => (i / 24) * 1.5 * Math.PI);
  const end = /** @type {number} */ (steps.at(-1));
  const along = plus(scaled(u, -Math.sin(end)), scaled(v, Math.cos(end)));
  return [
    {cls: 'load ring', points: steps.map(point)},
    ...head(plus(point(end), scaled(along, radius * 0.45)), along, radius * 0.6)
  ];
}

/** Loads at a load factor or a time; arrows of one kind are in proportion.
 * @param {RunFile} run @param {Posed[]} bodies @param {number} factor @param {Sizes} sizes @returns {Piece[]}
 */
function loadPieces({loads, path}, bodies, factor, {axis}) {
  const isMoment = (/** @type {{type: string}} */ load) => load.type.endsWith('moment');
  return loads.flatMap((load) => {
    const size = Math.hypot(...load.value);
    const share = path.over ? multiplierAt(load, factor) : factor / path.factor_end;
    if (!(size > 0) || !share) return [];
    const alike = loads.filter((l) => isMoment(l) === isMoment(load)).map((l) => Math.hypot(...l.value));
    const body = bodies[load.body];
    const value = load.type.startsWith('follower') ? turned(body.q, load.value) : load.value;
    const d = scaled(value, Math.sign(share) / size);
    const strength = (size / Math.max(...alike)) * Math.abs(share);
    const length = axis * (0.35 + 0.95 * strength);
    const from = isMoment(load) ? body.x : pointOf(body, load.point);
    const tip = plus(from, scaled(d, length));
    const far = plus(from, scaled(d, length + axis * 0.14));
    return [
      {cls: 'gap', points: [body.x, from]},
      {cls: 'load', points: [from, tip]},
      ...head(tip, d, axis * 0.17),
      ...(isMoment(load) ? ring(plus(from, scaled(d, length * 0.72)), d, axis * 0.2) : []),
      {cls: 'word strong', points: [far], text: isMoment(load) ? 'M' : 'F'}
    ];
  });
}

/** The arms of a joint, its frames, and what is between its points.
 * @param {import('../run').RunJoint} joint @param {Posed[]} bodies @param {Sizes} sizes @param {string} color
 * @returns {Piece[]}
 */
function jointPieces(joint, bodies, {axis, length}, color) {
  const frames = [joint.a, joint.b].map(({body, o, h}) => ({
    x: pointOf(bodies[body], o),
    q: composed(bodies[body].q, h)
  }));
  const isApart = Math.hypot(...plus(frames[0].x, scaled(frames[1].x, -1))) > 1e-3 * length;
  const isOwn = ({o, h}) => Math.hypot(...o) > 0 || Math.abs(h[0]) < 1 - 1e-12;
  const ends = [joint.a, joint.b].flatMap((end, i) => {
    const own = i ? {cls: 'frame', color} : {cls: 'frame clamped', color: undefined};
    const arm = {cls: 'arm', color: own.color, points: [bodies[end.body].x, frames[i].x]};
    if (!isOwn(end)) return [];
    return [
      arm,
      ...axes(frames[i], axis * 0.62, [0, 0, 0], {...own, names: i ? ['1', '2', '3'] : ['', '', '']})
    ];
  });
  return isApart ? [...ends, {cls: 'gap', points: frames.map((f) => f.x)}] : ends;
}

/** Where a curve's bodies are at a row.
 * @param {RunFile} run @param {RunCurve} curve @param {number} row @param {number} times
 */
export function bodiesAt({bodies}, curve, row, times) {
  const poses = curve.poses[row];
  return bodies.map(({rest}, i) => (poses ? exaggerated(posed(rest), posed(poses[i]), times) : posed(rest)));
}

/** The way of axis tips of moving bodies up to a row. @param {Posed[][]} states @returns {Piece[]} */
function trails(run, states, {axis}, color) {
  return run.bodies.flatMap(({clamped}, i) =>
    clamped
      ? []
      : UNITS.map((unit) => ({
          ...{cls: 'trail', color},
          points: states.map((bodies) => pointOf(bodies[i], scaled(unit, axis)))
        }))
  );
}

const kPrimes = ['', '′', '″', '‴'];
/** @param {RunFile} run @param {number} body */
const axisNames = ({bodies}, body) =>
  bodies.length > kPrimes.length ? ['', '', ''] : ['x', 'y', 'z'].map((name) => name + kPrimes[body]);

/** @param {RunFile} run @param {Posed[]} bodies @param {Posed[]} rest @param {Sizes} sizes @param {string} color */
function boxes(run, bodies, rest, sizes, color) {
  const isHidden = (/** @type {number} */ i) =>
    run.bodies.some(
      (other, j) =>
        !other.clamped && Math.hypot(...plus(rest[j].x, scaled(rest[i].x, -1))) < 2 * sizes.half[0]
    );
  return run.bodies.flatMap(({clamped, name}, i) => {
    const how = clamped ? {cls: 'axis clamped'} : {cls: 'axis', color};
    const named = {...how, color: how.color, names: axisNames(run, i)};
    const aside = sizes.half.map((x, k) => (clamped || k === 1 ? -1.3 : 1.3) * x);
    const word = {cls: 'word strong', color: how.color, text: name, points: [pointOf(bodies[i], aside)]};
    const own = axes(bodies[i], sizes.axis, clamped && isHidden(i) ? [0, 0, 0] : sizes.half, named);
    if (clamped)
      return [...box(bodies[i], sizes.half, isHidden(i) ? 'outline' : 'body clamped'), ...own, word];
    return [
      ...box(rest[i], sizes.half, 'outline'),
      ...box(bodies[i], sizes.half, 'body', color),
      ...own,
      word
    ];
  });
}

/** A chain: its line, its section's axis 2 at some nodes, its root. */
function chainPieces(run, bodies, rest, sizes, color) {
  const every = Math.max(1, Math.round(bodies.length / 16));
  const ticks = bodies.filter((_, i) => i % every === 0 || i === bodies.length - 1);
  return [
    ...box(bodies[0], sizes.half, 'body clamped'),
    {cls: 'chain rest', points: rest.map((b) => b.x)},
    {cls: 'chain', color, points: bodies.map((b) => b.x)},
    ...ticks.map((b) => ({cls: 'tick', color, points: [b.x, pointOf(b, [0, 0.4 * sizes.axis, 0])]})),
    ...axes(bodies[bodies.length - 1], sizes.axis, [0, 0, 0], {cls: 'axis', color, names: ['x', 'y', 'z']})
  ];
}

/** The other formulations at the same load factor: where their axes point, or the line of their chain. */
function beside(run, others, factor, sizes) {
  return others.flatMap(({curve, look}) => {
    const row = rowBeside(curve, factor);
    if (row < 0 || !curve.poses[row]) return [];
    const bodies = bodiesAt(run, curve, row, sizes.times);
    if (run.chain) return [{cls: 'chain other', color: look.color, points: bodies.map((b) => b.x)}];
    const how = {cls: 'other', color: look.color, names: ['', '', '']};
    return run.bodies.flatMap(({clamped}, i) => (clamped ? [] : axes(bodies[i], sizes.axis, [0, 0, 0], how)));
  });
}

/** Everything at a row of the chosen series, and the others beside it.
 * @param {RunFile} run @param {Series} chosen @param {Series[]} others @param {number} row @param {Sizes} sizes
 * @returns {Piece[]}
 */
export function piecesOf(run, chosen, others, row, sizes) {
  const {curve, look} = chosen;
  const {color} = look;
  const rest = run.bodies.map((b) => posed(b.rest));
  const states = curve.poses.slice(0, row + 1).map((_, i) => bodiesAt(run, curve, i, sizes.times));
  const bodies = states.at(-1) ?? rest;
  const factor = curve.rows[row]?.[0] ?? 0;
  const drawn = run.chain
    ? [
        ...states.slice(1, -1).map((b) => ({cls: 'chain before', color, points: b.map((p) => p.x)})),
        ...chainPieces(run, bodies, rest, sizes, color)
      ]
    : [
        ...trails(run, states, sizes, color),
        ...boxes(run, bodies, rest, sizes, color),
        ...run.joints.flatMap((joint) => jointPieces(joint, bodies, sizes, color))
      ];
  return [...beside(run, others, factor, sizes), ...drawn, ...loadPieces(run, bodies, factor, sizes)];
}

/** Everything that the chosen curve ever needs to be seen.
 * @param {RunFile} run @param {RunCurve} curve @param {Sizes} sizes
 */
export function placesOf(run, curve, sizes) {
  const states = [
    run.bodies.map((b) => posed(b.rest)),
    ...curve.poses.map((_, i) => bodiesAt(run, curve, i, sizes.times))
  ];
  return states.flatMap((bodies) => [
    ...bodies.map((b) => b.x),
    ...run.joints.flatMap((j) => [j.a, j.b].map(({body, o}) => pointOf(bodies[body], o))),
    ...run.loads.map(({body, point}) => pointOf(bodies[body], point))
  ]);
}
