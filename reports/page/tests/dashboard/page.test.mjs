// The dashboard in Chromium: every interaction.
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {after, before, test} from 'node:test';
import {address, begin, commitOf, drawn, end, ERROR, hashOf, index, linkTo, named} from './page.mjs';
import {open, rows, skip, TIME} from './page.mjs';
import {HOSTILE} from './history_fixture.mjs';

before(begin);
after(end);

test('the first screen says what got worse, since when and how sure', {skip}, () =>
  open({}, async (page) => {
    const sentence = await page.locator('#changes .answer').textContent();
    assert.match(sentence, /2 figures got worse/);
    assert.ok(
      sentence.includes(ERROR) && sentence.includes(commitOf(ERROR)) && sentence.includes('0.5 digits lost'),
      sentence
    );
    const [first, second] = await rows(page, 'changes').allTextContents();
    assert.ok(first.includes(ERROR) && first.includes('exact'), first);
    assert.ok(second.includes(TIME) && second.includes('+10 %') && second.includes('p = 2·10⁻⁴'), second);
    const {y, height} = await rows(page, 'changes').nth(1).boundingBox();
    assert.ok(y + height < 900, 'without scrolling');
    await page.waitForSelector('#changes svg.spark');
  })
);

test('only regressions at first; the filter shows the others, and a link restores it', {skip}, () =>
  open({}, async (page) => {
    const marks = () => page.locator('#changes tbody .verdict').allTextContents();
    assert.ok((await marks()).every((t) => t.startsWith('✗')));
    await page.locator('#changes label', {hasText: 'better'}).click();
    assert.ok((await marks()).length > 0 && (await marks()).every((t) => t.startsWith('✓')));
    assert.match(await hashOf(page), /show=improvement/);
    await page.reload();
    await page.waitForSelector('#changes tbody tr');
    assert.ok((await marks()).every((t) => t.startsWith('✓')));
    await page.locator('#changes label', {hasText: 'all'}).click();
    assert.equal((await marks()).length, index.changes.filter((c) => c.series === 0).length);
  })
);

test('a link restores figure and series; one that names nothing says so', {skip}, async () => {
  let link = '';
  await open({hash: linkTo(ERROR)}, async (page) => {
    await named(page, ERROR);
    await page.getByLabel('Machine and build').selectOption({index: 1});
    await page.waitForFunction(() => document.querySelector('#trend .note:nth-of-type(1)') !== null);
    link = new URL(page.url()).hash;
  });
  await open({hash: link}, async (page) => {
    await named(page, ERROR);
    await drawn(page);
    assert.match(await page.getByLabel('Machine and build').locator('option:checked').textContent(), /Intel/);
  });
  await open({hash: '#figure=gone&series=none'}, async (page) => {
    assert.match(
      await page.locator('[role=status]').textContent(),
      /names .*“none” and .*“gone”, which this history does not hold/
    );
    await drawn(page);
  });
});

test('following a change goes to its trend, and back', {skip}, () =>
  open({}, async (page) => {
    await drawn(page);
    await page.locator('#changes tbody a', {hasText: TIME}).click();
    await named(page, TIME);
    await page.waitForFunction(
      () => Math.abs(document.getElementById('trend').getBoundingClientRect().top) < 300
    );
    await page.locator('#nav a', {hasText: 'now'}).click();
    // The browser follows the link first, the page then says again what is shown: else this waits in vain.
    await page.waitForFunction(
      (name) => decodeURIComponent(location.hash.replaceAll('+', ' ')).includes(name),
      TIME
    );
  })
);

test('search, filters and the list choose a figure', {skip}, () =>
  open({}, async (page) => {
    const options = page.locator('select.figures option');
    assert.equal(await options.count(), index.figures.name.length);
    await page.getByLabel('Search').fill('quaternion KERNEL');
    assert.deepEqual(await options.allTextContents(), [
      'quaternion/angular/residual/kernel',
      'quaternion/linear/residual/kernel'
    ]);
    await page.getByLabel('Search').press('Enter');
    await named(page, 'quaternion/angular/residual/kernel');
    await page.getByLabel('Search').fill('');
    await page.getByLabel('Kind').selectOption('count');
    assert.deepEqual(await options.allTextContents(), ['invariant/angular/flops']);
    await page.getByLabel('Kind').selectOption('');
    await page.getByLabel('Verdict now').selectOption('known_failure');
    assert.deepEqual(await options.allTextContents(), ['attached_a/angular/node_order']);
    await page.getByLabel('Verdict now').selectOption('');
    await page.locator('#trend .controls').first().getByLabel('Formulation').selectOption(HOSTILE);
    assert.equal(await options.count(), 4);
    await page.locator('select.figures').selectOption({label: `${HOSTILE}/linear/modelling_error`});
    await named(page, `${HOSTILE}/linear/modelling_error`);
    assert.match(await hashOf(page), /figure=<script>alert\(1\)<\/script>\/linear/);
  })
);

test('the cursor reads runs by keyboard and pointer, and jumps to changes', {skip}, () =>
  open({hash: linkTo(TIME)}, async (page) => {
    await drawn(page);
    const say = page.locator('#trend output');
    const last = await say.textContent();
    assert.ok(last.includes(index.runs.commit[71].slice(0, 10)), last);
    await page.getByLabel('Run', {exact: true}).press('ArrowLeft');
    assert.notEqual(await say.textContent(), last);
    assert.equal(await page.locator('#cursor').getAttribute('aria-valuetext'), await say.textContent());
    await page.locator('#cursor').press('Home');
    assert.ok((await say.textContent()).includes(index.runs.commit[1].slice(0, 10)));
    await page.getByRole('button', {name: 'change ›'}).click();
    assert.ok((await say.textContent()).includes(commitOf(TIME)));
    const {x, y, width, height} = await page.locator('#trend-drawn svg.plot').boundingBox();
    await page.mouse.move(x + width - 15, y + height / 2);
    assert.equal(await say.textContent(), last);
  })
);

test('the picture marks the regression and names its commit; limits are drawn', {skip}, () =>
  open({hash: linkTo(TIME)}, async (page) => {
    await drawn(page);
    assert.match(
      await page.locator('#trend-drawn .change.fail text').textContent(),
      new RegExp(commitOf(TIME))
    );
    assert.match(
      await page.locator('#trend-drawn svg.plot').getAttribute('aria-label'),
      /60 runs.*worse at .*\+10 %/
    );
    assert.equal(await page.locator('#trend-drawn .level').count(), 2);
    await page.goto(address + linkTo(ERROR));
    await named(page, ERROR);
    await drawn(page);
    assert.notEqual(await page.locator('#trend-drawn .limit').getAttribute('d'), '');
    const tick = () => page.locator('#trend-drawn .tick').first().textContent();
    const first = await tick();
    await page.locator('#trend label', {hasText: 'linear'}).click();
    await page.locator('#trend label', {hasText: 'logarithmic'}).click();
    const asLog = await tick();
    await page.locator('#trend label', {hasText: 'linear'}).click();
    assert.notEqual(await tick(), asLog, first);
  })
);

test('every chart has a table', {skip}, () =>
  open({hash: linkTo(TIME)}, async (page) => {
    await drawn(page);
    await page.getByText('As a table').click();
    await rows(page, 'trend').nth(49).waitFor();
    assert.equal(await rows(page, 'trend').count(), 50);
    await page.getByRole('button', {name: 'Show 10 more'}).click();
    assert.equal(await rows(page, 'trend').count(), 60);
    assert.ok(await rows(page, 'scatter').count());
  })
);

/** The text of what a button downloads. */
async function downloaded(page, section, name) {
  const press = page.locator(`#${section}`).getByRole('button', {name}).click();
  const [file] = await Promise.all([page.waitForEvent('download'), press]);
  return {name: file.suggestedFilename(), text: readFileSync(await file.path(), 'utf8')};
}

test('picture and data can be downloaded', {skip}, () =>
  open({hash: linkTo(TIME)}, async (page) => {
    await drawn(page);
    const picture = await downloaded(page, 'trend', 'SVG');
    assert.equal(picture.name, 'invariant_angular_residual_kernel.svg');
    assert.ok(
      picture.text.includes(commitOf(TIME)) &&
        !picture.text.includes('var(') &&
        !picture.text.includes('light-dark')
    );
    const isWellFormed = (text) =>
      page.evaluate(
        (t) => !new DOMParser().parseFromString(t, 'image/svg+xml').querySelector('parsererror'),
        text
      );
    assert.ok(await isWellFormed(picture.text));
    assert.ok(!(await isWellFormed(picture.text.slice(0, -5)))); // the check can fail
    const data = await downloaded(page, 'trend', 'CSV');
    assert.equal(data.text.split('\r\n').length, 62);
    const points = await downloaded(page, 'scatter', 'SVG');
    assert.equal(points.name, 'accuracy_speed_angular.svg');
    assert.ok(await isWellFormed(points.text));
    assert.ok((await downloaded(page, 'scatter', 'CSV')).text.startsWith('commit,date,formulation,ns,error'));
  })
);

test('states count verdicts and link to times', {skip}, () =>
  open({}, async (page) => {
    const row = rows(page, 'state').filter({hasText: 'invariant'});
    assert.match(await row.textContent(), /✓ 2≈ 0✗ 0/);
    assert.match(await row.textContent(), /✗ \+10 %/);
    await row.locator(`a[aria-label^="${TIME}"]`).click();
    await named(page, TIME);
  })
);

test('another machine: its own state, its own changes, and no times said', {skip}, () =>
  open({}, async (page) => {
    await page.locator('#changes .others a').click();
    await page.waitForFunction(() =>
      document.querySelector('#changes .answer').textContent.includes('1 figure got worse')
    );
    assert.match(await page.locator('#state').textContent(), /This series holds no times/);
    await page.waitForFunction(() =>
      document.getElementById('scatter').textContent.includes('no formulation with both')
    );
    await page.locator('select.figures').selectOption({label: TIME});
    await page.waitForFunction(() =>
      document.getElementById('trend-drawn').textContent.includes('never measured')
    );
  })
);

test('accuracy against speed moves over the runs, and is printed as several', {skip}, () =>
  open({}, async (page) => {
    await page.waitForSelector('#scatter svg.plot');
    const points = () =>
      page
        .locator('#scatter .chart .point')
        .evaluateAll((list) => list.map((p) => p.getAttribute('transform')).join());
    const [last, table] = [await points(), await page.locator('#scatter tbody').textContent()];
    await page.locator('#when').press('Home');
    assert.notEqual(await points(), last);
    assert.notEqual(await page.locator('#scatter tbody').textContent(), table);
    assert.match(await hashOf(page), new RegExp(`run=${index.runs.commit[1]}`));
    await page.locator('#scatter label', {hasText: /^linear$/}).click();
    await page.waitForFunction(() =>
      document.querySelector('#scatter svg.plot').ariaLabel.includes(', linear,')
    );
    await page.evaluate(() => window.dispatchEvent(new Event('beforeprint')));
    assert.equal(await page.locator('#scatter .paper svg').count(), 4);
    await page.emulateMedia({media: 'print'});
    assert.ok(await page.locator('#scatter .paper').isVisible());
  })
);

test('what changed since the last release', {skip}, () =>
  open({}, async (page) => {
    const text = await page.locator('#release').textContent();
    assert.match(text, /Since release 0\.2\.0/);
    const since = index.changes.filter((c) => c.series === 0 && c.run > index.release.run).length;
    assert.equal(await rows(page, 'release').count(), since);
    await page.locator('#release summary').click();
    assert.ok((await page.locator('#release li').count()) > 20);
  })
);

test('names are text, whatever they hold', {skip}, () =>
  open({hash: linkTo(`${HOSTILE}/angular/residual/kernel`)}, async (page) => {
    let alerts = 0;
    page.on('dialog', (dialog) => (alerts++, dialog.dismiss()));
    await drawn(page);
    await page.getByText('As a table').click();
    await page.locator('#release summary').click();
    assert.equal(await page.locator('#figure-name').textContent(), `${HOSTILE}/angular/residual/kernel`);
    assert.match(
      await page.locator('#release li', {hasText: 'Faster <b>'}).textContent(),
      /Faster <b>tables<\/b>/
    );
    assert.equal(await page.locator('main b, main script').count(), 0);
    assert.equal(alerts, 0);
    await page.evaluate(
      () => (document.querySelector('#figure-name').innerHTML = '<img src="data:," onerror="alert(1)">')
    );
    await page.waitForTimeout(100);
    assert.equal(alerts, 1, 'the check can fail');
  })
);
