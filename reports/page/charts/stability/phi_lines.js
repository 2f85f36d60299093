// Error against phi, one line per series: over a logarithmic axis, or range by range where many crowd at pi.
import {AT_DECADES, isNarrow} from '../../chart.js';
import {full, isNumber, nanoseconds} from '../../format.js';
import {nearPi, rangeKey, rangeLabel, rangesOf, roundingFloor} from '../../data/speed_data.js';

const FADED = 0.12;
const shown = (t, error) => Math.max(error, roundingFloor(t));

/** Rows over phi itself; all ranges next to pi make one point there. */
export function rowsOverPhi(series) {
  return series.flatMap(({key, label, timing}) => {
    const errors = timing.errors.filter((e) => isNumber(e.error) && e.to > 0);
    const row = (phi, error, range) => ({
      series: key,
      label,
      phi,
      error: shown(timing, error),
      shown: full(error),
      range
    });
    const last = errors.filter(nearPi);
    const before = errors
      .filter((e) => !nearPi(e))
      .map((e) => row(e.from > 0 ? Math.sqrt(e.from * e.to) : e.to, e.error, rangeLabel(e)));
    return last.length
      ? [
          ...before,
          row(
            Math.PI,
            Math.max(...last.map((e) => e.error)),
            `${rangeLabel({from: last[0].from, to: last.at(-1).to})}, worst`
          )
        ]
      : before;
  });
}

/** Rows over the ranges in their order. */
export function rowsOverRanges(series) {
  const ranges = rangesOf(series.map((s) => s.timing)).map(rangeKey);
  return series.flatMap(({key, label, timing}) =>
    timing.errors
      .filter((e) => isNumber(e.error))
      .map((e) => ({
        series: key,
        label,
        place: ranges.indexOf(rangeKey(e)),
        range: rangeLabel(e),
        from: e.from,
        error: shown(timing, e.error),
        shown: full(e.error)
      }))
  );
}

const Y = {
  field: 'error',
  type: 'quantitative',
  scale: {type: 'log', padding: 8},
  title: 'numerical error, relative',
  axis: {labelExpr: 'power10(datum.value)', tickCount: 9, gridOpacity: AT_DECADES, tickOpacity: AT_DECADES}
};
const OVER_PHI = {
  field: 'phi',
  type: 'quantitative',
  title: 'φ, rad',
  scale: {type: 'log', nice: false, padding: 8},
  axis: {labelExpr: 'power10(datum.value)', tickCount: 7, gridOpacity: AT_DECADES, tickOpacity: AT_DECADES}
};

/** Axis over ranges: each is named by its lower end; narrow screens turn the names. */
function overRanges(rows) {
  const names = [...new Map(rows.map((r) => [r.place, r.range.split(' … ')[0]])).entries()]
    .sort((a, b) => a[0] - b[0])
    .map((e) => e[1]);
  return {
    field: 'place',
    type: 'quantitative',
    title: 'φ from, rad',
    scale: {nice: false, padding: 8},
    axis: {
      values: names.map((_, i) => i),
      labelExpr: `${JSON.stringify(names)}[datum.value]`,
      labelAngle: -90,
      labelAlign: 'right',
      labelBaseline: 'middle',
      labelFontSize: 11,
      grid: false
    }
  };
}

/** looks: series -> {color, dash}; only: the isolated series, or null; over: 'phi' or 'ranges'. */
export function phiSpec(rows, looks, only, over) {
  const domain = Object.keys(looks);
  const faded = only
    ? {opacity: {condition: {test: `datum.series === ${JSON.stringify(only)}`, value: 1}, value: FADED}}
    : {};
  const x = over === 'phi' ? OVER_PHI : overRanges(rows);
  const color = {
    field: 'series',
    type: 'nominal',
    legend: null,
    scale: {domain, range: domain.map((d) => looks[d].color)}
  };
  const strokeDash = {
    field: 'series',
    type: 'nominal',
    legend: null,
    scale: {domain, range: domain.map((d) => (looks[d].dash?.length ? looks[d].dash : [1, 0]))}
  };
  const tooltip = [
    {field: 'label', title: 'what'},
    {field: 'range', title: 'φ'},
    {field: 'shown', title: 'error'}
  ];
  return {
    height: isNarrow() ? 320 : 400,
    data: {values: rows},
    layer: [
      {
        mark: {type: 'line', strokeWidth: 2, strokeJoin: 'round'},
        encoding: {x, y: Y, color, strokeDash, ...faded}
      },
      {
        params: [
          {name: 'near', select: {type: 'point', on: 'pointerover', nearest: true, clear: 'pointerout'}}
        ],
        mark: {type: 'point', filled: true, size: 50},
        encoding: {
          x,
          y: Y,
          color,
          opacity: {condition: {param: 'near', empty: false, value: 1}, value: 0},
          tooltip
        }
      }
    ]
  };
}

/** Time of each series as a bar, or as a point on a logarithmic axis. */
export function timeSpec(rows, looks, {only, log, title}) {
  const domain = Object.keys(looks);
  const opacity = only
    ? {opacity: {condition: {test: `datum.series === ${JSON.stringify(only)}`, value: 1}, value: FADED}}
    : {};
  const y = {
    field: 'label',
    type: 'nominal',
    sort: rows.map((r) => r.label),
    title: null,
    axis: {
      labelColor: 'var(--ink)',
      ticks: false,
      domain: false,
      labelLimit: isNarrow() ? 150 : 200,
      grid: log,
      labelOverlap: false
    }
  };
  const x = {
    field: 'ns',
    type: 'quantitative',
    title,
    scale: log ? {type: 'log', padding: 12} : {zero: true},
    axis: {format: '~r', tickCount: 5, grid: true, ...(log ? {gridOpacity: AT_DECADES} : {})}
  };
  const color = {
    field: 'series',
    type: 'nominal',
    legend: null,
    scale: {domain, range: domain.map((d) => looks[d].color)}
  };
  const text = {
    mark: {type: 'text', align: 'left', dx: log ? 9 : 5},
    encoding: {x, y, text: {field: 'shown'}, ...opacity}
  };
  const bars = {
    mark: log ? {type: 'point', filled: true, size: 90, opacity: 1} : {type: 'bar', height: {band: 0.62}},
    encoding: {
      x,
      y,
      color,
      tooltip: [
        {field: 'label', title: 'what'},
        {field: 'shown', title: 'ns'}
      ],
      ...opacity
    }
  };
  return {
    height: {step: isNarrow() ? 22 : 24},
    data: {values: rows.map((r) => ({...r, shown: nanoseconds(r.ns)}))},
    layer: [bars, text]
  };
}
