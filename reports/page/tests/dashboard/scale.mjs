// How large and how fast the dashboard of 10 000 runs of 5 000 figures is, in Chromium: one that the tests' own
// history makes, or PAGE, written by halfway_large or ./halfway dashboard:
//   npm run scale [-- PAGE]
// Ends with 1 where it misses what the design allows.
import {statSync} from 'node:fs';
import {resolve} from 'node:path';
import {fileURLToPath, pathToFileURL} from 'node:url';
import {bundleForNow, launch} from '../browser.mjs';
import {dashboardAddress, largeHistory, packed} from './history_fixture.mjs';

const kMostBytes = 15e6;
const kFirst = 2000; // ms until the first chart
const kFurther = 50; // ms for a further figure
const kLoads = 5;
const kFigures = 30;

const median = (list) => [...list].sort((a, b) => a - b)[list.length >> 1];
const worst = (list) => Math.max(...list);
const ms = (x) => `${x.toFixed(0)} ms`;

/** Address of the page to measure. */
function pageFor(file) {
  // npm changes the folder, and says which one it was called in.
  if (file) return pathToFileURL(resolve(process.env.INIT_CWD ?? '.', file)).href;
  bundleForNow();
  return dashboardAddress(packed(largeHistory(), false), 'scale');
}

const address = pageFor(process.argv[2]);
const bytes = statSync(fileURLToPath(address)).size;
const browser = await launch();

/** Milliseconds from navigation until the first trend is drawn. */
async function firstChart() {
  const page = await browser.newPage({viewport: {width: 1400, height: 900}});
  await page.goto(address, {waitUntil: 'commit'});
  await page.waitForFunction(() => performance.getEntriesByName('trend').length);
  const at = await page.evaluate(() => performance.getEntriesByName('trend')[0].startTime);
  return {page, at};
}

/** Milliseconds from choosing a figure until its trend is drawn; every second one is a time. */
const further = (page) =>
  page.evaluate(async (count) => {
    const spent = [];
    const list = document.querySelector('select.figures');
    for (let i = 1; i <= count; i++) {
      const number = i % 2 ? 20 + 7 * i : 464 + 7 * i;
      list.replaceChildren(new Option('', String(number), true, true));
      performance.clearMarks('trend');
      const begin = performance.now();
      list.dispatchEvent(new Event('change'));
      while (!performance.getEntriesByName('trend').length) await new Promise((go) => setTimeout(go));
      spent.push(performance.getEntriesByName('trend')[0].startTime - begin);
      await new Promise((go) => setTimeout(go, 30));
    }
    return spent;
  }, kFigures);

const firsts = [];
for (let i = 0; i < kLoads; i++) {
  const {page, at} = await firstChart();
  firsts.push(at);
  if (i < kLoads - 1) await page.close();
}
const [page] = browser.contexts().at(-1).pages();
await page.waitForTimeout(2000); // small pictures are drawn in the meantime
const others = await further(page);
const heap = await page.evaluate(() => performance.memory?.usedJSHeapSize ?? NaN);
await browser.close();

console.log(`size: ${(bytes / 1e6).toFixed(2)} MB (at most ${kMostBytes / 1e6})`);
console.log(
  `first chart: median ${ms(median(firsts))}, worst ${ms(worst(firsts))} of ${kLoads} loads (at most ${kFirst})`
);
console.log(
  `a further figure: median ${ms(median(others))}, worst ${ms(worst(others))} of ${kFigures} (median at most ${kFurther})`
);
console.log(`heap: ${(heap / 1e6).toFixed(0)} MB`);
process.exitCode = bytes <= kMostBytes && worst(firsts) <= kFirst && median(others) <= kFurther ? 0 : 1;
