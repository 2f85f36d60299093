// Histories by seed, as ./halfway dashboard writes them: noisy times, exact other figures, and known changes.
import {readFileSync, writeFileSync} from 'node:fs';
import {pathToFileURL} from 'node:url';
import {deflateRawSync, deflateSync} from 'node:zlib';

const kDay = 86400;
const kBegin = 1767225600; // 2026-01-01
const kSpread = 0.008; // low and high of the repetitions, relative to the median

/** mulberry32: uniform in [0, 1), the same for the same seed. @param {number} seed */
export function randomOf(seed) {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

/** Heavy-tailed, about as wide as a normal deviate. */
const noiseOf = (random) => {
  const normal = Math.sqrt(-2 * Math.log(1 - random())) * Math.cos(2 * Math.PI * random());
  return random() < 0.02 ? 6 * Math.abs(normal) : normal;
};
const round = (x) => Number(x.toPrecision(4));
const hex = (random, n) => Array.from({length: n}, () => Math.floor(16 * random()).toString(16)).join('');

const WORDS =
  'kernel tangent inlined batch limit bound atlas scene rounding kept again faster split test'.split(' ');
const titleOf = (random) =>
  Array.from({length: 3 + Math.floor(4 * random())}, () => WORDS[Math.floor(WORDS.length * random())]).join(
    ' '
  );

/**
 * @typedef {{series: number, at: number, factor: number, verdict?: string}} Event  at: position in its series
 * @typedef {{name: string, unit: string, kind: string, better?: string, formulation: string, base: number,
 *   noise?: number, limit?: number, verdict?: string, events?: Event[], only?: number}} Spec
 */

/** How large one figure is at each run of a series. @param {Spec} spec */
function columnOf(spec, series, count, random) {
  const events = (spec.events ?? []).filter((e) => e.series === series);
  const factorAt = (n) => events.filter((e) => e.at <= n).reduce((product, e) => product * e.factor, 1);
  return Array.from({length: count}, (_, n) => {
    const exact = spec.base * factorAt(n);
    return spec.kind === 'time' ? round(exact * (1 + (spec.noise ?? 0.02) * noiseOf(random))) : exact;
  });
}

/** @param {Spec} spec */
const verdictOf = (spec, value) =>
  spec.kind !== 'accuracy'
    ? ''
    : (spec.verdict ?? (spec.limit !== undefined && value > spec.limit ? 'fail' : 'pass'));

/** A stretch of the contract. spreadLast: of how many last runs low and high are kept. @param {Spec} spec */
function stretchOf(spec, series, runs, values, spreadLast) {
  if (spec.kind === 'time') {
    const edge = (sign) => values.slice(-spreadLast).map((v) => round(v * (1 + sign * kSpread)));
    return {series, r: null, v: values, l: edge(-1), h: edge(1)};
  }
  const at = [...values.keys()].filter((n) => n === 0 || values[n] !== values[n - 1]);
  const v = at.map((n) => values[n]);
  const changes = {series, r: at.map((n) => runs[n]), v};
  if (spec.kind === 'count') return changes;
  return {...changes, limit: v.map(() => spec.limit ?? null), verdict: v.map((x) => verdictOf(spec, x))};
}

/** @param {Spec} spec */
function changeOf(spec, figure, {series, at, factor}, run) {
  const before =
    spec.base * spec.events.filter((e) => e.series === series && e.at < at).reduce((f, e) => f * e.factor, 1);
  const isWorse = factor > 1 === (spec.better !== 'up');
  const isTime = spec.kind === 'time';
  const [from, to] = [before, before * factor].map((x) => (isTime ? round(x) : x));
  const digits = Math.log10(factor).toFixed(1);
  return {
    ...{figure, series, run, before: from, after: to},
    verdict: isWorse ? 'regression' : 'improvement',
    ratio: spec.kind === 'accuracy' ? null : factor,
    digits: spec.kind === 'accuracy' ? -Math.log10(factor) : null,
    p: spec.kind === 'time' ? 0.0002 : null,
    text: isTime
      ? `time ${factor > 1 ? '+' : ''}${(100 * factor - 100).toFixed(1)} %`
      : `${from} -> ${to}${spec.kind === 'accuracy' ? `, ${digits.replace('-', '')} digits ${isWorse ? 'lost' : 'gained'}` : ''}`
  };
}

/**
 * @param {{seed?: number, order: number[], specs: Spec[], releases?: Record<number, string>, pairs?: object[],
 *   spreadLast?: number, titles?: Record<number, string>}} what  order: the series of each run
 */
export function makeHistory({
  seed = 1,
  order,
  specs,
  releases = {},
  pairs = [],
  spreadLast = Infinity,
  titles = {}
}) {
  const random = randomOf(seed);
  const count = Math.max(...order, 0) + 1;
  const runsOf = Array.from({length: count}, (_, s) => [...order.keys()].filter((run) => order[run] === s));
  const values = specs.map((spec) =>
    runsOf.map((runs, s) => ((spec.only ?? s) === s ? columnOf(spec, s, runs.length, random) : null))
  );
  const releaseRuns = Object.keys(releases).map(Number);
  const lastRelease = releaseRuns.length ? Math.max(...releaseRuns) : -1;
  const column = (/** @type {(spec: Spec) => any} */ of) => specs.map(of);
  const index = {
    ...{schema: 'halfway-dashboard', version: 1, generated: '2026-11-29T04:00:00Z'},
    command: './halfway dashboard',
    release: lastRelease < 0 ? null : {run: lastRelease, name: releases[lastRelease]},
    machines: ['AMD EPYC', 'Intel Xeon Gold'].map((cpu) => ({
      cpu,
      cores: 2,
      caches: '32K 512K 16M',
      microcode: '0xa20'
    })),
    series: runsOf.map((_, s) => ({
      machine: s % 2,
      compiler: s < 2 ? 'g++ 12.2.0' : 'clang++ 14.0.6',
      flags: '-O3',
      build_type: 'Release',
      isa: 'avx512'
    })),
    runs: {
      commit: order.map(() => hex(random, 12)),
      date: order.map((_, i) => kBegin + i * kDay),
      title: order.map((_, i) => titles[i] ?? titleOf(random)),
      dirty: order.map((_, i) => (i === 3 ? 1 : 0)),
      series: order,
      load: order.map(() => round(random())),
      release: order.map((_, i) => releases[i] ?? '')
    },
    figures: {
      ...{name: column((s) => s.name), unit: column((s) => s.unit), kind: column((s) => s.kind)},
      ...{better: column((s) => s.better ?? 'down'), formulation: column((s) => s.formulation)}
    },
    latest: runsOf.map((runs, s) => {
      const value = values.map((v) => v[s]?.at(-1) ?? null);
      return {
        ...{run: runs.at(-1) ?? 0, value, limit: column((spec) => spec.limit ?? null)},
        verdict: specs.map((spec, i) => (value[i] === null ? '' : verdictOf(spec, value[i])))
      };
    }),
    changes: specs.flatMap((spec, i) =>
      (spec.events ?? []).map((e) => changeOf(spec, i, e, runsOf[e.series][e.at]))
    ),
    pairs
  };
  const blocks = specs.map((spec, i) => ({
    s: runsOf.flatMap((runs, s) => (values[i][s] ? [stretchOf(spec, s, runs, values[i][s], spreadLast)] : []))
  }));
  return {index, blocks};
}

export const HOSTILE = '<script>alert(1)</script>';
const NAMES = ['attached_a', 'invariant', 'quaternion', HOSTILE];
const KINDS = ['angular', 'linear'];

/** @param {string} f formulation @param {string} k kind of joint */
const pairSpecs = (f, k, i) => [
  {name: `${f}/${k}/residual/kernel`, unit: 'ns per joint', kind: 'time', formulation: f, base: 25 + 20 * i},
  {
    name: `${f}/${k}/modelling_error`,
    unit: 'relative',
    kind: 'accuracy',
    formulation: f,
    base: 10 ** -(2 + 3 * i),
    limit: 10 ** -(1 + 3 * i)
  }
];

/** Four formulations on two machines, of which one has no times; 60 runs and 12; changes of every sort. */
export function smallHistory() {
  const specs = NAMES.flatMap((f, i) => KINDS.flatMap((k) => pairSpecs(f, k, i)));
  const named = (name) => specs.find((s) => s.name === name);
  for (const s of specs) if (s.kind === 'time') s.only = 0;
  named('invariant/angular/residual/kernel').events = [{series: 0, at: 42, factor: 1.1}];
  named('attached_a/angular/residual/kernel').events = [
    {series: 0, at: 20, factor: 1.25},
    {series: 0, at: 30, factor: 0.8}
  ];
  named('attached_a/linear/residual/kernel').events = [{series: 0, at: 48, factor: 0.9}];
  named('invariant/angular/modelling_error').events = [{series: 0, at: 50, factor: 10 ** 0.5}];
  named('quaternion/angular/modelling_error').events = [{series: 1, at: 6, factor: 20}];
  specs.push(
    {name: 'frames/other_axes', unit: 'eps', kind: 'accuracy', formulation: '', base: 2, limit: 8},
    {
      name: 'attached_a/angular/node_order',
      unit: 'relative',
      kind: 'accuracy',
      formulation: 'attached_a',
      base: 0.5,
      limit: 1,
      verdict: 'known_failure'
    },
    {
      name: 'invariant/angular/flops',
      unit: 'operations',
      kind: 'count',
      formulation: 'invariant',
      base: 334,
      events: [{series: 0, at: 10, factor: 0.5}]
    }
  );
  const order = Array.from({length: 72}, (_, i) => (i % 6 === 0 ? 1 : 0));
  const number = (name) => specs.findIndex((s) => s.name === name);
  const pairs = NAMES.flatMap((formulation) =>
    KINDS.map((kind) => ({
      ...{formulation, kind},
      time: number(`${formulation}/${kind}/residual/kernel`),
      error: number(`${formulation}/${kind}/modelling_error`)
    }))
  );
  return makeHistory({
    order,
    specs,
    pairs,
    releases: {10: '0.1.0', 40: '0.2.0'},
    titles: {61: `Faster <b>tables</b>, "twice"`}
  });
}

const kRuns = 10000;
const kTimes = 464;
const kOthers = 4536;

/** 10 000 runs of 5 000 figures on one machine, with changes at known runs. */
export function largeHistory(seed = 7, runs = kRuns) {
  const random = randomOf(seed);
  const event = (factor) => ({series: 0, at: 20 + Math.floor((runs - 40) * random()), factor});
  const formulations = Array.from({length: 17}, (_, i) => `formulation_${i}`);
  const specOf = (i, kind) => ({
    name: `${formulations[i % 17]}/angular/${kind}_${i}`,
    unit: kind === 'time' ? 'ns per joint' : 'relative',
    ...{
      kind,
      formulation: formulations[i % 17],
      base: kind === 'time' ? round(5 + 900 * random()) : 1e-15 * (1 + random())
    },
    ...(kind === 'accuracy' ? {limit: 1e-14} : {}),
    events: Array.from({length: i % 20 === 0 ? 2 : 0}, () => event(kind === 'time' ? 1.1 : 1.3))
  });
  const times = Array.from({length: kTimes}, (_, i) => specOf(i, 'time'));
  const others = Array.from({length: kOthers}, (_, i) => specOf(i, 'accuracy'));
  const pairs = formulations.map((formulation, i) => ({
    formulation,
    kind: 'angular',
    time: i,
    error: kTimes + i
  }));
  const order = new Array(runs).fill(0);
  const releases = {[Math.floor(runs / 2)]: '1.0.0'};
  return makeHistory({seed, order, specs: [...times, ...others], pairs, releases, spreadLast: 200});
}

/** @param {unknown} json @param {boolean} isRaw */
const pack = (json, isRaw) =>
  (isRaw ? deflateRawSync : deflateSync)(JSON.stringify(json), {level: 9}).toString('base64');

/** A list of [id, base64] as the page reads them. @param {{index: object, blocks: object[]}} history */
export const packed = ({index, blocks}, isRaw = true) => [
  ['index', pack(index, isRaw)],
  ...blocks.map((block, i) => [`f${i}`, pack(block, isRaw)])
];

/** The bundle with blocks in the place of its placeholder, as C++ writes it. Returns its address.
 * @param {string[][]} list @param {string} name of the file, beside the bundle
 */
export function dashboardAddress(list, name) {
  const bundle = process.env.DASHBOARD_BUNDLE ?? '';
  const file = `${bundle}.${process.pid}.${name}.html`;
  const text = list
    .map(([id, base64]) => `<script type="text/plain" id="${id}">${base64}</script>\n`)
    .join('');
  writeFileSync(
    file,
    readFileSync(bundle, 'utf8').replace('<!-- halfway data -->\n', () => text)
  );
  return pathToFileURL(file).href;
}
