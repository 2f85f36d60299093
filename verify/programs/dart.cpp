// DART's joints with spring stiffness, between a body that is free in space and another that hangs on it.
// Loads are mass times acceleration of forward dynamics at rest.
#include "verify/programs/adapter.hpp"

#include <dart/config.hpp>
#include <dart/dynamics/BallJoint.hpp>
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/FreeJoint.hpp>
#include <dart/dynamics/Skeleton.hpp>

namespace halfway::programs {
namespace {

using dart::dynamics::BallJoint;
using dart::dynamics::BodyNode;
using dart::dynamics::FreeJoint;
using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kStep = 1e-9;  // s: springs are implicit, K h^2 adds to the inertia

Vec out(const Vector3d& v) { return {v[0], v[1], v[2]}; }

Isometry3d placed(const Quat& q, const Vec& x) {
  Isometry3d T = Isometry3d::Identity();
  T.linear() = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
  T.translation() = Vector3d(x[0], x[1], x[2]);
  return T;
}

void weigh(BodyNode& node, const Body& body) {
  node.setInertia({body.mass, Vector3d::Zero(), body.inertia * Eigen::Matrix3d::Identity()});
}

/// The joint's coordinates in its own type; the first three springs are the rotations'.
Eigen::VectorXd coordinates(const BallJoint&, const Isometry3d& relative) {
  return BallJoint::convertToPositions(relative.linear());
}
Eigen::VectorXd coordinates(const FreeJoint&, const Isometry3d& relative) {
  return FreeJoint::convertToPositions(relative);
}

template <class Type>
Loads forward(const Joint& joint) {
  const auto skeleton = dart::dynamics::Skeleton::create("two bodies");
  skeleton->setGravity(Vector3d::Zero());
  skeleton->setTimeStep(kStep);
  const auto [root, a] = skeleton->createJointAndBodyNodePair<FreeJoint>(nullptr);
  root->setName("root");  // DART says on stdout when it has to make names unique
  a->setName("a");
  const auto [spring, b] = skeleton->createJointAndBodyNodePair<Type>(a);
  weigh(*a, joint.a);
  weigh(*b, joint.b);
  const Isometry3d at_a = placed(joint.a.q, joint.a.x), in_a = placed(joint.a.h, joint.a.o);
  const Isometry3d at_b = placed(joint.b.q, joint.b.x), in_b = placed(joint.b.h, joint.b.o);
  root->setPositions(FreeJoint::convertToPositions(at_a));
  spring->setTransformFromParentBodyNode(in_a);
  spring->setTransformFromChildBodyNode(in_b);
  spring->setPositions(coordinates(*spring, (at_a * in_a).inverse() * (at_b * in_b)));
  for (std::size_t i = 0; i < spring->getNumDofs(); ++i)
    spring->setSpringStiffness(i, i < 3 ? joint.k_rot[i] : joint.k_trans[i - 3]);
  skeleton->computeForwardDynamics();
  const auto force = [](const BodyNode& node, double mass) {
    return times(mass, out(node.getCOMLinearAcceleration()));
  };
  const auto moment = [](const BodyNode& node, double inertia) {
    return times(inertia, out(node.getAngularAcceleration()));
  };
  return {force(*a, joint.a.mass), moment(*a, joint.a.inertia), force(*b, joint.b.mass),
          moment(*b, joint.b.inertia)};
}

/// The pin is put at both centres of mass, where it carries nothing: what moves the bodies is the spring
/// alone.
Loads ball(Joint joint) {
  joint.a.o = joint.b.o = {};
  return forward<BallJoint>(joint);
}

}  // namespace
}  // namespace halfway::programs

int main(int argc, char** argv) {
  using namespace halfway::programs;
  return run(argc, argv,
             {{.id = "dart_free",
               .name = "DART FreeJoint with spring stiffness",
               .version = DART_VERSION,
               .kinds = kAllKinds,
               .trans = Springs::diagonal,
               .rot = Springs::diagonal,
               .digits = 12,
               .frames = true,
               .loads = forward<FreeJoint>},
              {.id = "dart_ball",
               .name = "DART BallJoint with spring stiffness",
               .version = DART_VERSION,
               .kinds = {"angular"},
               .trans = Springs::diagonal,
               .rot = Springs::diagonal,
               .digits = 12,
               .frames = true,
               .loads = ball}});
}
