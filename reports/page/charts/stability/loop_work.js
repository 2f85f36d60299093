// Work round a closed loop of poses: how it grows with the amplitude.
import {Chart, isNarrow} from '../../chart.js';
import {kindLabel} from '../../data/accuracy_data.js';
import {VERDICTS} from '../../data.js';
import {h, swatch} from '../../dom.js';
import {isNumber, short} from '../../format.js';
import {KIND_SHAPES, look} from '../../palette.js';
import {Absent} from '../../parts.js';

/** The band in which a finding is held.
 * @param {import('../../results').Finding} f
 */
function bandOf({comparison, expected, low, high}) {
  if (comparison === 'within') return {low, high};
  const [middle, half] = [expected ?? NaN, high ?? NaN];
  return {low: middle - half, high: middle + half};
}

/** @param {import('../../data.js').Results} results */
export function loopWorkFigure(results) {
  const chart = new Chart(
    'loop-work',
    'Slope of the loop work in the amplitude, per formulation, for formulations that do net work ' +
      'round a closed loop.'
  );
  const measured = (property) =>
    results.findings.filter(
      (f) => f.name.endsWith(`/${property}`) && f.verdict !== 'left_out' && isNumber(f.value)
    );
  const sloped = measured('loop_order').filter((f) => f.comparison === 'equal'); // the others do no work
  const rows = sloped.map((f) => ({
    formulation: f.formulation,
    kind: f.kind,
    kind_label: kindLabel(f.kind),
    value: f.value,
    ...bandOf(f),
    verdict: VERDICTS[f.verdict].label,
    shown: short(f.value, 3),
    reason: f.reason
  }));
  if (!rows.length) return new Absent('no finding of the loop work has a slope');
  const names = [...new Set(rows.map((r) => r.formulation))];
  const kinds = Object.keys(KIND_SHAPES);
  const y = {
    field: 'formulation',
    type: 'nominal',
    sort: names,
    title: null,
    axis: {
      labelColor: 'var(--ink)',
      labelFontSize: 13,
      ticks: false,
      domain: false,
      grid: true,
      labelLimit: 140
    }
  };
  const x = {
    type: 'quantitative',
    title: 'slope s: work ~ amplitudeˢ',
    scale: {zero: false},
    axis: {tickCount: 6}
  };
  const apart =
    new Set(rows.map((r) => r.kind)).size > 1
      ? {yOffset: {field: 'kind', type: 'nominal', scale: {domain: kinds}}}
      : {};
  chart.draw({
    height: {step: isNarrow() ? 26 : 30},
    data: {values: rows},
    layer: [
      {
        mark: {type: 'rule', strokeWidth: 7, opacity: 0.35, color: 'var(--known)'},
        encoding: {x: {...x, field: 'low'}, x2: {field: 'high'}, y, ...apart}
      },
      {
        mark: {type: 'point', filled: true, size: 80, opacity: 1},
        encoding: {
          x: {...x, field: 'value'},
          y,
          ...apart,
          shape: {
            field: 'kind',
            type: 'nominal',
            legend: null,
            scale: {domain: kinds, range: kinds.map((k) => KIND_SHAPES[k])}
          },
          color: {
            field: 'formulation',
            type: 'nominal',
            legend: null,
            scale: {domain: names, range: names.map((n) => look(n).color)}
          },
          tooltip: [
            {field: 'formulation'},
            {field: 'kind_label', title: 'kind'},
            {field: 'value', title: 'slope', format: '.4g'},
            {field: 'low', format: '.3g'},
            {field: 'high', format: '.3g'},
            {field: 'verdict'},
            {field: 'reason'}
          ]
        }
      }
    ]
  });
  const legend = kinds
    .filter((k) => rows.some((r) => r.kind === k))
    .map((k) =>
      h('span', {class: 'key'}, swatch({color: 'var(--muted)', shape: KIND_SHAPES[k]}), kindLabel(k))
    );
  const conservative = results.formulations
    .map((f) => f.name)
    .filter((name) =>
      ['angular', 'linear_angular'].every(
        (kind) => results.finding(name, kind, 'loop_work')?.verdict === 'pass'
      )
    );
  return h(
    'figure',
    {},
    h('p', {class: 'keys'}, legend),
    chart.box,
    h(
      'figcaption',
      {},
      'A joint without a potential gains or loses energy round a closed loop of poses; the pale ' +
        'bar is the band in which the slope is held. ',
      conservative.length
        ? `No work beyond rounding, angular and linear/angular: ${conservative.join(', ')}.`
        : ''
    )
  );
}
