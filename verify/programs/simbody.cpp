// Simbody's Force::LinearBushing between two free bodies. Its loads are exact: forces of the system, no time
// step.
#include "verify/programs/adapter.hpp"

#include <Simbody.h>

namespace halfway::programs {
namespace {

SimTK::Vec3 vec(const Vec& v) { return {v[0], v[1], v[2]}; }
SimTK::Rotation rotation(const Quat& q) { return SimTK::Rotation(SimTK::Quaternion(q[0], q[1], q[2], q[3])); }
Vec out(const SimTK::Vec3& v) { return {v[0], v[1], v[2]}; }

SimTK::Body::Rigid rigid(const Body& body) {
  return SimTK::Body::Rigid(SimTK::MassProperties(body.mass, SimTK::Vec3(0), SimTK::Inertia(body.inertia)));
}

Loads loads(const Joint& joint) {
  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter(system);
  SimTK::GeneralForceSubsystem forces(system);
  const auto free_body = [&](const Body& body) {
    return SimTK::MobilizedBody::Free(matter.Ground(), SimTK::Transform(), rigid(body), SimTK::Transform());
  };
  const SimTK::MobilizedBody::Free a = free_body(joint.a), b = free_body(joint.b);
  const auto frame = [](const Body& body) { return SimTK::Transform(rotation(body.h), vec(body.o)); };
  SimTK::Vec6 stiffness;  // rotations first
  for (int i = 0; i < 3; ++i) {
    stiffness[i] = joint.k_rot[std::size_t(i)];
    stiffness[3 + i] = joint.k_trans[std::size_t(i)];
  }
  SimTK::Force::LinearBushing(forces, a, frame(joint.a), b, frame(joint.b), stiffness, SimTK::Vec6(0));

  SimTK::State state = system.realizeTopology();
  a.setQToFitTransform(state, SimTK::Transform(rotation(joint.a.q), vec(joint.a.x)));
  b.setQToFitTransform(state, SimTK::Transform(rotation(joint.b.q), vec(joint.b.x)));
  system.realize(state, SimTK::Stage::Dynamics);
  const auto& all = system.getRigidBodyForces(state, SimTK::Stage::Dynamics);
  const SimTK::SpatialVec on_a = all[a.getMobilizedBodyIndex()], on_b = all[b.getMobilizedBodyIndex()];
  return {out(on_a[1]), out(on_a[0]), out(on_b[1]), out(on_b[0])};
}

std::string version() {
  int major = 0, minor = 0, build = 0;
  SimTK_version_simbody(&major, &minor, &build);
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(build);
}

}  // namespace
}  // namespace halfway::programs

// Its headers are no C++20: no designated initializers here.
int main(int argc, char** argv) {
  using namespace halfway::programs;
  return run(argc, argv,
             {{"simbody", "Simbody Force::LinearBushing", version(), kAllKinds, Springs::diagonal,
               Springs::diagonal, 14, true, loads}});
}
