// The cheapest sufficient model: per scene and tolerance, what to use.
import {account} from '../chart.js';
import {kindLabel} from '../data.js';
import {h, scrolling, swatch} from '../dom.js';
import {isNumber, nanoseconds, short, superscript} from '../format.js';
import {look} from '../palette.js';
import {percent} from '../solids_data.js';
import {isAnalytic, methodLabel, ratio, speedOf, variantLabel} from '../speed_data.js';

const powerText = (x) => (Number.isInteger(Math.log10(x)) ? `10${superscript(Math.log10(x))}` : short(x));
const madeOf = (c) =>
  [
    c.implementation,
    c.precision === 'double' ? '' : c.precision,
    variantLabel(c.variant ?? ''),
    isAnalytic({method: c.method ?? ''}) ? '' : methodLabel(c.method)
  ]
    .filter(Boolean)
    .join(', ');

/** Cost, flops, and what is not computed as a share of the whole. */
function cost(c) {
  const saved = c.flops_saved > 0 ? `, ${percent(c.flops_saved / (c.flops + c.flops_saved))} saved` : '';
  return [
    isNumber(c.relative_cost) ? `cost ${ratio(c.relative_cost)}` : '',
    isNumber(c.flops) ? `${short(c.flops, 3)} flops${saved}` : ''
  ]
    .filter(Boolean)
    .join('; ');
}

function cell(c, tolerance) {
  const label = {'data-label': `to ${powerText(tolerance)}`};
  if (!c) return h('td', {...label, class: 'none'}, '–');
  if (!c.formulation || !isNumber(c.ns))
    return h(
      'td',
      {...label, class: 'none'},
      h('span', {class: 'aside unmet'}, c.note || 'nothing that was measured meets it')
    );
  return h(
    'td',
    {...label, title: c.note || null},
    h(
      'span',
      {class: 'name'},
      swatch({color: look(c.formulation).color, shape: 'circle'}),
      h('span', {}, h('code', {}, c.formulation), c.kind ? ` ${kindLabel(c.kind)}` : '')
    ),
    h(
      'span',
      {class: 'cost'},
      h('strong', {}, `${nanoseconds(c.ns)} ns`),
      ` ${madeOf(c)}`,
      h(
        'span',
        {class: 'aside'},
        `error ${short(c.error)}${isNumber(c.margin) ? `; margin ${ratio(c.margin)}` : ''}`
      ),
      h('span', {class: 'aside'}, cost(c))
    )
  );
}

/** Notes that several rows share stand once below the table. */
function notesOf(rows) {
  const notes = [...new Set(rows.filter((c) => c.formulation && c.note).map((c) => c.note))];
  return notes.length
    ? h(
        'details',
        {},
        h('summary', {}, `Notes of the choices (${notes.length})`),
        h(
          'ul',
          {class: 'reasons'},
          notes.map((note) =>
            h(
              'li',
              {},
              note,
              h(
                'span',
                {class: 'reason'},
                [
                  ...new Set(
                    rows.filter((c) => c.note === note).map((c) => `${c.scene} at ${powerText(c.tolerance)}`)
                  )
                ].join(', ')
              )
            )
          )
        )
      )
    : null;
}

export function cheapestTable(results) {
  const rows = speedOf(results).cheapest;
  const part = h('div', {class: 'part', id: 'cheapest'}, h('h3', {}, 'The cheapest sufficient model'));
  account('cheapest', rows.length ? 'drawn' : 'empty');
  if (!rows.length) {
    part.append(
      h('p', {class: 'empty'}, 'Not shown: the results name no cheapest sufficient model (speed.cheapest).')
    );
    return part;
  }
  const titles = new Map((results.scenes ?? []).map((s) => [s.name, s.title]));
  const tolerances = [...new Set(rows.map((c) => c.tolerance))].sort((a, b) => b - a);
  const body = [...new Set(rows.map((c) => c.scene))].map((scene) =>
    h(
      'tr',
      {},
      h('th', {scope: 'row'}, titles.get(scene) ?? scene.replaceAll('_', ' ')),
      tolerances.map((tolerance) =>
        cell(
          rows.find((c) => c.scene === scene && c.tolerance === tolerance),
          tolerance
        )
      )
    )
  );
  part.append(
    scrolling(
      h(
        'table',
        {class: 'compact narrow cheapest'},
        h(
          'thead',
          {},
          h(
            'tr',
            {},
            ['scene', ...tolerances.map((t) => `to ${powerText(t)}`)].map((t) => h('th', {scope: 'col'}, t))
          )
        ),
        h('tbody', {}, body)
      ),
      'The cheapest sufficient model'
    ),
    h(
      'p',
      {class: 'note'},
      'Per scene and tolerance: the cheapest formulation, kind, precision and method whose measured error stays below it. Margin: tolerance over error. Cost: relative to the most exact one of the scene. Saved: what the scene does not need and is not computed.'
    ),
    notesOf(rows) ?? ''
  );
  return part;
}
