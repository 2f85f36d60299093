// The picture of one output against the load factor or the time: a line a series, a cursor, and the nearest point.
import {PATHS, svg} from '../dom.js';
import {frameOf, picture, xAxis, xTicks, yAxis} from '../dashboard/plot.js';
import {scaleOf} from '../dashboard/scale.js';

/** @typedef {import('./run_data.js').Series} Series */
/** @typedef {{series: Series, row: number, across: number, up: number}} Place  a point of a line, px */

const kTall = 230;
/** A pointer that is farther from every line than this points at none. */
const kNear = 40; // px

/** @param {Series[]} shown @param {number} column @param {(n: number) => number} x @param {(n: number) => number} y */
const placesOfLines = (shown, column, x, y) =>
  shown.map((series) =>
    series.curve.rows.map((row, i) => ({series, row: i, across: x(row[0]), up: y(row[column])}))
  );

const pathThrough = (/** @type {Place[]} */ places) =>
  places.map(({across, up}, i) => `${i ? 'L' : 'M'}${across.toFixed(1)},${up.toFixed(1)}`).join('');

/** Its line, and its symbol at the end; a cross where that is early. @param {Place[]} places */
function drawnLine(places) {
  const last = places.at(-1);
  if (!last) return [];
  const {look, curve} = last.series;
  const at = `translate(${last.across.toFixed(1)},${last.up.toFixed(1)})`;
  return [
    svg('path', {
      class: 'line',
      d: pathThrough(places),
      style: `--color:${look.color}`,
      'stroke-dasharray': look.dash.join(' ')
    }),
    svg('path', {class: 'point end', d: PATHS[look.shape], transform: at, style: `--color:${look.color}`}),
    curve.converged ? [] : svg('path', {class: 'early', d: 'M-7,-7L7,7M-7,7L7,-7', transform: at})
  ];
}

/** @param {{shown: Series[], column: number, title: string, width: number, factorEnd: number, over: string}} request
 *   over: what it is drawn against
 */
export function linesChart({shown, column, title, width, factorEnd, over}) {
  const frame = frameOf(width, kTall);
  const rows = shown.flatMap((s) => s.curve.rows);
  const x = scaleOf([0, factorEnd, ...rows.map((r) => r[0])], frame.left, frame.right, false);
  const y = scaleOf([0, ...rows.map((r) => r[column])], frame.bottom, frame.top, false);
  const lines = placesOfLines(shown, column, x.at, y.at);
  const cursor = svg('path', {class: 'cursor'});
  const dot = svg('circle', {class: 'dot', r: 4.5, visibility: 'hidden'});
  const drawn = picture(frame, `${title} against ${over}: ${shown.map((s) => s.key).join(', ')}`);
  drawn.append(
    ...yAxis({...frame, top: 22}, y, title),
    ...xAxis(frame, xTicks(x), over),
    cursor,
    ...lines.map(drawnLine).flat(3),
    dot
  );
  return {
    drawn,
    /** The cursor to a load factor. @param {number} factor */
    point: (factor) => {
      const at = x.at(factor).toFixed(1);
      cursor.setAttribute('d', `M${at},${frame.top}V${frame.bottom}`);
    },
    /** @param {Place | undefined} place */
    mark: (place) => {
      dot.setAttribute('visibility', place ? 'visible' : 'hidden');
      dot.setAttribute('cx', String(place?.across ?? 0));
      dot.setAttribute('cy', String(place?.up ?? 0));
      dot.setAttribute('style', place ? `--color:${place.series.look.color}` : '');
    },
    /** @param {number} across px @param {number} up px @returns {Place | undefined} */
    nearest: (across, up) => {
      const far = (/** @type {Place} */ p) => Math.hypot(p.across - across, p.up - up);
      const all = lines.flat();
      const best = all.reduce((a, b) => (far(b) < far(a) ? b : a), all[0]);
      return best && far(best) < kNear ? best : undefined;
    }
  };
}
