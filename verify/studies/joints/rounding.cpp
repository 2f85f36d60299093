// Loads and tangent in double against the same joint at 50 digits.
#include "verify/oracle/property.hpp"

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
  const Eigen::Matrix<double, 12, 12> T = exact.tangent.cast<double>();
  const double q_error = (in_double.q.cast<Real50>() - exact.q).cast<double>().lpNorm<Eigen::Infinity>();
  const double T_error =
      (in_double.tangent.cast<Real50>() - exact.tangent).cast<double>().lpNorm<Eigen::Infinity>();
  const double T_size = T.lpNorm<Eigen::Infinity>();
  const double q_size = std::max(exact.q.cast<double>().lpNorm<Eigen::Infinity>(), T_size);
  constexpr double eps = std::numeric_limits<double>::epsilon();
  return {q_error / q_size / eps, T_error / T_size / eps};
}

Finding worst(const Entry& entry, Kind kind, Finding f, double Errors::*member) {
  for (const Probe& probe : probes(entry, kind, 40, 1.2)) {
    const double error = errors(entry, probe).*member;
    if (error >= f.value) {
      f.value = error;
      f.parameter = fmt::format("phi = {:.3g} rad", probe.phi);
    }
  }
  f.unit = "eps";
  f.oracle = Oracle::fifty_digits;
  f.high = 10;
  f.reason =
      "a chain of about ten 3x3 products, half an eps each in the mean: twice the worst ever seen, 4.4";
  return f;
}

}  // namespace

void rounding(Checks& checks) {
  const auto kinds = {Kind::angular, Kind::linear, Kind::linear_angular};
  add_property(checks, "rounding", kinds,
               [](const Entry& e, Kind kind, Finding f) { return worst(e, kind, f, &Errors::loads); });
  add_property(checks, "rounding_tangent", kinds,
               [](const Entry& e, Kind kind, Finding f) { return worst(e, kind, f, &Errors::tangent); });
}

}  // namespace halfway::verify
