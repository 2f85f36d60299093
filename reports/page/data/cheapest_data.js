// The choices of the cheapest sufficient model (results.speed.cheapest), and which of them is its own judge.

/** @typedef {import('../results').Cheapest} Cheapest */

/** The formulation that the scene's truth is a path of, by the note: "truth: invariant at 50 digits, ...".
 * @param {Cheapest} row
 */
export const truthOf = (row) => row.truth ?? row.note?.match(/^truth: (\w+)/)?.[1];

/** Its error is rounding alone, because the truth is its own path at 50 digits.
 * @param {Cheapest} row
 */
export const isOwnTruth = (row) => Boolean(row.formulation) && row.formulation === truthOf(row);

/** Tolerances and scenes of the table, and its cells.
 * @param {Cheapest[]} rows
 */
export function tableOf(rows) {
  const tolerances = [...new Set(rows.map((c) => c.tolerance))].sort((a, b) => b - a);
  const scenes = [...new Set(rows.map((c) => c.scene))].map((scene) => ({
    scene,
    truth: rows.map((c) => (c.scene === scene ? truthOf(c) : undefined)).find(Boolean),
    cells: tolerances.map((t) => rows.find((c) => c.scene === scene && c.tolerance === t))
  }));
  return {tolerances, scenes};
}
