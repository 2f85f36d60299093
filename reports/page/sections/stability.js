// Where does it fail? The atlas first, then each failure's own chart.
import {failuresOf} from '../data/atlas_data.js';
import {atlasFigure} from '../charts/stability/atlas.js';
import {basinsFigure} from '../charts/stability/basins.js';
import {bucklingFigure} from '../charts/stability/buckling.js';
import {criticalLoadsFigure} from '../charts/stability/critical_loads.js';
import {criticalModesFigure} from '../charts/stability/critical_modes.js';
import {energyFigure} from '../charts/stability/energy.js';
import {energyLoopsFigure} from '../charts/stability/energy_loops.js';
import {loopWorkFigure} from '../charts/stability/loop_work.js';
import {pathsFigure} from '../charts/stability/paths.js';
import {digitsLostFigure} from '../charts/stability/range_errors.js';
import {turnsFigure} from '../charts/stability/range_turns.js';

/** @type {(results: any) => import('../parts.js').PartSpec[]}
 * @param {import('../data.js').Results} results
 */
const bucklingParts = (results) => [
  {
    id: 'buckling',
    title: 'Buckling loads (4.1.2)',
    charts: ['buckling'],
    build: () => bucklingFigure(results)
  },
  {
    id: 'paths',
    title: 'Paths through buckling',
    charts: ['paths'],
    build: () => pathsFigure(results)
  },
  {
    id: 'critical-loads',
    title: 'Divergence or flutter',
    charts: ['critical-loads'],
    build: () => criticalLoadsFigure(results)
  },
  {
    id: 'critical-modes',
    title: 'On the way to the critical moment',
    charts: ['critical-modes'],
    build: () => criticalModesFigure(results)
  }
];

/** @type {(results: any) => import('../parts.js').PartSpec[]}
 * @param {import('../data.js').Results} results
 */
const energyParts = (results) => [
  {id: 'energy', title: 'Energy in motion', charts: ['energy-runs'], build: () => energyFigure(results)},
  {
    id: 'energy-loops',
    title: 'Work round closed loops, over the amplitude',
    charts: ['energy-loops'],
    half: true,
    build: () => energyLoopsFigure(results)
  },
  {
    id: 'loop-work',
    title: 'How that work grows with the amplitude',
    charts: ['loop-work'],
    half: true,
    build: () => loopWorkFigure(results)
  }
];

/** @type {(results: any) => import('../parts.js').PartSpec[]}
 * @param {import('../data.js').Results} results
 */
export const stabilityParts = (results) => [
  {
    id: 'atlas',
    title: 'Failure atlas',
    charts: failuresOf(results).map((f) => `atlas-${f.key}`),
    build: () => atlasFigure(results)
  },
  ...bucklingParts(results),
  ...energyParts(results),
  {
    id: 'basins',
    title: 'Newton in a single load step',
    charts: ['basins-loads', 'basins-starts'],
    build: () => basinsFigure(results)
  },
  {id: 'turns', title: 'Beyond half a turn', charts: ['range-turns'], build: () => turnsFigure(results)},
  {
    id: 'digits-lost',
    title: 'Digits lost, and to what',
    charts: ['range-errors'],
    build: () => digitsLostFigure(results)
  }
];
