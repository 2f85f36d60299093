// What the figure of assemblies shows: each way from poses to a sparse matrix, by kind and by where the matrix lies.
import {KINDS} from '../../data/accuracy_data.js';
import {isaLabel, usable, variantLabel} from '../../data/speed_data.js';

const WAYS = [
  {key: 'textbook', label: 'textbook, Eigen'},
  {key: 'reference', label: 'as MBDyn codes it'},
  {key: 'kernel', label: 'scalar kernel'},
  {key: 'batch', label: 'batch, whole table'},
  {key: 'assemble', label: 'assemble'}
];
const VARIANT = {upper: 'upper triangle', eigen: 'into an Eigen::SparseMatrix'};
const isDrawn = (t) =>
  t.what === 'assembly' && usable(t) && (t.threads || 1) === 1 && t.variant !== 'wall' && t.joints > 0;

/** The way, and which joint where the ways before it are of another one. */
function labelOf(t) {
  const way = WAYS.find((w) => w.key === t.implementation)?.label ?? t.implementation;
  return [
    way,
    t.implementation === 'assemble' && t.formulation !== 'invariant' ? t.formulation : '',
    t.variant ? (VARIANT[t.variant] ?? variantLabel(t.variant)) : ''
  ]
    .filter(Boolean)
    .join(', ');
}

/** Rows of the figure: ways in order, then kinds; `place`: the smaller size stays in the caches.
 * @param {import('../../data.js').Results} results
 */
export function rowsOf(results) {
  const timings = results.timings.filter(isDrawn);
  const least = Math.min(...timings.map((t) => t.joints));
  const order = (t) => {
    const way = WAYS.findIndex((w) => w.key === t.implementation);
    return 10 * (way < 0 ? WAYS.length : way) + (t.formulation === 'invariant' ? 0 : 1) + (t.variant ? 2 : 0);
  };
  return timings
    .map((t) => ({
      way: labelOf(t),
      kind: t.kind,
      kind_label: KINDS.find((k) => k.key === t.kind)?.label ?? t.kind,
      place: t.joints === least ? 'in cache' : 'from memory',
      joints: t.joints,
      ns: t.ns,
      spread: t.spread,
      isa: t.isa ? isaLabel(t.isa) : '',
      order: order(t)
    }))
    .sort((a, b) => a.order - b.order);
}
