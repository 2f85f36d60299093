// The history with the look-ups that several sections need. No document here.
import {KINDS} from '../data/accuracy_data.js';
import {hashOf} from '../palette.js';

/** @typedef {import('./history').Index} Index */
/** @typedef {import('./history').Change} Change */
/** A change, and the next improvement of the same figure in the same series, if any.
 * @typedef {Change & {mended: Change | null}} Story */

const SCHEMA = 'halfway-dashboard';
const VERSION = 1;

/** Columns of one table must have one length. @param {Record<string, any>} columns */
function uneven(columns) {
  const [[first, {length}], ...others] = Object.entries(columns);
  const bad = others.find(([, column]) => column.length !== length);
  return bad ? `${bad[0]} has ${bad[1].length} entries, ${first} has ${length}` : '';
}

/** The first number that leads to nothing, in words, or ''. @param {Index} index */
function astray({runs, figures, series, latest, changes, pairs, release}) {
  const counts = {run: runs.commit.length, figure: figures.name.length, series: series.length};
  /** @type {[string, keyof typeof counts, number[]][]} */
  const named = [
    ['a run', 'series', runs.series],
    ['a latest', 'run', runs.commit.length ? latest.map((l) => l.run) : []],
    ['a change', 'run', changes.map((c) => c.run)],
    ['a change', 'figure', changes.map((c) => c.figure)],
    ['a change', 'series', changes.map((c) => c.series)],
    ['a pair', 'figure', pairs.flatMap((p) => [p.time, p.error])],
    ['the release', 'run', release ? [release.run] : []]
  ];
  for (const [who, what, numbers] of named) {
    const bad = numbers.find((n) => !(n >= 0 && n < counts[what]));
    if (bad !== undefined) return `${who} names ${what} ${bad}, of ${counts[what]}`;
  }
  return '';
}

/** What is wrong with an index, or ''. @param {Index} index */
export function indexFault(index) {
  if (index?.schema !== SCHEMA || index.version !== VERSION) {
    return `schema ${index?.schema} version ${index?.version}; this page reads ${SCHEMA} version ${VERSION}`;
  }
  const faults = [uneven(index.runs), uneven(index.figures)];
  for (const {value, limit, verdict} of index.latest) {
    faults.push(uneven({figures: index.figures.name, value, limit, verdict}));
  }
  if (index.latest.length !== index.series.length) faults.push('not one latest run for each series');
  return faults.find(Boolean) ?? astray(index);
}

const dayOf = (/** @type {number} */ seconds) => new Date(1000 * seconds).toISOString().slice(0, 10);

export class History {
  /** @param {Index} index */
  constructor(index) {
    Object.assign(this, index);
    this.runs = index.runs;
    this.figures = index.figures;
    this.latest = index.latest;
    this.pairs = index.pairs;
    this.release = index.release;
    this.generated = index.generated;
    this.command = index.command;
    this.numbers = new Map(index.figures.name.map((name, i) => [name, i]));
    this.series = index.series.map((s, i) => this.describe(index, s, i));
    this.labelSeries();
    index.runs.series.forEach((s, run) => this.series[s]?.runs.push(run));
    /** @type {Story[]} */
    this.changes = index.changes.map((c) => ({...c, mended: null}));
    this.findMended();
  }

  /** @param {Index} index @param {Index['series'][0]} one @param {number} number */
  describe(index, one, number) {
    const machine = index.machines[one.machine] ?? {
      cpu: 'unknown machine',
      cores: 0,
      caches: '',
      microcode: ''
    };
    const facts = {
      machine: `${machine.cpu}, ${machine.cores} cores`,
      compiler: one.compiler,
      isa: one.isa,
      build_type: one.build_type,
      flags: one.flags,
      caches: machine.caches,
      microcode: machine.microcode
    };
    /** A link keeps its meaning when series are added or reordered. */
    const key = hashOf(JSON.stringify(facts)).toString(36);
    return {number, key, facts, label: '', runs: /** @type {number[]} */ ([])};
  }

  /** By what everyone asks for, and by what tells it from the others. */
  labelSeries() {
    const asked = ['machine', 'compiler', 'isa'];
    const differing = ['build_type', 'flags', 'caches', 'microcode'].filter(
      (f) => new Set(this.series.map((s) => s.facts[f])).size > 1
    );
    for (const s of this.series) {
      s.label = [...asked, ...differing]
        .map((f) => s.facts[f])
        .filter(Boolean)
        .join(' · ');
    }
  }

  findMended() {
    /** @type {Map<string, Story>} */
    const open = new Map();
    const byRun = [...this.changes].sort((a, b) => a.run - b.run);
    for (const change of byRun) {
      const key = `${change.figure}/${change.series}`;
      const earlier = open.get(key);
      if (change.verdict === 'regression') open.set(key, change);
      else if (earlier) {
        earlier.mended = change;
        open.delete(key);
      }
    }
  }

  /** The series that was measured last. */
  newestSeries() {
    return this.series[this.runs.series.at(-1) ?? 0];
  }

  /** @param {number} run */
  day(run) {
    return dayOf(this.runs.date[run]);
  }

  /** The commit as people write it. @param {number} run */
  commit(run) {
    return `${this.runs.commit[run].slice(0, 10)}${this.runs.dirty[run] ? ' + changes' : ''}`;
  }

  /** Has a regression made a figure fail, which it still does? @param {Story} c */
  fails(c) {
    return isOpen(c) && this.latest[c.series].verdict[c.figure] === 'fail';
  }

  /** What fails comes first, what was mended last; else newest first, and of one run the largest first.
   * @param {number} series @param {(c: Story) => boolean} wanted
   */
  changesOf(series, wanted = () => true) {
    const size = (/** @type {Story} */ c) => Math.abs(c.digits ?? 0) + Math.abs(Math.log(c.ratio ?? 1));
    const rank = (/** @type {Story} */ c) =>
      c.mended ? 3 : c.verdict !== 'regression' ? 2 : this.fails(c) ? 0 : 1;
    return this.changes
      .filter((c) => c.series === series && wanted(c))
      .sort((a, b) => rank(a) - rank(b) || b.run - a.run || size(b) - size(a));
  }

  /** Regressions that stand. @param {number} series */
  open(series) {
    return this.changesOf(series, isOpen);
  }

  /** Kinds of the pairs, in the order of the report. */
  pairKinds() {
    const order = KINDS.map((k) => k.key);
    const kinds = [...new Set(this.pairs.map((p) => p.kind))];
    return kinds.sort((a, b) => order.indexOf(a) - order.indexOf(b));
  }

  /** Figures whose name holds every word, by kind, formulation and verdict now where these are given.
   * @param {{series: number, words?: string, kind?: string, formulation?: string, verdict?: string}} wanted
   */
  find({series, words = '', kind = '', formulation = '', verdict = ''}) {
    const parts = words.toLowerCase().split(/\s+/).filter(Boolean);
    const {name, kind: kinds, formulation: formulations} = this.figures;
    return [...name.keys()].filter(
      (i) =>
        (!kind || kinds[i] === kind) &&
        (!formulation || formulations[i] === formulation) &&
        (!verdict || this.latest[series].verdict[i] === verdict) &&
        parts.every((w) => name[i].toLowerCase().includes(w))
    );
  }
}

export const isOpen = (/** @type {Story} */ c) => c.verdict === 'regression' && !c.mended;
