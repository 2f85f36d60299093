// Loads and tangent in double against the same joint at 50 digits.
#include "reference/scene/joint/convexity.hpp"
#include "verify/oracle/property.hpp"
#include "verify/oracle/replay.hpp"

#include <fmt/format.h>

#include <limits>

namespace halfway::verify {
namespace {

struct Errors {
  double loads = 0, tangent = 0;
};

/// In eps. The loads' error is taken over max(|q|, |T|): poses are rounded to eps, and T carries that
/// into the loads whatever the algorithm.
Errors errors(const Entry& entry, const Probe& probe) {
  const auto in_double = reference::node_loads<double>(entry, probe.spec, probe.a, probe.b, true);
  const auto exact = reference::node_loads<Real50>(entry, probe.spec, reference::cast<Real50>(probe.a),
                                                   reference::cast<Real50>(probe.b), true);
  const double q_error = double(largest_entry<Real50>(in_double.q.cast<Real50>() - exact.q));
  const double T_error = double(largest_entry<Real50>(in_double.tangent.cast<Real50>() - exact.tangent));
  const double T_size = double(largest_entry<Real50>(exact.tangent));
  const double q_size = larger(double(largest_entry<Real50>(exact.q)), T_size);
  constexpr double eps = std::numeric_limits<double>::epsilon();
  return {q_error / q_size / eps, T_error / T_size / eps};
}

Finding worst(const Entry& entry, Kind kind, Draft f, double Errors::*member) {
  Measurement error;
  for (const Probe& probe : probes(entry, kind, 40, 1.2)) {
    // Beyond, what solves refuses; the terms of a series outgrow the law there and cancel.
    if (probe.phi > reference::convex_radius(entry, probe.spec)) continue;
    if (error.include(errors(entry, probe).*member, fmt::format("phi = {:.3g} rad", probe.phi)))
      error.set_replay(eval_request(std::string(entry.name), probe.spec, probe.a, probe.b));
  }
  return f.measured(error)
      .in("eps")
      .at_most(
          10,
          "a chain of about ten 3x3 products, half an eps each in the mean: twice the worst ever seen, 4.4")
      .by(Oracle::fifty_digits);
}

}  // namespace

void rounding(Checks& checks) {
  const auto kinds = {Kind::angular, Kind::linear, Kind::linear_angular};
  add_property(checks, "rounding", kinds,
               [](const Entry& e, Kind kind, Draft f) { return worst(e, kind, f, &Errors::loads); });
  add_property(checks, "rounding_tangent", kinds,
               [](const Entry& e, Kind kind, Draft f) { return worst(e, kind, f, &Errors::tangent); });
}

}  // namespace halfway::verify
