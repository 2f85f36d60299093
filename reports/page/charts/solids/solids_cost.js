// Accuracy against cost of the 3D truth itself: elements and meshes, and CalculiX on the same meshes.
import {AT_DECADES, Chart, isNarrow} from '../../chart.js';
import {choice, h, swatch} from '../../dom.js';
import {full, isNumber, seconds} from '../../format.js';
import {bodyLabel, ELEMENTS, elementLook, lawLook, LAWS, paperXi} from '../../data/solids_data.js';
import {Absent} from '../../parts.js';

const WHAT = [
  {key: 'xi', label: 'ξ'},
  {key: 'compliance', label: 'compliance'}
];
const Y_TITLE = {xi: 'error of ξ', compliance: 'largest error of the six compliances, relative'};
const kCalculixLaw = 'st_venant';
/** Below this error bar xi is exact on every mesh, and its error is rounding. */
const kExact = 1e-9;

/** Error and its floor for one mesh; undefined where the results do not tell. */
function errorOf(body, run, what, law) {
  if (what === 'xi') {
    const truth = paperXi(body, law);
    return truth && isNumber(run.xi?.[law])
      ? {value: Math.abs(run.xi[law] - truth.value), floor: truth.uncertainty}
      : undefined;
  }
  const pairs = (body.compliances ?? [])
    .map((c, k) => ({
      value: Math.abs(run.compliance?.[k] / c.value - 1),
      floor: c.uncertainty / Math.abs(c.value)
    }))
    .filter((p) => isNumber(p.value));
  return pairs.length
    ? {value: Math.max(...pairs.map((p) => p.value)), floor: Math.max(...pairs.map((p) => p.floor))}
    : undefined;
}

/** @param {ReturnType<typeof import('../../data/solids_data.js').solidsOf>} solids */
function pointsOf(solids, body, what, law) {
  const own = (body.runs ?? []).map((r) => ({...r, look: r.element}));
  // CalculiX has one law, and only its xi is kept.
  const other =
    what === 'xi' && law === kCalculixLaw
      ? solids.calculix
          .filter((c) => c.body === body.name)
          .map((c) => ({...c, look: 'calculix', xi: {[law]: c.xi}}))
      : [];
  return [...own, ...other].flatMap((r) => {
    const e = errorOf(body, r, what, law);
    if (!e || !(r.seconds > 0) || !(Math.max(e.value, e.floor) > 0)) return [];
    return [
      {
        series: r.look,
        label: elementLook(r.look).label,
        level: r.level,
        unknowns: r.unknowns,
        seconds: r.seconds,
        time: seconds(r.seconds),
        floor: e.floor,
        error: Math.max(e.value, e.floor),
        shown: full(e.value),
        floored: !(e.value > e.floor)
      }
    ];
  });
}

function spec(points, what) {
  const series = Object.keys(ELEMENTS).filter((k) => points.some((p) => p.series === k));
  const range = (key) => series.map((s) => elementLook(s)[key]);
  const x = {
    field: 'seconds',
    type: 'quantitative',
    scale: {type: 'log', nice: false, padding: 18},
    title: 'processor time, s',
    axis: {format: '~r', tickCount: 5, gridOpacity: AT_DECADES, tickOpacity: AT_DECADES}
  };
  const y = {
    field: 'error',
    type: 'quantitative',
    scale: {type: 'log', padding: 14},
    title: Y_TITLE[what],
    axis: {labelExpr: 'power10(datum.value)', tickCount: 6, gridOpacity: AT_DECADES, tickOpacity: AT_DECADES}
  };
  const color = {
    field: 'series',
    type: 'nominal',
    legend: null,
    scale: {domain: series, range: range('color')}
  };
  return {
    height: isNarrow() ? 300 : 380,
    layer: [
      {
        data: {values: [{error: points[0].floor}]},
        mark: {type: 'rule', strokeDash: [2, 4], color: 'var(--muted)'},
        encoding: {y}
      },
      {
        data: {values: points},
        mark: {type: 'line', strokeWidth: 1.8},
        encoding: {x, y, color, order: {field: 'unknowns'}}
      },
      {
        data: {values: points},
        mark: {type: 'point', size: 80, strokeWidth: 1.8, opacity: 1},
        encoding: {
          x,
          y,
          color,
          shape: {
            field: 'series',
            type: 'nominal',
            legend: null,
            scale: {domain: series, range: range('shape')}
          },
          fill: {
            condition: {test: 'datum.floored', value: 'var(--paper)'},
            field: 'series',
            type: 'nominal',
            legend: null,
            scale: {domain: series, range: range('color')}
          },
          tooltip: [
            {field: 'label', title: 'element'},
            {field: 'level', title: 'mesh level'},
            {field: 'unknowns', format: ','},
            {field: 'time', title: 'processor time'},
            {field: 'shown', title: 'error'},
            {field: 'floor', title: 'known to', format: '.2g'}
          ]
        }
      }
    ]
  };
}

/** Where there is most to see: CalculiX beside ours, or at least a xi that is not exact.
 * @param {ReturnType<typeof import('../../data/solids_data.js').solidsOf>} solids
 */
function firstBody(solids) {
  return (
    solids.bodies.find((b) => solids.calculix.some((c) => c.body === b.name)) ??
    solids.bodies.find((b) => paperXi(b, kCalculixLaw)?.uncertainty > kExact) ??
    solids.bodies[0]
  );
}

/** @param {ReturnType<typeof import('../../data/solids_data.js').solidsOf>} solids */
export function costFigure(solids) {
  const bodies = solids.bodies.filter((b) => b.runs?.length);
  if (!bodies.length) return new Absent('the results hold no run over meshes (solids.bodies[].runs)');
  const chart = new Chart(
    'solids-cost',
    'Error of ξ or of the compliances against processor time, both logarithmic, one line per ' +
      'element over its meshes.'
  );
  const state = {body: firstBody(solids), what: 'xi', law: kCalculixLaw};
  const legend = h('p', {class: 'keys'});
  const laws = choice(
    'Law',
    Object.keys(LAWS).map((key) => ({key, label: lawLook(key).label})),
    state.law,
    (law) => {
      state.law = law;
      draw();
    }
  );
  const draw = () => {
    const points = pointsOf(solids, state.body, state.what, state.law);
    laws.hidden = state.what !== 'xi';
    const keys = [...new Set(points.map((p) => p.series))];
    legend.replaceChildren(
      ...keys.map((k) =>
        h(
          'span',
          {class: 'key'},
          swatch({color: elementLook(k).color, shape: elementLook(k).shape}),
          elementLook(k).label
        )
      )
    );
    if (!points.length) chart.say('No mesh has both a time and an error for this choice.');
    else if (state.what === 'xi' && points[0].floor < kExact)
      chart.say(
        `The ξ of the ${bodyLabel(state.body.name)} is exact on every mesh: its error is rounding. Its compliance shows what accuracy costs.`
      );
    else chart.draw(spec(points, state.what));
  };
  draw();
  return h(
    'figure',
    {},
    h(
      'div',
      {class: 'controls'},
      choice(
        'Body',
        bodies.map((b) => ({key: b.name, label: bodyLabel(b.name)})),
        state.body.name,
        (key) => {
          state.body = bodies.find((b) => b.name === key) ?? state.body;
          draw();
        }
      ),
      choice('Error of', WHAT, state.what, (key) => {
        state.what = key;
        draw();
      }),
      laws,
      legend
    ),
    chart.box,
    h(
      'figcaption',
      {},
      'Error: distance to the value extrapolated from the meshes of hex20. Dotted: the error bar ' +
        'of that value; ',
      'what is nearer is drawn there, hollow. Ours: one linear analysis with the couplings of all laws; ',
      'CalculiX: one linear and several nonlinear runs, St. Venant–Kirchhoff only.'
    )
  );
}
