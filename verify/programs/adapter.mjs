// What the adapters for node share, as adapter.hpp is for C++: JSON lines in, JSON lines out, and the law of
// a request as one spring for each axis. Quaternions are [w, x, y, z].
import fs from 'node:fs';
import readline from 'node:readline';

export const allKinds = ['angular', 'linear', 'linear_angular'];

/** What a program cannot do; the request itself is a good one. */
export class Skipped extends Error {}

/** A request that no program could answer. */
class BadRequest extends Error {}

export const product = (p, q) => [
  p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3],
  p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
  p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1],
  p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0]
];

export const inverse = (q) => [q[0], -q[1], -q[2], -q[3]];

export const rotated = (q, v) => product(product(q, [0, ...v]), inverse(q)).slice(1);

/** Where the packages are that build.sh installed: beside this file. */
export const fileOf = (path) => new URL(`./node_modules/${path}`, import.meta.url);

export const npmVersion = (name) =>
  `npm ${name} ${JSON.parse(fs.readFileSync(fileOf(`${name}/package.json`), 'utf8')).version}`;

// Diagonals come out of products, with their rounding.
const rounding = 1e-12;

function readNumbers(list, n, what) {
  if (!Array.isArray(list) || list.length !== n || !list.every(Number.isFinite)) {
    throw new BadRequest(`${what} has to be ${n} numbers`);
  }
  return list;
}

function readRotation(list, what) {
  const length = Math.hypot(...readNumbers(list, 4, what));
  if (!(Math.abs(length - 1) < 1e-3)) throw new BadRequest(`${what} is no unit quaternion`);
  return list.map((part) => part / length);
}

function readBody(request, node) {
  const from = request[node];
  if (!from || !from.x || !from.q) throw new BadRequest(`node ${node} needs x and q`);
  const i = node === 'a' ? 0 : 1;
  const body = {
    x: readNumbers(from.x, 3, `${node}.x`),
    q: readRotation(from.q, `${node}.q`),
    o: readNumbers(from.o ?? [0, 0, 0], 3, `${node}.o`),
    h: readRotation(from.h ?? [1, 0, 0, 0], `${node}.h`),
    mass: readNumbers(request.mass ?? [1, 1], 2, 'mass')[i],
    inertia: readNumbers(request.inertia ?? [1, 1], 2, 'inertia')[i]
  };
  if (!(body.mass > 0 && body.inertia > 0)) throw new BadRequest('mass and inertia have to be positive');
  return body;
}

/** K as one spring for each axis: n numbers, or n rows with nothing beside the diagonal. */
function readSprings(K, n) {
  if (!Array.isArray(K) || K.length !== n)
    throw new BadRequest(`law.K has to be ${n} rows of as many numbers`);
  if (typeof K[0] === 'number') return readNumbers(K, n, 'law.K');
  const springs = K.map((row, i) => readNumbers(row, n, 'a row of law.K')[i]);
  const isZero = (k, i, j) =>
    i === j || Math.abs(k) <= rounding * Math.sqrt(Math.abs(springs[i] * springs[j]));
  if (!K.every((row, i) => row.every((k, j) => isZero(k, i, j)))) {
    throw new Skipped('law.K is not diagonal: the program has one spring for each axis');
  }
  return springs;
}

function checkSprings(can, k, what) {
  if (k.some((one) => one < 0)) throw new BadRequest('law.K has a negative stiffness');
  const isIsotropic = k.every((one) => Math.abs(one - k[0]) <= rounding * k[0]);
  if (can === 'isotropic' && !isIsotropic) throw new Skipped(`the program has one stiffness for all ${what}`);
}

function readLaw(law, kind) {
  if (!law) throw new BadRequest('law is missing');
  if ((law.type ?? 'linear') !== 'linear') throw new Skipped(`law.type '${law.type}': only linear ones`);
  const none = [0, 0, 0];
  if (kind === 'linear') return [readSprings(law.K, 3), none];
  if (kind === 'angular') return [none, readSprings(law.K, 3)];
  const k = readSprings(law.K, 6);
  return [k.slice(0, 3), k.slice(3)];
}

function readJoint(request, can) {
  const {kind} = request;
  if (!allKinds.includes(kind)) throw new BadRequest(`kind is '${kind}'; allowed: ${allKinds.join(', ')}`);
  if (!can.kinds.includes(kind)) throw new Skipped(`kind ${kind}: the program has no such joint`);
  const [kTrans, kRot] = readLaw(request.law, kind);
  checkSprings(can.trans, kTrans, 'translations');
  checkSprings(can.rot, kRot, 'rotations');
  return {kTrans, kRot, a: readBody(request, 'a'), b: readBody(request, 'b')};
}

function hello(can) {
  const law = can.trans === 'diagonal' && can.rot === 'diagonal' ? 'diagonal' : 'isotropic';
  return {
    name: can.name,
    version: can.version,
    kinds: can.kinds,
    law,
    digits: can.digits,
    frames: can.frames
  };
}

function answer(request, can) {
  try {
    if (request.hello) return hello(can);
    const loads = can.loads(readJoint(request, can));
    if (!loads.every(Number.isFinite)) throw new Error('the program gave loads that are not finite');
    return {loads};
  } catch (e) {
    if (e instanceof Skipped) return {skipped: e.message};
    const code = e instanceof BadRequest ? 'bad_request' : 'program_failed';
    return {error: {code, message: String(e?.message ?? e)}};
  }
}

function answerLine(line, can) {
  const refused = (code, message) => ({id: null, error: {code, message}});
  let request;
  try {
    request = JSON.parse(line);
  } catch (e) {
    return refused('malformed_json', e.message);
  }
  if (request === null || typeof request !== 'object' || Array.isArray(request)) {
    return refused('bad_request', 'a request is a JSON object');
  }
  return {id: request.id ?? null, ...answer(request, can)};
}

/** Loads [f_a, m_a, f_b, m_b] of a step from rest, from the velocities [v_a, w_a, v_b, w_b] after it. */
export function loadsOf({a, b}, velocities, step) {
  const sizes = [a.mass, a.inertia, b.mass, b.inertia];
  return velocities.flatMap((v, i) => v.map((part) => (part * sizes[i]) / step));
}

/** Runs work(keep), then frees, last first, what keep(object, free) was given: wasm collects no garbage. */
export function freeing(work) {
  const kept = [];
  try {
    return work((object, free) => {
      kept.push(() => free(object));
      return object;
    });
  } finally {
    while (kept.length > 0) kept.pop()();
  }
}

/** A program's main: reads requests, one a line, and answers each at once. Its only argument is the case. */
export async function run(cases) {
  const can = cases.find(({id}) => id === process.argv[2]);
  if (!can || process.argv.length !== 3) {
    process.stderr.write(`usage: ${process.argv[1]} CASE, one of: ${cases.map(({id}) => id).join(' ')}\n`);
    process.exit(2);
  }
  for await (const line of readline.createInterface({input: process.stdin})) {
    process.stdout.write(`${JSON.stringify(answerLine(line, can))}\n`);
  }
}
