// What the figure of batch sizes shows: batches that were timed at several sizes, and where caches are full.
import {KINDS} from '../../data/accuracy_data.js';
import {
  ISAS,
  levelOf,
  present,
  speedOf,
  usable,
  variantLabel,
  WHAT,
  whatLabel
} from '../../data/speed_data.js';

const isCandidate = (t) => t.implementation === 'batch' && t.what !== 'assembly' && t.joints > 0 && usable(t);
/** What comes out, and by which variant; batches are timed with joint points and frames at the nodes. */
const outputOf = (t) =>
  [t.what, t.variant === 'no_ends' ? '' : t.variant || 'with_ends'].filter(Boolean).join(' ');
export const outputLabel = (key) => {
  const [what, ...variant] = key.split(' ');
  return [whatLabel(what), ...variant.map(variantLabel)].join(', ');
};

export const seriesKey = (t) => [t.output, t.isa, t.threads].join('/');

/** Where the working set of a level is full: capacity over the bytes of one joint, per output shown.
 * @param {import('../../data.js').Results} results
 */
export function limitsOf(results, timings) {
  const levels = speedOf(results).bandwidth.filter((b) => levelOf(b) && b.capacity > 0);
  const sizes = new Map(timings.filter((t) => t.bytes > 0).map((t) => [t.output, t.bytes]));
  const most = Math.max(...timings.map((t) => t.joints));
  const places = levels.flatMap((b) =>
    [...sizes].map(([output, bytes]) => ({
      output,
      level: levelOf(b),
      joints: b.capacity / bytes,
      label: `${levelOf(b)} full`
    }))
  );
  return [
    ...new Map(
      places.filter((p) => p.joints >= 1 && p.joints <= most).map((p) => [`${p.output}/${p.level}`, p])
    ).values()
  ];
}

/** Only what has been timed at several sizes makes a line.
 * @param {import('../../data.js').Results} results
 */
export function candidatesOf(results) {
  const all = results.timings
    .filter(isCandidate)
    .map((t) => ({...t, output: outputOf(t), threads: t.threads || 1}));
  const sizes = (t) =>
    new Set(
      all
        .filter(
          (o) =>
            o.formulation === t.formulation &&
            o.kind === t.kind &&
            o.precision === t.precision &&
            o.output === t.output
        )
        .map((o) => o.joints)
    ).size;
  const several = new Map();
  return all.filter((t) => {
    const key = [t.formulation, t.kind, t.precision, t.output].join('/');
    if (!several.has(key)) several.set(key, sizes(t) > 1);
    return several.get(key);
  });
}

/** First choice: the invariant joint, its residual and tangent, the widest instructions, all threads. */
export function firstState(all) {
  const of = (key) => all.map((t) => t[key]);
  const first = (key, order) => present(of(key), order)[0];
  const isa = present(of('isa'), ISAS).at(-1);
  const outputs = present(of('output'), Object.keys(WHAT)).slice(0, 2);
  return {
    formulation: first('formulation', ['invariant']),
    kind: first(
      'kind',
      KINDS.map((k) => k.key)
    ),
    precision: first('precision', ['double', 'float']),
    output: new Set(outputs),
    isa: new Set([isa]),
    threads: new Set(of('threads'))
  };
}
