// The results with the look-ups that several sections need.
import {isAnalytic, isPlain, withDefaults} from './data/speed_data.js';

/** @typedef {import('./results').ResultsFile} ResultsFile */
/** @typedef {import('./results').Finding} Finding */
/** @typedef {import('./results').Timing} Timing */

export const VERDICTS = {
  pass: {label: 'pass', mark: '✓'},
  known_failure: {label: 'known failure', mark: '≈'},
  fail: {label: 'FAIL', mark: '✗'},
  left_out: {label: 'left out', mark: '–'}
};

export const ORACLES = {
  none: 'no reference',
  closed_form: 'closed form',
  fifty_digits: 'same formula at 50 digits',
  independent: 'independent road',
  printed: 'printed in the paper',
  other_program: 'another program',
  kept: 'kept from an earlier day'
};

export class Results {
  /** @param {ResultsFile} json */
  constructor(json) {
    if (json.schema !== 'halfway-results' || json.version !== 1) {
      throw new Error(
        `results.json: schema ${json.schema} version ${json.version}; this page reads halfway-results version 1`
      );
    }
    this.context = json.context;
    this.command = json.command;
    this.formulations = json.formulations;
    this.scenes = json.scenes;
    this.findings = json.findings;
    this.curves = json.curves;
    this.timings = json.timings.map(withDefaults);
    this.left_out = json.left_out;
    this.saboteurs = json.saboteurs ?? [];
    this.programs = json.programs ?? [];
    this.paper = json.paper;
    this.solids = json.solids;
    this.speed = json.speed;
    this.rods = json.rods ?? {};
    this.stability = json.stability;
    this.durations = json.durations;
    this.byName = new Map(this.findings.map((f) => [f.name, f]));
    this.infos = new Map(this.formulations.map((f) => [f.name, f]));
    this.timed = this.plainTimings('reference', (t) => t.method === '');
    this.kernels = this.plainTimings('kernel', isAnalytic);
  }

  /** In double and without a variant, by formulation, kind and output.
   * @param {string} implementation
   * @param {(timing: Timing) => boolean} isOfMethod
   */
  plainTimings(implementation, isOfMethod) {
    const own = this.timings.filter(
      (t) => t.implementation === implementation && isPlain(t) && isOfMethod(t)
    );
    return new Map(own.map((t) => [`${t.formulation}/${t.kind}/${t.what}`, t]));
  }

  /** @param {string[]} parts of the name */
  finding(...parts) {
    return this.byName.get(parts.join('/'));
  }

  /** The readable transcription's time.
   * @param {string} formulation
   * @param {string} kind
   * @param {string} what
   */
  timing(formulation, kind, what) {
    return this.timed.get(`${formulation}/${kind}/${what}`);
  }

  /** The time of what a user would plug in: the kernel, or the transcription where there is no kernel.
   * @param {string} formulation
   * @param {string} kind
   * @param {string} what
   */
  preferred(formulation, kind, what) {
    return this.kernels.get(`${formulation}/${kind}/${what}`) ?? this.timing(formulation, kind, what);
  }

  /** The name of a curve's series: free-xi formulations carry their xi.
   * @param {{formulation: string, xi: number}} curve
   */
  series(curve) {
    const isFree = this.infos.get(curve.formulation)?.needs_xi;
    return isFree ? `${curve.formulation} ξ = ${curve.xi}` : curve.formulation;
  }

  /** Other programs' curves of a scene, and ours of its 3D body.
   * @param {string} scene
   */
  referencesOf(scene) {
    return (this.paper?.reference_curves ?? []).filter((c) => c.scene === scene);
  }

  /** Bodies and groups of couplings for which formulations were held against the 3D truth. */
  solidViews() {
    const found = this.findings
      .map((f) => f.name.match(/\/fe_(\w+)_(moments|forces|all)$/))
      .filter((m) => m !== null);
    return {bodies: [...new Set(found.map((m) => m[1]))], groups: [...new Set(found.map((m) => m[2]))]};
  }
}

/** Does a property hold for a formulation and kind? 'yes', 'no', or undefined when it was not measured.
 * @param {Finding | undefined} finding
 */
export function holds(finding) {
  if (!finding || finding.verdict === 'left_out') return undefined;
  return finding.verdict === 'pass' ? 'yes' : 'no';
}
