// Chromium, and the page to look at: a report's index.html, or the bundle with the tests' own results.
import {execFileSync} from 'node:child_process';
import {accessSync, mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {fileURLToPath, pathToFileURL} from 'node:url';
import {chromium} from 'playwright-core';
import {fixture} from './fixture.mjs';

const NAMES = ['chromium', 'chromium-browser', 'google-chrome'];
const QUIET = ['--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking'];
const ARGUMENTS = ['--no-sandbox', '--disable-component-update', '--disable-sync', ...QUIET];

/** axe-core, to be evaluated in a page. */
export const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
export const NO_BROWSER = 'no Chromium (Debian: apt-get install chromium; CHROMIUM names another)';

/** @param {string} file */
function isThere(file) {
  try {
    accessSync(file);
    return true;
  } catch {
    return false;
  }
}

/** The browser's program, or undefined. */
export function browserFile() {
  const folders = (process.env.PATH ?? '').split(':');
  const named = process.env.CHROMIUM;
  if (named?.includes('/')) return named;
  return (named ? [named] : NAMES).flatMap((n) => folders.map((f) => join(f, n))).find(isThere);
}

export const launch = () => chromium.launch({executablePath: browserFile(), args: ARGUMENTS});

/** Address of the page: PAGE_UNDER_TEST, or PAGE_BUNDLE with results that are written into it as C++ does. */
export function pageAddress(results = fixture()) {
  const report = process.env.PAGE_UNDER_TEST;
  if (report) return pathToFileURL(report).href;
  const bundle = process.env.PAGE_BUNDLE ?? '';
  const json = JSON.stringify(results).replaceAll('<', '\\u003c');
  const file = `${bundle}.${process.pid}.html`;
  writeFileSync(
    file,
    readFileSync(bundle, 'utf8').replace('@HALFWAY_RESULTS@', () => json)
  );
  return pathToFileURL(file).href;
}

/** Bundles the pages for a command of its own, into a folder that goes with it. */
export function bundleForNow() {
  const folder = mkdtempSync(join(tmpdir(), 'halfway-'));
  process.on('exit', () => rmSync(folder, {recursive: true}));
  const build = fileURLToPath(new URL('../build.mjs', import.meta.url));
  execFileSync(process.execPath, [build, join(folder, 'page.html')]);
  process.env.DASHBOARD_BUNDLE = join(folder, 'dashboard.html');
}
