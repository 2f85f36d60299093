#include "reports/import/record/text.hpp"
#include "reports/import/scene/scene_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halfway::imports {
namespace {

constexpr double kTurn = 0.1, kMove = 1e-3;  // rad, m

/// Between the rows round zero, or of the nearest two.
double slope_at_zero(const AxisLaw& axis) {
  if (axis.x.empty()) return axis.stiffness;
  const auto above = std::ranges::upper_bound(axis.x, 0.0);
  const std::size_t i = std::clamp<std::size_t>(std::size_t(above - axis.x.begin()), 1, axis.x.size() - 1);
  return (axis.y[i] - axis.y[i - 1]) / (axis.x[i] - axis.x[i - 1]);
}

/// Along all three axes as the softest one allows; along that one alone where another is free to turn.
Vec3<double> softly(const Vec3<double>& k, double strain, bool alone_beside_free) {
  Vec3<double> out = Vec3<double>::Zero();
  double softest = INFINITY;
  int axis = 0;
  for (int i = 0; i < 3; ++i) {
    if (k[i] > 0 && k[i] < softest) softest = k[i], axis = i;
  }
  if (!std::isfinite(softest)) return out;
  if (alone_beside_free && k.minCoeff() <= 0)
    out[axis] = strain * softest;
  else
    out = (k.array() > 0).select(Vec3<double>::Constant(strain * softest / std::sqrt(3.0)), 0.0);
  return out;
}

}  // namespace

Eigen::MatrixXd stiffness_at_rest(const ImportedJoint& joint) {
  if (joint.axes.empty()) return joint.K;
  Eigen::VectorXd k(Eigen::Index(joint.axes.size()));
  for (std::size_t i = 0; i < joint.axes.size(); ++i) k[Eigen::Index(i)] = slope_at_zero(joint.axes[i]);
  return k.asDiagonal();
}

ExampleLoad example_load(const ImportedJoint& joint) {
  const Eigen::VectorXd k = stiffness_at_rest(joint).diagonal();
  ExampleLoad out;
  if (joint.kind != Kind::linear) {
    out.value = joint.a.H * softly(k.tail<3>(), kTurn, true);
    out.said = fmt::format("a moment of {:.3g} N m, at most {:g} rad about the softest axis",
                           out.value.norm(), kTurn);
  }
  if (out.value.isZero(0) && joint.kind != Kind::angular) {
    out.is_moment = false;
    out.value = joint.a.H * softly(k.head<3>(), kMove, false);
    out.point = joint.b.o;
    out.said = fmt::format("a force of {:.3g} N at the joint, at most {:g} mm along the softest axis",
                           out.value.norm(), 1e3 * kMove);
  }
  if (out.value.isZero(0))
    refuse({joint.line, "stiffness", "0"}, "of every axis: nothing holds this joint", "a stiffness > 0");
  return out;
}

}  // namespace halfway::imports
