// Paints pieces in three dimensions as SVG, the farthest first.
import {svg} from '../dom.js';
import {START} from '../turntable.js';
import {shade, turn} from '../charts/solids/view3d.js';

/** @typedef {import('./solids.js').Piece} Piece */
/** @typedef {{centre: number[], radius: number, view: import('../turntable.js').View}} Camera  m, rad */

/** From the side and a little above. */
export const FIRST_VIEW = {...START, yaw: 0.65, pitch: 0.35};

const kWide = [1.28, 0.98]; // half of the picture, in radii of what it shows
/** Where axes x, y, z of the scene are shown again, small. */
const kCorner = [-1.02, 0.78];

/** z points up. @param {number[]} point @param {Camera} camera */
function seen([x, y, z], {centre, radius, view}) {
  const at = [z - centre[2], x - centre[0], y - centre[1]].map((v) => (v * view.zoom) / radius);
  return turn(at, view);
}

/** What makes points fit as the view is at first, with so much round each of them; turned, most of them do.
 * @param {number[][]} points @param {number[]} centre @param {number} margin m
 */
export function radiusFor(points, centre, margin) {
  const still = {centre, radius: 1, view: FIRST_VIEW};
  const needed = points.map((p) => {
    const [across, up] = seen(p, still).map((v) => Math.abs(v) + margin);
    return Math.max(across / kWide[0], up / kWide[1], 0.75 * (Math.hypot(...seen(p, still)) + margin));
  });
  return Math.max(...needed);
}

const flat = (/** @type {number[]} */ p) => `${p[0].toFixed(4)},${(-p[1]).toFixed(4)}`;
const mean = (/** @type {number[][]} */ points) => points.reduce((sum, p) => sum + p[2], 0) / points.length;

/** Does a face look away? @param {number[][]} points */
function isBehind(points) {
  const area = points.reduce((sum, [x, y], i) => {
    const [u, v] = points[(i + 1) % points.length];
    return sum + x * v - u * y;
  }, 0);
  return area < 0;
}

/** @param {Piece} piece @param {number[][]} points */
function element({cls, color, isFace, text}, points) {
  const style = color ? `--color:${color}` : '';
  if (text !== undefined) {
    const word = svg('text', {class: cls, x: points[0][0].toFixed(4), y: (-points[0][1]).toFixed(4), style});
    word.textContent = text;
    return word;
  }
  if (!isFace) return svg('polyline', {class: cls, points: points.map(flat).join(' '), style});
  const dark = cls.startsWith('body') ? `--shade:${(45 * shade(points)).toFixed(0)}%;` : '';
  return svg('polygon', {class: cls, points: points.map(flat).join(' '), style: dark + style});
}

/** An empty picture. @param {string} label */
export const emptyView = (label) =>
  svg('svg', {
    viewBox: `${-kWide[0]} ${-kWide[1]} ${2 * kWide[0]} ${2 * kWide[1]}`,
    role: 'img',
    'aria-label': label
  });

/** @param {Camera} camera */
function corner({view}) {
  const still = {centre: [0, 0, 0], radius: 1, view: {...view, zoom: 1}};
  return ['x', 'y', 'z'].map((name, k) => {
    const tip = seen(
      [0, 1, 2].map((j) => (j === k ? 0.13 : 0)),
      still
    );
    const word = svg('text', {class: 'word small', x: 1.4 * tip[0], y: -1.4 * tip[1]});
    word.textContent = name;
    return [svg('polyline', {class: 'axis clamped', points: `0,0 ${flat(tip)}`}), word];
  });
}

/** Words are over everything else. @param {SVGElement} picture @param {Piece[]} pieces @param {Camera} camera */
export function paint(picture, pieces, camera) {
  const ready = pieces
    .map((piece) => ({piece, points: piece.points.map((p) => seen(p, camera))}))
    .filter(({piece, points}) => !(piece.isFace && piece.cls.startsWith('body') && isBehind(points)))
    .map((item) => ({...item, near: item.piece.text === undefined ? mean(item.points) : Infinity}))
    .sort((a, b) => a.near - b.near);
  const small = svg('g', {transform: `translate(${kCorner[0]} ${kCorner[1]})`}, corner(camera));
  picture.replaceChildren(...ready.map(({piece, points}) => element(piece, points)), small);
}
