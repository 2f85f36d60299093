// The data blocks of the dashboard, as ./halfway dashboard writes them (schema "halfway-dashboard", version 1).

export type Kind = 'accuracy' | 'time' | 'count';
export type Verdict = 'pass' | 'fail' | 'known_failure' | '';

/** Columns, by rising date; date in seconds since 1970. */
export interface Runs {
  commit: string[];
  date: number[];
  title: string[];
  dirty: number[];
  series: number[];
  load: Array<number | null>;
  release: string[];
}

/** Columns. */
export interface Figures {
  name: string[];
  unit: string[];
  kind: Kind[];
  better: Array<'down' | 'up' | 'none'>;
  formulation: string[];
}

/** A change point of one figure in one series; digits: how many decimal digits of accuracy it cost or won. */
export interface Change {
  figure: number;
  series: number;
  run: number;
  before: number | null;
  after: number | null;
  verdict: 'regression' | 'improvement';
  ratio: number | null;
  digits: number | null;
  p: number | null;
  text: string;
}

/** What is measured together, for accuracy against speed. */
export interface Pair {
  formulation: string;
  kind: string;
  time: number;
  error: number;
}

export interface Latest {
  run: number;
  value: Array<number | null>;
  limit: Array<number | null>;
  verdict: Verdict[];
}

export interface Index {
  schema: string;
  version: number;
  generated: string;
  command: string;
  release: {run: number; name: string} | null;
  machines: Array<{cpu: string; cores: number; caches: string; microcode: string}>;
  series: Array<{machine: number; compiler: string; flags: string; build_type: string; isa: string}>;
  runs: Runs;
  figures: Figures;
  latest: Latest[];
  changes: Change[];
  pairs: Pair[];
}

/** One figure in one series. Times: one entry a run (r null: every run of the series). Others: only the runs at
 * which the value changed; it holds until the next. v null: not measured, or gone. l and h may be shorter: they are
 * of the last runs. */
export interface Stretch {
  series: number;
  r: number[] | null;
  v: Array<number | null>;
  l?: Array<number | null>;
  h?: Array<number | null>;
  limit?: Array<number | null>;
  verdict?: Verdict[];
}

export interface FigureBlock {
  s: Stretch[];
}
