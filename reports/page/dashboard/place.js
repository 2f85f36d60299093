// What the address says: which figure, which series, what is filtered. A link restores it.

/** @typedef {import('./history_data.js').History} History */
/** @typedef {import('./history_data.js').History['series'][0]} Series */
/** @typedef {{figure: string, series: string, show: string, kind: string, run: string}} Words */

/** What the list of changes shows. */
export const SHOWN = {
  regression: 'worse',
  improvement: 'better',
  all: 'all'
};

export class Place {
  /** @param {History} history */
  constructor(history) {
    this.history = history;
    this.series = history.newestSeries();
    this.figure = this.firstFigure();
    /** @type {keyof typeof SHOWN} */
    this.show = 'regression';
    /** Of the joints in accuracy against speed. */
    this.kind = history.pairKinds()[0] ?? '';
    /** Commit at which accuracy against speed is shown; '' for the last. */
    this.run = '';
  }

  /** What a reader most likely wants to see: the newest regression, else the first time, else the first figure. */
  firstFigure() {
    const [change] = this.history.changesOf(this.series.number);
    return change?.figure ?? this.history.pairs[0]?.time ?? 0;
  }

  /** Takes what a hash says; returns what it names that is not there.
   * @param {string} hash
   */
  read(hash) {
    const said = new URLSearchParams(hash.slice(1));
    const missing = [];
    const series = this.history.series.find((s) => s.key === said.get('series'));
    if (series) this.series = series;
    else if (said.has('series')) missing.push(`a machine or build “${said.get('series')}”`);
    const figure = this.history.numbers.get(said.get('figure') ?? '');
    if (figure !== undefined) this.figure = figure;
    else if (said.has('figure')) missing.push(`a figure “${said.get('figure')}”`);
    const show = said.get('show') ?? '';
    if (show in SHOWN) this.show = /** @type {keyof typeof SHOWN} */ (show);
    const kind = said.get('kind') ?? '';
    if (this.history.pairKinds().includes(kind)) this.kind = kind;
    this.run = said.get('run') ?? this.run;
    return missing;
  }

  /** The hash of this place, with what a link changes.
   * @param {Partial<Words>} changed
   */
  hash(changed = {}) {
    const words = {
      figure: this.history.figures.name[this.figure] ?? '',
      series: this.series.key,
      show: this.show === 'regression' ? '' : this.show,
      kind: this.kind === this.history.pairKinds()[0] ? '' : this.kind,
      run: this.run,
      ...changed
    };
    return `#${new URLSearchParams(Object.entries(words).filter(([, value]) => value))}`;
  }

  /** @param {number} figure */
  linkTo(figure) {
    return this.hash({figure: this.history.figures.name[figure]});
  }

  write() {
    window.history.replaceState(null, '', this.hash());
  }
}
