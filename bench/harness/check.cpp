#include "bench/harness/check.hpp"

#include "reference/record/effort.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace halfway::bench {
namespace {

using reference::larger, reference::Measurement;
using reference::Real50;

struct Truth {
  Eigen::Matrix<Real50, Eigen::Dynamic, 1> loads;
  Eigen::Matrix<Real50, Eigen::Dynamic, Eigen::Dynamic> tangent;
  double strain = 0;  ///< |strain|
};

Truth truth(const reference::Entry& entry, const Inputs& in, int i, bool with_tangent, Given given) {
  const auto& e = entry.in_real50;
  const bool matrices = given == Given::matrices;
  const auto a = matrices ? reference::cast<Real50>(in.a[i]) : reference::exact_pose(in.qa[i]);
  const auto b = matrices ? reference::cast<Real50>(in.b[i]) : reference::exact_pose(in.qb[i]);
  Truth t;
  t.strain = double(Real50(e.strain(in.spec, a, b).norm()));
  if (in.spec.kind == Kind::angular) {
    const auto r = e.angular(in.spec, a, b, with_tangent);
    t.loads = r.m_b;
    t.tangent.resize(3, 6);
    if (with_tangent) t.tangent << r.m_b_wa, r.m_b_wb;
  } else {
    const auto r = e.point(in.spec, a, b, with_tangent);
    t.loads = r.q;
    if (with_tangent) t.tangent = r.tangent;
  }
  return t;
}

/// A few roundings, multiplied near pi by the poles of cayley and Euler measures (4 / (pi - 3) = 28 in
/// the tangent at our largest angle): 256 eps. Poses are absolute, so a small strain is what
/// cancellation leaves of rotations and offsets of order one, each three products from the data: 4 eps
/// of those, over the strain.
double limit(double strain, const Tolerance& t) { return 256 * t.eps + 4 * t.eps / strain + t.approximation; }

double error_of_loads(const Evaluated& value, const Truth& t, double stiffness) {
  return largest_difference(value.loads, t.loads) / larger(stiffness * t.strain, largest_entry(t.loads));
}
double error_of_tangent(const Evaluated& value, const Truth& t) {
  return largest_difference(value.tangent, t.tangent) / largest_entry(t.tangent);
}

constexpr int kQuickStep = 4;  // of the poses: the same ones each time

double stiffness_of(const Inputs& in) { return std::get<reference::LinearSpec>(in.spec.law).matrix.norm(); }

}  // namespace

Checked compare(std::string_view formulation, const Inputs& in, const std::vector<Evaluated>& values,
                Given given, const Tolerance& tolerance) {
  const reference::Entry* entry = reference::find_formulation(formulation);
  if (entry == nullptr) return {.message = "not in the registry: nothing to check against"};
  const double stiffness = stiffness_of(in);
  Measurement worst, excess;  // the latter of what its pose allows
  for (int i = 0; i < int(values.size()); i += reference::by_effort(1, kQuickStep)) {
    const bool with_tangent = values[i].tangent.size() > 0;
    const Truth t = truth(*entry, in, i, with_tangent, given);
    const double loads = error_of_loads(values[i], t, stiffness);
    const double error = with_tangent ? larger(loads, error_of_tangent(values[i], t)) : loads;
    const double allowed = limit(t.strain, tolerance);
    worst.include(error, {});
    excess.include(error / allowed,
                   fmt::format("pose {}: relative error {:.2e}, limit {:.2e}", i, error, allowed));
  }
  const bool passes = excess.value() <= 1;
  return {.error = worst.value(), .message = passes ? "" : excess.where()};
}

std::vector<ErrorAt> errors_by_range(std::string_view formulation, const Inputs& in,
                                     const EvaluateAll& evaluate, Given given) {
  const reference::Entry& entry = *reference::find_formulation(formulation);
  std::vector<ErrorAt> errors;
  for (const ErrorAt& range : phi_ranges()) {
    const Inputs moved = moved_into(in, range);
    const std::vector<Evaluated> values = evaluate(moved);
    Measurement worst;
    for (int i = 0; i < int(values.size()); ++i) {
      const bool of_tangent = values[i].tangent.size() > 0;
      const Truth t = truth(entry, moved, i, of_tangent, given);
      worst.include(
          of_tangent ? error_of_tangent(values[i], t) : error_of_loads(values[i], t, stiffness_of(moved)),
          {});
    }
    errors.push_back({range.from, range.to, worst.value()});
  }
  return errors;
}

}  // namespace halfway::bench
