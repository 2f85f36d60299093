// Small-load equilibria against second-order theory, an independent road to the solver's answers.
#include "reference/truth/second_order.hpp"
#include "verify/oracle/property.hpp"
#include "verify/oracle/scene_access.hpp"
#include "verify/studies/joints/second_order_theory.hpp"

#include <optional>

namespace halfway::verify {
namespace {

constexpr double kSmall = 1e-6;  // load factor: rotations of 1e-9 rad, third order 1e-9 of the second

Finding moment_response(const Entry& entry, Draft f) {
  if (!entry.facts.has_fingerprint) return f.left_out("its second order has no (alpha, beta) form");
  const reference::Scene& c2 = scene("c2_parallelepiped_small");
  const Vec3<double> m = kSmall * c2.loads.front().value;
  const auto theory =
      reference::second_order_rotation<double>(compliances(c2), m, entry.facts.alpha, entry.facts.beta);
  // attached_a has no coupling at all: hold it to the theory on the scale of the half-way one.
  const auto scale = reference::second_order_rotation<double>(compliances(c2), m, 0.5, 0)[1];
  return f.measured(double(rotation_at(c2.name, entry, entry.probe_xi, kSmall)[1]))
      .in("rad")
      .equal(theory[1], 1e-7 * std::abs(scale), "the third order is 1e-7 of the second at load factor 1e-6")
      .by(Oracle::closed_form);
}

Finding force_response(const Entry& entry, double xi, Draft f) {
  const reference::Scene& c6 = scene("c6_compression_shear");
  const Eigen::VectorXd F = compliances(c6);
  const Vec3<double> force = kSmall * c6.loads.front().value;
  const auto theory = reference::second_order_bending<double>(F.head<3>(), F.tail<3>(), force, xi);
  const auto scale = reference::second_order_bending<double>(F.head<3>(), F.tail<3>(), force, 0.5)[1];
  return f.measured(double(rotation_at(c6.name, entry, entry.probe_xi, kSmall)[1]))
      .in("rad")
      .equal(theory[1], 1e-5 * std::abs(scale),
             "the third order is the strain, 1e-7 at load factor 1e-6, times a factor of order 10")
      .by(Oracle::closed_form);
}

}  // namespace

void second_order(Checks& checks) {
  add_property(checks, "second_order_moment", {Kind::angular},
               [](const Entry& entry, Kind, Draft f) { return moment_response(entry, f); });
  add_property(checks, "second_order_force", {Kind::linear_angular},
               [](const Entry& entry, Kind, Draft f) -> Finding {
                 const auto xi = force_frame(entry);
                 if (xi) return force_response(entry, *xi, f);
                 return f.left_out("not one of the paper's forms: no theory for its force");
               });
}

}  // namespace halfway::verify
