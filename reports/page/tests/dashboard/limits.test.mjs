// The dashboard in Chromium: what is empty, damaged or missing, widths and axe-core.
import assert from 'node:assert/strict';
import {after, before, test} from 'node:test';
import {axe} from '../browser.mjs';
import {begin, blocks, drawn, end, ERROR, index, linkTo, open, skip, TIME} from './page.mjs';
import {dashboardAddress, makeHistory, packed} from './history_fixture.mjs';

before(begin);
after(end);

const empty = {...index, series: [], latest: [], changes: [], release: null, pairs: []};
empty.runs = Object.fromEntries(Object.keys(index.runs).map((key) => [key, []]));
const oneRun = makeHistory({
  order: [0],
  specs: [{name: 'a', unit: 'ns per joint', kind: 'time', formulation: '', base: 5}]
});
const flip = (text, i) => text.slice(0, i) + (text[i] === 'A' ? 'B' : 'A') + text.slice(i + 1);

test('an empty history says how to begin', {skip}, () =>
  open({at: dashboardAddress(packed({index: empty, blocks: []}), 'empty')}, async (page) =>
    assert.match(await page.textContent('main'), /holds no run yet.*history add/)
  )
);

test('a history of one run', {skip}, () =>
  open({at: dashboardAddress(packed(oneRun), 'one')}, async (page) => {
    await drawn(page);
    assert.match(await page.textContent('#changes'), /One run so far/);
    assert.match(await page.textContent('#release'), /No run in this history is a release/);
    assert.match(await page.textContent('#scatter'), /no formulation with both/);
  })
);

test('a damaged figure is named, and the others are there', {skip}, () => {
  const bad = index.figures.name.indexOf(TIME);
  const list = blocks.map(([id, text]) => [id, id === `f${bad}` ? flip(text, 40) : text]);
  return open({at: dashboardAddress(list, 'flipped'), hash: linkTo(TIME)}, async (page) => {
    await page.waitForFunction(() => document.getElementById('trend-drawn').textContent.includes('damaged'));
    assert.match(await page.textContent('#trend-drawn'), new RegExp(`data of ${TIME} are damaged`));
    await page.locator('select.figures').selectOption({label: ERROR});
    await drawn(page);
  });
});

test('a damaged or missing index, and another version, are said', {skip}, async () => {
  const said = (list, name, words) =>
    open({at: dashboardAddress(list, name), errors: words}, async (page) =>
      assert.match(await page.textContent('main'), words)
    );
  await said(
    blocks.map(([id, text]) => [id, id === 'index' ? flip(text, 99) : text]),
    'index',
    /history are damaged/
  );
  await said([], 'none', /history are not in this file/);
  await said(
    packed({index: {...index, version: 2}, blocks: []}),
    'version',
    /this page reads halfway-dashboard version 1/
  );
});

for (const width of [1400, 820, 390]) {
  test(`nothing is wider than ${width} px, no table is cut off`, {skip}, () =>
    open({width, hash: linkTo(TIME)}, async (page) => {
      await drawn(page);
      await page.waitForSelector('#scatter svg.plot');
      await page.getByText('As a table').click();
      await page.waitForSelector('#trend tbody tr');
      const cut = () =>
        page.evaluate(() => {
          for (const details of document.querySelectorAll('main details')) details.open = true;
          const boxes = [document.documentElement, ...document.querySelectorAll('.scroll')];
          return boxes.filter((b) => b.scrollWidth > b.clientWidth).map((b) => b.ariaLabel ?? 'page');
        });
      assert.deepEqual(await cut(), []);
      await page.evaluate(() => (document.querySelector('#state table').style.minWidth = '1600px'));
      assert.deepEqual(await cut(), ['State of each formulation']); // the check can fail
    })
  );
}

const LOOKS = ['light', 'dark'].flatMap((theme) => [1400, 820, 390].map((width) => ({theme, width})));
for (const {theme, width} of LOOKS) {
  test(`axe-core: ${theme}, ${width} px`, {skip}, () =>
    open({theme, width, hash: `${linkTo(TIME)}&show=all`}, async (page) => {
      await drawn(page);
      await page.waitForSelector('#scatter svg.plot');
      await page.getByText('As a table').click();
      await page.evaluate(axe);
      const violations = () =>
        page.evaluate(async () => {
          const {violations: list} = await window.axe.run(document, {resultTypes: ['violations']});
          return list.map((v) => `${v.id}: ${v.nodes.slice(0, 3).map((n) => n.target)}`);
        });
      assert.deepEqual(await violations(), []);
      await page.evaluate(() => document.getElementById('cursor').removeAttribute('aria-label'));
      assert.equal((await violations()).length, 1); // the check can fail
    })
  );
}
