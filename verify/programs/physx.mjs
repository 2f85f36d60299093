// PhysX's PxD6Joint with drives as springs, stiffness only. PhysX only steps in time: a load is the change of
// momentum in one step from rest.
import fs from 'node:fs';

import initPhysX from 'physx-js-webidl';

import {allKinds, fileOf, freeing, loadsOf, npmVersion, run} from './adapter.mjs';

const step = 1e-5; // s: drives are implicit, an error of K dt^2 / m beside the digits of a float

/** The package is built for browsers: it refuses node, which is hidden while it starts. */
async function start() {
  const wasmBinary = fs.readFileSync(fileOf('physx-js-webidl/physx-js-webidl.wasm'));
  const hidden = globalThis.process;
  const toStderr = (text) => hidden.stderr.write(`${text}\n`);
  globalThis.window = globalThis;
  globalThis.document = {currentScript: null};
  globalThis.process = undefined;
  try {
    return await initPhysX({wasmBinary, print: toStderr, printErr: toStderr});
  } finally {
    globalThis.process = hidden;
    delete globalThis.window;
    delete globalThis.document;
  }
}

const P = await start();
const top = P.PxTopLevelFunctions.prototype;
const foundation = top.CreateFoundation(
  P.PHYSICS_VERSION,
  new P.PxDefaultAllocator(),
  new P.PxDefaultErrorCallback()
);
const tolerances = new P.PxTolerancesScale();
const physics = top.CreatePhysics(P.PHYSICS_VERSION, foundation, tolerances);
top.InitExtensions(physics);
const dispatcher = top.DefaultCpuDispatcherCreate(0);

const release = (made) => made.release();

/** Of objects of one request. */
function makers(keep) {
  const own = (object) => keep(object, P.destroy);
  return {
    own,
    vector: (v) => own(new P.PxVec3(...v)),
    transform(q, x) {
      const made = own(new P.PxTransform(P.PxIDENTITYEnum.PxIdentity));
      [made.q.w, made.q.x, made.q.y, made.q.z] = q;
      [made.p.x, made.p.y, made.p.z] = x;
      return made;
    },
    drive: (k) => own(new P.PxD6JointDrive(k, 0, 3e38, false))
  };
}

function addScene(make, keep) {
  const description = make.own(new P.PxSceneDesc(tolerances));
  description.gravity = make.vector([0, 0, 0]);
  description.cpuDispatcher = dispatcher;
  description.filterShader = top.DefaultFilterShader();
  return keep(physics.createScene(description), release);
}

function addBody(scene, body, make, keep) {
  const made = keep(physics.createRigidDynamic(make.transform(body.q, body.x)), release);
  made.setMass(body.mass);
  made.setMassSpaceInertiaTensor(make.vector([body.inertia, body.inertia, body.inertia]));
  made.setLinearDamping(0);
  made.setAngularDamping(0);
  made.setMaxLinearVelocity(1e15);
  made.setMaxAngularVelocity(1e15);
  made.setSolverIterationCounts(32, 1);
  made.setSleepThreshold(0);
  scene.addActor(made);
  return made;
}

function addJoint({a, b, kTrans}, bodyA, bodyB, make, keep) {
  const joint = keep(
    top.D6JointCreate(physics, bodyA, make.transform(a.h, a.o), bodyB, make.transform(b.h, b.o)),
    release
  );
  for (const axis of ['eX', 'eY', 'eZ', 'eTWIST', 'eSWING1', 'eSWING2']) {
    joint.setMotion(P.PxD6AxisEnum[axis], P.PxD6MotionEnum.eFREE);
  }
  ['eX', 'eY', 'eZ'].forEach((axis, i) => joint.setDrive(P.PxD6DriveEnum[axis], make.drive(kTrans[i])));
  return joint;
}

const drives = {
  swingTwist(d6, {kRot}, make) {
    d6.setAngularDriveConfig(P.PxD6AngularDriveConfigEnum.eSWING_TWIST);
    ['eTWIST', 'eSWING1', 'eSWING2'].forEach((axis, i) =>
      d6.setDrive(P.PxD6DriveEnum[axis], make.drive(kRot[i]))
    );
  },
  slerp(d6, {kRot}, make) {
    d6.setAngularDriveConfig(P.PxD6AngularDriveConfigEnum.eSLERP);
    d6.setDrive(P.PxD6DriveEnum.eSLERP, make.drive(kRot[0]));
  }
};

const loadsWith = (setRotations) => (joint) =>
  freeing((keep) => {
    const make = makers(keep);
    const scene = addScene(make, keep);
    const [a, b] = [addBody(scene, joint.a, make, keep), addBody(scene, joint.b, make, keep)];
    const d6 = addJoint(joint, a, b, make, keep);
    setRotations(d6, joint, make);
    d6.setDrivePosition(make.transform([1, 0, 0, 0], [0, 0, 0]));
    scene.simulate(step);
    scene.fetchResults(true);
    const components = ({x, y, z}) => [x, y, z];
    const velocities = [a, b].flatMap((body) => [
      components(body.getLinearVelocity()),
      components(body.getAngularVelocity())
    ]);
    return loadsOf(joint, velocities, step);
  });

const number = P.PHYSICS_VERSION;
const physx = {
  version: `${number >> 24}.${(number >> 16) & 255}.${(number >> 8) & 255}, ${npmVersion('physx-js-webidl')}`,
  kinds: allKinds,
  trans: 'diagonal',
  digits: 5,
  frames: true
};

await run([
  {
    ...physx,
    id: 'physx_swing_twist',
    name: 'PhysX PxD6Joint, swing and twist drives',
    rot: 'diagonal',
    loads: loadsWith(drives.swingTwist)
  },
  {
    ...physx,
    id: 'physx_slerp',
    name: 'PhysX PxD6Joint, slerp drive',
    rot: 'isotropic',
    loads: loadsWith(drives.slerp)
  }
]);
