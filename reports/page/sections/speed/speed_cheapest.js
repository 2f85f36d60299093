// The cheapest sufficient model: per scene and tolerance, what to use.
import {isOwnTruth, tableOf} from '../../data/cheapest_data.js';
import {kindLabel} from '../../data/accuracy_data.js';
import {h, scrolling, swatch} from '../../dom.js';
import {isNumber, nanoseconds, percent, short, powerOfTen} from '../../format.js';
import {look} from '../../palette.js';
import {Absent} from '../../parts.js';
import {signNote} from '../notes.js';
import {
  implementationLabel,
  isAnalytic,
  methodLabel,
  ratio,
  speedOf,
  variantLabel
} from '../../data/speed_data.js';

const powerText = (x) => powerOfTen(x) || short(x);
const madeOf = (c) =>
  [
    implementationLabel(c.implementation),
    c.precision === 'double' ? '' : c.precision,
    variantLabel(c.variant ?? ''),
    isAnalytic({method: c.method ?? ''}) ? '' : methodLabel(c.method)
  ]
    .filter(Boolean)
    .join(', ');

const NOTE =
  'Per scene and tolerance: the cheapest formulation, precision and method whose measured error stays below it. ' +
  'It is what ./halfway advise answers for each. All times here include the tangent, which a solver needs, but for ' +
  'the linear analysis, whose tangent is one matrix. ' +
  'The truth of a scene is one of the formulations at 50 digits, named in its row; where that formulation itself ' +
  'is the choice (†) the error is that of its arithmetic and says nothing about modelling; ' +
  'a body’s own truth is under “Who is right?”. ' +
  'Margin: tolerance over error. Cost: relative to the most exact one of the scene. ' +
  'Saved: what the scene does not need and is not computed.';

/** Said in the cell of a choice that cannot lose. */
const OWN = '† the truth’s own form: no modelling error';

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
      ` ${madeOf(c)}, with tangent`,
      isOwnTruth(c) ? h('span', {class: 'aside own'}, OWN) : null,
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

/** @param {import('../../data.js').Results} results */
export function cheapestTable(results) {
  const rows = speedOf(results).cheapest;
  if (!rows.length) return new Absent('the results name no cheapest sufficient model (speed.cheapest)');
  const titles = new Map((results.scenes ?? []).map((s) => [s.name, s.title]));
  const {tolerances, scenes} = tableOf(rows);
  const heads = ['scene', ...tolerances.map((t) => `to ${powerText(t)}`)];
  const body = scenes.map(({scene, truth, cells}) =>
    h(
      'tr',
      {},
      h(
        'th',
        {scope: 'row'},
        titles.get(scene) ?? scene.replaceAll('_', ' '),
        truth ? h('span', {class: 'aside'}, 'truth: ', h('code', {}, truth), ' at 50 digits') : null
      ),
      cells.map((c, i) => cell(c, tolerances[i]))
    )
  );
  return [
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
            heads.map((t) => h('th', {scope: 'col'}, t))
          )
        ),
        h('tbody', {}, body)
      ),
      'The cheapest sufficient model'
    ),
    h('p', {class: 'note'}, NOTE, ' ', signNote()),
    notesOf(rows)
  ];
}
