#include "reports/advise/core/ratio.hpp"

#include "reports/cli/errors.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace halfway::advise {
namespace {

using reference::Scene;
using Principal = Eigen::SelfAdjointEigenSolver<Mat3<double>>;

/// Of the angular stiffness, in joint axes.
std::optional<Principal> principal_of(const Scene& scene) {
  const auto* law = std::get_if<reference::LinearSpec>(&scene.joint.law);
  if (!law || scene.joint.kind != Kind::angular) return std::nullopt;
  const Mat3<double> K = law->is_compliance ? Mat3<double>(law->matrix.inverse()) : Mat3<double>(law->matrix);
  Principal out((K + K.transpose()) / 2);
  return out.eigenvalues()[0] > 0 ? std::optional(out) : std::nullopt;
}

/// Bisected between a ratio at which the advice is as it is and one at which it is another.
Change changed_between(const Advice& advice, const std::map<std::string, Cost>& costs, double same,
                       double other, std::string instead, const std::string& own) {
  while (std::abs(std::log(other / same)) > 0.05) {  // 5 %: what a margin needs
    const double middle = std::sqrt(same * other);
    const std::string name = advised_at(advice, costs, middle);
    if (name == own)
      same = middle;
    else
      other = middle, instead = name;
  }
  return {other, 0, instead};
}

Change other_ratio(const Advice& advice, const std::map<std::string, Cost>& costs, double ratio, bool more) {
  const std::string own = advised_at(advice, costs, ratio);
  double same = ratio;
  for (int step = 0; step < 4; ++step) {
    const double next = more ? same * 2 : std::max(1., same / 2);
    const std::string name = advised_at(advice, costs, next);
    if (name != own) return changed_between(advice, costs, same, next, name, own);
    same = next;
    if (same == 1) break;
  }
  return {same, 0, "", true};
}

}  // namespace

std::optional<double> stiffness_ratio(const Scene& scene) {
  const auto principal = principal_of(scene);
  if (!principal) return std::nullopt;
  return principal->eigenvalues()[2] / principal->eigenvalues()[0];
}

Scene with_ratio(const Scene& scene, double ratio) {
  const Principal principal = *principal_of(scene);
  const Vec3<double> k = principal.eigenvalues();
  const double mean = std::cbrt(k.prod()), own = k[2] / k[0];
  Vec3<double> shape(1, std::sqrt(ratio), ratio);
  shape *= mean / std::cbrt(shape.prod());
  if (own > 1 + 1e-9) {
    const double power = std::log(ratio) / std::log(own);
    for (int i = 0; i < 3; ++i) shape[i] = mean * std::pow(k[i] / mean, power);
  }
  const Mat3<double>& Q = principal.eigenvectors();
  const Mat3<double> K = Q * shape.asDiagonal() * Q.transpose();
  Scene out = scene;
  out.joint.law = reference::LinearSpec{Eigen::MatrixXd((K + K.transpose()) / 2), false};
  return out;
}

bool has_other_ratios(const Advice& advice) {
  const bool again = advice.truth.kind == TruthKind::rod || advice.truth.kind == TruthKind::chain;
  return again && stiffness_ratio(advice.truth.scene).has_value() &&
         rotation_at(advice.answers, advice.envelope.rows - 1).has_value();
}

std::string advised_at(const Advice& advice, const std::map<std::string, Cost>& costs, double ratio) {
  Question question = advice.question;
  question.scene = with_ratio(advice.truth.scene, ratio);
  // The rotation stays as it is: that is the envelope.
  question.degrees = *rotation_at(advice.answers, advice.envelope.rows - 1) * 180 / M_PI;
  try {
    const Truth truth = truth_of(question.scene, question.truth);
    const Envelope envelope = envelope_of(question, truth);
    const Answers answers = truth.at(envelope.factors);
    if (answers.value.size() < envelope.rows) return "no truth";
    const auto judged = judge(question, truth, answers, envelope, advice.measure(), costs);
    const auto choice = choose(judged, question.tolerance);
    return choice ? judged[*choice].candidate.name(question.scene.joint.kind) : "";
  } catch (const reports::BadInput&) {
    return "no truth";  // so large a rotation is not reached with that stiffness
  }
}

void add_ratio_margin(const Advice& advice, const std::map<std::string, Cost>& costs, Margin& out) {
  if (!has_other_ratios(advice)) return;
  out.ratio = *stiffness_ratio(advice.truth.scene);
  out.less_ratio = other_ratio(advice, costs, out.ratio, false);
  out.more_ratio = other_ratio(advice, costs, out.ratio, true);
}

}  // namespace halfway::advise
