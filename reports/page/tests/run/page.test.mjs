// The page of a run in Chromium: every interaction, both themes, wide and narrow. Runs are made up, and real ones
// where HALFWAY_RUN names the program.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {existsSync, mkdtempSync, readFileSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {dirname, join} from 'node:path';
import {after, before, test} from 'node:test';
import {fileURLToPath, pathToFileURL} from 'node:url';
import {Ajv2020} from 'ajv/dist/2020.js';
import {axe, browserFile, launch, NO_BROWSER} from '../browser.mjs';
import {chainFixture, HOSTILE, motionFixture, rowFixture, runAddress, runFixture} from './fixture.mjs';

const skip = browserFile() && process.env.RUN_BUNDLE ? false : NO_BROWSER;
const program = process.env.HALFWAY_RUN ?? '';
const noProgram = program ? skip : 'HALFWAY_RUN names no program';
/** @type {import('playwright-core').Browser} */
let browser;
/** @type {Record<string, string>} */
const address = {};
const folder = mkdtempSync(join(tmpdir(), 'halfway-run-'));

/** Runs a scene with the real program: NAME -> the page's address. @param {string} scene @param {string} by */
function really(scene, by) {
  execFileSync(by, ['run', scene, '--out', folder, '--format', 'html'], {stdio: 'pipe'});
  const name = scene.replace(/^.*\//, '').replace(/\.toml$/, '');
  address[name] = pathToFileURL(join(folder, name, 'index.html')).href;
}

before(async () => {
  if (skip) return;
  browser = await launch();
  address.joint = runAddress(runFixture(), 'joint');
  address.row = runAddress(rowFixture(), 'row');
  address.motion = runAddress(motionFixture(), 'motion');
  address.chain = runAddress(chainFixture(), 'chain');
  if (!program) return;
  const field = fileURLToPath(new URL('../../../tests/field/turned_offsets.toml', import.meta.url));
  for (const scene of ['c1_skewed_torque', 'c3_buckling', 'torsional_pendulum', 'four_bar', field])
    really(scene, program);
  const chains = join(dirname(program), 'halfway-chains');
  if (existsSync(chains)) really('roll_up', chains);
});
after(async () => {
  await browser?.close();
  rmSync(folder, {recursive: true});
});

/** A page that is ready; it must report no error, and nothing may run that is not its own.
 * @param {{at?: string, width?: number, theme?: string}} how
 * @param {(page: import('playwright-core').Page) => Promise<void>} use
 */
async function open({at = 'joint', width = 1400, theme = 'light'}, use) {
  const page = await browser.newPage({viewport: {width, height: 1000}});
  const said = [];
  page.on('console', (message) => said.push(message.text()));
  page.on('pageerror', (error) => said.push(error.message));
  page.on('dialog', (dialog) => (said.push('a dialog'), dialog.dismiss()));
  try {
    await page.goto(`${address[at]}?theme=${theme}`);
    await page.waitForFunction(() => document.documentElement.dataset.state !== 'loading');
    await use(page);
    assert.equal(await page.evaluate(() => document.documentElement.dataset.state), 'ready');
    assert.deepEqual(said, []);
  } finally {
    await page.close();
  }
}

const bodies = (page) =>
  page.locator('.run3d .body').evaluateAll((list) => list.map((e) => e.getAttribute('points')).sort());
const outlines = (page) =>
  page.locator('.run3d .outline').evaluateAll((list) => list.map((e) => e.getAttribute('points')));
const slide = (page, to) => page.locator('#factor').fill(String(to));
const cursor = (page) => page.locator('.plot .cursor').first().getAttribute('d');

test(
  'the first screen has the scene’s name, who agrees, why a path ends, the joint and a curve',
  {skip},
  () =>
    open({}, async (page) => {
      assert.equal(await page.locator('h1').textContent(), HOSTILE);
      assert.match(await page.locator('.answer').textContent(), /3 of 4 formulations reach load factor 10/);
      assert.match(await page.locator('.run-ended').textContent(), /jointc at 5: a fold/);
      for (const part of ['.answer', '.run-ended', '.run3d', '.plot']) {
        const {y, height} = await page.locator(part).first().boundingBox();
        assert.ok(y + height < 1000, `${part} is below the first screen`);
      }
    })
);

test('the slider turns the joint, moves the cursor of each curve, and says where it stands', {skip}, () =>
  open({}, async (page) => {
    const [end, at] = [await bodies(page), await cursor(page)];
    await slide(page, 0);
    const rest = await bodies(page);
    assert.notDeepEqual(rest, end);
    for (const face of rest.filter((f) => (f ?? '').length)) assert.ok(face);
    assert.equal(rest.filter((face) => end.includes(face)).length, 3); // of the clamped box, which is seen as before
    const still = await outlines(page);
    assert.ok(
      rest.filter((face) => still.includes(face)).length >= 3,
      'at rest the loaded box is where it is at rest'
    );
    assert.notEqual(await cursor(page), at);
    assert.match(await page.locator('.run-slider output').textContent(), /load factor 0 of 10/);
    await page.locator('#factor').press('ArrowRight');
    assert.match(await page.locator('#factor').getAttribute('aria-valuetext'), /load factor 2.5 of 10/);
  })
);

test('another formulation at the same load factor; one that ends early says why', {skip}, () =>
  open({}, async (page) => {
    await slide(page, 2);
    const first = await bodies(page);
    await page.locator('.run-motion select').selectOption('attached_a');
    assert.notDeepEqual(await bodies(page), first);
    assert.match(await page.locator('.run-slider output').textContent(), /load factor 5 of 10/);
    await page.locator('.run-motion select').selectOption('jointc');
    assert.match(await page.locator('.run-slider output').textContent(), /ends here: a fold/);
  })
);

test('dragging and keys turn the view, and it can be reset', {skip}, () =>
  open({}, async (page) => {
    const first = await bodies(page);
    const {x, y, width, height} = await page.locator('.run3d').boundingBox();
    await page.mouse.move(x + width / 2, y + height / 2);
    await page.mouse.down();
    await page.mouse.move(x + width / 2 + 80, y + height / 2 + 20);
    await page.mouse.up();
    const dragged = await bodies(page);
    assert.notDeepEqual(dragged, first);
    await page.locator('.run3d').press('ArrowLeft');
    assert.notDeepEqual(await bodies(page), dragged);
    await page.getByRole('button', {name: 'Reset view'}).click();
    assert.deepEqual(await bodies(page), first);
  })
);

test('the legend takes a line out of every chart and brings it back', {skip}, () =>
  open({}, async (page) => {
    const count = () => page.locator('.plot .line').count();
    assert.equal(await count(), 6); // three shown, two outputs
    await page.getByRole('button', {name: 'attached_a'}).click();
    assert.equal(await count(), 4);
    await page.getByRole('button', {name: 'chrono_body'}).click();
    assert.equal(await count(), 6);
    assert.equal(await page.locator('.plot .early').count(), 2);
  })
);

test('the pointer reads the nearest point of a curve with its error', {skip}, () =>
  open({}, async (page) => {
    const {x, y} = await page.locator('.plot').first().boundingBox();
    const end = await page.locator('.plot').first().locator('.point').nth(1).boundingBox();
    await page.mouse.move(end.x + end.width / 2, end.y + end.height / 2);
    assert.match(
      await page.locator('.run-panels .readout').first().textContent(),
      /^invariant at load factor 10: theta_z = 1 ± 1·10⁻¹⁵ rad$/
    );
    await page.mouse.move(x + 2, y + 2);
    assert.equal(await page.locator('.run-panels .readout').first().textContent(), '');
  })
);

/** The text of what a button downloads. */
async function downloaded(page, name) {
  const press = page.getByRole('button', {name, exact: true}).click();
  const [file] = await Promise.all([page.waitForEvent('download'), press]);
  return {name: file.suggestedFilename(), text: readFileSync(await file.path(), 'utf8')};
}

test('curves as a table, CSV and SVG', {skip}, () =>
  open({}, async (page) => {
    await page.getByText('The curves as a table').click();
    await page.locator('.tall tbody tr').nth(4).waitFor();
    assert.equal(await page.locator('.tall tbody tr').count(), 5);
    const csv = await downloaded(page, 'CSV of all curves');
    assert.equal(csv.name, 'x.csv');
    assert.equal(csv.text.trimEnd().split('\r\n').length, 24);
    const svg = await downloaded(page, 'theta_z');
    assert.equal(svg.name, 'x_theta_z.svg');
    assert.ok(!svg.text.includes('var(') && !svg.text.includes('light-dark'));
    const isWellFormed = (text) =>
      page.evaluate(
        (t) => !new DOMParser().parseFromString(t, 'image/svg+xml').querySelector('parsererror'),
        text
      );
    assert.ok(await isWellFormed(svg.text));
    assert.ok(!(await isWellFormed(svg.text.slice(0, -5)))); // the check can fail
  })
);

test('what holds the nodes follows the slider; what does not balance is said', {skip}, () =>
  open({}, async (page) => {
    const table = () => page.locator('#holding tbody').textContent();
    const last = await table();
    assert.match(await page.locator('#holding').textContent(), /Forces balance/);
    await slide(page, 1);
    assert.notEqual(await table(), last);
    await page.locator('.run-motion select').selectOption('linearized');
    assert.match(await page.locator('#holding').textContent(), /Nobody says/);
    const run = runFixture();
    for (const row of run.curves[1].holding) row[0][5] *= 0.9;
    await page.goto(runAddress(run, 'unbalanced'));
    assert.match(await page.locator('#holding').textContent(), /does not balance: invariant/);
  })
);

test('a chain: what holds its ends', {skip}, () =>
  open({at: 'chain'}, async (page) => {
    const rows = await page.locator('#holding tbody tr').allTextContents();
    assert.match(rows.join('; '), /^node 0[^;]*; node 32[^;]*$/);
    assert.match(await page.locator('#holding').textContent(), /Forces balance/);
  })
);

test('a motion: the time under the slider, its energies, what the joints exert', {skip}, () =>
  open({at: 'motion'}, async (page) => {
    assert.match(await page.locator('.run-slider output').textContent(), /time 10 s of 10/);
    assert.match(await page.locator('#energy .note').textContent(), /is off by 0.25 J at most/);
    assert.equal(await page.locator('#energy .plot .line').count(), 5);
    const rows = () => page.locator('#holding tbody tr').allTextContents();
    assert.match((await rows())[0], /^first on ground4/);
    assert.equal((await rows()).length, 4);
    await slide(page, 1);
    assert.match((await rows())[0], /^first on ground1/);
    assert.match(await page.locator('#holding caption').textContent(), /time 2.5 s/);
  })
);

test('texts are text, whatever they hold', {skip}, () =>
  open({}, async (page) => {
    assert.equal(await page.title(), `${HOSTILE} · Halfway`);
    assert.match(await page.locator('.facts').textContent(), /words <i>and<\/i> more/);
    assert.equal(await page.locator('main b, main i, main script').count(), 0);
    await page.evaluate(() => (document.querySelector('h1').innerHTML = '<b>bold</b>'));
    assert.equal(await page.locator('main b').count(), 1, 'the check can fail');
  })
);

const made = ['joint', 'row', 'motion', 'chain'];
const real = [
  'c1_skewed_torque',
  'c3_buckling',
  'torsional_pendulum',
  'four_bar',
  'turned_offsets',
  'roll_up'
];
const pages = [...made, ...(program ? real : [])];
/** What axe-core looks at: each theme and width, and each sort of run, once.
 * @type {Record<string, [string, number][]>}
 */
const LOOKS = {
  joint: [
    ['light', 1400],
    ['dark', 1400],
    ['light', 400]
  ],
  row: [['light', 1400]],
  motion: [['light', 1400]],
  chain: [['dark', 1400]],
  c3_buckling: [['light', 1400]],
  turned_offsets: [['dark', 400]]
};

for (const at of pages) {
  for (const width of [1400, 400]) {
    test(`${at}: nothing is wider than ${width} px or cut off`, {skip}, () =>
      open({at, width}, async (page) => {
        const wide = await page.evaluate(() => document.documentElement.scrollWidth);
        assert.ok(wide <= width, `the page is ${wide} px wide`);
        const cut = await page.evaluate((isWide) => {
          for (const details of document.querySelectorAll('main details')) details.open = true;
          const boxes = [
            ...document.querySelectorAll(isWide ? '.scroll, .toggles, .controls' : '.toggles, .controls')
          ];
          return boxes.filter((box) => box.scrollWidth > box.clientWidth + 1).map((box) => box.className);
        }, width === 1400);
        assert.deepEqual(cut, []);
      })
    );
  }
  for (const [theme, width] of LOOKS[at] ?? []) {
    test(`${at}: axe-core, ${theme}, ${width} px`, {skip, timeout: 120000}, () =>
      open({at, theme, width}, async (page) => {
        await page.evaluate(() => {
          for (const details of document.querySelectorAll('main details')) details.open = true;
        });
        await page.evaluate(axe);
        const found = await page.evaluate(async () => {
          const {violations} = await window.axe.run(document, {resultTypes: ['violations']});
          return violations.map(
            (v) =>
              `${v.id}: ${v.nodes
                .slice(0, 3)
                .map((n) => n.target)
                .join('; ')}`
          );
        });
        assert.deepEqual(found, []);
      })
    );
  }
}

const schema = JSON.parse(readFileSync(new URL('../../../run.schema.json', import.meta.url), 'utf8'));
for (const def of [schema, ...Object.values(schema.$defs)]) def.additionalProperties = false;
const holds = new Ajv2020({allowUnionTypes: true}).compile(schema);

for (const at of real) {
  test(
    `${at}: the program’s data satisfy the schema, with no field more, and its joint moves`,
    {skip: noProgram},
    () =>
      open({at}, async (page) => {
        const text = await page.locator('#run').textContent();
        assert.equal(holds(JSON.parse(text)), true, JSON.stringify(holds.errors?.slice(0, 3)));
        const moving = () =>
          page.locator('.run3d polyline').evaluateAll((l) => l.map((e) => e.getAttribute('points')));
        const end = await moving();
        await slide(page, 0);
        assert.notDeepEqual(await moving(), end);
      })
  );
}

test('turned_offsets: a title that is a script is a title', {skip: noProgram}, () =>
  open({at: 'turned_offsets'}, async (page) => {
    assert.match(await page.locator('h1').textContent(), /<script>alert\(1\)<\/script>/);
    assert.equal(await page.locator('main script').count(), 0);
  })
);
