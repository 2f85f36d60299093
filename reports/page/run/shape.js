// The bodies of a run in three dimensions, turned by a slider of the load factor.
import {account} from '../account.js';
import {button, choice, h, select} from '../dom.js';
import {short} from '../format.js';
import {ball} from '../charts/solids/view3d.js';
import {turnable} from '../turntable.js';
import {firstChosen} from './run_data.js';
import {piecesOf, placesOf, sizesOf} from './solids.js';
import {placeText} from './words.js';
import {emptyView, FIRST_VIEW, paint, radiusFor} from './view.js';

/** @typedef {import('./run.js').App} App */

/** What is in the picture. @param {App} app */
function caption({run, state}, times) {
  const parts = run.chain
    ? ['Coloured: the chain, with axis y of its section; dashed: at rest; thin: at smaller loads.']
    : [
        'Grey, axes x, y, z: the clamped node. Coloured: the loaded one; dashed: at rest; fine: the way of its axes.'
      ];
  if (run.joints.some((j) => [j.a, j.b].some(({o, h: q}) => o.some((x) => x !== 0) || Math.abs(q[0]) < 1)))
    parts.push('1, 2, 3: joint axes, at the ends of the arms.');
  if (run.loads.length) parts.push('Arrows: loads, F forces, M moments.');
  if (times !== 1 && state.times !== 1)
    parts.push(`Motions are drawn ${short(times, 2)} times as large: at true size they could not be seen.`);
  return parts.join(' ');
}

/** Where the slider stands, in words. @param {App} app */
function placeWords({run, state, chosen}) {
  const {rows, converged, cause} = chosen();
  const ends = state.row === rows.length - 1 && !converged ? `; it ends here: ${cause}` : '';
  return `${placeText(run, state.factor, 5)} of ${short(run.path.factor_end, 5)}${ends}`;
}

/** @param {App} app */
export function shapeSection(app) {
  const {run, series, state} = app;
  const drawable = series.filter((s) => s.curve.poses.length > 1);
  if (!drawable.length) {
    account('shape', 'drawn');
    return {
      update: () => {},
      content: h('p', {class: 'empty'}, 'Not drawn: no formulation has left the state of rest.')
    };
  }
  const sizes = sizesOf(run);
  const view = {...FIRST_VIEW};
  const picture = emptyView('');
  const frame = h(
    'div',
    {
      ...{class: 'view3d run3d', id: 'chart-shape', tabindex: 0, role: 'group'},
      'aria-label': 'The joint: arrow keys turn the view, plus and minus zoom, Home resets'
    },
    picture
  );
  const range = h('input', {
    type: 'range',
    min: 0,
    max: 1,
    step: 1,
    id: 'factor',
    'aria-label': run.path.over ? 'Time' : 'Load factor'
  });
  const say = h('output', {for: 'factor', class: 'readout'});
  const words = h('figcaption');
  const camera = {centre: [0, 0, 0], radius: 1, view};

  const repaint = () => {
    const chosen = drawable.find((s) => s.key === state.chosen) ?? drawable[0];
    const others = series.filter((s) => s.on && s !== chosen && s.curve.formulation !== 'linearized');
    const drawn = {...sizes, times: state.times};
    const places = placesOf(run, chosen.curve, drawn);
    camera.centre = ball(places).centre;
    camera.radius = radiusFor(places, camera.centre, 1.6 * sizes.axis);
    paint(picture, piecesOf(run, chosen, others, state.row, drawn), camera);
    picture.setAttribute('aria-label', `${chosen.key}, ${placeWords(app)}`);
    account('shape', 'drawn');
  };
  const update = () => {
    range.max = String(app.chosen().rows.length - 1);
    range.value = String(state.row);
    say.textContent = placeWords(app);
    range.setAttribute('aria-valuetext', say.textContent);
    words.textContent = caption(app, sizes.times);
    repaint();
  };
  state.times = sizes.times;
  range.addEventListener('input', () => app.go(Number(range.value)));
  turnable(frame, view, repaint);
  const options = drawable.map((s) => ({key: s.key, label: s.key}));
  const times = [1, sizes.times].map((n) => ({key: String(n), label: `× ${short(n, 2)}`}));
  const content = h(
    'figure',
    {},
    h(
      'div',
      {class: 'controls'},
      select('Formulation', options, firstChosen(run), (/** @type {string} */ key) => app.choose(key)),
      sizes.times === 1
        ? ''
        : choice('motions', times, String(sizes.times), (/** @type {string} */ key) => {
            state.times = Number(key);
            update();
          }),
      button('Reset view', () => {
        Object.assign(view, FIRST_VIEW);
        repaint();
      })
    ),
    frame,
    h('div', {class: 'run-slider'}, range, say),
    words
  );
  return {update, content};
}
