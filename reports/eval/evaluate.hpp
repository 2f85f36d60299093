// What a request asks for, at one pose: evaluated, and judged before anybody sees it.
#pragma once

#include "reports/eval/eval_request.hpp"

#include <optional>
#include <variant>

namespace halfway::reports {

struct EvalAnswer {
  Eigen::VectorXd strain;                 ///< m, then rad
  Eigen::Matrix<double, 12, 1> loads;     ///< N, N m, where they or the tangent are wanted
  Eigen::Matrix<double, 12, 12> tangent;  ///< where it is wanted
  std::optional<double> energy;           ///< J, where it is wanted and there is a potential
};

/// By the readable transcription, never by kernels or batches: these are held against its answers.
class Evaluator {
 public:
  using Law = std::variant<reference::AnyLaw<double, 3>, reference::AnyLaw<double, 6>>;

  /// @param request  has to outlive it
  explicit Evaluator(const EvalRequest& request);

  /// @return  why there is no answer: singular_pose, no finite result; beyond_convexity, an energy that is a
  /// series
  std::optional<reference::Refusal> operator()(const PosePair& pose, EvalAnswer& answer) const;

 private:
  struct Bounds;
  Bounds bounds(const PosePair& pose, const Eigen::VectorXd& strain) const;
  bool is_regular(const PosePair& pose, const EvalAnswer& answer) const;

  const EvalRequest* request_;
  Law law_;               ///< made once for all poses
  double convex_radius_;  ///< rad, the same
};

}  // namespace halfway::reports
