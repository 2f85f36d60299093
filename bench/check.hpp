// Check before timing: what the timed code returns, against 50 digits.
#pragma once

#include "bench/case.hpp"
#include "bench/inputs.hpp"
#include "reference/registry.hpp"

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

/// The worst error over the poses: of loads relative to |K| |strain| or, where a measure amplifies
/// (cayley near pi), to the largest load; of tangents relative to the largest entry.
Checked compare(std::string_view formulation, const Inputs& in, const std::vector<Evaluated>& values);

}  // namespace halfway::bench
