// The page's parts: each is drawn when it comes into view, is linked to or asked for, or is about to be printed.
import {account, promise, reportError, settle} from './account.js';
import {drawAttached} from './chart.js';
import {button, h} from './dom.js';

/** The hash that draws everything: for printing, for searching the whole page, and for look.sh. */
export const EVERYTHING = '#all';
/** How far below the screen drawing begins, so that a reader rarely sees an empty place. */
const kAhead = '500px';

/** Says why a part has nothing to show. */
export class Absent {
  /** @param {string} why */
  constructor(why) {
    this.why = why;
  }
}

/**
 * @typedef {object} PartSpec
 * @property {string} id of its section, for links
 * @property {string} title
 * @property {string[]} [charts] what it promises to draw
 * @property {boolean} [optional] a report without it is complete
 * @property {boolean} [half] two of these stand side by side on wide screens
 * @property {() => Node | any[] | Absent} build
 */

export class Part {
  /** @param {PartSpec} spec */
  constructor(spec) {
    this.spec = spec;
    this.link = `#${spec.id}`;
    this.isDrawn = false;
    this.body = h('div', {class: 'body pending'}, this.button());
    const title = h('h3', {id: `${spec.id}-title`, tabindex: '-1'}, spec.title);
    this.title = title;
    this.section = h(
      'section',
      {class: spec.half ? 'part half' : 'part', id: spec.id, 'aria-labelledby': title.id},
      title,
      this.body
    );
    promise([this.link, ...(spec.charts ?? [])]);
  }

  /** What a keyboard finds in the place of a part that is not drawn yet. */
  button() {
    return button(`Show: ${this.spec.title}`, () => {
      this.draw();
      this.title.focus();
    });
  }

  draw() {
    if (this.isDrawn) return;
    this.isDrawn = true;
    const wasFocused = this.body.contains(document.activeElement);
    this.body.classList.remove('pending');
    try {
      this.fill(this.spec.build());
    } catch (error) {
      this.body.replaceChildren(h('p', {class: 'empty'}, `Not shown: ${error}`));
      reportError(error);
    }
    settle(this.spec.charts ?? []);
    if (wasFocused) this.title.focus();
  }

  /** @param {ReturnType<PartSpec['build']>} content */
  fill(content) {
    if (content instanceof Absent) {
      this.body.replaceChildren(h('p', {class: 'empty'}, `Not shown: ${content.why}.`));
      account(this.link, this.spec.optional ? 'drawn' : 'empty');
      return;
    }
    this.body.replaceChildren(h('div', {}, content));
    account(this.link, 'drawn');
    drawAttached();
  }
}

export class Parts {
  /** @param {Part[]} list */
  constructor(list) {
    this.list = list;
    /** Where a link led, until the reader moves on. @type {Element | null} */
    this.goal = null;
    this.observer = new IntersectionObserver((entries) => this.seen(entries), {rootMargin: kAhead});
  }

  /** Begins to watch; the parts must be in the page. */
  watch() {
    for (const part of this.list) this.observer.observe(part.section);
    window.addEventListener('beforeprint', () => this.list.forEach((part) => part.draw()));
    window.addEventListener('hashchange', () => this.follow(location.hash));
    for (const moving of ['wheel', 'touchmove', 'pointerdown', 'keydown']) {
      window.addEventListener(moving, () => (this.goal = null), {passive: true});
    }
    this.follow(location.hash);
  }

  /** @param {IntersectionObserverEntry[]} entries */
  seen(entries) {
    for (const {isIntersecting, target} of entries) {
      const part = this.list.find((p) => p.section === target);
      if (!isIntersecting || !part) continue;
      this.observer.unobserve(target);
      part.draw();
    }
    this.goal?.scrollIntoView(); // what was drawn above it has moved it
  }

  /** Draws what a link leads to, then goes there: its height was not known before.
   * @param {string} hash
   */
  follow(hash) {
    if (hash === EVERYTHING) {
      this.all();
      return;
    }
    const id = decodeURIComponent(hash.slice(1));
    const part = this.list.find((p) => p.spec.id === id);
    if (part) part.draw();
    else if (id && !document.getElementById(id)) this.list.forEach((p) => p.draw());
    this.goal = id ? document.getElementById(id) : null;
    this.goal?.scrollIntoView();
  }

  /** One part after another, so that the page answers in between. */
  all() {
    const {dataset, scrollHeight} = document.documentElement;
    const next = this.list.find((part) => !part.isDrawn);
    dataset.everything = next ? 'drawing' : 'drawn';
    if (!next) {
      dataset.height = String(scrollHeight);
      return;
    }
    next.draw();
    setTimeout(() => this.all());
  }
}
