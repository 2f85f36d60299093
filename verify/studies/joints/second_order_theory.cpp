#include "verify/studies/joints/second_order_theory.hpp"

#include "reference/truth/second_order.hpp"

#include <algorithm>

namespace halfway::verify {
namespace {

bool is_one_of(const Entry& entry, std::initializer_list<std::string_view> names) {
  return std::ranges::find(names, entry.name) != names.end();
}

/// Turns by e about the body axes 3, 1, 2 are the rotation vector e + (-e2 e3, e3 e1, e1 e2)/2 to second
/// order: half the commutators of the turns, in their order.
Vec3<double> rotation_of_312(const Vec3<double>& e) {
  return e + Vec3<double>(-e[1] * e[2], e[2] * e[0], e[0] * e[1]) / 2;
}

}  // namespace

std::optional<double> force_frame(const Entry& entry) {
  if (entry.needs_xi) return entry.probe_xi;
  if (is_one_of(entry, {"attached_a", "jointc", "simbody_xyz", "field_a", "chrono_body"})) return 0;
  if (is_one_of(entry, {"attached_b", "field_b"})) return 1;
  if (is_one_of(entry, {"invariant", "conformal", "potential", "quaternion", "cayley", "helicoidal", "fasse",
                        "rod4", "rod34", "drake_rpy", "exudyn_intrinsic", "mbdyn_joint_inv"}))
    return 0.5;
  return std::nullopt;
}

std::optional<Vec3<double>> response_to_moment(const Entry& entry, const Vec3<double>& F,
                                               const Vec3<double>& m) {
  if (entry.facts.has_fingerprint)
    return reference::second_order_rotation<double>(F, m, entry.facts.alpha, entry.facts.beta);
  // The moment K e is applied in the axes of node a, which is clamped, or of node b, which the turn itself
  // moves.
  const Vec3<double> e = F.cwiseProduct(m);
  if (entry.name == "field_a") return rotation_of_312(e);
  if (entry.name == "field_b") return rotation_of_312(F.cwiseProduct(m - e.cross(m)));
  return std::nullopt;
}

}  // namespace halfway::verify
