// The poses at which the tangent is computed by every method, and its truth at 50 digits.
#pragma once

#include "bench/harness/check.hpp"

#include <memory>

namespace halfway::bench {

inline constexpr double kEps = std::numeric_limits<double>::epsilon();

/// Poses and the tangent of a formulation at them, 50 digits, computed when first asked for.
class TangentTruth {
 public:
  TangentTruth(std::string formulation, Inputs in)
      : formulation_(std::move(formulation)), in_(std::move(in)) {}
  const Inputs& inputs() const { return in_; }
  /// Worst |value - truth| of any entry over the poses, relative to the largest entry of the truth.
  double error(const std::vector<Evaluated>& values);

 private:
  std::string formulation_;
  Inputs in_;
  std::vector<Eigen::Matrix<reference::Real50, Eigen::Dynamic, Eigen::Dynamic>> exact_;
};

/// One joint whose tangent every method computes.
struct TangentProblem {
  std::string formulation;
  Kind kind;
  TangentTruth timed;
  std::vector<TangentTruth> ranges;  ///< one for each of phi_ranges()
};

/// The problem of that formulation and kind, made once and shared by the methods.
std::shared_ptr<TangentProblem> tangent_problem(const std::string& formulation, Kind kind);

using Evaluate = std::function<Evaluated(const Pose<double>& a, const Pose<double>& b)>;

/// Loads to the rounding of every other case, the tangent to `limit` (relative to its largest entry), both
/// at the timed poses. The error is that of the tangent; `errors` too, which no limit holds: differences
/// fail near pi, and are shown failing.
Checked check_tangent(TangentProblem& problem, const Evaluate& evaluate, double limit);

}  // namespace halfway::bench
