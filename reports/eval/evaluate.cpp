#include "reports/eval/evaluate.hpp"

#include "reference/scene/joint/convexity.hpp"

#include <fmt/format.h>

#include <cmath>

namespace halfway::reports {

/// Bounds that a regular pose keeps. Near a singular pose rounding of 1e-16 is magnified; where a
/// result is 1e12 times what stress, lever arms and the measure's own rate (at most 1 + e^2 for
/// Cayley's tangent, the steepest) can make of it, no four digits of it are left.
struct Evaluator::Bounds {
  double strain, loads, tangent;
};

namespace {

Evaluator::Law law_of(const reference::JointSpec& spec) {
  if (strain_count(spec.kind) == 3) return reference::AnyLaw<double, 3>(spec.law);
  return reference::AnyLaw<double, 6>(spec.law);
}

/// The largest entries of a law's stress and stiffness.
struct Sizes {
  double stress, stiffness;
};

template <int N>
Sizes sizes(const reference::AnyLaw<double, N>& law, const Eigen::VectorXd& strain) {
  const LawResponse<double, N> response = law(Eigen::Matrix<double, N, 1>(strain));
  return {response.stress.cwiseAbs().maxCoeff(), response.stiffness.cwiseAbs().maxCoeff()};
}

reference::Refusal singular_pose(const reference::Entry& entry) {
  return {"singular_pose",
          fmt::format("{} has no finite result here: its rotation measure is singular at this relative "
                      "rotation, or the numbers overflow",
                      entry.name),
          ""};
}

/// NaN is out of any bound.
template <class M>
bool is_within(const M& values, double bound) {
  return values.allFinite() && values.cwiseAbs().maxCoeff() <= bound;
}

}  // namespace

Evaluator::Evaluator(const EvalRequest& request)
    : request_(&request),
      law_(law_of(request.spec)),
      convex_radius_(reference::convex_radius(*request.entry, request.spec)) {}

std::optional<reference::Refusal> Evaluator::operator()(const PosePair& pose, EvalAnswer& answer) const {
  const auto& evaluators = request_->entry->in_double;
  answer.strain = evaluators.strain(request_->spec, pose.a, pose.b);
  if (const double phi = answer.strain.tail<3>().norm(); phi > convex_radius_)
    return reference::Refusal("beyond_convexity",
                              reference::beyond_convexity(*request_->entry, phi, convex_radius_), "");
  if (request_->loads || request_->tangent) {
    const NodeLoads<double> loads =
        reference::node_loads<double>(*request_->entry, request_->spec, pose.a, pose.b, request_->tangent);
    answer.loads = loads.q;
    if (request_->tangent) answer.tangent = loads.tangent;
  }
  if (request_->energy) answer.energy = evaluators.energy(request_->spec, pose.a, pose.b);
  if (is_regular(pose, answer)) return std::nullopt;
  return singular_pose(*request_->entry);
}

Evaluator::Bounds Evaluator::bounds(const PosePair& pose, const Eigen::VectorXd& strain) const {
  constexpr double kLost = 1e12;
  const auto [stress, stiffness] = std::visit([&](const auto& law) { return sizes(law, strain); }, law_);
  double angle = 0;
  if (request_->spec.kind != Kind::linear) angle = strain.tail<3>().cwiseAbs().maxCoeff();
  const double lever =
      1 + (pose.b.x - pose.a.x).norm() + request_->spec.a.o.norm() + request_->spec.b.o.norm();
  const double rate = 1 + angle * angle;
  return {kLost, kLost * stress * lever * rate, kLost * (stiffness + stress) * lever * lever * rate * rate};
}

bool Evaluator::is_regular(const PosePair& pose, const EvalAnswer& answer) const {
  if (!answer.strain.allFinite()) return false;
  const Bounds bound = bounds(pose, answer.strain);
  const bool has_angles = request_->spec.kind != Kind::linear;
  if (has_angles && !is_within(answer.strain.tail<3>(), bound.strain)) return false;
  if ((request_->loads || request_->tangent) && !is_within(answer.loads, bound.loads)) return false;
  if (request_->tangent && !is_within(answer.tangent, bound.tangent)) return false;
  return !answer.energy || std::isfinite(*answer.energy);
}

}  // namespace halfway::reports
