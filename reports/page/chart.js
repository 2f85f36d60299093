// Draws Vega-Lite charts into their boxes, at once and without waiting: a page that is about to be printed has
// no time for promises.
import {Error as kErrorsOnly, expressionFunction, logger, parse, View} from 'vega';
import {compile} from 'vega-lite';
import {Handler} from 'vega-tooltip';
import {account} from './account.js';
import {h} from './dom.js';
import {powerOfTen} from './format.js';

/** @typedef {Record<string, any>} Spec  of Vega or Vega-Lite */

expressionFunction('power10', powerOfTen);

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
const tooltip = new Handler({theme: 'custom', disableDefaultStyle: true});

/** Charts whose box is not in the page yet, where it would have no width. @type {Set<Chart>} */
const detached = new Set();

export class Chart {
  /**
   * @param {string} id names the chart in the page's account
   * @param {string} label is read by screen readers
   */
  constructor(id, label) {
    this.id = id;
    this.label = label;
    this.box = h('div', {class: 'chart', id: `chart-${id}`});
    /** @type {() => void} */
    this.render = () => {};
    /** @type {View | undefined} */
    this.view = undefined;
    account(id, 'waiting');
  }

  /** There is data, but words say more than a picture.
   * @param {string} text
   */
  say(text) {
    this.clear();
    this.box.append(h('p', {class: 'empty'}, text));
    account(this.id, 'drawn');
  }

  /**
   * @param {Spec} spec of Vega-Lite
   * @param {(spec: Spec) => Spec} [patch] of the Vega that it becomes
   */
  draw(spec, patch = (vega) => vega) {
    this.render = () => {
      this.clear();
      this.embed(spec, patch);
    };
    if (this.box.isConnected) this.render();
    else detached.add(this);
  }

  clear() {
    detached.delete(this);
    this.view?.finalize();
    this.view = undefined;
    this.box.replaceChildren();
    this.box.removeAttribute('role');
    this.box.removeAttribute('aria-label');
  }

  /**
   * @param {Spec} spec
   * @param {(spec: Spec) => Spec} patch
   */
  embed(spec, patch) {
    const full = {
      $schema: 'https://vega.github.io/schema/vega-lite/v6.json',
      width: 'container',
      autosize: {type: 'fit', contains: 'padding'},
      ...spec,
      config
    };
    const compiled = compile(/** @type {any} */ (full), {logger: logger(kErrorsOnly)}).spec;
    this.view = new View(parse(/** @type {any} */ (patch(compiled))), {
      renderer: 'svg',
      logLevel: kErrorsOnly
    });
    this.view.initialize(this.box).tooltip(tooltip.call).hover().run();
    const picture = this.box.querySelector('svg');
    picture?.setAttribute('aria-hidden', 'true'); // the box speaks for the marks, of which there are thousands
    this.box.setAttribute('role', 'img');
    this.box.setAttribute('aria-label', this.label);
    account(this.id, picture ? 'drawn' : 'empty');
  }
}

/** Draws the charts whose boxes have come into the page. */
export function drawAttached() {
  for (const chart of [...detached]) if (chart.box.isConnected) chart.render();
}

/** Lines of a logarithmic axis at its decades only. */
export const AT_DECADES = {condition: {test: 'power10(datum.value) != ""', value: 1}, value: 0};

export const isNarrow = () => window.innerWidth < 640;
