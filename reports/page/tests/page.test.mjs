// The page in Chromium: how much of it is there at load, that everything can be reached, and axe-core.
import assert from 'node:assert/strict';
import {after, before, test} from 'node:test';
import {axe, browserFile, launch, NO_BROWSER, pageAddress} from './browser.mjs';

const kMostElements = 8000;
const skip = browserFile() ? false : NO_BROWSER;
/** @type {import('playwright-core').Browser} */
let browser;
let address = '';

before(async () => {
  if (skip) return;
  browser = await launch();
  address = pageAddress();
});
after(() => browser?.close());

/** A page that is ready; `use` gets it, and it is closed whatever happens.
 * @param {{width?: number, theme?: string, hash?: string}} how
 * @param {(page: import('playwright-core').Page) => Promise<void>} use
 */
async function open({width = 1400, theme = 'light', hash = ''}, use) {
  const page = await browser.newPage({viewport: {width, height: 1000}});
  try {
    await page.goto(`${address}?theme=${theme}${hash}`);
    await page.waitForFunction(() => document.documentElement.dataset.state !== 'loading');
    await use(page);
    assert.equal(await page.evaluate(() => document.documentElement.dataset.errors), '');
  } finally {
    await page.close();
  }
}

const pendingIds = (page) =>
  page.evaluate(() => [...document.querySelectorAll('.part:has(> .pending)')].map((e) => e.id));

/** Charts with marks far outside of their box: axe-core's contrast rule dies of one that is millions of pixels wide. */
function marksFarOutside() {
  const kFar = 5000;
  const isFar = (mark, box) => {
    const rect = mark.getBoundingClientRect();
    if (!rect.width && !rect.height) return false; // a definition, drawn nowhere
    return (
      Math.max(box.left - rect.left, rect.right - box.right, box.top - rect.top, rect.bottom - box.bottom) >
      kFar
    );
  };
  return [...document.querySelectorAll('.chart')]
    .filter((chart) =>
      [...chart.querySelectorAll('svg *')].some((m) => isFar(m, chart.getBoundingClientRect()))
    )
    .map((chart) => chart.id);
}

test('at load there is little, and not everything', {skip}, () =>
  open({}, async (page) => {
    const count = await page.evaluate(() => document.querySelectorAll('*').length);
    assert.ok(count <= kMostElements, `${count} elements at load`);
    const pending = await pendingIds(page);
    assert.ok(pending.length > 5 && !pending.includes('accuracy'), `pending: ${pending}`);
  })
);

test('a link to a part draws it and goes there', {skip}, () =>
  open({hash: '#basins'}, async (page) => {
    assert.ok(!(await pendingIds(page)).includes('basins'));
    await page.waitForFunction(
      () => Math.abs(document.getElementById('basins').getBoundingClientRect().top) < 400
    );
  })
);

test('scrolling draws what comes into view', {skip}, () =>
  open({}, async (page) => {
    await page.evaluate(() => document.getElementById('targets').scrollIntoView());
    await page.waitForFunction(() => !document.querySelector('#targets > .pending'));
  })
);

test('printing draws everything before it returns', {skip}, () =>
  open({}, async (page) => {
    await page.evaluate(() => window.dispatchEvent(new Event('beforeprint')));
    assert.deepEqual(await pendingIds(page), []);
    assert.equal(await page.evaluate(() => document.documentElement.dataset.chartsPromised), '');
  })
);

test('the keyboard reaches and draws a part', {skip}, () =>
  open({}, async (page) => {
    const [id] = (await pendingIds(page)).slice(-1);
    await page.evaluate((part) => document.querySelector(`#${part} button`).focus({preventScroll: true}), id);
    await page.keyboard.press('Enter');
    await page.waitForFunction((part) => document.activeElement.id === `${part}-title`, id);
    assert.ok(!(await pendingIds(page)).includes(id));
  })
);

for (const width of [1400, 400]) {
  test(`nothing is wider than ${width} px, and no mark far outside its chart`, {skip}, () =>
    open({width, hash: '#all'}, async (page) => {
      await page.waitForFunction(() => document.documentElement.dataset.everything === 'drawn');
      const wide = await page.evaluate(() => document.documentElement.scrollWidth);
      assert.ok(wide <= width, `the page is ${wide} px wide`);
      assert.deepEqual(await page.evaluate(marksFarOutside), []);
    })
  );
}

test('no table is cut off at 1400 px', {skip}, () =>
  open({hash: '#all'}, async (page) => {
    await page.waitForFunction(() => document.documentElement.dataset.everything === 'drawn');
    const cut = await page.evaluate(() => {
      for (const details of document.querySelectorAll('main details')) details.open = true;
      const boxes = [...document.querySelectorAll('.scroll')];
      return boxes.filter((box) => box.scrollWidth > box.clientWidth).map((box) => box.ariaLabel);
    });
    assert.deepEqual(cut, []);
  })
);

test('names are text, whatever they hold', {skip: skip || Boolean(process.env.PAGE_UNDER_TEST)}, () =>
  open({hash: '#all'}, async (page) => {
    await page.waitForFunction(() => document.documentElement.dataset.everything === 'drawn');
    assert.match(await page.textContent('#formulations'), /law <brand_new>/);
    assert.match(await page.textContent('#programs'), /Engine <engine>/);
    assert.equal(await page.locator('brand_new, engine').count(), 0);
  })
);

for (const [theme, width] of [
  ['light', 1400],
  ['dark', 1400],
  ['light', 400]
]) {
  test(`axe-core: ${theme}, ${width} px`, {skip, timeout: 600000}, () =>
    open({theme, width}, async (page) => {
      await page.evaluate(axe);
      const violations = await page.evaluate(async () => {
        const found = [];
        const check = async (place) => {
          const {violations: list} = await window.axe.run(place, {resultTypes: ['violations']});
          for (const v of list)
            found.push(
              `${v.id}: ${v.nodes
                .slice(0, 3)
                .map((n) => n.target)
                .join('; ')}`
            );
        };
        await check(document);
        // Part by part: all of them at once are more than the contrast rule survives.
        for (const part of document.querySelectorAll('.part')) {
          part.querySelector('.pending button')?.click();
          await check(part);
          part.querySelector('.body').replaceChildren();
        }
        return found;
      });
      assert.deepEqual(violations, []);
    })
  );
}
