// Tables of large rotation: what loads and tangents do across large angles, and near gimbal locks.
import {plainTable} from '../../dom.js';
import {short} from '../../format.js';

function crossingText(c) {
  if (!c) return '–';
  if (c.behaviour === 'jump') return `jumps by ${short(c.jump, 3)} |K|φ`;
  if (c.behaviour === 'pole') return `pole of order ${short(c.order, 2)}`;
  return c.behaviour;
}

/** breaksOf: a formulation -> where its curve breaks, in words. */
export function crossingTable(range, breaksOf) {
  const angles = range.large_rotation[0]?.crossings.map((c) => c.angle) ?? [];
  const rows = range.large_rotation.map((l) => [
    l.formulation,
    l.axis,
    ...angles.map((a) => crossingText(l.crossings.find((c) => c.angle === a))),
    l.axis === 'generic' ? breaksOf(l.formulation) : ''
  ]);
  return plainTable(
    'Across large angles',
    [
      {text: 'formulation'},
      {text: 'axis'},
      ...angles.map((a) => ({text: `at ${a.replace('pi', 'π')}`})),
      {text: 'the line breaks at'}
    ],
    rows,
    'What the moment does across an angle, the pose alone being known: limits from both sides at ' +
      '50 digits. K has the largest stiffness |K|.'
  );
}

export function tangentTable(range) {
  const rows = range.large_rotation
    .filter((l) => l.axis === 'generic')
    .flatMap((l) =>
      l.points.map((p) => [
        l.formulation,
        p.angle.replace('pi', 'π'),
        short(p.moment, 3),
        short(p.smallest, 3),
        short(p.condition, 3)
      ])
    );
  return plainTable(
    'Tangent at large angles',
    [
      {text: 'formulation'},
      {text: 'φ'},
      {text: '|m|/(|K|φ)', number: true},
      {text: 'smallest singular value/|K|', number: true},
      {text: 'condition', number: true}
    ],
    rows,
    'Tangent about the generic axis; –: not finite'
  );
}

export function gimbalTable(range) {
  const rows = range.gimbal.map((g) => [
    g.formulation,
    g.sequence,
    short(g.load_order, 3),
    short(g.tangent_order, 3),
    g.lost_1e6 ? short(g.lost_1e6) : 'never',
    g.lost_1e3 ? short(g.lost_1e3) : 'never'
  ]);
  return plainTable(
    'Gimbal locks',
    [
      {text: 'formulation'},
      {text: 'axes'},
      {text: 'loads grow as distance to the −', number: true},
      {text: 'tangent', number: true},
      {text: '10⁻⁶ lost at, rad', number: true},
      {text: '10⁻³ lost at, rad', number: true}
    ],
    rows,
    'Near a quarter turn about the middle one of three axes'
  );
}
