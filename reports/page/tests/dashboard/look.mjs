// Pictures of the dashboard, to be looked at: both themes at three widths, with the tests' small history, or with
// one made up around the names, units and values of a report.
//   npm run look-dashboard -- FOLDER [RESULTS.json]
import {mkdirSync, readFileSync} from 'node:fs';
import {join} from 'node:path';
import {bundleForNow, launch} from '../browser.mjs';
import {dashboardAddress, makeHistory, packed, smallHistory} from './history_fixture.mjs';

const [folder, results] = process.argv.slice(2);
if (!folder) throw new Error('usage: npm run look-dashboard -- FOLDER [RESULTS.json]');
const kRuns = 150;
bundleForNow();

/** Findings and timings as figures, with eight changes. */
function aroundReport({findings, timings}) {
  const accuracy = findings
    .filter((f) => f.verdict !== 'left_out')
    .map((f) => ({
      ...{name: f.name, unit: f.unit, kind: 'accuracy', formulation: f.formulation, base: f.value},
      ...{verdict: f.verdict, limit: f.comparison === 'at_most' ? f.high : undefined}
    }));
  const times = timings.map((t) => ({
    ...{name: t.name, unit: 'ns per joint', kind: 'time', formulation: t.formulation, base: t.ns},
    noise: Math.min(t.spread, 0.02)
  }));
  const specs = [...accuracy, ...times];
  const number = (name) => specs.findIndex((s) => s.name === name);
  const change = (name, ...events) => {
    specs[number(name)].events = events.map(([at, factor]) => ({series: 0, at, factor}));
    if (specs[number(name)].kind === 'accuracy') delete specs[number(name)].verdict;
  };
  change('invariant/angular/residual_tangent/batch/avx2/no_ends/256', [118, 1.1]);
  change('conformal/angular/residual/kernel', [60, 1.31], [75, 0.77]);
  change('drake_rpy/linear/residual/kernel', [130, 1.04]);
  change('jointc/linear/residual_tangent/batch/avx2/float/no_ends/256', [90, 0.84]);
  change('simbody_xyz/angular/residual/kernel', [20, 0.7]);
  change('exudyn_intrinsic/linear/kernel_tangent', [121, 3.1]);
  change('chrono_body/linear_angular/rounding_tangent', [125, 4]);
  change('field_b/angular/batch_sse2_polynomial_tangent', [101, 0.4]);
  const pairs = [...new Set(timings.map((t) => t.formulation))].filter(Boolean).flatMap((formulation) =>
    ['angular', 'linear', 'linear_angular'].map((kind) => ({
      ...{formulation, kind, time: number(`${formulation}/${kind}/residual/kernel`)},
      error: number(`${formulation}/${kind}/modelling_error`)
    }))
  );
  const there = pairs.filter((p) => p.time >= 0 && p.error >= 0);
  const order = Array.from({length: kRuns}, (_, i) => (i % 9 === 4 ? 1 : 0));
  return makeHistory({order, specs, pairs: there, releases: {50: '0.9.0', 110: '1.0.0'}});
}

const history = results ? aroundReport(JSON.parse(readFileSync(results, 'utf8'))) : smallHistory();
const address = dashboardAddress(packed(history, false), results ? 'report' : 'small');
mkdirSync(folder, {recursive: true});
const browser = await launch();
for (const width of [390, 820, 1400]) {
  for (const theme of ['light', 'dark']) {
    const page = await browser.newPage({viewport: {width, height: 900}});
    await page.goto(`${address}?theme=${theme}`);
    await page.waitForSelector('#trend-drawn svg.plot');
    await page.waitForSelector('#scatter svg.plot, #scatter .empty');
    await page.evaluate(() => window.dispatchEvent(new Event('beforeprint')));
    await page.waitForTimeout(1000);
    await page.screenshot({path: join(folder, `${width}-${theme}.png`), fullPage: true});
    await page.close();
  }
}
await browser.close();
