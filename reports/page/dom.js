// Elements without a framework.

/** @typedef {import('./palette.js').Look} Look */

/** h('p', {class: 'x', onclick: f}, 'text', child, [more children])
 * @template {keyof HTMLElementTagNameMap} T
 * @param {T} tag
 * @param {Record<string, any>} attributes
 * @param {any[]} children
 * @returns {HTMLElementTagNameMap[T]}
 */
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
/** @type {Record<string, string>} */
export const PATHS = {
  circle: 'M-5,0a5,5 0 1,0 10,0a5,5 0 1,0 -10,0',
  square: 'M-4.4,-4.4h8.8v8.8h-8.8z',
  'triangle-up': 'M0,-5.4L5.4,4.2H-5.4z',
  'triangle-right': 'M5.4,0L-4.2,5.4V-5.4z',
  'triangle-down': 'M0,5.4L5.4,-4.2H-5.4z',
  diamond: 'M0,-5.8L5.8,0L0,5.8L-5.8,0z',
  cross: 'M-5.5,-1.9h3.6v-3.6h3.8v3.6h3.6v3.8h-3.6v3.6h-3.8v-3.6h-3.6z'
};

/** @param {string} tag @param {Record<string, any>} attributes @param {any[]} children
 * @returns {SVGElement}
 */
export function svg(tag, attributes, ...children) {
  const element = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children.flat(Infinity));
  return element;
}

/** A legend swatch: a line with its dash, or a symbol; a look that has both is a line.
 * @param {{color: string, dash?: number[], shape?: string}} look
 */
export function swatch({color, dash, shape}) {
  const picture = svg('svg', {
    width: dash ? 26 : 14,
    height: 14,
    viewBox: dash ? '-13 -7 26 14' : '-7 -7 14 14',
    'aria-hidden': 'true'
  });
  if (dash) {
    picture.append(
      svg('path', {
        d: 'M-13,0H13',
        stroke: color,
        'stroke-width': 2.5,
        'stroke-dasharray': dash.join(' '),
        fill: 'none'
      })
    );
  } else {
    picture.append(svg('path', {d: PATHS[shape ?? 'circle'], fill: color}));
  }
  return picture;
}

/** @param {string} label @param {() => void} pressed */
export const button = (label, pressed) =>
  h('button', {type: 'button', class: 'plain', onclick: pressed}, label);

/** A button that gives a file to keep. @param {string} type @param {() => string} content */
export const download = (/** @type {string} */ label, /** @type {string} */ name, type, content) =>
  button(label, () => {
    const href = URL.createObjectURL(new Blob([content()], {type}));
    h('a', {href, download: name}).click();
    setTimeout(() => URL.revokeObjectURL(href));
  });

/** A row of toggle buttons that wraps; `items`: {key, label, swatch, on}. Items off at the start fold away. */
export function toggles(label, items, changed) {
  const buttons = items.map((item) => {
    const own = h(
      'button',
      {
        type: 'button',
        class: 'toggle',
        'aria-pressed': String(item.on),
        title: item.title,
        onclick: () => {
          item.on = !item.on;
          own.setAttribute('aria-pressed', String(item.on));
          changed(items.filter((i) => i.on).map((i) => i.key));
        }
      },
      item.swatch ?? '',
      item.label
    );
    return own;
  });
  const few = items.length <= 6;
  const first = buttons.filter((_, i) => few || items[i].on);
  const folded = buttons.filter((b) => !first.includes(b));
  return h(
    'div',
    {class: 'toggles', role: 'group', 'aria-label': label},
    first,
    folded.length
      ? h(
          'details',
          {class: 'more'},
          h('summary', {}, `${folded.length} more`),
          h('div', {class: 'toggles'}, folded)
        )
      : null
  );
}

let radioGroups = 0;

/** One choice of several, as a segmented control. */
export function choice(label, options, initial, changed) {
  const name = `choice-${++radioGroups}`;
  return h(
    'fieldset',
    {class: 'choice'},
    h('legend', {}, label),
    options.map(({key, label: text}) =>
      h(
        'label',
        {},
        h('input', {type: 'radio', name, value: key, checked: key === initial, onchange: () => changed(key)}),
        h('span', {}, text)
      )
    )
  );
}

/** One choice of many. */
export function select(label, options, initial, changed) {
  return h(
    'label',
    {class: 'select'},
    h('span', {}, label),
    h(
      'select',
      {onchange: (e) => changed(e.target.value)},
      options.map(({key, label: text}) => h('option', {value: key, selected: key === initial}, text))
    )
  );
}

/** Legend buttons, of which one or none is pressed: changed(key), or changed(null) after a second click. */
export function isolate(label, items, changed) {
  let chosen = null;
  const buttons = items.map((item) =>
    h(
      'button',
      {
        type: 'button',
        class: 'toggle isolate',
        'aria-pressed': 'false',
        title: item.title,
        onclick: () => press(item.key)
      },
      item.swatch ?? '',
      item.label
    )
  );
  const press = (key) => {
    chosen = chosen === key ? null : key;
    buttons.forEach((b, i) => b.setAttribute('aria-pressed', String(items[i].key === chosen)));
    box.classList.toggle('isolating', chosen !== null);
    changed(chosen);
  };
  const box = h('div', {class: 'toggles', role: 'group', 'aria-label': label}, buttons);
  const folds = items.length > 8 && window.matchMedia('(max-width: 640px)').matches; // else the chart is a screen away
  return folds ? h('details', {class: 'more'}, h('summary', {}, `${label} (${items.length})`), box) : box;
}

/** columns: [{text, number}]; rows: lists of cells (text or nodes), or {cells, class}; the first cell heads its row.
 * cards: on narrow screens each row is a card, whose cells say what they are. */
export function plainTable(label, columns, rows, caption, cards = false) {
  const cell = (content, i) =>
    h(
      i ? 'td' : 'th',
      {
        scope: i ? null : 'row',
        class: columns[i].number ? 'number' : null,
        'data-label': cards && i ? columns[i].text : null
      },
      content
    );
  return scrolling(
    h(
      'table',
      {class: cards ? 'compact narrow cards' : 'compact narrow'},
      caption ? h('caption', {}, caption) : null,
      h(
        'thead',
        {},
        h(
          'tr',
          {},
          columns.map((c) => h('th', {scope: 'col', class: c.number ? 'number' : null}, c.text))
        )
      ),
      h(
        'tbody',
        {},
        rows.map((r) => h('tr', {class: r.class}, (r.cells ?? r).map(cell)))
      )
    ),
    label
  );
}

/** A section that its heading names. @param {string} id @param {string} title @param {any} content */
export const section = (id, title, content, cls = id) =>
  h(
    'section',
    {class: cls, id, 'aria-labelledby': `${id}-title`},
    h('h2', {id: `${id}-title`}, title),
    content
  );

/** What is there for those who ask; `opened` is told when they do. */
export const folded = (title, content, opened) =>
  h('details', {class: 'more', ontoggle: opened}, h('summary', {}, title), content);

/** A table that scrolls sideways by itself on narrow screens. */
export function scrolling(table, label) {
  return h('div', {class: 'scroll', tabindex: '0', role: 'group', 'aria-label': label}, table);
}
