// Jolt's SixDOFConstraint with position motors as springs, no damping and no limits. Jolt only steps in time:
// a load is the change of momentum in one step from rest.
import initJolt from 'jolt-physics';

import {allKinds, freeing, loadsOf, npmVersion, rotated, run, Skipped} from './adapter.mjs';

const step = 1e-5; // s: springs are implicit, an error of K dt^2 / m beside the digits of a float

const J = await initJolt();

function openWorld() {
  const settings = new J.JoltSettings();
  const broadPhase = new J.BroadPhaseLayerInterfaceTable(1, 1);
  broadPhase.MapObjectToBroadPhaseLayer(0, new J.BroadPhaseLayer(0));
  settings.mObjectLayerPairFilter = new J.ObjectLayerPairFilterTable(1); // no pair collides
  settings.mBroadPhaseLayerInterface = broadPhase;
  settings.mObjectVsBroadPhaseLayerFilter = new J.ObjectVsBroadPhaseLayerFilterTable(
    broadPhase,
    1,
    settings.mObjectLayerPairFilter,
    1
  );
  const world = new J.JoltInterface(settings);
  world.GetPhysicsSystem().SetGravity(new J.Vec3(0, 0, 0));
  return world;
}

const world = openWorld();
const system = world.GetPhysicsSystem();
const bodies = system.GetBodyInterface();
const shape = new J.SphereShape(1);
shape.AddRef(); // else the first body's settings take it with them

const axes = ['TranslationX', 'TranslationY', 'TranslationZ', 'RotationX', 'RotationY', 'RotationZ'].map(
  (name) => J[`SixDOFConstraintSettings_EAxis_${name}`]
);

const components = (v) => [v.GetX(), v.GetY(), v.GetZ()];

function addBody(body, keep) {
  const own = (object) => keep(object, J.destroy);
  const [w, x, y, z] = body.q;
  const settings = own(
    new J.BodyCreationSettings(
      shape,
      own(new J.RVec3(...body.x)),
      own(new J.Quat(x, y, z, w)),
      J.EMotionType_Dynamic,
      0
    )
  );
  settings.mOverrideMassProperties = J.EOverrideMassProperties_MassAndInertiaProvided;
  settings.mMassPropertiesOverride.mMass = body.mass;
  settings.mMassPropertiesOverride.mInertia = J.Mat44.prototype.sScale(body.inertia);
  settings.mLinearDamping = settings.mAngularDamping = 0;
  settings.mMaxLinearVelocity = settings.mMaxAngularVelocity = 1e9;
  settings.mAllowSleeping = settings.mApplyGyroscopicForce = false;
  const made = bodies.CreateBody(settings);
  bodies.AddBody(made.GetID(), J.EActivation_Activate);
  return keep(made, () => {
    bodies.RemoveBody(made.GetID());
    bodies.DestroyBody(made.GetID());
  });
}

function setFrame(settings, end, {o, h}, own) {
  settings[`mPosition${end}`] = own(new J.RVec3(...o));
  settings[`mAxisX${end}`] = own(new J.Vec3(...rotated(h, [1, 0, 0])));
  settings[`mAxisY${end}`] = own(new J.Vec3(...rotated(h, [0, 1, 0])));
}

function setSpring(constraint, axis, k) {
  const motor = constraint.GetMotorSettings(axis);
  motor.mSpringSettings.mMode = J.ESpringMode_StiffnessAndDamping;
  motor.mSpringSettings.mStiffness = k;
  motor.mSpringSettings.mDamping = 0;
  motor.mMinForceLimit = motor.mMinTorqueLimit = -1e30;
  motor.mMaxForceLimit = motor.mMaxTorqueLimit = 1e30;
  constraint.SetMotorState(axis, J.EMotorState_Position);
}

function addSprings(joint, a, b, keep) {
  const own = (object) => keep(object, J.destroy);
  const settings = own(new J.SixDOFConstraintSettings());
  settings.mSpace = J.EConstraintSpace_LocalToBodyCOM;
  setFrame(settings, 1, joint.a, own);
  setFrame(settings, 2, joint.b, own);
  axes.forEach((axis) => settings.MakeFreeAxis(axis));
  const constraint = J.castObject(settings.Create(a, b), J.SixDOFConstraint);
  system.AddConstraint(constraint);
  keep(constraint, () => system.RemoveConstraint(constraint));
  [...joint.kTrans, ...joint.kRot].forEach((k, i) => {
    if (k > 0) setSpring(constraint, axes[i], k);
  });
  constraint.SetTargetPositionCS(own(new J.Vec3(0, 0, 0)));
  constraint.SetTargetOrientationCS(own(new J.Quat(0, 0, 0, 1)));
}

function loads(joint) {
  return freeing((keep) => {
    const [a, b] = [addBody(joint.a, keep), addBody(joint.b, keep)];
    addSprings(joint, a, b, keep);
    world.Step(step, 1);
    const velocities = [a, b].flatMap((body) => [
      components(body.GetLinearVelocity()),
      components(body.GetAngularVelocity())
    ]);
    return loadsOf(joint, velocities, step);
  });
}

/** With motors on one or two of the rotations Jolt has a law of its own. */
function partial(joint) {
  const off = joint.kRot.filter((k) => k === 0).length;
  if (off !== 1 && off !== 2) throw new Skipped('this case is for one or two rotations without stiffness');
  return loads(joint);
}

const jolt = {
  version: npmVersion('jolt-physics'),
  trans: 'diagonal',
  rot: 'diagonal',
  digits: 5,
  frames: true
};

await run([
  {...jolt, id: 'jolt', name: 'Jolt SixDOFConstraint', kinds: allKinds, loads},
  {
    ...jolt,
    id: 'jolt_partial',
    name: 'Jolt SixDOFConstraint, motors on one or two rotations',
    kinds: ['angular', 'linear_angular'],
    loads: partial
  }
]);
