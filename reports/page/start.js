// What every page begins with: the theme that its address fixes, the colours, and an account of its errors.
import {reportError, seal} from './account.js';
import {h} from './dom.js';
import {paletteStyle} from './palette.js';

export const main = () => document.getElementById('main') ?? document.body;

/** Errors of the page and of what it calls come into its account. */
function watchErrors() {
  const logged = console.error;
  console.error = (...parts) => {
    reportError(parts.join(' '));
    logged(...parts);
  };
  window.addEventListener('error', (event) => reportError(event.error ?? event.message));
  window.addEventListener('unhandledrejection', (event) => reportError(event.reason));
}

/** Builds the page; `what` names what cannot be shown where that fails.
 * @param {string} what
 * @param {() => void | Promise<void>} build
 */
export async function start(what, build) {
  watchErrors();
  const theme = new URLSearchParams(location.search).get('theme');
  if (theme === 'dark' || theme === 'light') document.documentElement.dataset.theme = theme;
  document.head.append(h('style', {}, paletteStyle()));
  try {
    await build();
    seal();
  } catch (error) {
    const why = error instanceof Error ? error.message : String(error);
    main().append(h('p', {class: 'empty'}, `${what} cannot be shown: ${why}`));
    reportError(error);
  }
}
