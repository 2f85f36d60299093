// The counts of a report, by the rule of summary.md and junit.xml: every finding counts once, by its verdict.

/** @typedef {import('../results').Finding} Finding */

/** @param {Finding[]} findings */
export function tallyOf(findings) {
  const tally = {pass: 0, fail: 0, known_failure: 0, left_out: 0};
  for (const {verdict} of findings) tally[verdict] += 1;
  return tally;
}

/** What was not run to its end and is no finding: paths that stop, benchmarks that were skipped. The results
 * list the findings that were left out among them as well; counted here, they would count twice.
 * @param {{findings: Finding[], left_out: import('../results').LeftOut[]}} results
 */
export function notRun({findings, left_out: leftOut}) {
  const names = new Set(findings.map((f) => f.name));
  const seen = new Set();
  return leftOut.filter(({what}) => !names.has(what) && !seen.has(what) && seen.add(what));
}
