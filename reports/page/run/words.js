// A scene in words.
import {plural, short} from '../format.js';
import {angleAxis} from './poses.js';

/** @typedef {import('../run').RunFile} RunFile */
/** @typedef {import('../run').RunJoint} RunJoint */
/** @typedef {import('../run').RunEnd} RunEnd */

const kDegree = Math.PI / 180;

/** In up to four digits, without zeros at its end. @param {number} x */
const number = (x) => {
  const text = String(Number(x.toPrecision(4)));
  return Math.abs(x) >= 1e-4 && Math.abs(x) < 1e5
    ? text.replace('-', '−')
    : short(x, 4).replace(/\.?0+·/, '·');
};
const listed = (/** @type {number[]} */ v) => v.map(number).join(', ');
export const vectorWords = (/** @type {number[]} */ v) => `(${listed(v)})`;
const isZero = (/** @type {number[]} */ v) => v.every((x) => x === 0);

const KINDS = {
  angular: ['Angular: it resists three rotations', '; the position of node b is held.'],
  linear: ['Linear: it resists three displacements', '; the orientation of node b is held.'],
  linear_angular: ['Linear and angular: it resists three displacements and three rotations', '.']
};

/** What it resists, and what is held where it is the only one. @param {RunJoint} joint @param {boolean} isOne */
export const kindWords = ({kind}, isOne) => `${KINDS[kind][0]}${isOne ? KINDS[kind][1] : '.'}`;

/** Per strain: unit of what the law multiplies it with. */
const LAW_UNITS = {
  stiffness: {shift: 'N/m', turn: 'N m/rad'},
  compliance: {shift: 'm/N', turn: 'rad/(N m)'}
};

/** @param {RunJoint} joint @returns {{shift: number, turn: number}} where the strains of each sort begin, or -1 */
const placesOfStrains = ({kind}) => ({
  shift: kind === 'angular' ? -1 : 0,
  turn: kind === 'linear' ? -1 : kind === 'angular' ? 0 : 3
});

/** @param {RunJoint} joint @param {number[]} diagonal @param {{shift: string, turn: string}} units */
function alongAndAbout(joint, diagonal, units) {
  const {shift, turn} = placesOfStrains(joint);
  const parts = [
    shift < 0 ? '' : `${listed(diagonal.slice(shift, shift + 3))} ${units.shift} along`,
    turn < 0 ? '' : `${listed(diagonal.slice(turn, turn + 3))} ${units.turn} about`
  ];
  return `${parts.filter(Boolean).join(' and ')} joint axes 1, 2, 3`;
}

/** Of a joint with a damper. @param {RunJoint} joint */
export function dampingWords(joint) {
  const rows = joint.damping ?? [];
  const isDiagonal = rows.every((row, i) => row.every((x, j) => i === j || x === 0));
  const diagonal = rows.map((row, i) => row[i]);
  const units = {shift: 'N s/m', turn: 'N m s/rad'};
  const values = isDiagonal
    ? alongAndAbout(joint, diagonal, units)
    : `in N s, m, rad: ${rows.map((r) => `[${listed(r)}]`).join(', ')}`;
  return `Of the rates of the half-way strains, whatever the formulation: ${values}.`;
}

/** @param {RunJoint} joint */
export function lawWords(joint) {
  const {offset, preload} = joint.law;
  const shifts = [
    offset && !isZero(offset) ? `its own zero is at strain ${listed(offset)}` : '',
    preload && !isZero(preload) ? `preloaded by ${listed(preload)}` : ''
  ].filter(Boolean);
  return shifts.length ? `${plainLawWords(joint)} In N, m, rad: ${shifts.join('; ')}.` : plainLawWords(joint);
}

/** @param {RunJoint} joint */
function plainLawWords(joint) {
  const {type, matrix, k1, k3, k5, knots} = joint.law;
  if (type === 'per_axis') {
    const curves = (knots ?? []).map((n) =>
      n === 0 ? 'polynomial' : n === 1 ? 'two slopes' : `${n} points`
    );
    return `A curve for each strain along the joint axes: ${curves.join(', ')}.`;
  }
  if (type === 'polynomial') {
    const terms = /** @type {[string, number[] | undefined][]} */ ([
      ['e', k1],
      ['e³', k3],
      ['e⁵', k5]
    ]);
    const shown = terms.flatMap(([power, k]) => (k && !isZero(k) ? [`(${listed(k)}) ${power}`] : []));
    return `Polynomial in each strain e of the joint axes, N, m, rad: ${shown.join(' + ') || '0'}.`;
  }
  const rows = matrix ?? [];
  const isDiagonal = rows.every((row, i) => row.every((x, j) => i === j || x === 0));
  const diagonal = rows.map((row, i) => row[i]);
  if (isDiagonal) {
    const free =
      type === 'stiffness' && diagonal.some((x) => x === 0) ? '; where it is 0 the joint is free' : '';
    return `Linear, ${type} ${alongAndAbout(joint, diagonal, LAW_UNITS[type])}${free}.`;
  }
  const order = joint.kind === 'linear_angular' ? ', translation first' : '';
  return `Linear and coupled, ${type} in N, m, rad${order}: ${rows.map((r) => `[${listed(r)}]`).join(', ')}.`;
}

/** @param {RunEnd} end */
export function endWords({o, h}) {
  const {angle, axis} = angleAxis(h);
  const point = isZero(o) ? 'at the node' : `at ${vectorWords(o)} m in its axes`;
  const frame =
    angle < 1e-12
      ? 'along its axes'
      : `turned by ${short(angle / kDegree, 4)}° about ${vectorWords(tidy(axis))}`;
  return `joint point ${point}, joint axes ${frame}`;
}

/** Without the rounding of a frame that is not exact. @param {number[]} axis */
const tidy = (axis) => axis.map((x) => Number(x.toFixed(6)) + 0);

const LOADS = {
  fixed_moment: {word: 'moment', unit: 'N m', way: 'fixed in space'},
  follower_moment: {word: 'moment', unit: 'N m', way: 'turning with it'},
  fixed_force: {word: 'force', unit: 'N', way: 'fixed in space'},
  follower_force: {word: 'force', unit: 'N', way: 'turning with it'},
  semi_tangential_moment: {word: 'moment', unit: 'N m', way: 'of dead forces on a cross that turns with it'},
  quasi_tangential_moment: {
    word: 'moment',
    unit: 'N m',
    way: 'of two dead forces on an arm that turns with it'
  }
};

/** @param {RunFile} run @returns {string[]} */
export const loadWords = ({loads, bodies}) =>
  loads.map(({body, type, value, point, held, times = [], factors = []}) => {
    const {word, unit, way} = LOADS[type];
    const where = isZero(point) ? '' : `, at ${vectorWords(point)} m in its axes`;
    return `${word} ${vectorWords(value)} ${unit} on ${nodeWords(bodies[body].name)}${where}, ${way}${held ? '; in full from the start' : ''}${times.length ? `; times ${listed(factors)} at ${listed(times)} s` : ''}`;
  });

/** What bodies are made to do. @param {RunFile} run @returns {string[]} */
export const motionWords = ({motions = [], bodies}) =>
  motions.map(({name, body, type, value, axis, point}) => {
    const unit = type === 'rotation' ? 'rad' : 'm';
    const what = axis
      ? `${short(value['xyz'.indexOf(axis)], 5)} ${unit} ${type === 'rotation' ? 'about' : 'along'} ${axis} alone`
      : `${vectorWords(value)} ${unit}`;
    const where = isZero(point) ? '' : `, of its point ${vectorWords(point)} m`;
    return `${name}: ${type} of ${nodeWords(bodies[body].name)} by ${what}${where}`;
  });

/** @param {string} name */
export const nodeWords = (name) => (/^\w$/.test(name) ? `node ${name}` : name);

/** @param {import('../run').RunChain} chain */
export function chainWords({links, length, stiffness, curvature, held}) {
  const [ea, ga2, ga3, gj, ei2, ei3] = stiffness.map(number);
  return [
    `A rod ${number(length)} m long, clamped at its root${held ? ' and held at its end' : ''}, as ${links} rigid links with a joint in the middle of each.`,
    `Torsion ${gj}, bending ${ei2} and ${ei3} N m²; axial ${ea}, shear ${ga2} and ${ga3} N.`,
    isZero(curvature) ? 'Straight at rest.' : `At rest curved by ${vectorWords(curvature)} 1/m.`
  ];
}

/** "rotation about x: theta_x, rad". @param {import('../run').RunOutput} output */
export function outputWords({name, unit}) {
  const [, what, axis] = /^(theta|u)_([xyz])$/.exec(name) ?? [];
  const words =
    what === 'theta' ? `rotation about ${axis}: ` : what === 'u' ? `displacement along ${axis}: ` : '';
  return `${words}${/^[xyz]$/.test(name) ? `position ${name}` : name}, ${unit}`;
}

/** What the curves run over. @param {RunFile} run */
export const overWords = ({path}) => path.over ?? 'load factor';

/** "load factor 0.5", "time 0.5 s". @param {RunFile} run @param {number} factor @param {number} digits */
export const placeText = ({path}, factor, digits) =>
  path.over ? `time ${short(factor, digits)} s` : `load factor ${short(factor, digits)}`;

/** Who arrives, and how far apart the answers are. @param {RunFile} run */
export function answerWords({comparison, curves, path}) {
  const isOwn = (/** @type {number} */ i) => !['linearized', 'rod'].includes(curves[i].formulation);
  const all = curves.filter((_, i) => isOwn(i)).length;
  const arrived = comparison.groups.flatMap((g) => g.curves).filter(isOwn).length;
  const agree = `${short(100 * comparison.agree, 2)} %`;
  const late = all - arrived;
  const early = late ? ` ${late} ${late === 1 ? 'ends' : 'end'} early.` : '';
  const reach = `${arrived} of ${plural(all, 'formulation')} ${arrived === 1 ? 'reaches' : 'reach'} ${path.over ?? 'load factor'} ${number(path.factor_end)}${path.over ? ' s' : ''}`;
  const {answers} = comparison;
  if (answers > 1) {
    return `${reach}, with ${answers} answers more than ${agree} apart; the farthest differ by ${short(100 * comparison.apart, 2)} %.${early}`;
  }
  return arrived > 1 ? `${reach}, and agree to ${agree} of the answer.${early}` : `${reach}.${early}`;
}
