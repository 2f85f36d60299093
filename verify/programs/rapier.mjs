// Rapier's generic joint with force-based position motors on its six axes. Rapier only steps in time: a load
// is the change of momentum in one step from rest.
import RAPIER from '@dimforge/rapier3d-compat';

import {allKinds, freeing, inverse, loadsOf, npmVersion, product, rotated, run} from './adapter.mjs';

const step = 1e-5; // s: springs are implicit, an error of K dt^2 / m beside the digits of a float

const forceBased = 1;

const xyz = ([x, y, z]) => ({x, y, z});
const wxyz = ([w, x, y, z]) => ({w, x, y, z});

// Its joints have no turned frames: the body's axes are made those of the joint. The inertia is the same
// about all.
function addBody(world, {x, q, h, mass, inertia}) {
  const about = [inertia, inertia, inertia];
  const body = RAPIER.RigidBodyDesc.dynamic()
    .setTranslation(...x)
    .setRotation(wxyz(product(q, h)))
    .setAdditionalMassProperties(mass, xyz([0, 0, 0]), xyz(about), wxyz([1, 0, 0, 0]))
    .setCanSleep(false);
  return world.createRigidBody(body);
}

function addSprings(world, joint, a, b) {
  const anchor = ({h, o}) => xyz(rotated(inverse(h), o));
  const description = RAPIER.JointData.generic(anchor(joint.a), anchor(joint.b), xyz([1, 0, 0]), 0);
  const {rawSet, handle} = world.createImpulseJoint(description, a, b, true);
  // The classes for JavaScript have no joint with six motors; what is below them has.
  [...joint.kTrans, ...joint.kRot].forEach((k, axis) => {
    if (!(k > 0)) return;
    rawSet.jointConfigureMotorModel(handle, axis, forceBased);
    rawSet.jointConfigureMotorPosition(handle, axis, 0, k, 0);
  });
}

function loads(joint) {
  return freeing((keep) => {
    const world = keep(new RAPIER.World(xyz([0, 0, 0])), (made) => made.free());
    world.timestep = step;
    const [a, b] = [addBody(world, joint.a), addBody(world, joint.b)];
    addSprings(world, joint, a, b);
    world.step();
    const components = ({x, y, z}) => [x, y, z];
    const velocities = [a, b].flatMap((body) => [components(body.linvel()), components(body.angvel())]);
    return loadsOf(joint, velocities, step);
  });
}

await RAPIER.init();
await run([
  {
    id: 'rapier',
    name: 'Rapier generic joint, six position motors',
    version: npmVersion('@dimforge/rapier3d-compat'),
    kinds: allKinds,
    trans: 'diagonal',
    rot: 'diagonal',
    digits: 5,
    frames: true,
    loads
  }
]);
