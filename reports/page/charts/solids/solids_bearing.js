// xi of the bearing over the width of its hole, one line per material law, beside the printed value.
import {Chart, isNarrow} from '../../chart.js';
import {choice, h, swatch} from '../../dom.js';
import {isNumber, short} from '../../format.js';
import {familyLabel, familyNamed, lawLook} from '../../data/solids_data.js';

const TITLES = {
  cone: 'angle of the conical hole from the axis, rad',
  cylinder: 'radius of the cylindrical hole, m'
};

/** The scan of a family, and its fitted members: the best hole, and none at all. */
function rowsOf(bearing, name) {
  const scan = bearing.scans.filter((s) => s.name === name);
  const {cut, hole} = familyNamed(bearing, name) ?? {};
  const line = scan.flatMap((s) =>
    Object.entries(s.xi ?? {}).map(([law, value]) => ({
      law,
      width: s.width,
      value,
      largest: s.largest,
      admissible: s.admissible
    }))
  );
  const fits = bearing.families
    .filter((f) => f.cut === cut && (f.hole === hole || f.hole === 'none'))
    .flatMap((f) =>
      (f.xi ?? []).map((x) => ({
        law: x.law,
        width: f.hole === 'none' ? 0 : f.width,
        value: x.value,
        low: x.value - x.uncertainty,
        high: x.value + x.uncertainty,
        largest: f.largest,
        admissible: f.admissible
      }))
    );
  const named = (rows) =>
    rows
      .filter((r) => isNumber(r.value))
      .map((r) => ({
        ...r,
        law_label: lawLook(r.law).label,
        admitted: r.admissible ? 'yes' : 'no',
        off: `${short(100 * r.largest)} %`
      }));
  return {hole, line: named(line), fits: named(fits)};
}

function spec({hole, line, fits}, printed) {
  const laws = [...new Set(line.map((r) => r.law))];
  const range = (what) => laws.map((l) => lawLook(l)[what]);
  const x = {
    field: 'width',
    type: 'quantitative',
    title: TITLES[hole] ?? 'width of the hole',
    scale: {zero: true},
    axis: {tickCount: 6}
  };
  const y = {
    field: 'value',
    type: 'quantitative',
    title: 'ξ under compression and shear',
    scale: {zero: false},
    axis: {tickCount: 7}
  };
  const color = {field: 'law', type: 'nominal', legend: null, scale: {domain: laws, range: range('color')}};
  const shape = {field: 'law', type: 'nominal', legend: null, scale: {domain: laws, range: range('shape')}};
  const fill = {
    condition: {test: '!datum.admissible', value: 'var(--paper)'},
    field: 'law',
    type: 'nominal',
    legend: null,
    scale: {domain: laws, range: range('color')}
  };
  const tooltip = [
    {field: 'law_label', title: 'law'},
    {field: 'width', title: 'hole', format: '.3g'},
    {field: 'value', title: 'ξ', format: '.4g'},
    {field: 'admitted', title: 'admissible'},
    {field: 'off', title: 'largest datum off'}
  ];
  const printedLine = {data: {values: [{value: printed, text: `printed ${short(printed, 6)}`}]}};
  return {
    height: isNarrow() ? 280 : 340,
    layer: [
      {...printedLine, mark: {type: 'rule', strokeDash: [6, 4], color: 'var(--ink)'}, encoding: {y}},
      {
        data: {values: line},
        mark: {type: 'line', strokeWidth: 1.8},
        encoding: {
          x,
          y,
          color,
          strokeDash: {
            field: 'law',
            type: 'nominal',
            legend: null,
            scale: {domain: laws, range: range('dash')}
          }
        }
      },
      {
        data: {values: fits},
        mark: {type: 'rule', strokeWidth: 2},
        encoding: {x, y: {...y, field: 'low'}, y2: {field: 'high'}, color}
      },
      {
        data: {values: line},
        mark: {type: 'point', size: 50, strokeWidth: 1.6, opacity: 1},
        encoding: {x, y, color, shape, fill, tooltip}
      },
      {
        data: {values: fits},
        mark: {type: 'point', size: 150, strokeWidth: 1.8, opacity: 1},
        encoding: {x, y, color, shape, fill, tooltip}
      },
      // The halo first: a line behind the label stays legible.
      ...[{stroke: 'var(--paper)', strokeWidth: 4, strokeJoin: 'round'}, {}].map((halo) => ({
        ...printedLine,
        mark: {type: 'text', align: 'right', baseline: 'bottom', dy: -3, ...halo},
        encoding: {x: {value: 'width'}, y, text: {field: 'text'}}
      }))
    ]
  };
}

export function bearingChart(bearing) {
  const scans = bearing.scans ?? [];
  const names = [...new Set(scans.map((s) => s.name))];
  if (!names.length)
    return h('p', {class: 'empty'}, 'No scan over the width of a hole (solids.bearing.scans).');
  const chart = new Chart(
    'solids-bearing',
    'ξ of the bearing against the width of its hole, one line per material law, with the printed ' +
      'value as a dashed line.'
  );
  const draw = (name) => chart.draw(spec(rowsOf(bearing, name), bearing.printed_xi));
  const options = names.map((key) => ({key, label: familyLabel(familyNamed(bearing, key))}));
  const laws = [...new Set(scans.flatMap((s) => Object.keys(s.xi ?? {})))];
  const legend = h(
    'p',
    {class: 'keys'},
    laws.map((l) =>
      h('span', {class: 'key'}, swatch({color: lawLook(l).color, shape: lawLook(l).shape}), lawLook(l).label)
    )
  );
  draw(names[0]);
  return h(
    'figure',
    {},
    h('h4', {}, 'ξ over the width of the hole'),
    h('div', {class: 'controls'}, choice('Family', options, names[0], draw), legend),
    chart.box,
    h(
      'figcaption',
      {},
      'Each point is a geometry fitted anew with its hole held at that width. Hollow: not admissible. ',
      'Large: the hole fitted as well, and no hole at all (width 0), with error bars.'
    )
  );
}
