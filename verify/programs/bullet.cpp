// Bullet's two 6-DOF spring constraints, six springs, no limits and no damping. Bullet only steps in time: a
// load is the change of momentum in one step from rest.
#include "verify/programs/adapter.hpp"

#include <btBulletDynamicsCommon.h>

#include <memory>

namespace halfway::programs {
namespace {

constexpr double kStep = 1e-6;  // s; the springs' impulse is linear in it: no smaller one is more exact

btVector3 vec(const Vec& v) { return {v[0], v[1], v[2]}; }
btQuaternion quat(const Quat& q) { return {q[1], q[2], q[3], q[0]}; }
Vec out(const btVector3& v) { return {v.x(), v.y(), v.z()}; }
btTransform frame(const Body& body) { return btTransform(quat(body.h), vec(body.o)); }

struct Rigid : btRigidBody {
  Rigid(const Body& body, btCollisionShape* shape)
      : btRigidBody(body.mass, nullptr, shape, btVector3(body.inertia, body.inertia, body.inertia)) {
    setDamping(0, 0);
    setActivationState(DISABLE_DEACTIVATION);
    setWorldTransform(btTransform(quat(body.q), vec(body.x)));
    updateInertiaTensor();
  }
};

struct World {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};

  World() {
    world.setGravity(btVector3(0, 0, 0));
    // Until nothing moves any more: rows of a joint are coupled, and each iteration treats one after the
    // other.
    world.getSolverInfo().m_numIterations = 1000;
    world.getSolverInfo().m_leastSquaresResidualThreshold = 0;
  }
};

double stiffness(const Joint& joint, int i) {
  return i < 3 ? joint.k_trans[std::size_t(i)] : joint.k_rot[std::size_t(i - 3)];
}

/// make(a, b) gives the constraint, its springs set.
template <class Make>
Loads one_step(const Joint& joint, Make make) {
  World w;
  btSphereShape shape(0.01);
  Rigid a(joint.a, &shape), b(joint.b, &shape);
  for (btRigidBody* body : {static_cast<btRigidBody*>(&a), static_cast<btRigidBody*>(&b)})
    w.world.addRigidBody(body, 0, 0);  // in no group: they never collide
  const auto constraint = make(a, b);
  w.world.addConstraint(constraint.get(), true);
  w.world.stepSimulation(kStep, 0, kStep);
  const auto force = [](const btRigidBody& body, double mass) {
    return out(body.getLinearVelocity() * (mass / kStep));
  };
  const auto moment = [](const btRigidBody& body, double inertia) {
    return out(body.getAngularVelocity() * (inertia / kStep));
  };
  const Loads loads{force(a, joint.a.mass), moment(a, joint.a.inertia), force(b, joint.b.mass),
                    moment(b, joint.b.inertia)};
  w.world.removeConstraint(constraint.get());
  w.world.removeRigidBody(&a);
  w.world.removeRigidBody(&b);
  return loads;
}

void free_axis(auto& constraint, int i) { constraint.setLimit(i, 1, -1); }

/// The older class.
Loads spring(const Joint& joint, bool frame_offset) {
  return one_step(joint, [&](Rigid& a, Rigid& b) {
    auto c = std::make_unique<btGeneric6DofSpringConstraint>(a, b, frame(joint.a), frame(joint.b), true);
    c->setUseFrameOffset(frame_offset);
    for (int i = 0; i < 6; ++i) {
      free_axis(*c, i);
      c->enableSpring(i, stiffness(joint, i) != 0);
      c->setStiffness(i, stiffness(joint, i));
      c->setDamping(i, 1);  // its word for none
      c->setEquilibriumPoint(i, 0);
    }
    return c;
  });
}

Loads spring2(const Joint& joint, bool infinite_error) {
  return one_step(joint, [&](Rigid& a, Rigid& b) {
    auto c = std::make_unique<btGeneric6DofSpring2Constraint>(a, b, frame(joint.a), frame(joint.b));
    for (int i = 0; i < 6; ++i) {
      free_axis(*c, i);
      c->enableSpring(i, stiffness(joint, i) != 0);
      c->setStiffness(i, stiffness(joint, i), false);
      c->setDamping(i, 0, false);
      c->setEquilibriumPoint(i, 0);
    }
    // The bit of BT_6DOF_FLAGS_USE_INFINITE_ERROR is also that of axis 4's stop CFM, and this is its only
    // setter. With it a spring asks for its whole impulse; without, for a velocity that its share of the mass
    // would take.
    if (infinite_error) c->setParam(BT_CONSTRAINT_STOP_CFM, 0, 4);
    return c;
  });
}

Case bullet(const char* id, const char* name, std::function<Loads(const Joint&)> loads) {
  const int version = btGetVersion();
  return {
      .id = id,
      .name = name,
      .version = std::to_string(version / 100) + "." + std::to_string(version % 100) + ", double precision",
      .kinds = kAllKinds,
      .trans = Springs::diagonal,
      .rot = Springs::diagonal,
      .digits = 12,
      .frames = true,
      .loads = std::move(loads)};
}

}  // namespace
}  // namespace halfway::programs

int main(int argc, char** argv) {
  using namespace halfway::programs;
  return run(argc, argv,
             {bullet("bullet_old", "Bullet btGeneric6DofSpringConstraint",
                     [](const Joint& joint) { return spring(joint, true); }),
              bullet("bullet_old_nooffset", "Bullet btGeneric6DofSpringConstraint, setUseFrameOffset(false)",
                     [](const Joint& joint) { return spring(joint, false); }),
              bullet("bullet", "Bullet btGeneric6DofSpring2Constraint, USE_INFINITE_ERROR",
                     [](const Joint& joint) { return spring2(joint, true); }),
              bullet("bullet_default", "Bullet btGeneric6DofSpring2Constraint as shipped",
                     [](const Joint& joint) { return spring2(joint, false); })});
}
