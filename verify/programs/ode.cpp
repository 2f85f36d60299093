// ODE has no bushing: a Ball with an AMotor, or a Fixed joint, made soft by ERP = 1 and CFM = 1/(h k). ODE
// only steps in time: a load is the change of momentum in one step from rest.
#include "verify/programs/adapter.hpp"

#include <ode/ode.h>

#include <cmath>

namespace halfway::programs {
namespace {

constexpr double kStep = 1e-6;  // s; the error is O(h^2), and what is left of it goes by extrapolation

/// Of a spring that is not there: a row cannot be left out of a joint.
constexpr double kNone = 1e-30;

double cfm(double h, double k) { return 1 / (h * (k > 0 ? k : kNone)); }

Vec velocity(const dReal* v) { return {v[0], v[1], v[2]}; }

class World {
 public:
  World(const Joint& joint, double h) : h_(h), joint_(joint) {
    dWorldSetGravity(world_, 0, 0, 0);
    dWorldSetCFM(world_, 0);
    dWorldSetERP(world_, 0);
    a_ = make(joint.a);
    b_ = make(at_rest(joint));  // joints remember where the bodies were when they were attached
  }
  ~World() { dWorldDestroy(world_); }
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  void add_ball() {
    const Vec p = joint_point(joint_.a);
    const dJointID ball = dJointCreateBall(world_, nullptr);
    dJointAttach(ball, a_, b_);
    dJointSetBallAnchor(ball, p[0], p[1], p[2]);
    dJointSetBallParam(ball, dParamERP, 1);
    dJointSetBallParam(ball, dParamCFM, cfm(h_, joint_.k_trans[0]));
  }

  /// Three angles with stops at 0 on both sides.
  void add_euler_motor() {
    const dJointID motor = dJointCreateAMotor(world_, nullptr);
    dJointAttach(motor, a_, b_);
    dJointSetAMotorMode(motor, dAMotorEuler);
    const Quat P_a = joint_frame(joint_.a);
    const Vec x = rotated(P_a, {1, 0, 0}), z = rotated(P_a, {0, 0, 1});
    dJointSetAMotorAxis(motor, 0, 1, x[0], x[1], x[2]);
    dJointSetAMotorAxis(motor, 2, 2, z[0], z[1], z[2]);
    constexpr int groups[] = {0, dParamGroup2, dParamGroup3};
    for (std::size_t i = 0; i < 3; ++i) {
      dJointSetAMotorParam(motor, groups[i] + dParamLoStop, 0);
      dJointSetAMotorParam(motor, groups[i] + dParamHiStop, 0);
      dJointSetAMotorParam(motor, groups[i] + dParamStopERP, 1);
      dJointSetAMotorParam(motor, groups[i] + dParamStopCFM, cfm(h_, joint_.k_rot[i]));
    }
  }

  /// Its rows of rotation obey the world's ERP and CFM only, those of translation the joint's own.
  void add_fixed() {
    dWorldSetERP(world_, 1);
    dWorldSetCFM(world_, cfm(h_, joint_.k_rot[0]));
    const dJointID fixed = dJointCreateFixed(world_, nullptr);
    dJointAttach(fixed, a_, b_);
    dJointSetFixed(fixed);
    dJointSetFixedParam(fixed, dParamERP, 1);
    dJointSetFixedParam(fixed, dParamCFM, cfm(h_, joint_.k_trans[0]));
  }

  Loads step() {
    put(b_, joint_.b);
    dWorldStep(world_, h_);
    const auto force = [&](dBodyID id, double mass) {
      return times(mass / h_, velocity(dBodyGetLinearVel(id)));
    };
    const auto moment = [&](dBodyID id, double inertia) {
      return times(inertia / h_, velocity(dBodyGetAngularVel(id)));
    };
    return {force(a_, joint_.a.mass), moment(a_, joint_.a.inertia), force(b_, joint_.b.mass),
            moment(b_, joint_.b.inertia)};
  }

 private:
  dBodyID make(const Body& body) {
    const dBodyID id = dBodyCreate(world_);
    dMass mass;
    dMassSetParameters(&mass, body.mass, 0, 0, 0, body.inertia, body.inertia, body.inertia, 0, 0, 0);
    dBodySetMass(id, &mass);
    dBodySetGyroscopicMode(id, 0);
    put(id, body);
    return id;
  }

  static void put(dBodyID id, const Body& body) {
    const dQuaternion q = {body.q[0], body.q[1], body.q[2], body.q[3]};
    dBodySetPosition(id, body.x[0], body.x[1], body.x[2]);
    dBodySetQuaternion(id, q);
  }

  double h_;
  Joint joint_;
  dWorldID world_ = dWorldCreate();
  dBodyID a_, b_;
};

template <class Add>
Loads extrapolated(const Joint& joint, Add add) {
  return at_zero({1, 4}, [&](double squared) {
    World world(joint, kStep * std::sqrt(squared));
    add(world);
    return world.step();
  });
}

Loads ball_and_motor(const Joint& joint) {
  return extrapolated(joint, [](World& world) {
    world.add_ball();
    world.add_euler_motor();
  });
}

Loads fixed(const Joint& joint) {
  if (joint.b.o != Vec{})
    throw Skipped("ODE's Fixed joint works at the centre of mass of b: b.o has to be 0");
  return extrapolated(joint, [](World& world) { world.add_fixed(); });
}

}  // namespace
}  // namespace halfway::programs

int main(int argc, char** argv) {
  using namespace halfway::programs;
  dInitODE2(0);
  const std::string version = dODE_VERSION ", double precision";
  return run(argc, argv,
             {{.id = "ode_amotor",
               .name = "ODE Ball and AMotor (Euler), soft by ERP and CFM",
               .version = version,
               .kinds = kAllKinds,
               .trans = Springs::isotropic,
               .rot = Springs::diagonal,
               .digits = 9,
               .frames = true,
               .loads = ball_and_motor},
              {.id = "ode_fixed",
               .name = "ODE Fixed joint, soft by ERP and CFM",
               .version = version,
               .kinds = kAllKinds,
               .trans = Springs::isotropic,
               .rot = Springs::isotropic,
               .digits = 9,
               .frames = false,
               .loads = fixed}});
}
