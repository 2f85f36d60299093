// The account that look.sh reads from the root element: which charts the page promises, which are drawn, and
// which have no data. A promise is made before anything is drawn, so that a chart nobody builds is missed.

/** @typedef {'promised' | 'waiting' | 'drawn' | 'empty'} State */

/** @type {Map<string, State>} */
const states = new Map();
/** @type {string[]} */
const errors = [];
let isSealed = false;
let isScheduled = false;

/** @param {unknown} error */
export function reportError(error) {
  errors.push(error instanceof Error ? error.message : String(error));
  publish();
}

/** @param {string[]} ids */
export function promise(ids) {
  for (const id of ids) if (!states.has(id)) states.set(id, 'promised');
  publish();
}

/**
 * @param {string} id
 * @param {State} state
 */
export function account(id, state) {
  states.set(id, state);
  publish();
}

/** What was promised of a part that is done, but never drawn, has no data.
 * @param {string[]} ids
 */
export function settle(ids) {
  for (const id of ids)
    if (states.get(id) === 'promised' || states.get(id) === 'waiting') states.set(id, 'empty');
  publish();
}

/** All promises are made; from now on the page may call itself ready. */
export function seal() {
  isSealed = true;
  publish();
}

/** Many states change together: the attributes are written once, after them. */
function publish() {
  if (isScheduled) return;
  isScheduled = true;
  queueMicrotask(write);
}

function write() {
  isScheduled = false;
  /** @param {State} state */
  const idsOf = (state) => [...states.keys()].filter((id) => states.get(id) === state);
  const root = document.documentElement;
  root.dataset.chartsDrawn = idsOf('drawn').join(' ');
  root.dataset.chartsEmpty = idsOf('empty').join(' ');
  root.dataset.chartsPromised = idsOf('promised').join(' ');
  root.dataset.errors = errors.join(' | ');
  if (errors.length) root.dataset.state = 'error';
  else if (isSealed && !idsOf('waiting').length) {
    root.dataset.state = idsOf('empty').length ? 'incomplete' : 'ready';
  }
}
