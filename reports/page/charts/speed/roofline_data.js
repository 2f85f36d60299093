// Numbers of the roofline: rate, intensity and limit of each batch kernel, and the roofs themselves.
import {percent, short} from '../../format.js';
import {ISAS, isaLabel, levelOf, usable, variantLabel, whatLabel} from '../../data/speed_data.js';

const BANDWIDTH = {nontemporal: 'non-temporal'};
const bandwidthLabel = (b) =>
  [levelOf(b), BANDWIDTH[b.what] ?? b.what.replace(/_l\d$/, '')].filter(Boolean).join(' ');
/** Fewer joints than this may stay in a cache. */
const kInMemory = 1e5;
export const isRoofed = (t) => t.implementation === 'batch' && t.flops > 0 && t.threads <= 1 && usable(t);
export const inMemory = (t) => t.joints >= kInMemory;

const peakOf = (speed, t) =>
  speed.peaks.find((p) => p.isa === t.isa && p.precision === t.precision)?.flops_per_ns;

/** Per kernel its fastest size in cache, or its largest in memory; the limit of its place: peak, or bandwidth
 * times flops per byte. */
export function kernelsOf(timings, speed, {kind, precision, place}) {
  const band = Math.max(
    0,
    ...speed.bandwidth.filter((b) => Boolean(levelOf(b)) === (place === 'cache')).map((b) => b.bytes_per_ns)
  );
  const kept = new Map();
  for (const t of timings.filter(
    (c) => c.kind === kind && c.precision === precision && (place === 'cache' || inMemory(c))
  )) {
    const key = [t.formulation, t.what, t.variant, t.isa].join('/');
    const old = kept.get(key);
    if (!old || (place === 'cache' ? t.ns < old.ns : t.joints > old.joints)) kept.set(key, t);
  }
  return [...kept.values()]
    .map((t) => {
      const rate = t.flops / t.ns,
        intensity = t.bytes > 0 ? t.flops / t.bytes : null,
        peak = peakOf(speed, t);
      const roof = intensity && band ? Math.min(peak ?? Infinity, band * intensity) : peak;
      return {
        formulation: t.formulation,
        what: t.what,
        what_label: [whatLabel(t.what), variantLabel(t.variant)].filter(Boolean).join(', '),
        isa: t.isa,
        isa_label: isaLabel(t.isa),
        ns: t.ns,
        joints: t.joints,
        flops: t.flops,
        bytes: t.bytes,
        rate,
        intensity,
        of_peak: peak ? rate / peak : null,
        of_ports: peak && t.products > 0 ? (2 * t.products) / peak / t.ns : null,
        of_roof: roof ? rate / roof : null,
        share: percent(roof ? rate / roof : null)
      };
    })
    .sort((a, b) => ISAS.indexOf(a.isa) - ISAS.indexOf(b.isa) || (b.of_roof ?? 0) - (a.of_roof ?? 0));
}

/** The peaks, and the bandwidths up to the highest peak; `space`: how far they reach beyond the points, for
 * their labels. */
export function linesOf(speed, points, precision, space) {
  const peaks = speed.peaks.filter((p) => p.precision === precision && p.flops_per_ns > 0);
  const xs = points.map((p) => p.intensity),
    low = Math.min(...xs) / 2,
    high = Math.max(...xs) * space;
  const top = Math.max(...peaks.map((p) => p.flops_per_ns), ...points.map((p) => p.rate));
  const flat = peaks.map((p) => ({
    isa: p.isa,
    y: p.flops_per_ns,
    x: low,
    x2: high,
    label: `${isaLabel(p.isa)} peak ${short(p.flops_per_ns, 3)}`
  }));
  const slanted = speed.bandwidth
    .filter((b) => b.bytes_per_ns > 0)
    .map((b) => {
      const end = Math.min(high, top / b.bytes_per_ns);
      return {
        label: `${bandwidthLabel(b)} ${short(b.bytes_per_ns, 3)} B/ns`,
        x: low,
        y: low * b.bytes_per_ns,
        x2: end,
        y2: end * b.bytes_per_ns
      };
    })
    .filter((b) => b.x2 > b.x);
  return {flat: apart(flat), slanted};
}

/** Peaks within 15 % of each other share one label: two would overlap. */
function apart(flat) {
  const lines = [...flat].sort((a, b) => b.y - a.y);
  for (let i = lines.length - 1; i > 0; --i) {
    if (lines[i - 1].y / lines[i].y < 1.15) {
      lines[i - 1].label += `, ${lines[i].label}`;
      lines[i].label = '';
    }
  }
  return lines;
}
