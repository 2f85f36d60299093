// Loads of a kind against what they stand for: a cross of dead forces, and a law that has stresses at rest.
#include "verify/oracle/property.hpp"
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/oracle/worst.hpp"
#include "verify/studies/mechanisms/generic.hpp"

#include <fmt/format.h>

#include <cmath>

namespace halfway::verify {
namespace {

using reference::LoadType;
using reference::Path;
using reference::Scene;
using reference::SceneLoad;

Vec3<double> theta_of(const Scene& scene, const Entry& entry) {
  Path<double> path(scene, entry, entry.probe_xi);
  if (path.advance(1).status != Status::converged) return Vec3<double>::Constant(std::nan(""));
  return {path.output("theta_x"), path.output("theta_y"), path.output("theta_z")};
}

/// The joint of the generic scene under one load.
Scene under(const Entry& entry, Kind kind, const SceneLoad& load) {
  Scene out = generic_scene(entry, kind, 0.1);
  out.loads = {load};
  return out;
}

/// Pairs of dead forces at the ends of arms fixed to the node, each force f and arm r: f r^T + (-f)(-r)^T.
std::vector<SceneLoad> pair(const Vec3<double>& force, const Vec3<double>& arm) {
  std::vector<SceneLoad> out;
  for (const double sign : {1., -1.}) out.push_back({LoadType::fixed_force, sign * force, sign * arm});
  return out;
}

/// The moment of type `type` beside the forces that it stands for.
Finding as_forces(const Entry& entry, Kind kind, Draft f, LoadType type) {
  SceneLoad load = generic_scene(entry, kind, 0.1).loads.back();  // has an arm across it
  load.type = type;
  const Scene scene = under(entry, kind, load);
  const Mat3<double> at_rest = scene.joint.a.H * scene.joint.b.H.transpose();
  const double size = load.value.norm(), lever = 0.3;  // m
  const Vec3<double> e = load.value / size, p = at_rest * load.arm, q = e.cross(p);
  const auto node_axes = [&](const Vec3<double>& v) -> Vec3<double> { return at_rest.transpose() * v; };
  Scene forces = scene;
  const bool is_cross = type == LoadType::semi_tangential_moment;
  const double share = is_cross ? 0.5 : 1;  // of each arm
  forces.loads = pair(share * size / (2 * lever) * q, node_axes(lever * p));
  if (is_cross)
    for (const SceneLoad& force : pair(-share * size / (2 * lever) * p, node_axes(lever * q)))
      forces.loads.push_back(force);
  const Vec3<double> off = tapped(theta_of(scene, entry)) - theta_of(forces, entry);
  return f.measured(reference::largest_entry<double>(off))
      .in("rad")
      .at_most(1e-14, "some tens of roundings of loads, levers and rotations")
      .by(Oracle::independent);
}

/// The same law with a constant moment in it, axes of the clamped joint frame.
Entry stressed(const Entry& entry, const Vec3<double>& moment) {
  Entry out = entry;
  const auto own = entry.in_double.angular;
  out.in_double.angular = [own, moment](const JointSpec& spec, const Pose<double>& a, const Pose<double>& b,
                                        bool tangent) {
    AngularLoads<double> q = own(spec, a, b, tangent);
    const Vec3<double> more = a.R * spec.a.H * moment;
    q.m_b += more;
    if (tangent) q.m_b_wa -= skew<double>(more);
    return q;
  };
  return out;
}

/// Stresses at rest do what a held load of the opposite sign does: by both solvers.
Finding stresses(const Entry& entry, Kind, Draft f) {
  const Scene free = generic_scene(entry, Kind::angular, 0.03);
  const Vec3<double> moment = free.loads[4].value;
  Scene loaded = free, plain = free;
  SceneLoad held{LoadType::fixed_moment, -moment};
  held.held = true;
  loaded.loads.push_back(held);
  const Entry with = stressed(entry, free.joint.a.H.transpose() * moment);
  const Vec3<double> truth = theta_of(loaded, entry), one = tapped(theta_of(plain, with));
  const auto bodies = as_mechanism(plain);
  const reference::mechanism::Model<double> model(bodies, with, entry.probe_xi);
  reference::mechanism::Follower<double> path(model);
  path.advance(1);
  Vec3<double> other;
  for (int i = 0; i < 3; ++i)
    other[i] = tapped(reference::mechanism::output(path, std::string("theta_") + char('x' + i)));
  Measurement worst;
  worst.include(reference::largest_entry<double>((one - truth).eval()), "one joint");
  worst.include(reference::largest_entry<double>((other - truth).eval()), "a mechanism");
  return f.measured(worst)
      .in("rad")
      .at_most(1e-14, "some tens of roundings of loads and rotations")
      .by(Oracle::closed_form);
}

}  // namespace

void mechanism_loads(Checks& checks) {
  for (const LoadType type : {LoadType::semi_tangential_moment, LoadType::quasi_tangential_moment})
    add_property(checks, to_string(type), {Kind::angular, Kind::linear_angular},
                 [type](const Entry& entry, Kind kind, Draft f) {
                   return as_forces(entry, kind, std::move(f), type);
                 });
  add_property(checks, "stresses_at_rest", {Kind::angular}, stresses);
}

}  // namespace halfway::verify
