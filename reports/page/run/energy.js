// Where the energy of a motion is, of the chosen formulation: kinetic, strain, dissipated, the work of the loads, and
// what the balance of them misses.
import {h, swatch} from '../dom.js';
import {short} from '../format.js';
import {seriesLook} from '../palette.js';
import {linesChart} from './lines.js';

/** @typedef {import('./run.js').App} App */

const kEnergies = ['kinetic', 'strain', 'dissipated', 'work of the loads'];
/** Whose looks the lines have: far apart, and the same in every run. */
const kLooks = ['attached_a', 'invariant', 'potential', 'conformal', 'rod'];

/** @param {number[][]} energies kinetic, strain, dissipated, work @returns {number[]} what appears or is lost */
export function balanceOf(energies) {
  const total = energies.map(([kinetic, strain, dissipated, work]) => kinetic + strain + dissipated - work);
  return total.map((x) => x - total[0]);
}

/** Lines of the energies that are there at all, and their balance. @param {App} app */
function energySeries({chosen}) {
  const {rows, energies = [], converged} = chosen();
  const columns = kEnergies.map((name, k) => ({name, look: kLooks[k], values: energies.map((e) => e[k])}));
  const shown = columns.filter(({values}) => values.some((x) => x !== 0));
  return [...shown, {name: 'balance', look: kLooks[4], values: balanceOf(energies)}].map(
    ({name, look, values}) => ({
      ...{key: name, look: seriesLook(look ?? name, 0), on: true},
      curve: /** @type {any} */ ({
        ...{converged, errors: []},
        rows: values.map((value, i) => [rows[i][0], value])
      })
    })
  );
}

/** @param {App} app */
function energyNote({chosen}) {
  const {energies = [], label} = chosen();
  const largest = Math.max(...energies.flatMap((e) => e.map(Math.abs)));
  const off = Math.max(...balanceOf(energies).map(Math.abs));
  return `${label}: the balance, kinetic + strain + dissipated − work since the start, is off by ${short(off, 2)} J at most, ${short(off / (largest || 1), 2)} of the largest energy: the integration, or a law that makes or loses energy.`;
}

/** @param {App} app */
export function energySection(app) {
  const box = h('div', {class: 'chart'});
  const legend = h('p', {class: 'run-names'});
  const note = h('p', {class: 'note'});
  let drawn = '';
  /** @type {ReturnType<typeof linesChart> | undefined} */
  let chart;
  const draw = () => {
    const shown = energySeries(app);
    chart = linesChart({
      ...{shown, column: 1, title: 'energy, J', over: 'time, s'},
      ...{factorEnd: app.run.path.factor_end, width: Math.max(box.clientWidth, 280)}
    });
    drawn = app.state.chosen;
    legend.replaceChildren(...shown.map((s) => h('span', {class: 'name'}, swatch(s.look), s.key)));
    note.textContent = energyNote(app);
    box.replaceChildren(chart.drawn);
    chart.point(app.state.factor);
  };
  return {
    content: h('figure', {}, box, legend, note),
    draw,
    update: () => (drawn === app.state.chosen ? chart?.point(app.state.factor) : draw())
  };
}
