// Generated from reports/run.schema.json by tools/schema.mjs; edit that, then run `npm run schema`.

export interface RunFile {
  schema: "halfway-run-page";
  version: 1;
  command: string;
  scene: RunScene;
  notes: Array<string>;
  path: RunPath;
  critical_axis?: number;
  outputs: Array<RunOutput>;
  curves: Array<RunCurve>;
  left_out: Array<RunLeftOut>;
  comparison: RunComparison;
  bodies: Array<RunBody>;
  joints: Array<RunJoint>;
  chain?: RunChain;
  loads: Array<RunLoad>;
  motions?: Array<RunMotion>;
}

export interface RunMotion {
  name: string;
  body: number;
  type: "rotation" | "displacement";
  value: Array<number>;
  axis?: string;
  point: Array<number>;
}

export interface RunScene {
  name: string;
  title: string;
  description: string;
  source: string;
}

export interface RunPath {
  factor_end: number;
  points: number;
  over?: "time";
}

export interface RunOutput {
  name: string;
  unit: string;
}

export interface RunCurve {
  label: string;
  formulation: string;
  converged: boolean;
  outcome: string;
  cause: string;
  rows: Array<Array<number>>;
  errors: Array<number | null>;
  critical_moment?: number;
  poses: Array<Array<Array<number>>>;
  holding: Array<Array<Array<number>>>;
  reactions?: Array<Array<Array<Array<number>>>>;
  energies?: Array<Array<number>>;
}

export interface RunLeftOut {
  formulation: string;
  reason: string;
}

export interface RunComparison {
  agree: number;
  answers: number;
  apart: number;
  groups: Array<RunGroup>;
  ended: Array<RunEnded>;
}

export interface RunGroup {
  curves: Array<number>;
  answer: Array<number>;
  apart: number;
  error: number | null;
}

export interface RunEnded {
  cause: string;
  curves: Array<number>;
}

export interface RunBody {
  name: string;
  clamped: boolean;
  rest: Array<number>;
}

export interface RunJoint {
  name: string;
  kind: "angular" | "linear" | "linear_angular";
  law: RunLaw;
  a: RunEnd;
  b: RunEnd;
  damping?: Array<Array<number>>;
}

export interface RunLaw {
  type: "stiffness" | "compliance" | "polynomial" | "per_axis";
  matrix?: Array<Array<number>>;
  k1?: Array<number>;
  k3?: Array<number>;
  k5?: Array<number>;
  knots?: Array<number>;
  offset?: Array<number>;
  preload?: Array<number>;
}

export interface RunEnd {
  body: number;
  o: Array<number>;
  h: Array<number>;
}

export interface RunChain {
  links: number;
  length: number;
  stiffness: Array<number>;
  curvature: Array<number>;
  held: boolean;
}

export interface RunLoad {
  body: number;
  type: "fixed_moment" | "follower_moment" | "fixed_force" | "follower_force" | "semi_tangential_moment" | "quasi_tangential_moment";
  value: Array<number>;
  point: Array<number>;
  held?: boolean;
  times?: Array<number>;
  factors?: Array<number>;
}
