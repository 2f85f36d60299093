// A deformed body that can be turned: drag, or arrow keys; SVG, so that light, dark and print need no second drawing.
import {account} from '../../account.js';
import {h} from '../../dom.js';
import {short} from '../../format.js';
import {HUE} from '../../palette.js';
import {START, turnable} from '../../turntable.js';
import {ball, farthestFirst, outline, outward, shade, size, turn} from './view3d.js';

const SVG = 'http://www.w3.org/2000/svg';
const kHalf = [1.15, 0.88]; // of the picture, in radii of the body

function make(tag, attributes, parent) {
  const element = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  parent.append(element);
  return element;
}

const point = (p, zoom) => `${(p[0] * zoom).toFixed(4)},${(-p[1] * zoom).toFixed(4)}`;

/** The elements of the picture, made once; painting only moves them. */
function scene(shape) {
  const svg = make(
    'svg',
    {
      viewBox: `${-kHalf[0]} ${-kHalf[1]} ${2 * kHalf[0]} ${2 * kHalf[1]}`,
      role: 'img',
      'aria-label': `${shape.title}: deformed body and undeformed outline`
    },
    document.createDocumentFragment()
  );
  const edges = outline(shape.faces, shape.X);
  const lines = (cls) => edges.map(() => make('line', {class: cls}, svg));
  const behind = lines('outline');
  const faces = shape.faces.map(() => make('polygon', {}, svg));
  const before = lines('outline before');
  const triad = make(
    'g',
    {class: 'triad', transform: `translate(${-kHalf[0] + 0.2} ${kHalf[1] - 0.2})`},
    svg
  );
  const axes = [1, 2, 3].map((k) => ({
    line: make('line', {x1: 0, y1: 0}, triad),
    name: make('text', {}, triad),
    k
  }));
  axes.forEach(({name, k}) => {
    name.textContent = k;
  });
  return {svg, edges, behind, before, faces, axes};
}

/** Places everything for one view; share: 0 undeformed to 1 the whole scale. */
function paint(parts, shape, body, view, share) {
  const place = (p) =>
    turn(
      p.map((x, k) => (x - body.centre[k]) / body.radius),
      view
    );
  const flat = shape.X.map(place);
  const seen = shape.X.map((X, n) => place(X.map((x, k) => x + share * shape.scale * shape.u[n][k])));
  const painted = farthestFirst(body.faces, seen);
  parts.faces.slice(painted.length).forEach((polygon) => polygon.setAttribute('points', ''));
  painted.forEach((f, i) => {
    const corners = body.faces[f].map((n) => seen[n]);
    const moved = body.faces[f].reduce((sum, n) => sum + body.moved[n], 0) / 4;
    parts.faces[i].setAttribute('points', corners.map((p) => point(p, view.zoom)).join(' '));
    parts.faces[i].style.fill =
      `color-mix(in oklab, color-mix(in oklab, ${HUE['solid-far']} ${(100 * moved).toFixed(0)}%, ${HUE['solid-near']}), ${HUE['solid-shade']} ${(40 * shade(corners)).toFixed(0)}%)`;
  });
  parts.edges.forEach(([a, b], i) =>
    [parts.behind[i], parts.before[i]].forEach((line) => {
      line.setAttribute('x1', flat[a][0] * view.zoom);
      line.setAttribute('y1', -flat[a][1] * view.zoom);
      line.setAttribute('x2', flat[b][0] * view.zoom);
      line.setAttribute('y2', -flat[b][1] * view.zoom);
    })
  );
  for (const {line, name, k} of parts.axes) {
    const tip = turn(
      [1, 2, 3].map((j) => (j === k ? 0.13 : 0)),
      view
    );
    line.setAttribute('x2', tip[0]);
    line.setAttribute('y2', -tip[1]);
    name.setAttribute('x', 1.35 * tip[0]);
    name.setAttribute('y', -1.35 * tip[1]);
  }
}

export function shapeFigure(shape) {
  const id = `solids-shape-${shape.name}`;
  const frame = h('div', {
    class: 'view3d',
    id: `chart-${id}`,
    tabindex: 0,
    role: 'group',
    'aria-label': `${shape.title}: arrow keys turn, plus and minus zoom, Home resets`
  });
  const largest = Math.max(...(shape.u ?? []).map(size));
  if (!shape.faces?.length || !(largest > 0)) {
    account(id, 'empty');
    return h(
      'figure',
      {},
      h('h3', {}, shape.title),
      h('p', {class: 'empty'}, 'Not drawn: the results hold no surface or no displacement.')
    );
  }
  const body = {
    ...ball(shape.X),
    faces: outward(shape.faces, shape.X),
    moved: shape.u.map((u) => size(u) / largest)
  };
  const parts = scene(shape);
  const view = {...START};
  const share = h('input', {
    type: 'range',
    min: 0,
    max: 1.5,
    step: 0.05,
    value: 1,
    'aria-label': `Displacements of ${shape.title}`
  });
  const times = h('output', {});
  const repaint = () => {
    paint(parts, shape, body, view, Number(share.value));
    times.textContent = `× ${short(shape.scale * Number(share.value), 3)}`;
  };
  share.addEventListener('input', repaint);
  turnable(frame, view, repaint);
  frame.append(parts.svg);
  repaint();
  account(id, 'drawn');
  return h(
    'figure',
    {},
    h('h3', {}, shape.title),
    frame,
    h(
      'div',
      {class: 'controls'},
      h('label', {class: 'slider'}, 'displacements ', share, times),
      h(
        'button',
        {
          type: 'button',
          class: 'plain',
          onclick: () => {
            Object.assign(view, START);
            share.value = '1';
            repaint();
          }
        },
        'Reset'
      )
    ),
    h(
      'figcaption',
      {},
      `${shape.note[0].toUpperCase()}${shape.note.slice(1)}. Displacements drawn ${short(shape.scale, 3)} times as large; dashed: undeformed. Colour: `,
      h('span', {class: 'ramp', 'aria-hidden': 'true'}),
      ` displacement from 0, at the clamped face, to ${short(largest, 3)} m. Drag or use the arrow keys to turn.`
    )
  );
}
