// xi of each body and material law: under the paper's moments, the best one, and what no xi represents.
import {h, scrolling} from '../../dom.js';
import {isNumber, percent, short} from '../../format.js';
import {bodyLabel, GROUPS, lawLook, paperXi, withBar} from '../../data/solids_data.js';
import {Absent} from '../../parts.js';

/** The printed xi of the frustum and whether a law gives it to the printed digits.
 * @param {import('../../data.js').Results} results
 */
function printed(results, law) {
  const finding = results.findings.find(
    (f) => f.name.startsWith('fe/') && f.name.endsWith(`printed_xi/${law}`)
  );
  const limit = results.findings.find(
    (f) => f.name.startsWith('fe/') && f.name.includes('printed_xi/') && f.comparison === 'equal'
  )?.high;
  if (!finding || !isNumber(finding.value) || !isNumber(limit)) return null;
  return {value: finding.expected, met: Math.abs(finding.value - (finding.expected ?? NaN)) <= limit};
}

/** @param {import('../../data.js').Results} results */
function xiCell(results, body, law) {
  const xi = paperXi(body, law);
  if (!isNumber(xi?.value)) return h('td', {class: 'number none'}, '–');
  const print = body.name === 'frustum_top' ? printed(results, law) : null;
  const text = withBar(xi.value, xi.uncertainty);
  return print?.met
    ? h(
        'td',
        {class: 'number mark pass'},
        `✓ ${text}`,
        h('span', {class: 'aside'}, `the printed ${print.value}`)
      )
    : h('td', {class: 'number'}, text);
}

/** @param {import('../../data.js').Results} results */
function rows(results, body) {
  return (body.xis ?? []).map((x, i, all) =>
    h(
      'tr',
      {},
      i === 0
        ? h(
            'th',
            {scope: 'rowgroup', rowspan: all.length},
            bodyLabel(body.name),
            h('span', {class: 'aside'}, body.title)
          )
        : null,
      h('th', {scope: 'row', class: 'whole'}, lawLook(x.law).label),
      xiCell(results, body, x.law),
      GROUPS.flatMap(({key}) => {
        const best = x.best?.find((b) => b.group === key);
        return [
          h('td', {class: 'number'}, best ? short(best.xi, 4) : '–'),
          h('td', {class: 'number'}, best ? percent(best.remainder) : '–')
        ];
      })
    )
  );
}

/** Every pair of loads: they need not agree on xi.
 * @param {ReturnType<typeof import('../../data/solids_data.js').solidsOf>} solids
 */
function pairs(solids) {
  const names = ['13', '23', '12'];
  const cells = (list) =>
    names.map((n) => {
      const e = list?.find((m) => m.name === n);
      return h('td', {class: 'number'}, e ? withBar(e.value, e.uncertainty) : '–');
    });
  return h(
    'details',
    {},
    h('summary', {}, 'ξ from each pair of moments and of forces'),
    scrolling(
      h(
        'table',
        {class: 'compact'},
        h(
          'thead',
          {},
          h(
            'tr',
            {},
            [
              'body',
              'material law',
              ...names.map((n) => `moments ${n[0]} and ${n[1]}`),
              ...names.map((n) => `forces ${n[0]} and ${n[1]}`)
            ].map((t, i) => h('th', {scope: 'col', class: i > 1 ? 'number' : null}, t))
          )
        ),
        solids.bodies.map((b) =>
          h(
            'tbody',
            {},
            (b.xis ?? []).map((x, i, all) =>
              h(
                'tr',
                {},
                i === 0 ? h('th', {scope: 'rowgroup', rowspan: all.length}, bodyLabel(b.name)) : null,
                h('th', {scope: 'row'}, lawLook(x.law).label),
                cells(x.moments),
                cells(x.forces)
              )
            )
          )
        )
      ),
      'Pairs of loads'
    )
  );
}

/** Bodies whose xi is 1/2 on every mesh and for every law, in words.
 * @param {ReturnType<typeof import('../../data/solids_data.js').solidsOf>} solids
 */
function halves(solids) {
  return solids.bodies
    .map((b) => ({
      name: bodyLabel(b.name),
      off: Math.max(
        ...(b.runs ?? []).flatMap((r) => Object.values(r.xi ?? {})).map((x) => Math.abs((x ?? NaN) - 0.5))
      )
    }))
    .filter((b) => b.off < 1e-6 && b.off >= 0)
    .map(
      (b) =>
        `For the ${b.name} ξ is 1/2 for every law, element and mesh${b.off > 0 ? `, to ${short(b.off)}` : ''}: exchanging its two faces changes nothing, which leaves no other value.`
    );
}

/** @param {import('../../data.js').Results} results */
export function xiTable(results, solids) {
  if (!solids.bodies.some((b) => b.xis?.length)) return new Absent('the results hold no ξ of a 3D body');
  const head = h(
    'thead',
    {},
    h(
      'tr',
      {},
      h('th', {scope: 'col', rowspan: 2}, 'body'),
      h('th', {scope: 'col', rowspan: 2}, 'material law'),
      h('th', {scope: 'col', rowspan: 2, class: 'number'}, 'ξ under moments 1 and 3'),
      GROUPS.map((g) => h('th', {scope: 'colgroup', colspan: 2, class: 'number'}, `best for ${g.label}`))
    ),
    h(
      'tr',
      {},
      GROUPS.flatMap(() => [
        h('th', {scope: 'col', class: 'number'}, 'ξ'),
        h('th', {scope: 'col', class: 'number'}, 'remains')
      ])
    )
  );
  return [
    scrolling(
      h(
        'table',
        {class: 'compact'},
        head,
        solids.bodies.map((b) => h('tbody', {}, rows(results, b)))
      ),
      'ξ of each body and law'
    ),
    h(
      'p',
      {class: 'note'},
      'ξ is a second-order quantity: it depends on the law beyond small strains and on which ' +
        'face is clamped. Best: least squares over the group; ',
      'remains: the share of the second-order couplings that no ξ represents. Over all three ' +
        'pairs of moments the best ξ is 1/2 for every law with a potential, whatever the body: ' +
        'what is left is one cubic term c θ₁θ₂θ₃ of the potential, and no ξ can take part of it. ',
      halves(solids).join(' ')
    ),
    pairs(solids)
  ];
}
