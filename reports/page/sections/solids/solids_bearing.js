// The bearing of Table 4: geometries that have its compliances, and the xi of each.
import {bearingChart} from '../../charts/solids/solids_bearing.js';
import {h, scrolling} from '../../dom.js';
import {isNumber, percent, plural, short} from '../../format.js';
import {familyLabel, familyNamed, lawLook, withBar} from '../../data/solids_data.js';
import {Absent} from '../../parts.js';

const extent = (f) => `${short(f.extent, 4)} ${f.cut === 'cone' ? 'rad' : 'm'}`;
const width = (f) => (f.hole === 'none' ? '–' : `${short(f.width, 3)} ${f.hole === 'cone' ? 'rad' : 'm'}`);

const hundredths = (x) => (isNumber(x) ? `${(100 * x).toFixed(2).replace('-', '−')} %` : '–');

/** The answer in words. */
function statement(bearing) {
  const admissible = bearing.families.filter((f) => f.admissible);
  const count = admissible.length + (bearing.scans ?? []).filter((s) => s.admissible).length;
  const xis = [
    ...admissible.flatMap((f) => (f.xi ?? []).map((x) => ({family: f, law: x.law, value: x.value}))),
    ...(bearing.scans ?? [])
      .filter((s) => s.admissible)
      .flatMap((s) =>
        Object.entries(s.xi ?? {}).map(([law, value]) => ({family: familyNamed(bearing, s.name), law, value}))
      )
  ].filter((x) => isNumber(x.value));
  const printed = short(bearing.printed_xi, 6);
  if (!xis.length)
    return `No fitted geometry has the printed compliances, so nothing can be said about the printed ξ = ${printed}.`;
  const low = xis.reduce((a, b) => (b.value < a.value ? b : a)),
    high = xis.reduce((a, b) => (b.value > a.value ? b : a));
  const near = xis.reduce((a, b) =>
    Math.abs(b.value - bearing.printed_xi) < Math.abs(a.value - bearing.printed_xi) ? b : a
  );
  const where = (x) => `${familyLabel(x.family)}, ${lawLook(x.law).label}`;
  return (
    `The paper prints no dimension of its bearing, and its compliances do not give them: ${plural(count, 'fitted geometry has', 'fitted geometries have')} them${bearing.limit ? ` within ${percent(bearing.limit)}` : ''}. ` +
    `Over these geometries and ${plural(new Set(xis.map((x) => x.law)).size, 'material law')} ξ runs from ${short(low.value, 3)} (${where(low)}) to ${short(high.value, 3)} (${where(high)}). ` +
    `${count > 1 ? `The geometry, and with it the printed ξ = ${printed}, cannot be identified from the text; the` : 'The'} nearest to the printed one is ${short(near.value, 4)} (${where(near)}).`
  );
}

function familyTable(bearing) {
  const data = bearing.data ?? [];
  const head = h(
    'thead',
    {},
    h(
      'tr',
      {},
      h('th', {scope: 'col', rowspan: 2}, 'family'),
      h('th', {scope: 'colgroup', colspan: 4, class: 'number'}, 'fitted geometry'),
      h('th', {scope: 'colgroup', colspan: data.length, class: 'number'}, 'off from the print'),
      h('th', {scope: 'col', rowspan: 2}, 'admissible')
    ),
    h(
      'tr',
      {},
      ['inner, m', 'outer, m', 'extent', 'hole'].map((t) => h('th', {scope: 'col', class: 'number'}, t)),
      data.map((d) =>
        h('th', {scope: 'col', class: 'number', title: `printed ${short(d.printed, 6)}`}, d.name)
      )
    )
  );
  const body = h(
    'tbody',
    {},
    bearing.families.map((f) =>
      h(
        'tr',
        {},
        h('th', {scope: 'row', class: 'whole'}, familyLabel(f)),
        [short(f.inner, 4), short(f.outer, 4), extent(f), width(f)].map((t) => h('td', {class: 'number'}, t)),
        data.map((_, i) => h('td', {class: 'number'}, hundredths(f.residuals?.[i]))),
        h(
          'td',
          {
            class: `mark ${f.admissible ? 'pass' : 'known_failure'}`,
            title: f.message || `largest ${percent(f.largest)}, ${f.unknowns} unknowns`
          },
          f.admissible ? '✓ yes' : 'no'
        )
      )
    )
  );
  return scrolling(h('table', {class: 'compact narrow'}, head, body), 'Families of bearings');
}

function xiTable(bearing) {
  const laws = [...new Set(bearing.families.flatMap((f) => (f.xi ?? []).map((x) => x.law)))];
  const cell = (f, law) => {
    const x = f.xi?.find((e) => e.law === law);
    return h('td', {class: 'number'}, x ? withBar(x.value, x.uncertainty) : '–');
  };
  return scrolling(
    h(
      'table',
      {class: 'compact narrow'},
      h('caption', {}, 'ξ of the fitted geometries under compression and shear'),
      h(
        'thead',
        {},
        h(
          'tr',
          {},
          h('th', {scope: 'col'}, 'family'),
          laws.map((l) => h('th', {scope: 'col', class: 'number'}, lawLook(l).label))
        )
      ),
      h(
        'tbody',
        {},
        bearing.families.map((f) =>
          h(
            'tr',
            {},
            h('th', {scope: 'row', class: 'whole'}, familyLabel(f), f.admissible ? '' : ' (not admissible)'),
            laws.map((l) => cell(f, l))
          )
        )
      )
    ),
    'ξ of the fitted bearings'
  );
}

/** @param {ReturnType<typeof import('../../data/solids_data.js').solidsOf>} solids */
export function bearingPart(solids) {
  if (!solids.bearing?.families?.length)
    return new Absent('the results hold no fitted bearing (solids.bearing)');
  return [
    h('p', {class: 'statement'}, statement(solids.bearing)),
    familyTable(solids.bearing),
    h(
      'p',
      {class: 'note'},
      'Radii of the two bowls; extent: distance of the plane cut from the outer pole, or angle ' +
        'of the conical cut; ',
      'hole: radius or angle. Fitted by least squares to the four compliances and the joint point.'
    ),
    xiTable(solids.bearing),
    bearingChart(solids.bearing)
  ];
}
