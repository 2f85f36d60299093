// One joint by two solvers: the joint's own coordinates, and bodies in space.
#include "verify/oracle/property.hpp"
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/oracle/worst.hpp"
#include "verify/studies/mechanisms/generic.hpp"

#include <cmath>

namespace halfway::verify {
namespace {

using reference::MechanismScene;
using reference::Path;
using reference::Scene;
using reference::Setting;

/// Largest difference of theta (rad) and u (m) at the end of the path, in the axes of the scene.
template <class T>
T difference(const Entry& entry, const Scene& scene, const Setting& setting) {
  const T lost(std::nan(""));
  Path<T> path(scene, entry, entry.probe_xi, setting);
  if (path.advance(1).status != Status::converged) return lost;
  const MechanismScene bodies = as_mechanism(scene, setting);
  const reference::mechanism::Model<T> model(bodies, entry, entry.probe_xi);
  reference::mechanism::Follower<T> mechanism(model);
  if (mechanism.advance(T(1)).status != Status::converged) return lost;
  const Mat3<T> axes = so3::exp<T>(setting.frame_turn.cast<T>()).transpose();
  T worst(0);
  for (const char* what : {"theta_", "u_"}) {
    const Kind without = what[0] == 'u' ? Kind::angular : Kind::linear;
    if (scene.joint.kind == without) continue;
    Vec3<T> one, other;
    for (int i = 0; i < 3; ++i) {
      const std::string name = what + std::string(1, char('x' + i));
      one[i] = path.output(name);
      other[i] = reference::mechanism::output(mechanism, name);
    }
    reference::keep_largest(worst, reference::largest_entry<T>((one - tapped(Vec3<T>(axes * other))).eval()));
  }
  return worst;
}

constexpr double kAngle = 0.05;  // of seven loads: jointc carries no more

Finding by_two_solvers(const Entry& entry, Kind kind, Draft f) {
  Measurement worst;
  const Scene scene = generic_scene(entry, kind, kAngle);
  for (const bool exchanged : {false, true}) {
    const Setting setting{exchanged, {0.3, -0.7, 0.5}, {0.2, 0.1, -0.4}};
    worst.include(difference<double>(entry, scene, setting),
                  exchanged ? "nodes exchanged" : "nodes as written");
  }
  return f.measured(worst)
      .in("rad, m")
      .at_most(1e-14, "some tens of roundings of positions and rotation matrices of order 1")
      .by(Oracle::independent);
}

std::vector<Finding> at_fifty_digits(const Entry& entry) {
  Measurement worst;
  for (const Kind kind : kKinds) {
    const Setting setting{true};  // where it stands: a turned scene is one in double
    const auto off = difference<Real50>(entry, generic_scene(entry, kind, kAngle), setting);
    worst.include(double(off), to_string(kind));
  }
  return {finding(std::string(entry.name) + "/mechanism_fifty_digits")
              .of(std::string(entry.name))
              .about("mechanisms")
              .measured(worst)
              .in("rad, m")
              .at_most(1e-40,
                       "Newton at 50 digits, through a stiffness ratio of 1e3 and some hundreds of roundings")
              .by(Oracle::independent)};
}

}  // namespace

void mechanism_agreement(Checks& checks) {
  add_property(checks, "mechanism_of_one_joint", {Kind::angular, Kind::linear, Kind::linear_angular},
               by_two_solvers);
  for (const char* name : {"invariant", "attached_a", "conformal", "chrono_body"}) {
    const Entry* entry = reference::find_formulation(name);
    if (entry)
      checks.push_back({std::string(name) + "/mechanism_fifty_digits", "mechanisms",
                        [entry] { return at_fifty_digits(*entry); }});
  }
}

}  // namespace halfway::verify
