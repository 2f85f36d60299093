// The report page: sections in reading order, all from the results inlined in the page.
import {accuracyFigure} from './charts/accuracy.js';
import {bucklingFigure} from './charts/buckling.js';
import {curvesFigure} from './charts/curves.js';
import {loopWorkFigure} from './charts/loop_work.js';
import {reportError, seal} from './chart.js';
import {Results} from './data.js';
import {h} from './dom.js';
import {findingsTable} from './sections/findings_table.js';
import {formulationsTable} from './sections/formulations_table.js';
import {firstKind, headline} from './sections/headline.js';
import {leftOut} from './sections/left_out.js';
import {propertyMatrix} from './sections/matrix.js';
import {provenance} from './sections/provenance.js';
import {reading} from './sections/reading.js';
import {solidsSection} from './sections/solids.js';
import {speedSection} from './sections/speed.js';
import {stabilitySection} from './sections/stability.js';
import {table1} from './sections/table1.js';

const THETA = {theta_x: 'θ₁', theta_y: 'θ₂', theta_z: 'θ₃'};
const panel = (output) => ({output, title: THETA[output], unit: 'rad'});
const MOMENT = {title: 'moment M', unit: 'N·m'};
const FORCE = {title: 'force f in each direction', unit: 'N'};

/** The paper's figures: its scenes, its axes. */
const FIGURES = [
  {
    id: 'fig3',
    scene: 'c2',
    title: 'Fig. 3: parallelepiped, small moment',
    load: MOMENT,
    panels: [panel('theta_y')],
    caption:
      'Rotation about the axis that carries no moment. The paper reports that its 3D finite elements lie on the invariant curve.'
  },
  {
    id: 'fig6',
    scene: 'c4',
    title: 'Fig. 6: frustum, small moment',
    load: MOMENT,
    panels: [panel('theta_y')],
    caption: 'An asymmetric part: the paper fits its finite elements by ξ = 0.55 rather than 0.5.'
  },
  {
    id: 'fig4',
    scene: 'c3',
    title: 'Fig. 4: parallelepiped, large moment and buckling',
    load: MOMENT,
    wide: true,
    panels: ['theta_x', 'theta_y', 'theta_z'].map((o) => ({...panel(o), height: 300})),
    caption: 'The three components of the rotation vector up to 1800 N·m.'
  },
  {
    id: 'fig7',
    scene: 'c6',
    title: 'Fig. 7: compression with shear',
    load: FORCE,
    panels: [panel('theta_y')],
    caption:
      'Bending that a linear analysis misses, under equal compression along axis 1 and shear along axis 3.'
  },
  {
    id: 'fig9',
    scene: 'c7',
    title: 'Fig. 9: elastomeric bearing',
    load: FORCE,
    panels: [panel('theta_z')],
    caption: 'Quadratic in the force; the paper fits its finite elements by ξ = −0.435917.'
  }
];

const NAV = [
  ['accuracy', 'Accuracy'],
  ['formulations', 'Formulations'],
  ['speed', 'Speed'],
  ['table1', 'Table 1'],
  ['figures', 'Figures'],
  ['stability', 'Failures'],
  ['solids', '3D truth'],
  ['properties', 'Properties'],
  ['findings', 'Findings'],
  ['left-out', 'Left out'],
  ['reading', 'Reading'],
  ['provenance', 'Source']
];

function build(results, raw) {
  const kind = firstKind(results);
  const figures = FIGURES.map((f) => {
    const figure = curvesFigure(results, f);
    if (f.wide) figure.classList.add('wide');
    return figure;
  });
  document.getElementById('nav').append(...NAV.map(([id, text]) => h('a', {href: `#${id}`}, text)));
  document.getElementById('subtitle').textContent =
    `deformable joints · ${results.context.commit} · ${results.context.date}`;
  document
    .getElementById('main')
    .append(
      headline(results, kind),
      h('div', {class: 'first'}, accuracyFigure(results, kind), formulationsTable(results)),
      speedSection(results, kind),
      table1(results),
      h(
        'section',
        {'aria-labelledby': 'figures'},
        h('h2', {id: 'figures'}, 'The paper’s figures, computed again'),
        h('div', {class: 'figures'}, figures, bucklingFigure(results), loopWorkFigure(results))
      ),
      stabilitySection(results),
      solidsSection(results),
      propertyMatrix(results),
      findingsTable(results),
      leftOut(results),
      reading(),
      provenance(results, raw)
    );
}

const logged = console.error;
console.error = (...parts) => {
  reportError(parts.join(' '));
  logged(...parts);
};
window.addEventListener('error', (event) => reportError(event.error ?? event.message));
window.addEventListener('unhandledrejection', (event) => reportError(event.reason));

const theme = new URLSearchParams(location.search).get('theme');
if (theme === 'dark' || theme === 'light') document.documentElement.dataset.theme = theme;

try {
  const raw = document.getElementById('results').textContent;
  build(new Results(JSON.parse(raw)), raw);
  seal();
} catch (error) {
  document
    .getElementById('main')
    .append(h('p', {class: 'empty'}, `The results cannot be shown: ${error.message}`));
  reportError(error);
}
