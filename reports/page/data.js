// The results with the look-ups that several sections need.
import {isNumber, short} from './format.js';
import {isAnalytic, isPlain, withDefaults} from './speed_data.js';

export const KINDS = [
  {key: 'angular', label: 'angular'},
  {key: 'linear', label: 'linear'},
  {key: 'linear_angular', label: 'linear/angular'}
];
export const kindLabel = (key) => KINDS.find((k) => k.key === key)?.label ?? key;

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
  constructor(json) {
    if (json.schema !== 'halfway-results' || json.version !== 1) {
      throw new Error(`results.json: schema ${json.schema} version ${json.version}; this page reads halfway-results version 1`);
    }
    Object.assign(this, json);
    this.byName = new Map(this.findings.map((f) => [f.name, f]));
    this.timings = this.timings.map(withDefaults);
    const timed = (implementation, method) => new Map(this.timings.filter((t) => t.implementation === implementation && isPlain(t) && method(t))
      .map((t) => [`${t.formulation}/${t.kind}/${t.what}`, t]));
    this.timed = timed('reference', (t) => t.method === '');
    this.kernels = timed('kernel', isAnalytic);
    this.infos = new Map(this.formulations.map((f) => [f.name, f]));
  }

  finding(...parts) { return this.byName.get(parts.join('/')); }

  /** The readable transcription's time. */
  timing(formulation, kind, what) { return this.timed.get(`${formulation}/${kind}/${what}`); }

  /** The time of what a user would plug in: the kernel, or the reference where there is no kernel. */
  preferred(formulation, kind, what) { return this.kernels.get(`${formulation}/${kind}/${what}`) ?? this.timing(formulation, kind, what); }

  count(verdict) { return this.findings.filter((f) => f.verdict === verdict).length; }

  /** The name of a curve's series: free-xi formulations carry their xi. */
  series(curve) {
    return this.infos.get(curve.formulation)?.needs_xi ? `${curve.formulation} ξ = ${curve.xi}` : curve.formulation;
  }

  /** Curves of the scene whose name begins with `prefix`. */
  curvesOf(prefix) { return this.curves.filter((c) => c.scene === prefix || c.scene.startsWith(`${prefix}_`)); }

  /** Other programs' and printed curves of the same scene. */
  referencesOf(prefix) {
    return (this.paper?.reference_curves ?? []).filter((c) => c.scene === prefix || c.scene.startsWith(`${prefix}_`));
  }

  /** Bodies and groups of couplings for which formulations were held against the 3D truth. */
  solidViews() {
    const found = this.findings.map((f) => f.name.match(/\/fe_(\w+)_(moments|forces|all)$/)).filter(Boolean);
    return {bodies: [...new Set(found.map((m) => m[1]))], groups: [...new Set(found.map((m) => m[2]))]};
  }

  /** One point per formulation and kind; `missing` says why a point cannot be drawn. solid: {body, group} for the error 'solids'. */
  accuracy(what, error, solid, implementation = 'kernel') {
    const points = [];
    const missing = [];
    for (const {name, stands_for, needs_xi, probe_xi} of this.formulations) {
      for (const {key: kind} of KINDS) {
        const timing = implementation === 'kernel' ? this.preferred(name, kind, what) : this.timing(name, kind, what);
        const measured = error === 'numerical' ? this.numerical(timing) : error === 'solids' ? this.solidError(name, kind, solid) : this.modelling(name, kind);
        const reason = timing?.wrong ? `benchmark refused it: ${timing.message}` : !(timing?.ns > 0) ? 'not timed' : measured.reason;
        if (reason) { missing.push({name, kind, reason}); continue; }
        const floored = !(measured.value > measured.floor);
        points.push({formulation: name, label: needs_xi && error !== 'solids' ? `${name} ξ = ${probe_xi}` : name, stands_for, kind, kind_label: kindLabel(kind), implementation: timing.implementation, ns: timing.ns, spread: timing.spread,
                     error: Math.max(measured.value, measured.floor), value: measured.value, floor: measured.floor, floored,
                     note: measured.note, truth: measured.truth});
      }
    }
    return {points, missing};
  }

  modelling(name, kind) { return this.errorOf(this.finding(name, kind, 'modelling_error'), kind); }

  /** Error of the second-order couplings against the 3D body's. */
  solidError(name, kind, {body, group}) {
    const f = this.finding(name, kind, `fe_${body}_${group}`);
    return {...this.errorOf(f, kind), truth: f?.reason};
  }

  errorOf(f, kind) {
    if (!f) return {reason: 'no modelling error measured'};
    if (f.verdict === 'left_out') return {reason: f.reason};
    if (!isNumber(f.value)) return {reason: 'its modelling error is not a number'};
    const floor = isNumber(f.uncertainty) ? f.uncertainty : 0;
    if (!(Math.max(f.value, floor) > 0)) return {reason: 'its error and the uncertainty of the truth are both 0: no place on a log axis'};
    const where = [f.parameter, f.reason].filter(Boolean).join('; ');
    return {value: f.value, floor, note: where, truth: `${kindLabel(kind)}: ${where}${floor > 0 ? `, known to ${short(floor)}` : ''}`};
  }

  numerical(timing) {
    if (!isNumber(timing?.error)) return {reason: 'no numerical error measured'};
    return {value: timing.error, floor: 2 ** -54, note: 'against 50 digits of the same formula', truth: 'the same formula at 50 digits'};
  }
}

/** Points that no other point of the list beats in both time and error, by time. */
export function front(points) {
  const byTime = [...points].sort((a, b) => a.ns - b.ns || a.error - b.error);
  let best = Infinity;
  return byTime.filter((p) => p.error < best && (best = p.error, true));
}

/** Does a property hold for a formulation and kind? 'yes', 'no', or undefined when it was not measured. */
export function holds(finding) {
  if (!finding || finding.verdict === 'left_out') return undefined;
  return finding.verdict === 'pass' ? 'yes' : 'no';
}
