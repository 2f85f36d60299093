// Elements without a framework.

/** h('p', {class: 'x', onclick: f}, 'text', child, [more children]) */
export function h(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === undefined || value === null || value === false) continue;
    if (name.startsWith('on')) element.addEventListener(name.slice(2), value);
    else element.setAttribute(name, value === true ? '' : value);
  }
  element.append(...children.flat(Infinity).filter((c) => c !== null && c !== undefined && c !== false));
  return element;
}

const SVG = 'http://www.w3.org/2000/svg';
const PATHS = {
  circle: 'M-5,0a5,5 0 1,0 10,0a5,5 0 1,0 -10,0',
  square: 'M-4.4,-4.4h8.8v8.8h-8.8z',
  'triangle-up': 'M0,-5.4L5.4,4.2H-5.4z',
  'triangle-down': 'M0,5.4L5.4,-4.2H-5.4z',
  diamond: 'M0,-5.8L5.8,0L0,5.8L-5.8,0z',
  cross: 'M-5.5,-1.9h3.6v-3.6h3.8v3.6h3.6v3.8h-3.6v3.6h-3.8v-3.6h-3.6z'
};

function svg(tag, attributes) {
  const element = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  return element;
}

/** A legend swatch: a line with its dash, or a symbol; a look that has both is a line. */
export function swatch({color, dash, shape}) {
  const picture = svg('svg', {width: dash ? 26 : 14, height: 14, viewBox: dash ? '-13 -7 26 14' : '-7 -7 14 14', 'aria-hidden': 'true'});
  if (dash) {
    picture.append(svg('path', {d: 'M-13,0H13', stroke: color, 'stroke-width': 2.5, 'stroke-dasharray': dash.join(' '), fill: 'none'}));
  } else {
    picture.append(svg('path', {d: PATHS[shape], fill: color}));
  }
  return picture;
}

/** A row of toggle buttons that wraps; `items`: {key, label, swatch, on}. Items off at the start fold away. */
export function toggles(label, items, changed) {
  const buttons = items.map((item) => {
    const button = h('button', {type: 'button', class: 'toggle', 'aria-pressed': String(item.on), title: item.title, onclick: () => {
      item.on = !item.on;
      button.setAttribute('aria-pressed', String(item.on));
      changed(items.filter((i) => i.on).map((i) => i.key));
    }}, item.swatch ?? '', item.label);
    return button;
  });
  const few = items.length <= 6;
  const first = buttons.filter((_, i) => few || items[i].on);
  const folded = buttons.filter((b) => !first.includes(b));
  return h('div', {class: 'toggles', role: 'group', 'aria-label': label}, first,
    folded.length ? h('details', {class: 'more'}, h('summary', {}, `${folded.length} more`), h('div', {class: 'toggles'}, folded)) : null);
}

let radioGroups = 0;

/** One choice of several, as a segmented control. */
export function choice(label, options, initial, changed) {
  const name = `choice-${++radioGroups}`;
  return h('fieldset', {class: 'choice'}, h('legend', {}, label), options.map(({key, label: text}) =>
    h('label', {}, h('input', {type: 'radio', name, value: key, checked: key === initial, onchange: () => changed(key)}), h('span', {}, text))));
}

/** A table that scrolls sideways by itself on narrow screens. */
export function scrolling(table, label) {
  return h('div', {class: 'scroll', tabindex: '0', role: 'region', 'aria-label': label}, table);
}
