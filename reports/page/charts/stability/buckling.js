// Critical moments of the buckling case, with what the paper prints.
import {Chart, isNarrow} from '../../chart.js';
import {h} from '../../dom.js';
import {short} from '../../format.js';
import {look} from '../../palette.js';
import {Absent} from '../../parts.js';

const OUTPUT = 'critical_moment';

/** @param {import('../../data.js').Results} results */
function rowsOf(results) {
  const findings = results.findings.filter(
    (f) => f.name.startsWith('c3_buckling/') && f.name.endsWith(`/${OUTPUT}`)
  );
  const printed = new Map((results.paper?.buckling ?? []).map((p) => [p.formulation, p]));
  const printedOf = (name) => (printed.has(name) ? Number(printed.get(name)?.printed) : null);
  const drawn = findings
    .filter((f) => f.verdict !== 'left_out' && Number(f.value) > 0)
    .map((f) => ({
      formulation: f.formulation,
      value: Number(f.value),
      shown: `${short(f.value, 6)} N·m`,
      verdict: f.verdict,
      printed: printedOf(f.formulation),
      reason: f.reason
    }));
  const none = findings.filter((f) => !drawn.some((d) => d.formulation === f.formulation));
  drawn.sort((a, b) => b.value - a.value);
  return {drawn, none, printed};
}

function spec(rows) {
  const names = rows.map((r) => r.formulation);
  const y = {
    field: 'formulation',
    type: 'nominal',
    sort: names,
    title: null,
    axis: {labelColor: 'var(--ink)', labelFontSize: 13, ticks: false, domain: false, labelLimit: 140}
  };
  const most = Math.max(...rows.flatMap((r) => [r.value, r.printed ?? 0]));
  // Room for the value beside the longest bar.
  const x = {
    field: 'value',
    type: 'quantitative',
    title: 'critical moment about axis 1, N·m',
    axis: {tickCount: 6},
    scale: {domain: [0, most * (isNarrow() ? 1.5 : 1.25)], nice: false}
  };
  return {
    height: {step: isNarrow() ? 26 : 30},
    data: {values: rows},
    layer: [
      {
        mark: {type: 'bar', height: {band: 0.62}},
        encoding: {
          x,
          y,
          color: {
            field: 'formulation',
            type: 'nominal',
            legend: null,
            scale: {domain: names, range: names.map((n) => look(n).color)}
          },
          tooltip: [
            {field: 'formulation'},
            {field: 'value', format: '.13g', title: 'critical moment, N·m'},
            {field: 'printed', title: 'printed, N·m'},
            {field: 'verdict'},
            {field: 'reason', title: 'held against'}
          ]
        }
      },
      {mark: {type: 'text', align: 'left', dx: 6}, encoding: {x, y, text: {field: 'shown'}}},
      {
        transform: [{filter: 'isValid(datum.printed)'}],
        mark: {type: 'tick', thickness: 3, height: {band: 0.95}, color: 'var(--ink)'},
        encoding: {
          x: {...x, field: 'printed'},
          y,
          tooltip: [{field: 'formulation'}, {field: 'printed', title: 'printed, N·m'}]
        }
      }
    ]
  };
}

/** The same reason holds for several: said once. */
function byReason(findings) {
  const reasons = [...new Set(findings.map((f) => f.reason))];
  return reasons
    .map(
      (r) =>
        findings
          .filter((f) => f.reason === r)
          .map((f) => f.formulation)
          .join(', ') + (r ? ` (${r})` : '')
    )
    .join('; ');
}

/** @param {import('../../data.js').Results} results */
export function bucklingFigure(results) {
  const {drawn, none, printed} = rowsOf(results);
  if (!drawn.length) return new Absent('no finding c3_buckling/<formulation>/critical_moment has a value');
  const chart = new Chart(
    'buckling',
    'Critical moment of each formulation as horizontal bars, with ticks at the values that the paper prints.'
  );
  chart.draw(spec(drawn));
  const errata = [...printed.values()]
    .filter((p) => p.erratum)
    .map((p) => h('li', {}, `${p.formulation}: printed ${p.printed}, right ${p.corrected}: ${p.erratum}.`));
  return h(
    'figure',
    {},
    chart.box,
    h(
      'figcaption',
      {},
      'First zero of the tangent’s determinant under a moment about axis 1. Thick ticks: the ' +
        'values that the paper prints for that formulation. ',
      none.length ? `Without a critical moment: ${byReason(none)}. ` : '',
      'A slender rod of the same stiffness has none either, whatever that is: the poles are those of the single ' +
        'joint (see ',
      h('a', {href: '#rod-reach'}, 'who follows the rod'),
      '). The block itself, 5 m long and 30 m wide, is no rod: by 3D finite elements, neo-Hookean, it turns on ' +
        'without one up to 800 N·m at least, and coarse meshes give way in torsion near 890 N·m.'
    ),
    errata.length ? h('ul', {class: 'note'}, errata) : null
  );
}
