// Small results that satisfy the schema, with a formulation that no list of the page knows.

export const NEW = 'brand_new';
const NAMES = ['attached_a', 'invariant', 'quaternion', NEW];
const KINDS = ['angular', 'linear', 'linear_angular'];
const none = {low: 0, high: 0};
const bands = {angular: none, linear: none, linear_angular: none};
const facts = {
  ...{moment_balance: bands, node_order: bands, symmetry: bands, loop_work: bands, loop_slope: 0},
  ...{clamped_energy: none, has_fingerprint: false, alpha: 0, beta: 0}
};
const range = (n) => Array.from({length: n}, (_, i) => i);

/** A finding that passes, with what a test changes. */
export const finding = (name, rest = {}) => ({
  name,
  formulation: name.split('/')[0],
  kind: name.split('/')[1] ?? '',
  subject: name.split('/').at(-1),
  parameter: '',
  value: 1e-16,
  unit: '',
  comparison: 'at_most',
  expected: 0,
  low: 0,
  high: 1e-12,
  oracle: 'fifty_digits',
  uncertainty: 0,
  reason: 'rounding',
  verdict: 'pass',
  ...rest
});

/** A timing of a kernel, with what a test changes. */
export const timing = (formulation, kind, rest = {}) => {
  const t = {
    ...{formulation, kind, what: 'residual', implementation: 'kernel', precision: 'double', isa: ''},
    ...{variant: '', method: '', joints: 0, threads: 0, ns: 30, spread: 0.01, error: 1e-16},
    ...{errors: [], flops: 100, bytes: 200, wrong: false, message: '', ...rest}
  };
  return {name: [formulation, kind, t.what, t.implementation, t.variant, t.isa].join('/'), ...t};
};

/** A curve of a scene whose outputs grow linearly to `ends`, in four steps. */
export const curve = (scene, formulation, columns, ends, rest = {}) => ({
  ...{
    scene,
    formulation,
    xi: 0.5,
    columns,
    converged: true,
    outcome: 'converged',
    iterations: 8,
    residual: 0
  },
  rows: range(4).map((i) => ends.map((end) => (end * (i + 1)) / 4)),
  ...rest
});

const THETA = ['factor', 'theta_x', 'theta_y', 'theta_z'];
const C2 = 'c2_parallelepiped_small';
const modelling = (name, i) =>
  KINDS.map((kind) =>
    finding(`${name}/${kind}/modelling_error`, {
      ...{value: [1, 1e-9, 1e-9, 0.5][i], uncertainty: 2.5e-6, comparison: 'report'},
      parameter: `${C2}, theta_y at 1 N m`
    })
  );
const rangeFinding = (name, i) =>
  finding(`${name}/angular/fe_range_block_moment`, {
    ...{value: 20 + 20 * i, unit: 'N m', comparison: 'report', oracle: 'independent'},
    parameter: `theta_2 within 1 % up to ${20 + 20 * i}, within 5 % up to ${60 + 20 * i}; phi = 0.50 rad at 270`
  });

/** A law of other programs, with what a test changes. */
export const program = (name, rest = {}) => ({
  ...{name, stands_for: `engine <${name}>`, known: 'measured', source: 'engine 1.0', facts: [], cases: []},
  defects: [],
  ...rest
});

/** A program that was run. */
export const run = (name, rest = {}) => ({
  ...{
    name,
    program: `Engine <${name}>`,
    version: '1.0',
    how: 'one step from rest',
    answers: 'kept',
    poses: 32
  },
  ...{digits: 5.4, good_to: 5, finding: `programs/measured/double/${name}`},
  ...rest
});

/** Fresh results: a test may change them. */
export function fixture() {
  const left = finding('attached_a/linear/symmetry', {verdict: 'left_out', value: null, reason: 'not asked'});
  return {
    schema: 'halfway-results',
    version: 1,
    context: {
      machine: 'm',
      compiler: 'c',
      flags: 'f',
      commit: 'abc',
      date: '2026-01-01',
      build_type: 'Release'
    },
    command: './halfway report',
    formulations: NAMES.map((name) => ({
      ...{name, stands_for: `law <${name}>`, needs_xi: false, probe_xi: 0.5, facts, potential_kinds: []}
    })),
    scenes: [{name: C2, title: 'C2 Parallelepiped', description: 'A block.', source: 'paper'}],
    findings: [
      ...NAMES.flatMap(modelling),
      ...NAMES.map(rangeFinding),
      ...NAMES.map((n) => finding(`${n}/angular/node_order`)),
      finding('attached_a/angular/loop_work', {verdict: 'known_failure', value: 0.1}),
      left
    ],
    curves: NAMES.map((n, i) => curve(C2, n, THETA, [1, 1.6e-3, 1e-7 * (1 + i), 4e-6])),
    timings: NAMES.flatMap((n, i) => KINDS.map((k) => timing(n, k, {ns: 20 + 5 * i}))),
    left_out: [
      {what: left.name, reason: left.reason},
      {what: `${C2}/cayley, the rest of the path`, reason: 'half a turn'}
    ],
    programs: [
      program('engine_law', {
        facts: ['no axes of its own'],
        cases: [run('engine'), run('engine_2')],
        defects: [
          {words: 'moments do not balance', size: 0.66, finding: 'programs/moment_balance/engine_law'},
          {words: 'the order of the bodies matters', size: 1.3, finding: 'programs/body_order/engine_law'}
        ]
      }),
      program('read_law', {known: 'read in the source'})
    ],
    paper: {
      reference_curves: [
        {
          ...{scene: 'range_block_moment', formulation: 'block, cauchy_log', source: '3D finite elements'},
          ...{columns: THETA, rows: range(10).map((i) => [0.09 * (i + 1), 0.05 * (i + 1), 0, 0])}
        }
      ]
    },
    durations: {verify: 1}
  };
}
