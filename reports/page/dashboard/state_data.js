// How each formulation stands now, in one series. No document here.

/** @typedef {import('./history_data.js').History} History */

/** The name of what belongs to no formulation. */
export const COMMON = '';

/** Decimal digits that a figure lost over its history, net; and the figure that lost most.
 * @param {History} history @param {number} series @param {string} formulation
 */
function worstDigits(history, series, formulation) {
  /** @type {Map<number, number>} */
  const lost = new Map();
  for (const {figure, digits, verdict} of history.changesOf(series)) {
    if (!digits || history.figures.formulation[figure] !== formulation) continue;
    const sign = verdict === 'regression' ? 1 : -1;
    lost.set(figure, (lost.get(figure) ?? 0) + sign * Math.abs(digits));
  }
  const [worst] = [...lost].filter(([, digits]) => digits > 0).sort((a, b) => b[1] - a[1]);
  return worst ? {figure: worst[0], digits: worst[1]} : null;
}

/** Pair kinds -> number of the time figure. @param {History} history @param {string} formulation */
const timesOf = (history, formulation) =>
  new Map(history.pairs.filter((p) => p.formulation === formulation).map((p) => [p.kind, p.time]));

/** One row per formulation, in the order of the figures; what is common to all comes last.
 * @param {History} history @param {number} series
 */
export function statesOf(history, series) {
  const {kind, formulation} = history.figures;
  const latest = history.latest[series];
  const tallies = new Map(
    [...new Set(formulation)].map((name) => [name, {pass: 0, known_failure: 0, fail: 0}])
  );
  kind.forEach((k, i) => {
    const tally = tallies.get(formulation[i]);
    const verdict = latest.verdict[i];
    if (k === 'accuracy' && tally && verdict) tally[verdict]++;
  });
  const rows = [...tallies].map(([name, tally]) => ({
    name,
    tally,
    worst: worstDigits(history, series, name),
    times: timesOf(history, name)
  }));
  return [...rows.filter((r) => r.name !== COMMON), ...rows.filter((r) => r.name === COMMON)];
}
