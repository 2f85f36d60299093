// The dashboard in Chromium: how it is read, by digits and by keyboard.
import assert from 'node:assert/strict';
import {after, before, test} from 'node:test';
import {begin, drawn, end, ERROR, index, linkTo, named, open, rows, skip, TIME} from './page.mjs';

before(begin);
after(end);

test('few digits are shown, all of them in the table and the titles', {skip}, () =>
  open({hash: linkTo(ERROR)}, async (page) => {
    await drawn(page);
    const exact = String(index.changes.find((c) => index.figures.name[c.figure] === ERROR).after);
    assert.ok(exact.length > 10, exact); // else nothing is tried
    const long = async () => (await page.locator('main').innerText()).match(/\d[.]\d{5,}/g) ?? [];
    assert.deepEqual(await long(), []);
    assert.ok((await rows(page, 'changes').first().innerHTML()).includes(exact));
    await page.getByText('As a table').click();
    await rows(page, 'trend').first().waitFor();
    assert.ok((await rows(page, 'trend').first().textContent()).includes(exact));
    assert.ok((await long()).length > 0);
  })
);

test('the keyboard reaches everything in reading order', {skip}, () =>
  open({hash: linkTo(TIME)}, async (page) => {
    await drawn(page);
    await page.waitForSelector('#scatter svg.plot');
    const stops = [];
    for (let i = 0; i < 120; i++) {
      await page.keyboard.press('Tab');
      const stop = await page.evaluate(() => {
        const {id, tagName, className} = document.activeElement;
        const section = document.activeElement.closest('section, nav')?.id ?? '';
        const style = getComputedStyle(document.activeElement);
        const seen = style.outlineStyle !== 'none' || document.activeElement.matches('input[type=radio]');
        return {section, what: id || className || tagName, seen};
      });
      if (stop.what === 'BODY') break;
      stops.push(stop);
    }
    const sections = stops.map((s) => s.section).filter((s, i, all) => s && s !== all[i - 1]);
    assert.deepEqual(sections, ['nav', 'changes', 'state', 'trend', 'scatter', 'release']);
    for (const what of ['skip', 'search', 'figures', 'cursor', 'when'])
      assert.ok(
        stops.some((s) => s.what === what),
        what
      );
    assert.deepEqual(
      stops.filter((s) => !s.seen),
      []
    );
    await page.locator('select.figures').focus();
    await page.keyboard.press('ArrowDown');
    const next = index.figures.name[index.figures.name.indexOf(TIME) + 1];
    await named(page, next);
    await page.locator('#when').focus();
    const first = await page.locator('#when').getAttribute('aria-valuetext');
    await page.keyboard.press('ArrowLeft');
    assert.notEqual(await page.locator('#when').getAttribute('aria-valuetext'), first);
  })
);
