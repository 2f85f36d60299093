// Two panels that share their series: error against phi, and the time of each; the legend isolates one.
import {Chart} from '../chart.js';
import {h, isolate, swatch} from '../dom.js';
import {phiSpec, rowsOverPhi, rowsOverRanges, timeSpec} from './stability/phi_lines.js';

const timesOf = (series) => series.map((s) => ({series: s.key, label: s.label, ns: s.timing.ns}));

/** id: of the charts; noun: what a series is; looksOf(series): key -> {color, dash}; over: 'phi' or 'ranges';
 * log, title: of the time axis. */
export class SeriesPanels {
  constructor({id, noun, looksOf, tableOf, over, log = false, title}) {
    this.noun = noun;
    this.looksOf = looksOf;
    this.tableOf = tableOf;
    this.over = over;
    this.log = log;
    this.title = title;
    this.error = new Chart(`${id}-error`, `Error against φ, one line per ${noun}, logarithmic.`);
    this.time = new Chart(`${id}-time`, `Time of each ${noun}.`);
    this.legend = h('div');
    this.table = h('div');
  }

  /** series: {key, label, timing}; another list isolates none at first. */
  show(series) {
    const looks = this.looksOf(series);
    const items = series.map((s) => ({key: s.key, label: s.label, swatch: swatch(looks[s.key])}));
    this.legend.replaceChildren(
      isolate(`Isolate a ${this.noun}`, items, (only) => this.draw(series, looks, only))
    );
    this.table.replaceChildren(series.length ? this.tableOf(series) : '');
    this.draw(series, looks, null);
  }

  draw(series, looks, only) {
    const rows = this.over === 'phi' ? rowsOverPhi(series) : rowsOverRanges(series);
    if (rows.length) this.error.draw(phiSpec(rows, looks, only, this.over));
    else this.error.say(`No ${this.noun} has an error by range of φ for this choice.`);
    if (series.length)
      this.time.draw(timeSpec(timesOf(series), looks, {only, log: this.log, title: this.title}));
    else this.time.say(`No ${this.noun} is timed for this choice.`);
  }
}
