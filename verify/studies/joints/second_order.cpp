// Small-load equilibria against second-order theory, an independent road to the solver's answers.
#include "reference/truth/second_order.hpp"
#include "verify/oracle/property.hpp"
#include "verify/oracle/scene_access.hpp"

#include <optional>

namespace halfway::verify {
namespace {

constexpr double kSmall = 1e-6;  // load factor: rotations of 1e-9 rad, third order 1e-9 of the second

Finding against(Finding f, double value, double theory) {
  f.value = value;
  f.expected = theory;
  f.comparison = Comparison::equal;
  f.high = 1e-7 * std::abs(theory);
  f.oracle = Oracle::independent;
  f.unit = "rad";
  f.reason = "the third order is 1e-7 of the second at load factor 1e-6";
  return f;
}

Finding moment_response(const Entry& entry, Finding f) {
  if (!entry.facts.has_fingerprint) {
    f.verdict = Verdict::left_out;
    f.reason = "its second order has no (alpha, beta) form";
    return f;
  }
  const reference::Scene& c2 = scene("c2_parallelepiped_small");
  const Vec3<double> m = kSmall * c2.loads.front().value;
  const auto theory =
      reference::second_order_rotation<double>(compliances(c2), m, entry.facts.alpha, entry.facts.beta);
  // attached_a has no coupling at all: hold it to the theory on the scale of the half-way one.
  const auto scale = reference::second_order_rotation<double>(compliances(c2), m, 0.5, 0)[1];
  f = against(f, double(rotation_at(c2.name, entry, entry.probe_xi, kSmall)[1]), theory[1]);
  f.high = 1e-7 * std::abs(scale);
  return f;
}

Finding force_response(const Entry& entry, double xi, Finding f) {
  const reference::Scene& c6 = scene("c6_compression_shear");
  const Eigen::VectorXd F = compliances(c6);
  const Vec3<double> force = kSmall * c6.loads.front().value;
  const auto theory = reference::second_order_bending<double>(F.head<3>(), F.tail<3>(), force, xi);
  f = against(f, double(rotation_at(c6.name, entry, entry.probe_xi, kSmall)[1]), theory[1]);
  f.high = 1e-5 * std::abs(reference::second_order_bending<double>(F.head<3>(), F.tail<3>(), force, 0.5)[1]);
  f.reason = "the third order is the strain, 1e-7 at load factor 1e-6, times a factor of order 10";
  return f;
}

/// The frame xi of the force, for the systems of which formulations.md states it.
std::optional<double> force_frame(const Entry& entry) {
  if (entry.needs_xi) return entry.probe_xi;
  for (const char* name : {"attached_a", "jointc", "simbody_xyz", "field_a"}) {
    if (entry.name == name) return 0;
  }
  for (const char* name : {"attached_b", "field_b"}) {
    if (entry.name == name) return 1;
  }
  for (const char* name :
       {"invariant", "conformal", "potential", "quaternion", "cayley", "helicoidal", "drake_rpy"}) {
    if (entry.name == name) return 0.5;
  }
  return std::nullopt;
}

}  // namespace

void second_order(Checks& checks) {
  add_property(checks, "second_order_moment", {Kind::angular},
               [](const Entry& entry, Kind, Finding f) { return moment_response(entry, f); });
  add_property(checks, "second_order_force", {Kind::linear_angular}, [](const Entry& entry, Kind, Finding f) {
    const auto xi = force_frame(entry);
    if (xi) return force_response(entry, *xi, f);
    f.verdict = Verdict::left_out;
    f.reason = "not one of the paper's forms: cases.md has no theory for its force";
    return f;
  });
}

}  // namespace halfway::verify
