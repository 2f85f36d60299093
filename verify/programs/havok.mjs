// Havok's constraint with six SPRING_FORCE motors, no damping. Havok only steps in time, from rest: moments
// are the change of angular momentum, forces what the constraint itself reports, since body velocities lose
// 0.3 m/s2 to Havok's stabilisation at low speed.
import fs from 'node:fs';

import initHavok from '@babylonjs/havok';

import {allKinds, fileOf, freeing, npmVersion, rotated, run} from './adapter.mjs';

const step = 1e-4; // s: smaller ones lose digits in Havok's single precision

const wasm = '@babylonjs/havok/lib/esm/HavokPhysics.wasm';
const H = await initHavok({wasmBinary: fs.readFileSync(fileOf(wasm))});

/** What a call gave beside its result; the result is a number, or the first of an array. */
function ok(returned) {
  const [result, ...values] = [returned].flat(1);
  if (result !== H.Result.RESULT_OK) throw new Error(`Havok refuses a call: ${result?.value ?? result}`);
  return values.length === 1 ? values[0] : values;
}

// Always of unit mass and inertia: Havok keeps their inverses to 8 bits, and its springs do not depend on
// them.
function addBody(world, {x, q}, keep) {
  const body = keep(ok(H.HP_Body_Create()), H.HP_Body_Release);
  const shape = keep(ok(H.HP_Shape_CreateSphere([0, 0, 0], 0.01)), H.HP_Shape_Release);
  ok(H.HP_Shape_SetFilterInfo(shape, [0, 0])); // in no group: it never collides
  ok(H.HP_Body_SetShape(body, shape));
  ok(H.HP_Body_SetMotionType(body, H.MotionType.DYNAMIC));
  ok(H.HP_Body_SetMassProperties(body, [[0, 0, 0], 1, [1, 1, 1], [0, 0, 0, 1]]));
  ok(H.HP_Body_SetLinearDamping(body, 0));
  ok(H.HP_Body_SetAngularDamping(body, 0));
  ok(H.HP_World_AddBody(world, body, false));
  ok(H.HP_Body_SetQTransform(body, [x, [q[1], q[2], q[3], q[0]]]));
  keep(body, (added) => H.HP_World_RemoveBody(world, added));
  return body;
}

function setSpring(constraint, axis, k) {
  ok(H.HP_Constraint_SetAxisMode(constraint, axis, H.ConstraintAxisLimitMode.FREE));
  ok(H.HP_Constraint_SetAxisMotorType(constraint, axis, H.ConstraintMotorType.SPRING_FORCE));
  ok(H.HP_Constraint_SetAxisMotorStiffness(constraint, axis, k));
  ok(H.HP_Constraint_SetAxisMotorDamping(constraint, axis, 0));
  ok(H.HP_Constraint_SetAxisMotorMaxForce(constraint, axis, 1e30));
}

function addSprings(joint, a, b, keep) {
  const constraint = keep(ok(H.HP_Constraint_Create()), H.HP_Constraint_Release);
  const frame = ({o, h}) => [o, rotated(h, [1, 0, 0]), rotated(h, [0, 1, 0])];
  ok(H.HP_Constraint_SetParentBody(constraint, a));
  ok(H.HP_Constraint_SetChildBody(constraint, b));
  ok(H.HP_Constraint_SetAnchorInParent(constraint, ...frame(joint.a)));
  ok(H.HP_Constraint_SetAnchorInChild(constraint, ...frame(joint.b)));
  ok(H.HP_Constraint_SetCollisionsEnabled(constraint, 0));
  const {LINEAR_X, LINEAR_Y, LINEAR_Z, ANGULAR_X, ANGULAR_Y, ANGULAR_Z} = H.ConstraintAxis;
  const axes = [LINEAR_X, LINEAR_Y, LINEAR_Z, ANGULAR_X, ANGULAR_Y, ANGULAR_Z];
  axes.forEach((axis) => ok(H.HP_Constraint_SetAxisFriction(constraint, axis, 0)));
  [...joint.kTrans, ...joint.kRot].forEach((k, i) => {
    if (k > 0) setSpring(constraint, axes[i], k);
  });
  ok(H.HP_Constraint_SetEnabled(constraint, 1));
  return constraint;
}

function loads(joint) {
  return freeing((keep) => {
    const world = keep(ok(H.HP_World_Create()), H.HP_World_Release);
    ok(H.HP_World_SetGravity(world, [0, 0, 0]));
    ok(H.HP_World_SetIdealStepTime(world, step));
    ok(H.HP_World_SetSpeedLimit(world, 1e9, 1e9));
    const [a, b] = [addBody(world, joint.a, keep), addBody(world, joint.b, keep)];
    const constraint = addSprings(joint, a, b, keep);
    ok(H.HP_World_Step(world, step));
    const [impulse] = ok(H.HP_Constraint_GetAppliedImpulses(constraint)); // on b
    const force = impulse.map((part) => part / step);
    const moment = (body) => ok(H.HP_Body_GetAngularVelocity(body)).map((part) => part / step);
    return [...force.map((part) => -part), ...moment(a), ...force, ...moment(b)];
  });
}

await run([
  {
    id: 'havok',
    name: 'Havok constraint, six spring motors',
    version: npmVersion('@babylonjs/havok'),
    kinds: allKinds,
    trans: 'diagonal',
    rot: 'diagonal',
    digits: 4,
    frames: true,
    loads
  }
]);
