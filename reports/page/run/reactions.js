// Reactions of a mechanism: what each joint exerts on the bodies at either node.
import {h, plainTable} from '../dom.js';
import {full, short} from '../format.js';
import {nodeWords, placeText} from './words.js';

/** @typedef {import('./run.js').App} App */

const kNoReaction = 1e-9; // of the largest: a number that was kept in eight digits

/** @param {App} app */
function exertedTable({run, state, chosen}) {
  const {reactions = [], label} = chosen();
  const now = reactions[state.row];
  if (!now) return h('p', {class: 'note'}, `Nobody says what the joints of ${label} exert.`);
  const largest = [0, 3].map((k) => Math.max(...now.flat().map((l) => Math.hypot(...l.slice(k, k + 3)))));
  const cell = (/** @type {number} */ x, /** @type {number} */ k) =>
    h(
      'span',
      {title: full(x)},
      short(Math.abs(x) < kNoReaction * /** @type {number} */ (largest[k < 3 ? 0 : 1]) ? 0 : x, 5)
    );
  const rows = run.joints.flatMap((joint, j) =>
    [joint.a, joint.b].map((end, n) => [
      `${joint.name} on ${nodeWords(/** @type {any} */ (run.bodies[end.body]).name)}`,
      .../** @type {any} */ (now[j])[n].map(cell)
    ])
  );
  const columns = [
    {text: 'exerts'},
    ...['x', 'y', 'z'].map((k) => ({text: `force ${k}, N`, number: true})),
    ...['x', 'y', 'z'].map((k) => ({text: `moment ${k}, N m`, number: true}))
  ];
  return plainTable(
    `What the joints of ${label} exert`,
    columns,
    rows,
    `${label} at ${placeText(run, state.factor, 5)}; axes of the scene, moments about each node`
  );
}

/** @param {App} app */
export function reactionsSection(app) {
  const box = h('div');
  return {content: box, update: () => box.replaceChildren(exertedTable(app))};
}
