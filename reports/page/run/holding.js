// What holds the bodies where they are: reactions at a clamped node, the load on the other; a chain's ends.
import {h, plainTable} from '../dom.js';
import {full, short} from '../format.js';
import {unbalanced} from './run_data.js';
import {nodeWords, placeText} from './words.js';

/** @typedef {import('./run.js').App} App */

const kNothing = 1e-9; // of the largest load: a number that was kept in eight digits
const kBalanced = 1e-6; // likewise: sums of such numbers, and levers that have as many

/** Small beside the largest is rounding. @param {number} x @param {number} largest */
const cell = (x, largest) => h('span', {title: full(x)}, short(Math.abs(x) < kNothing * largest ? 0 : x, 5));

/** Sizes of the largest force and moment. @param {number[][]} loads */
const largestOf = (loads) =>
  [0, 3].map((k) => Math.max(...loads.map((l) => Math.hypot(...l.slice(k, k + 3)))));

/** @param {App} app */
function content({run, state, chosen}) {
  const {holding, poses, label} = chosen();
  const loads = holding[state.row];
  if (!loads) return h('p', {class: 'note'}, `Nobody says what holds the nodes of ${label}.`);
  const [force, moment] = largestOf(loads);
  const hasForces = Boolean(run.chain) || run.joints.some((j) => j.kind !== 'angular');
  const columns = [
    {text: 'holds'},
    ...(hasForces ? ['x', 'y', 'z'].map((k) => ({text: `force ${k}, N`, number: true})) : []),
    ...['x', 'y', 'z'].map((k) => ({text: `moment ${k}, N m`, number: true}))
  ];
  const row = (/** @type {string} */ name, /** @type {number[]} */ load) => [
    name,
    ...(hasForces ? load.slice(0, 3).map((x) => cell(x, force)) : []),
    ...load.slice(3).map((x) => cell(x, moment))
  ];
  const isHeld = (/** @type {number} */ i) => !run.chain || i === 0 || i === run.bodies.length - 1;
  const bodies = run.bodies.filter((_, i) => isHeld(i));
  const at = poses[state.row].filter((_, i) => isHeld(i));
  const sum = unbalanced(loads, at);
  const reach = Math.max(...at.map((p) => Math.hypot(...p.slice(0, 3))));
  const isBalanced =
    Math.hypot(...sum.slice(0, 3)) <= kBalanced * force &&
    Math.hypot(...sum.slice(3)) <= kBalanced * (moment + reach * force);
  return [
    plainTable(
      `What holds the nodes of ${label}`,
      columns,
      bodies.map((b, i) => row(nodeWords(b.name), loads[i])),
      `${label} at ${placeText(run, state.factor, 5)}; axes of the scene, moments about each node`
    ),
    h(
      'p',
      {class: isBalanced ? 'note' : 'note verdict mark known_failure'},
      isBalanced
        ? 'Forces balance, and moments about one point.'
        : `What holds the nodes does not balance: ${label} loses or wins moment. Left: force (${sum
            .slice(0, 3)
            .map((x) => short(x, 3))
            .join(', ')}) N, moment about the origin (${sum
            .slice(3)
            .map((x) => short(x, 3))
            .join(', ')}) N m.`
    )
  ];
}

/** @param {App} app */
export function holdingSection(app) {
  const box = h('div');
  return {content: box, update: () => box.replaceChildren(...[content(app)].flat())};
}
