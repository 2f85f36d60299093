// The page of `halfway run`: one scene, solved with each formulation.
import {account, promise} from '../account.js';
import {h, section} from '../dom.js';
import {main, start} from '../start.js';
import {answersSection, criticalPart, endedLines, leftOutSection, sceneFacts} from './answers.js';
import {curvesSection} from './curves.js';
import {holdingSection} from './holding.js';
import {energySection} from './energy.js';
import {reactionsSection} from './reactions.js';
import {firstChosen, rowNear, seriesOfRun} from './run_data.js';
import {shapeSection} from './shape.js';
import {answerWords} from './words.js';

/** @typedef {import('../run').RunFile} RunFile */
/** @typedef {{chosen: string, row: number, factor: number, times: number}} State
 *   the formulation that is drawn, its row and load factor, and how many times larger motions are drawn */
/** @typedef {{run: RunFile, series: import('./run_data.js').Series[], state: State,
 *   chosen: () => import('../run').RunCurve, go: (row: number) => void, choose: (key: string) => void,
 *   changed: () => void}} App */

const kPromised = ['curves', 'shape'];

/** @returns {RunFile} */
const dataOf = () => JSON.parse(document.getElementById('run')?.textContent ?? '');

/** @param {RunFile} run @returns {App} */
function appOf(run) {
  const series = seriesOfRun(run);
  const state = {chosen: firstChosen(run), row: 0, factor: 0, times: 1};
  const chosen = () =>
    /** @type {import('../run').RunCurve} */ (series.find((s) => s.key === state.chosen)?.curve);
  /** @type {App} */
  const app = {
    ...{run, series, state, chosen},
    go: (row) => {
      state.row = row;
      state.factor = chosen().rows[row]?.[0] ?? 0;
      app.changed();
    },
    choose: (key) => {
      state.chosen = key;
      app.go(rowNear(chosen(), state.factor));
    },
    changed: () => {}
  };
  return app;
}

/** The parts below the pictures: id, title, content; null where the run has nothing of that sort.
 * @param {App} app @param {{content: any} | null} holding @param {{content: any} | null} energy
 */
const partsOf = (app, holding, energy) =>
  /** @type {[string, string, any][]} */ ([
    ['answers', 'Who agrees', answersSection(app)],
    ['energy', 'Where the energy is', energy && energy.content],
    [
      'holding',
      app.run.curves.some((c) => c.holding.length)
        ? 'Reactions: what holds the nodes'
        : 'Reactions: what the joints exert',
      holding && holding.content
    ],
    ['critical', 'Where it buckles', app.run.critical_axis ? criticalPart(app) : null],
    ['left-out', 'What was left out', leftOutSection(app)]
  ]).filter(([, , content]) => content);

/** @param {RunFile} run */
function build(run) {
  const app = appOf(run);
  const [curves, shape] = [curvesSection(app), shapeSection(app)];
  const holding = run.curves.some((c) => c.holding.length)
    ? holdingSection(app)
    : run.curves.some((c) => c.reactions?.length)
      ? reactionsSection(app)
      : null;
  const energy = run.curves.some((c) => c.energies?.length) ? energySection(app) : null;
  const parts = partsOf(app, holding, energy);
  document.title = `${run.scene.title} · Halfway`;
  document.getElementById('nav')?.append(...parts.map(([id, title]) => h('a', {href: `#${id}`}, title)));
  main().replaceChildren(
    h(
      'section',
      {class: 'headline'},
      h('h1', {}, run.scene.title),
      h('p', {class: 'answer'}, answerWords(run)),
      endedLines(app),
      h(
        'div',
        {class: 'run-motion'},
        h('div', {}, shape.content, h('h2', {}, 'What was solved'), sceneFacts(app)),
        curves.content
      )
    ),
    h(
      'div',
      {class: 'run-parts'},
      parts.map(([id, title, content]) => section(id, title, content, `run-part ${id}`))
    )
  );
  app.changed = () => {
    shape.update();
    curves.update();
    holding?.update();
    energy?.update();
  };
  curves.draw();
  account('curves', run.curves.length ? 'drawn' : 'empty');
  app.go(Math.max(app.chosen().rows.length - 1, 0));
  window.addEventListener('resize', () => {
    curves.draw();
    energy?.draw();
  });
}

start('This run', () => {
  promise(kPromised);
  build(dataOf());
});
