// The dashboard: what got worse, since when, and how sure that is; from the data blocks inlined in the page.
import {account} from '../account.js';
import {h, section, select} from '../dom.js';
import {plural} from '../format.js';
import {main, start} from '../start.js';
import {Blocks} from './blocks.js';
import {changesSection} from './changes.js';
import {History, indexFault} from './history_data.js';
import {Place} from './place.js';
import {releaseSection} from './release.js';
import {scatterSection} from './scatter.js';
import {Sparks} from './spark.js';
import {stateSection} from './state.js';
import {blockFault, trendOf} from './trend_data.js';
import {trendSection} from './trend.js';

/** What the sections work with.
 * @typedef {object} App
 * @property {History} history
 * @property {Place} place
 * @property {Sparks} sparks
 * @property {(figure: number, series: number) => Promise<import('./trend_data.js').Trend>} trend
 * @property {(to: {figure: number}) => void} go
 */

const blocks = new Blocks((id) => document.getElementById(id)?.textContent);

/** @param {History} history */
const trendReader = (history) => async (/** @type {number} */ figure, /** @type {number} */ series) => {
  const name = history.figures.name[figure];
  /** @type {import('./history').FigureBlock} */
  const block = await blocks.get(`f${figure}`, name, blockFault(history));
  const stretch = block.s.find((s) => s.series === series);
  return trendOf(stretch, history.series[series].runs, history.figures.kind[figure] !== 'time');
};

/** @param {App} app @param {{id: string, show: () => void | Promise<void>}[]} sections @param {HTMLElement} said */
function follow(app, sections, said) {
  const {place} = app;
  const showSome = (/** @type {string[]} */ ids) => {
    for (const {id, show} of sections) if (!ids.length || ids.includes(id)) void show();
  };
  app.go = ({figure}) => {
    place.figure = figure;
    showSome(['trend']);
    place.write(); // takes as long as drawing: while the data are inflated
  };
  window.addEventListener('hashchange', () => {
    if (location.hash.includes('=')) {
      const before = place.series;
      say(place.read(location.hash));
      showSome(before === place.series ? ['trend'] : []);
      if (before === place.series) document.getElementById('trend')?.scrollIntoView();
    }
    place.write();
  });
  const say = (/** @type {string[]} */ missing) => {
    said.textContent = missing.length
      ? `The link names ${missing.join(' and ')}, which this history does not hold.`
      : '';
    said.hidden = !missing.length;
  };
  say(place.read(location.hash));
  showSome([]);
}

/** @param {App} app */
function seriesChoice({history, place}) {
  const options = history.series.map((s) => ({
    key: s.key,
    label: `${s.label} (${plural(s.runs.length, 'run')})`
  }));
  const box = h('div', {class: 'controls'});
  const show = () =>
    box.replaceChildren(
      select('Machine and build', options, place.series.key, (key) => {
        location.hash = place.hash({series: key, run: ''});
      })
    );
  return {content: box, show, id: 'series'};
}

/** @param {History} history */
function build(history) {
  const place = new Place(history);
  const app = /** @type {App} */ ({history, place, trend: trendReader(history)});
  app.sparks = new Sparks(app);
  const parts = [
    {id: 'changes', title: 'What got worse', ...changesSection(app)},
    {id: 'state', title: 'Each formulation now', ...stateSection(app)},
    {id: 'trend', title: 'Trend of a figure', ...trendSection(app)},
    {id: 'scatter', title: 'Accuracy against speed, over time', ...scatterSection(app)},
    {id: 'release', title: 'Since the last release', ...releaseSection(app)}
  ];
  const machine = seriesChoice(app);
  const said = h('p', {class: 'empty', role: 'status', hidden: true});
  document.getElementById('nav')?.append(...parts.map(({id, title}) => h('a', {href: `#${id}`}, title)));
  document.getElementById('subtitle')?.append(` · ${history.generated.slice(0, 10)}`);
  main().append(
    h('h1', {class: 'sr'}, 'History of accuracy and speed'),
    said,
    machine.content,
    ...parts.map(({id, title, content}) => section(id, title, content)),
    h(
      'p',
      {class: 'note'},
      'Written by ',
      h('code', {class: 'command'}, history.command),
      ` at ${history.generated}.`
    )
  );
  follow(app, [machine, ...parts], said);
}

start('The history', async () => {
  account('history', 'waiting');
  const index = await blocks.get('index', 'the history', indexFault);
  if (!index.runs.commit.length) {
    main().append(
      h('h1', {}, 'History of accuracy and speed'),
      h(
        'p',
        {class: 'empty'},
        'This history holds no run yet. Add one: ',
        h('code', {}, './halfway history add REPORT_FOLDER')
      )
    );
  } else build(new History(index));
  account('history', 'drawn');
});
