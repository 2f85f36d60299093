// Draws Vega-Lite charts into figures and keeps the account that look.sh reads: which charts the page promised,
// which were drawn, which have no data.
import {expressionFunction} from 'vega';
import vegaEmbed from 'vega-embed';
import {h} from './dom.js';
import {superscript} from './format.js';

expressionFunction('power10', (x) => {
  const exponent = Math.log10(x);
  return Math.abs(exponent - Math.round(exponent)) < 1e-9 ? `10${superscript(Math.round(exponent))}` : '';
});

export const FONT = 'system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif';
const config = {
  background: 'transparent',
  font: FONT,
  view: {stroke: null},
  axis: {
    domainColor: 'var(--rule)',
    tickColor: 'var(--rule)',
    gridColor: 'var(--grid)',
    labelColor: 'var(--muted)',
    titleColor: 'var(--ink)',
    titleFontWeight: 'normal',
    labelFontSize: 12,
    titleFontSize: 13,
    titlePadding: 8,
    labelOverlap: 'greedy',
    labelFlush: false
  },
  text: {color: 'var(--ink)', fontSize: 12}
};

const charts = new Map();
const errors = [];
let sealed = false;

export function reportError(error) {
  errors.push(String(error?.message ?? error));
  publish();
}

/** All charts are promised; from now on the page may call itself ready. */
export function seal() {
  sealed = true;
  publish();
}

function publish() {
  const states = [...charts.entries()];
  const of = (state) => states.filter(([, s]) => s === state).map(([id]) => id);
  const root = document.documentElement;
  root.dataset.chartsDrawn = of('drawn').join(' ');
  root.dataset.chartsEmpty = of('empty').join(' ');
  root.dataset.errors = errors.join(' | ');
  root.dataset.height = String(Math.ceil(root.scrollHeight));
  if (errors.length) root.dataset.state = 'error';
  else if (sealed && of('waiting').length === 0)
    root.dataset.state = of('empty').length ? 'incomplete' : 'ready';
}

/** For what is drawn without Vega: 'drawn' or 'empty'. */
export function account(id, state) {
  charts.set(id, state);
  publish();
}

export class Chart {
  /** `id` names the chart in the page's account; `label` is read by screen readers. */
  constructor(id, label) {
    this.id = id;
    this.label = label;
    this.box = h('div', {class: 'chart', id: `chart-${id}`});
    this.queue = Promise.resolve();
    charts.set(id, 'waiting');
  }

  /** No data: says so in the chart's place. */
  empty(why) {
    account(this.id, 'empty');
    this.box.replaceChildren(h('p', {class: 'empty'}, `Not drawn: ${why}`));
  }

  /** There is data, but words say more than a picture; after whatever is still being drawn here. */
  say(text) {
    this.queue = this.queue.then(() => {
      this.box.replaceChildren(h('p', {class: 'empty'}, text));
      account(this.id, 'drawn');
    });
  }

  /** Draws after whatever is still being drawn here. */
  draw(spec, patch) {
    this.queue = this.queue.then(() => this.embed(spec, patch)).catch(reportError);
    return this.queue;
  }

  async embed(spec, patch) {
    const full = {
      width: 'container',
      autosize: {type: 'fit', contains: 'padding'},
      ...spec,
      description: this.label,
      config
    };
    this.view?.finalize(); // before its place is cleared: a window resized meanwhile would find it without width
    const result = await vegaEmbed(this.box, full, {
      mode: 'vega-lite',
      renderer: 'svg',
      actions: false,
      ast: false,
      patch,
      tooltip: {theme: 'custom', disableDefaultStyle: true},
      logLevel: 1
    });
    this.view = result.view;
    charts.set(this.id, this.box.querySelector('svg') ? 'drawn' : 'waiting');
    publish();
  }
}

/** A figure: heading, controls, chart, caption. */
export function figure(title, controls, charts_, caption) {
  return h(
    'figure',
    {},
    h('h3', {}, title),
    controls,
    charts_,
    caption ? h('figcaption', {}, caption) : null
  );
}

/** Lines of a logarithmic axis at its decades only. */
export const AT_DECADES = {condition: {test: 'power10(datum.value) != ""', value: 1}, value: 0};

export const isNarrow = () => window.innerWidth < 640;
