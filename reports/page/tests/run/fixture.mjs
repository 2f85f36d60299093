// Runs for the tests of their page, made up: a joint with ends, a chain, and three bodies in a row.
import {writeFileSync, readFileSync} from 'node:fs';
import {pathToFileURL} from 'node:url';

export const HOSTILE = 'A joint </script><script>alert(1)</script><b>bold</b>';
const kRows = 5;

const about = (axis, angle) => [Math.cos(angle / 2), ...axis.map((x) => x * Math.sin(angle / 2))];
const Z = [0, 0, 1];

/** A curve that turns the last body about z by `most` and moves it. */
function curve(label, most, {bodies = 2, rows = kRows, cause = '', holding = true} = {}) {
  const share = (i) => i / (kRows - 1);
  const pose = (i, b) =>
    b ? [0.7 * b, 0.2 * share(i), 0, ...about(Z, most * share(i) * b)] : [0, 0, 0, 1, 0, 0, 0];
  const list = Array.from({length: rows}, (_, i) => i);
  const at = (i) => Array.from({length: bodies}, (_, b) => pose(i, b));
  return {
    ...{label, formulation: label.split(' ')[0], converged: !cause, cause},
    outcome: cause ? `stopped: ${cause}` : 'converged',
    rows: list.map((i) => [10 * share(i), most * share(i), 0.2 * share(i)]),
    errors: label === 'linearized' ? [] : list.map(() => 1e-15),
    poses: list.map(at),
    holding: holding ? list.map((i) => at(i).map((_, b) => [0, 0, 0, 0, 0, (b ? 1 : -1) * share(i)])) : []
  };
}

const END = {o: [0, 0, 0], h: [1, 0, 0, 0]};
const LAW = {
  type: 'stiffness',
  matrix: [0, 1, 2, 3, 4, 5].map((i) => [0, 1, 2, 3, 4, 5].map((j) => (i === j ? 10 + i : 0)))
};

/** @param {any} changes @returns {any} */
export function runFixture(changes = {}) {
  return {
    ...{schema: 'halfway-run-page', version: 1, command: './halfway run x.toml'},
    scene: {name: 'x', title: HOSTILE, description: 'words <i>and</i> more', source: ''},
    notes: ['frame_a is taken as the nearest rotation'],
    path: {factor_end: 10, points: kRows - 1},
    outputs: [
      {name: 'theta_z', unit: 'rad'},
      {name: 'u_y', unit: 'm'}
    ],
    curves: [
      curve('attached_a', 0.8),
      curve('invariant', 1),
      curve('chrono_body', 1),
      curve('jointc', 1.2, {rows: 3, cause: 'a fold: this path carries no more load'}),
      curve('linearized', 1.3, {rows: 5, holding: false})
    ],
    left_out: [{formulation: 'rod34', reason: 'needs the length of its rod'}],
    comparison: {
      ...{agree: 0.01, answers: 2, apart: 0.5},
      groups: [
        {curves: [0], answer: [0.8, 0.2], apart: 0, error: 1e-15},
        {curves: [2, 1], answer: [1, 0.2], apart: 1e-4, error: 1e-15},
        {curves: [4], answer: [1.3, 0.2], apart: 0, error: null}
      ],
      ended: [{cause: 'a fold: this path carries no more load', curves: [3]}]
    },
    bodies: [
      {name: 'a', clamped: true, rest: [0, 0, 0, 1, 0, 0, 0]},
      {name: 'b', clamped: false, rest: [0.7, 0, 0, 1, 0, 0, 0]}
    ],
    joints: [
      {
        ...{name: 'joint', kind: 'linear_angular', law: LAW},
        a: {body: 0, o: [0.3, 0.1, 0], h: about([0, 1, 0], Math.PI / 4)},
        b: {body: 1, o: [-0.4, 0.1, 0], h: about(Z, 0.5)}
      }
    ],
    loads: [
      {body: 1, type: 'fixed_force', value: [0, 2, 0], point: [0.5, 0, 0]},
      {body: 1, type: 'follower_moment', value: [0, 0, 3], point: [0, 0, 0]}
    ],
    ...changes
  };
}

/** Three bodies in a row, two joints: what scenes of several bodies are drawn from. */
export const rowFixture = () => {
  const joint = (name, a, b) => ({
    ...{name, kind: 'angular', law: {type: 'polynomial', k1: [1, 2, 3], k3: [0, 0, 0], k5: [0, 0, 1]}},
    a: {...END, body: a, o: [0.35, 0, 0]},
    b: {...END, body: b, o: [-0.35, 0, 0]}
  });
  const bodies = ['ground', 'lever', 'wheel'].map((name, i) => ({
    ...{name, clamped: i === 0},
    rest: [0.7 * i, 0, 0, 1, 0, 0, 0]
  }));
  return runFixture({
    ...{bodies, joints: [joint('first', 0, 1), joint('second', 1, 2)]},
    curves: [curve('invariant', 0.5, {bodies: 3})],
    comparison: {
      agree: 0.01,
      answers: 1,
      apart: 0,
      groups: [{curves: [0], answer: [1, 1], apart: 0, error: 1e-15}],
      ended: []
    }
  });
};

/** The row in time: energies, reactions, a damper, a load that goes with the time. */
export const motionFixture = () => {
  const run = rowFixture();
  const [only] = run.curves;
  return {
    ...run,
    path: {...run.path, over: 'time'},
    curves: [
      {
        ...only,
        holding: [],
        energies: only.rows.map((_, i) => [1 - i / 8, i / 16, i / 16, i === 4 ? 0.25 : 0]),
        reactions: only.rows.map((_, i) => [
          [
            [i, 0, 0, 0, 0, 1],
            [-i, 0, 0, 0, 0, -1]
          ],
          [
            [0, 2, 0, 0, 0, 0],
            [0, -2, 0, 0, 0, 0]
          ]
        ])
      }
    ],
    joints: run.joints.map((joint, i) =>
      i
        ? joint
        : {
            ...joint,
            damping: [
              [1, 0, 0],
              [0, 2, 0],
              [0, 0, 3]
            ]
          }
    ),
    loads: [{...run.loads[1], times: [0, 5], factors: [0, 1]}]
  };
};

/** A chain of 33 nodes that a moment bends to an arc. */
export const chainFixture = () => {
  const shape = (turn) =>
    Array.from({length: 33}, (_, i) => {
      const angle = (turn * i) / 32;
      const x = turn ? Math.sin(angle) / turn : i / 32;
      return [x, turn ? (1 - Math.cos(angle)) / turn : 0, 0, ...about(Z, angle)];
    });
  const whole = curve('invariant', 2);
  const curves = [
    {
      ...whole,
      poses: whole.rows.map(([f]) => shape(f / 5)),
      holding: whole.rows.map(([f]) => [-f, f].map((m) => [0, 0, 0, 0, 0, m]))
    }
  ];
  const bodies = shape(0).map((rest, i) => ({name: `node ${i}`, clamped: i === 0, rest}));
  return runFixture({
    ...{bodies, joints: [], curves},
    chain: {links: 32, length: 1, stiffness: [1e4, 5e3, 5e3, 1, 2, 2], curvature: [0, 0, 0], held: false},
    loads: [{body: 32, type: 'fixed_moment', value: [0, 0, 1], point: [0, 0, 0]}],
    comparison: {
      agree: 0.01,
      answers: 1,
      apart: 0,
      groups: [{curves: [0], answer: [1, 1], apart: 0, error: 1e-15}],
      ended: []
    }
  });
};

/** Writes a run into RUN_BUNDLE as C++ does. @returns {string} its address */
export function runAddress(run, name) {
  const bundle = process.env.RUN_BUNDLE ?? '';
  const json = JSON.stringify(run).replaceAll('<', '\\u003c');
  const file = `${bundle}.${name}.html`;
  writeFileSync(
    file,
    readFileSync(bundle, 'utf8').replace('@HALFWAY_RUN@', () => json)
  );
  return pathToFileURL(file).href;
}
