// The dashboard's page for its tests: opened with a history, and what they look for.
import assert from 'node:assert/strict';
import {browserFile, launch, NO_BROWSER} from '../browser.mjs';
import {dashboardAddress, packed, smallHistory} from './history_fixture.mjs';

export const skip = browserFile() && process.env.DASHBOARD_BUNDLE ? false : NO_BROWSER;
export const {index, blocks: figures} = smallHistory();
export const blocks = packed({index, blocks: figures}, false);
export const TIME = 'invariant/angular/residual/kernel';
export const ERROR = 'invariant/angular/modelling_error';
const runOf = (figure) => index.changes.find((c) => index.figures.name[c.figure] === figure).run;
export const commitOf = (figure) => index.runs.commit[runOf(figure)].slice(0, 10);
/** @type {import('playwright-core').Browser} */
let browser;
export let address = '';

export async function begin() {
  if (skip) return;
  browser = await launch();
  address = dashboardAddress(blocks, 'small');
}
export const end = () => browser?.close();

/** A page that is ready; it must not report an error unless that is expected.
 * @param {{width?: number, theme?: string, hash?: string, at?: string, errors?: RegExp}} how
 * @param {(page: import('playwright-core').Page) => Promise<void>} use
 */
export async function open({width = 1400, theme = 'light', hash = '', at = address, errors = /^$/}, use) {
  const page = await browser.newPage({viewport: {width, height: 900}});
  try {
    await page.goto(`${at}?theme=${theme}${hash}`);
    await page.waitForFunction(() => document.documentElement.dataset.state !== 'loading');
    await use(page);
    assert.match(await page.evaluate(() => document.documentElement.dataset.errors ?? ''), errors);
  } finally {
    await page.close();
  }
}

export const drawn = (page) => page.waitForSelector('#trend-drawn svg.plot');
export const named = (page, name) =>
  page.waitForFunction((n) => document.getElementById('figure-name')?.textContent === n, name);
export const rows = (page, section) => page.locator(`#${section} tbody tr`);
export const hashOf = (page) => page.evaluate(() => decodeURIComponent(location.hash.replaceAll('+', ' ')));
export const linkTo = (figure) => `#${new URLSearchParams({figure})}`;
