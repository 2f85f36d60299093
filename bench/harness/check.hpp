// Check before timing: what the timed code returns, against 50 digits.
#pragma once

#include "bench/harness/case.hpp"
#include "bench/harness/inputs.hpp"
#include "reference/face/registry.hpp"
#include "reference/record/worst.hpp"

#include <limits>
#include <string_view>
#include <vector>

namespace halfway::bench {

/// Loads (m_b, or f_a m_a f_b m_b) and tangent of one pose; the tangent may be empty.
struct Evaluated {
  Eigen::VectorXd loads;
  Eigen::MatrixXd tangent;
};

template <bool with_tangent>
Evaluated evaluated(const AngularLoads<double>& r) {
  Evaluated out{r.m_b, {}};
  if constexpr (with_tangent) {
    out.tangent.resize(3, 6);
    out.tangent << r.m_b_wa, r.m_b_wb;
  }
  return out;
}

template <bool with_tangent>
Evaluated evaluated(const NodeLoads<double>& r) {
  Evaluated out{r.q, {}};
  if constexpr (with_tangent) out.tangent = r.tangent;
  return out;
}

/// Largest entry of |value - exact|, of which `exact` has 50 digits.
template <class D, class R>
double largest_difference(const D& value, const R& exact) {
  using reference::Real50;
  return double(reference::largest_entry<Real50>((value.template cast<Real50>() - exact).eval()));
}

/// Largest |entry|, in double.
template <class R>
double largest_entry(const R& exact) {
  return double(reference::largest_entry<reference::Real50>(exact));
}

/// What the poses are of which values were computed: rounded matrices, or quaternions.
enum class Given { matrices, quaternions };

/// How far values may be off: a few hundred roundings of `eps`, and what an approximation leaves out.
struct Tolerance {
  double eps = std::numeric_limits<double>::epsilon();
  double approximation = 0;  ///< relative
};

/// The worst error over the poses: of loads relative to |K| |strain| or, where a measure amplifies
/// (cayley near pi), to the largest load; of tangents relative to the largest entry.
/// Quick effort: every fourth pose.
Checked compare(std::string_view formulation, const Inputs& in, const std::vector<Evaluated>& values,
                Given given = Given::matrices, const Tolerance& tolerance = {});

/// Values of all poses of some inputs.
using EvaluateAll = std::function<std::vector<Evaluated>(const Inputs&)>;

/// The worst error of poses in each of phi_ranges(), of the tangent where there is one. No limit holds
/// it: it is shown.
std::vector<ErrorAt> errors_by_range(std::string_view formulation, const Inputs& in,
                                     const EvaluateAll& evaluate, Given given);

}  // namespace halfway::bench
