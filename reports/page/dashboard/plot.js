// A chart's frame: axes, their labels, and a picture that can be taken away.
import {svg} from '../dom.js';
import {powerOfTen, short} from '../format.js';

/** @typedef {import('./scale.js').Scale} Scale */
/** @typedef {{width: number, height: number, left: number, right: number, top: number, bottom: number}} Frame */

/** @param {number} width @param {number} height @returns {Frame} */
export const frameOf = (width, height) => ({
  width,
  height,
  left: 72,
  right: width - 14,
  top: 26,
  bottom: height - 40
});

/** @param {Record<string, any>} attributes @param {string} content */
export function text(attributes, content) {
  const element = svg('text', attributes);
  element.textContent = content;
  return element;
}

/** @param {Frame} frame @param {string} label for screen readers */
export const picture = ({width, height}, label) =>
  svg('svg', {
    class: 'plot',
    role: 'img',
    'aria-label': label,
    width,
    height,
    viewBox: `0 0 ${width} ${height}`
  });

/** In as many digits as it has. @param {number} t @param {boolean} isLog */
function tickText(t, isLog) {
  const isFar = isLog && (t < 0.009 || t > 2e3);
  const digits = t.toExponential(5).replace(/0*e.*|[-.]/g, '').length;
  return (isFar && powerOfTen(t)) || short(t, Math.max(digits, 1));
}

/** Horizontal lines with their values, and what they are, above. @param {Frame} frame @param {Scale} y */
export const yAxis = ({left, right, top}, y, title) => [
  ...y.ticks.flatMap((t) => [
    svg('path', {class: 'grid', d: `M${left},${y.at(t)}H${right}`}),
    text({class: 'tick', x: left - 8, y: y.at(t) + 4, 'text-anchor': 'end'}, tickText(t, y.isLog))
  ]),
  text({class: 'title', x: 0, y: top - 12}, title)
];

/** @param {Frame} frame @param {{at: number, label: string}[]} ticks @param {string} title */
export const xAxis = ({left, right, bottom, height}, ticks, title) => [
  svg('path', {class: 'rule', d: `M${left},${bottom}H${right}`}),
  ...ticks.map(({at, label}) =>
    text({class: 'tick', x: at, y: bottom + 17, 'text-anchor': at > right - 30 ? 'end' : 'middle'}, label)
  ),
  text({class: 'title', x: right, y: height - 4, 'text-anchor': 'end'}, title)
];

/** Ticks of a scale along x. @param {Scale} x */
export const xTicks = (x) => x.ticks.map((t) => ({at: x.at(t), label: tickText(t, x.isLog)}));

const kept = [
  'fill',
  'stroke',
  'stroke-width',
  'stroke-dasharray',
  'opacity',
  'font-family',
  'font-size',
  'font-weight'
];

/** The picture as a file of its own: what the style sheet gave is written into each element.
 * @param {SVGElement} drawn
 */
export function svgFile(drawn) {
  const copy = /** @type {SVGElement} */ (drawn.cloneNode(true));
  const copies = [copy, ...copy.querySelectorAll('*')];
  [drawn, ...drawn.querySelectorAll('*')].forEach((element, i) => {
    const style = getComputedStyle(element);
    for (const property of kept) copies[i].setAttribute(property, style.getPropertyValue(property));
    copies[i].removeAttribute('class');
    copies[i].removeAttribute('style');
  });
  const paper = getComputedStyle(document.body).backgroundColor;
  copy.prepend(svg('rect', {width: '100%', height: '100%', fill: paper}));
  copy.setAttribute('xmlns', 'http://www.w3.org/2000/svg');
  return new XMLSerializer().serializeToString(copy);
}
