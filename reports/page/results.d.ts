// Generated from reports/results.schema.json by tools/schema.mjs; edit that, then run `npm run schema`.

export interface ResultsFile {
  schema: "halfway-results";
  version: 1;
  context: Context;
  command: string;
  formulations: Array<Formulation>;
  scenes: Array<Scene>;
  findings: Array<Finding>;
  curves: Array<Curve>;
  timings: Array<Timing>;
  left_out: Array<LeftOut>;
  saboteurs?: Array<Sabotaged>;
  programs?: Array<Program>;
  paper?: Paper;
  solids?: Solids;
  speed?: Speed;
  rods?: Rods;
  stability?: Stability;
  durations: Record<string, number>;
}

export interface Context {
  machine: string;
  compiler: string;
  flags: string;
  commit: string;
  date: string;
  build_type: string;
}

export interface Band {
  low: number | null;
  high: number | null;
}

export interface Bands {
  angular: Band;
  linear: Band;
  linear_angular: Band;
}

export interface Facts {
  moment_balance: Bands;
  node_order: Bands;
  symmetry: Bands;
  loop_work: Bands;
  loop_slope: any;
  clamped_energy: Band;
  has_fingerprint: boolean;
  alpha: number | null;
  beta: number | null;
}

export interface Formulation {
  name: string;
  stands_for: string;
  needs_xi: boolean;
  probe_xi: number;
  facts: Facts;
  potential_kinds: Array<string>;
}

export interface Axis {
  title: string;
  unit: string;
}

export interface Scene {
  name: string;
  title: string;
  description: string;
  source: string;
  load?: Axis;
}

export interface Finding {
  name: string;
  formulation: string;
  kind: string;
  subject: string;
  parameter: string;
  value: number | null;
  unit: string;
  comparison: "at_most" | "at_least" | "within" | "equal" | "report";
  expected: number | null;
  low: number | null;
  high: number | null;
  oracle: "none" | "closed_form" | "fifty_digits" | "independent" | "printed" | "other_program" | "kept";
  uncertainty: number | null;
  reason: string;
  verdict: "pass" | "fail" | "known_failure" | "left_out";
  replay?: string;
}

export interface Curve {
  scene: string;
  formulation: string;
  xi: number;
  columns: Array<string>;
  rows: Array<Array<number | null>>;
  converged: boolean;
  outcome: string;
  iterations: number;
  residual: number | null;
}

export interface ErrorAt {
  from: number;
  to: number;
  error: number | null;
}

export interface Timing {
  name: string;
  formulation: string;
  kind: string;
  what: string;
  implementation: string;
  precision: string;
  isa: string;
  variant: string;
  method: string;
  joints: number;
  threads: number;
  ns: number | null;
  spread: number | null;
  error: number | null;
  errors: Array<ErrorAt>;
  flops: number | null;
  products?: number | null;
  bytes: number | null;
  wrong: boolean;
  message: string;
}

export interface Sabotaged {
  check: string;
  room: string;
  siblings: number;
  sees: Array<string>;
  caught_by: Array<string>;
  wrong: Array<string>;
}

export interface Program {
  name: string;
  stands_for: string;
  known: "measured" | "read in the source" | "manual" | "reconstructed";
  source: string;
  facts: Array<string>;
  cases: Array<ProgramCase>;
  defects: Array<ProgramDefect>;
}

export interface ProgramCase {
  name: string;
  program: string;
  version: string;
  how: string;
  answers: "kept" | "live";
  poses: number;
  digits: number;
  good_to: number;
  finding: string;
}

export interface ProgramDefect {
  words: string;
  size: number;
  finding: string;
}

export interface LeftOut {
  what: string;
  reason: string;
}

export interface PrintedCell {
  formulation: string;
  column: string;
  output: string;
  printed: string;
  corrected?: string | null;
  erratum?: string | null;
}

export interface PrintedMoment {
  formulation: string;
  printed: string;
  corrected?: string | null;
  erratum?: string | null;
}

export interface ReferenceCurve {
  scene: string;
  formulation: string;
  source: string;
  columns: Array<string>;
  rows: Array<Array<number | null>>;
}

export interface Paper {
  table1?: Array<PrintedCell>;
  buckling?: Array<PrintedMoment>;
  reference_curves?: Array<ReferenceCurve>;
}

export interface Compliance {
  name: string;
  unit: string;
  value: number | null;
  uncertainty: number | null;
  order?: number | null;
}

export interface PairXi {
  name: string;
  value: number | null;
  uncertainty: number | null;
  order?: number | null;
  unit?: string;
}

export interface BestXi {
  group: string;
  xi: number | null;
  remainder: number | null;
}

export interface BodyXi {
  law: string;
  moments: Array<PairXi>;
  forces?: Array<PairXi>;
  best?: Array<BestXi>;
}

export interface BodyRun {
  element: string;
  level: number;
  unknowns: number;
  seconds: number | null;
  xi: Record<string, number | null>;
  compliance: Array<number | null>;
}

export interface Body {
  name: string;
  title: string;
  geometry?: any;
  joint_point?: Array<number | null>;
  compliances?: Array<Compliance>;
  xis?: Array<BodyXi>;
  runs?: Array<BodyRun>;
}

export interface BearingDatum {
  name: string;
  printed: number | null;
}

export interface LawXi {
  law: string;
  value: number | null;
  uncertainty: number | null;
}

export interface BearingFamily {
  name: string;
  cut: string;
  hole: string;
  inner: number | null;
  outer: number | null;
  extent: number | null;
  width?: number | null;
  residuals?: Array<number | null>;
  largest: number | null;
  admissible: boolean;
  unknowns?: number;
  xi?: Array<LawXi>;
  message?: string;
  rms?: number | null;
}

export interface BearingScan {
  name: string;
  width: number | null;
  largest: number | null;
  admissible: boolean;
  xi?: Record<string, number | null>;
  cut?: string;
  hole?: string;
  inner?: number | null;
  outer?: number | null;
  extent?: number | null;
  residuals?: Array<number | null>;
  rms?: number | null;
  unknowns?: number;
  message?: string;
}

export interface Bearing {
  printed_xi?: number | null;
  data?: Array<BearingDatum>;
  limit?: number | null;
  families?: Array<BearingFamily>;
  scans?: Array<BearingScan>;
}

export interface Calculix {
  body: string;
  element: string;
  level: number;
  unknowns: number;
  seconds: number | null;
  runs?: number;
  xi: number | null;
  version?: string;
}

export interface NewtonSolve {
  body: string;
  element: string;
  level: number;
  unknowns: number;
  seconds: number | null;
  iterations: number;
  megabytes: number | null;
}

export interface Shape {
  name: string;
  title: string;
  note: string;
  scale: number | null;
  faces: Array<Array<number>>;
  X: Array<Array<number>>;
  u: Array<Array<number>>;
}

export interface MissingStudy {
  study: string;
  what: string;
}

export interface Solids {
  bodies?: Array<Body>;
  bearing?: Bearing;
  calculix?: Array<Calculix>;
  newton?: Array<NewtonSolve>;
  shapes?: Array<Shape>;
  missing?: Array<MissingStudy>;
}

export interface Peak {
  isa: string;
  precision: string;
  flops_per_ns: number | null;
}

export interface Bandwidth {
  what: string;
  bytes_per_ns: number | null;
  capacity?: number | null;
}

export interface Target {
  name: string;
  value: number | null;
  limit: number | null;
  comparison: string;
  met: boolean;
  note: string;
}

export interface Published {
  program: string;
  version?: string;
  what: string;
  ns: number | null;
  machine: string;
  date: string;
  source: string;
}

export interface Cheapest {
  scene: string;
  tolerance: number;
  kind: string;
  formulation: string;
  truth?: string;
  implementation?: string;
  precision?: string;
  variant?: string;
  method?: string;
  error?: number | null;
  margin?: number | null;
  ns?: number | null;
  relative_cost?: number | null;
  flops?: number | null;
  flops_saved?: number | null;
  note: string;
}

export interface Instructions {
  name: string;
  instructions: number | null;
}

export interface Speed {
  peaks?: Array<Peak>;
  bandwidth?: Array<Bandwidth>;
  targets?: Array<Target>;
  published?: Array<Published>;
  cheapest?: Array<Cheapest>;
  instructions?: Array<Instructions>;
}

export interface PathEvent {
  type: string;
  factor: number | null;
  phi: number | null;
  located_to: number | null;
  simple?: boolean;
}

export interface Path {
  formulation: string;
  xi: number;
  load: string;
  branch: string;
  points: Array<Array<number | null>>;
  events: Array<PathEvent>;
  outcome: string;
  shortened: number;
  iterations: number;
}

export interface LoadStepping {
  formulation: string;
  xi: number;
  solver: string;
  steps: number;
  converged: boolean;
  reached: number | null;
  off: number;
  first_off: number | null;
  distance_off: number | null;
  message: string;
}

export interface Paths {
  scene?: string;
  columns: Array<string>;
  curves: Array<Path>;
  steps?: Array<LoadStepping>;
}

export interface Instability {
  kind: string;
  moment: string;
  axis: number;
  formulation: string;
  inertia: string;
  load: number | null;
  angle: number | null;
  until?: number | null;
  end?: string;
}

export interface Modes {
  formulation: string;
  moment: string;
  axis?: number;
  inertia?: string;
  columns?: Array<string>;
  points: Array<Array<number | null>>;
}

export interface MomentType {
  name: string;
  what: string;
}

export interface RigidBody {
  name: string;
  principal: Array<number | null>;
}

export interface Kinds {
  scene?: string;
  moments: Array<MomentType>;
  bodies: Array<RigidBody>;
  rows: Array<Instability>;
  modes: Array<Modes>;
}

export interface TurnCurve {
  formulation: string;
  phi: Array<number | null>;
  moment: Array<number | null>;
}

export interface TurnPoint {
  angle: string;
  moment: number | null;
  smallest: number | null;
  condition: number | null;
}

export interface Crossing {
  angle: string;
  phi: number | null;
  behaviour: string;
  jump: number | null;
  moment: number | null;
  order: number | null;
}

export interface LargeRotation {
  formulation: string;
  axis: string;
  points: Array<TurnPoint>;
  crossings: Array<Crossing>;
}

export interface Gimbal {
  formulation: string;
  sequence: string;
  load_order: number | null;
  tangent_order: number | null;
  lost_1e6: number | null;
  lost_1e3: number | null;
  distance: Array<number | null>;
  error: Array<number | null>;
}

export interface ErrorSeries {
  what: string;
  formulation: string;
  x: Array<number | null>;
  error: Array<number | null>;
  notes?: Array<string>;
}

export interface Refusal {
  what: string;
  who: string;
  says: string;
}

export interface Projection {
  quaternion: number | null;
  polar: number | null;
}

export interface Turns {
  stiffness: Array<number | null>;
  curves: Array<TurnCurve>;
  unwrapped: Array<TurnCurve>;
  large_rotation: Array<LargeRotation>;
  gimbal: Array<Gimbal>;
  conditioning: Array<ErrorSeries>;
  refusals: Array<Refusal>;
  convexity?: Array<ConvexRange>;
  projection: Projection;
}

export interface ConvexRange {
  formulation: string;
  radius: number;
  says: string;
}

export interface EnergyRun {
  formulation: string;
  scenario: string;
  potential: boolean;
  balanced: boolean;
  periods: number | null;
  steps: number;
  ending: string;
  largest: number | null;
  trend: number | null;
  linear: number | null;
  angular: number | null;
  samples: Array<Array<number | null>>;
}

export interface LoopPoint {
  amplitude: number;
  relative: number | null;
  error?: number | null;
}

export interface Loop {
  formulation: string;
  kind: string;
  slope: number | null;
  points: Array<LoopPoint>;
}

export interface Scenario {
  name: string;
  title: string;
  kind: string;
  period?: number | null;
  frequencies?: Array<number | null>;
}

export interface Integrator {
  order: number;
  steps_per_fastest: number | null;
}

export interface Energy {
  runs: Array<EnergyRun>;
  loops: Array<Loop>;
  scenarios: Array<Scenario>;
  integrator: Integrator;
}

export interface BasinGrid {
  name: string;
  axes: Array<number>;
  angles: number;
  steps: number;
  largest: number;
  unit: string;
}

export interface BasinMap {
  grid: string;
  formulation: string;
  tangent: string;
  share: number | null;
  safe_step: number | null;
  wrapped?: number;
  cells: Array<number>;
}

export interface Equilibrium {
  theta: Array<number | null>;
  cells: number;
}

export interface StartMap {
  formulation: string;
  moment: number | null;
  resolution: number;
  has_branch: boolean;
  equilibria: Array<Equilibrium>;
  cells: Array<number>;
}

export interface NewtonOrder {
  formulation: string;
  tangent: string;
  order: number | null;
  factor: number | null;
  predicted: number | null;
  iterations: number;
}

export interface Basins {
  tangents: Array<string>;
  ends: Array<string>;
  most_iterations: number;
  grids: Array<BasinGrid>;
  maps: Array<BasinMap>;
  starts: Array<StartMap>;
  orders: Array<NewtonOrder>;
}

export interface Defect {
  what: string;
  formulation: string;
  x: Array<number | null>;
  error: Array<number | null>;
}

export interface Reach {
  tolerance: number;
  moment: number;
  angle: number;
}

export interface FollowedCurve {
  formulation: string;
  error: Array<number | null>;
  within: Array<Reach>;
}

export interface SkewMoment {
  moment: Array<number>;
  angle: Array<number>;
  theta: Array<Array<number>>;
  curves: Array<FollowedCurve>;
}

export interface MedianError {
  formulation: string;
  median: number | null;
  lost: number;
  of: number;
}

export interface RandomMoments {
  stiffness: string;
  drawn: string;
  size: number;
  rows: Array<MedianError>;
}

export interface CriticalRatio {
  formulation: string;
  ratio: number | null;
}

export interface SemiTangential {
  stiffness: string;
  rod: number;
  rows: Array<CriticalRatio>;
}

export interface ForceError {
  formulation: string;
  error: Array<number | null>;
  order: number | null;
}

export interface EndForce {
  where: string;
  force: Array<number>;
  rows: Array<ForceError>;
}

export interface ChainPoint {
  links: number;
  error: number | null;
  iterations: number;
  ms: number | null;
}

export interface ChainOrder {
  formulation: string;
  rod: string;
  order: number | null;
  order_bar: number | null;
  points: Array<ChainPoint>;
}

export interface TangentCost {
  tangent: string;
  converged: boolean;
  iterations: number;
  load_steps: number;
  ms: number | null;
}

export interface ChainTangents {
  formulation: string;
  costs: Array<TangentCost>;
}

export interface Chains {
  orders: Array<ChainOrder>;
  tangents: Array<ChainTangents>;
}

export interface Rods {
  skew?: SkewMoment;
  random?: Array<RandomMoments>;
  semi_tangential?: Array<SemiTangential>;
  force?: Array<EndForce>;
  chains?: Chains;
}

export interface Stability {
  paths?: Paths;
  kind?: Kinds;
  range?: Turns;
  energy?: Energy;
  basins?: Basins;
  defects?: Array<Defect>;
}
