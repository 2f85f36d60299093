// Timings beyond the reference: what they are of, how they are marked, and the results' object `speed`.
import {isNumber, short, powerOfTen} from '../format.js';

/** Results of before kernels were timed name none of these. */
export const withDefaults = (t) => ({
  ...t,
  implementation: t.implementation || 'reference',
  precision: t.precision || 'double',
  isa: t.isa ?? '',
  variant: t.variant ?? '',
  method: t.method ?? '',
  joints: t.joints ?? 0,
  threads: t.threads ?? 0,
  errors: t.errors ?? []
});
export const isPlain = (t) => t.precision === 'double' && t.variant === '';
export const isAnalytic = (t) => t.method === '' || t.method === 'analytic';

const LISTS = ['peaks', 'bandwidth', 'targets', 'published', 'cheapest', 'instructions'];
/** Every list is there, possibly empty.
 * @param {import('../data.js').Results} results
 */
export const speedOf = (results) => Object.fromEntries(LISTS.map((key) => [key, results.speed?.[key] ?? []]));

/** The cache that a bandwidth is of, 'L1' from read_l1; undefined: the memory. */
export const levelOf = (bandwidth) => bandwidth.what.match(/_(l\d)$/)?.[1].toUpperCase();

/** Not ours: libraries, and the textbook's formula written down without care. */
export const isCompetitor = (t) => t.implementation === 'competitor' || t.implementation === 'textbook';

export const WHAT = {
  residual: 'without tangent',
  residual_tangent: 'with tangent',
  residual_tangent_144: 'with tangent, 144 entries',
  residual_compressed: 'with compressed tangent',
  product: 'product J v',
  assembly: 'poses to a sparse matrix'
};
const IMPLEMENTATION = {reference: 'transcription'};
/** @param {string} key */
export const implementationLabel = (key) => IMPLEMENTATION[key] ?? key;
export const whatLabel = (key) => WHAT[key] ?? key.replaceAll('_', ' ');
const ISA = {sse2: 'SSE2', avx2: 'AVX2', avx2vl: 'AVX2 in 32 registers', avx512: 'AVX-512', scalar: 'scalar'};
export const isaLabel = (key) => ISA[key] ?? key;
export const ISAS = Object.keys(ISA);

/** What a mark stands for, as the legend lists it. */
export const MARKS = [
  {key: 'reference', label: 'transcription', shape: 'circle'},
  {key: 'kernel', label: 'kernel', shape: 'square'},
  {key: 'batch', label: 'batch', shape: 'triangle-up'},
  {key: 'float', label: 'float', shape: 'triangle-down'},
  {key: 'variant', label: 'variant of a kernel', shape: 'cross'},
  {key: 'method', label: 'other tangent method', shape: 'triangle-right'},
  {key: 'competitor', label: 'textbook, competitor', shape: 'diamond'}
];

/** The key of a timing's mark: what sets it most apart comes first. */
export function markOf(t) {
  if (isCompetitor(t)) return 'competitor';
  if (!isAnalytic(t)) return 'method';
  // no_ends: joint points at the nodes, fewer operations, the same accuracy.
  if (t.variant !== '' && t.variant !== 'no_ends') return 'variant';
  if (t.precision === 'float') return 'float';
  return MARKS.some((m) => m.key === t.implementation) ? t.implementation : 'kernel';
}

/** All that tells this timing from others of its formulation, in words. */
export const makeOf = (t) =>
  [
    t.joints > 1
      ? `${implementationLabel(t.implementation)} of ${t.joints}`
      : implementationLabel(t.implementation),
    isaLabel(t.isa),
    t.precision === 'double' || t.variant === t.precision ? '' : t.precision,
    variantLabel(t.variant),
    isAnalytic(t) ? '' : methodLabel(t.method),
    t.threads > 1 ? `${t.threads} threads` : ''
  ]
    .filter(Boolean)
    .join(', ');
export const methodLabel = (key) =>
  ({
    analytic: 'analytic',
    dual: 'dual numbers',
    autodiff: 'Eigen AutoDiffScalar',
    ceres_jet: 'Ceres Jet',
    complex_step: 'complex step',
    forward: 'forward differences',
    central: 'central differences'
  })[key] ?? key.replaceAll('_', ' ');
export const variantLabel = (key) =>
  key
    .replace(/^order_(\d+)$/, 'order $1')
    .replace(/^log_(\d+)$/, 'log of degree $1')
    .replaceAll('_', ' ');

/** The same in short, for a label beside a point. */
export const briefOf = (t) =>
  [
    t.variant
      ? variantLabel(t.variant)
      : isAnalytic(t)
        ? implementationLabel(t.implementation)
        : methodLabel(t.method),
    isaLabel(t.isa),
    t.precision === 'float' && t.variant !== 'float' ? 'float' : ''
  ]
    .filter(Boolean)
    .join(' ');

/** Half a unit of rounding, below which an error says nothing. */
export const roundingFloor = (t) => (t.precision === 'float' ? 2 ** -25 : 2 ** -54);
export const usable = (t) => !t.wrong && t.ns > 0;

/** A batch is timed at many sizes: the fastest on one thread stands for it. */
export function fastestBatches(timings) {
  const best = new Map();
  for (const t of timings) {
    if (t.implementation === 'batch' && t.threads > 1) continue;
    const key =
      t.implementation === 'batch'
        ? [t.formulation, t.kind, t.what, t.isa, t.precision, t.variant, t.method].join('/')
        : t.name;
    if (!best.has(key) || t.ns < best.get(key).ns) best.set(key, t);
  }
  return [...best.values()];
}

const kNearPi = 3;
const power = (x) => (x === 1 ? '1' : powerOfTen(x) || String(Number(x.toPrecision(3))));
const toPi = (x) => (Math.PI - x < 1e-15 ? 'π' : `π − ${power(Number((Math.PI - x).toPrecision(3)))}`);
export const phiText = (x) => (x === 0 ? '0' : x < kNearPi || x > Math.PI + 1e-9 ? power(x) : toPi(x));
export const nearPi = (range) => range.from >= kNearPi;
export const rangeLabel = ({from, to}) => `${phiText(from)} … ${phiText(to)}`;
export const rangeKey = ({from, to}) => `${from}/${to}`;

/** All ranges of phi that the timings know, ascending. */
export function rangesOf(timings) {
  const ranges = new Map(
    timings.flatMap((t) => t.errors).map((e) => [rangeKey(e), {from: e.from, to: e.to}])
  );
  return [...ranges.values()].sort((a, b) => a.from - b.from || a.to - b.to);
}

/** The different keys: those of `order` first, the others sorted. */
export const present = (keys, order = []) => [
  ...order.filter((k) => keys.includes(k)),
  ...[...new Set(keys)].filter((k) => !order.includes(k)).sort()
];
export const ratio = (x) => (isNumber(x) ? `${short(x, 2)}×` : '–');
