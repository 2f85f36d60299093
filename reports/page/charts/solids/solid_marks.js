// Our 3D finite elements and rods as marks over the lumped formulations' curves: one series per body and material law.
import {bodyLabel, lawLook} from '../../data/solids_data.js';

export const SOLID_SOURCE = '3D finite elements';
const ROD_SOURCE = 'geometrically exact rod';
/** @param {{source: string}} curve of a body, not of a formulation */
export const isBody = (curve) => curve.source === SOLID_SOURCE || curve.source === ROD_SOURCE;
const kRod = {label: 'slender rod', shape: 'cross'};
/** Shown at the start: the law that the paper's program documents, on the scene's first body. */
const kFirstLaw = 'cauchy_log';

/** One entry per curve; its formulation reads "body, law". */
export function solidSeries(references) {
  const curves = references.filter(isBody);
  const solids = curves.filter((c) => c.source === SOLID_SOURCE);
  const bodies = [...new Set(solids.map((c) => c.formulation.split(', ')[0]))];
  const series = curves.map((curve) => {
    const [body, law] = curve.formulation.split(', ');
    const isRod = curve.source === ROD_SOURCE;
    const look = isRod ? kRod : lawLook(law);
    // Ink for the scene's own body, so that marks stand out from the coloured lines; the other body is muted.
    return {
      key: curve.formulation,
      curve,
      label: `${bodies.length > 1 && !isRod ? `${bodyLabel(body)}; ` : ''}${look.label}`,
      title: `${curve.source}: ${curve.formulation}`,
      look: {color: isRod || body === bodies[0] ? 'var(--ink)' : 'var(--muted)', shape: look.shape},
      on: isRod || (body === bodies[0] && law === kFirstLaw)
    };
  });
  if (series.length && !series.some((s) => s.on)) series[0].on = true;
  return series;
}

/** Vega-Lite layer for rows whose `series` is the key of a series above. */
export function solidLayer(rows, series, {x, y, tooltip}) {
  const domain = series.map((s) => s.key);
  const scaled = (what) => ({
    field: 'series',
    type: 'nominal',
    legend: null,
    scale: {domain, range: series.map((s) => s.look[what])}
  });
  return {
    data: {values: rows},
    mark: {type: 'point', size: 48, strokeWidth: 1.5, filled: false, opacity: 1},
    encoding: {
      x,
      y,
      shape: scaled('shape'),
      stroke: scaled('color'),
      tooltip: [{field: 'source', title: 'source'}, ...tooltip]
    }
  };
}
