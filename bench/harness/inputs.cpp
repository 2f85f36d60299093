#include "bench/harness/inputs.hpp"

#include "reference/numbers/random.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace halfway::bench {
namespace {

using reference::Generator;
using std::numbers::pi;

/// Sum of springs of stiffness 1 to 100 along random directions: positive definite, nothing aligned.
Eigen::MatrixXd stiffness(Generator& g, int n) {
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n, n);
  for (int spring = 0; spring < n; ++spring) {
    Eigen::VectorXd v(n);
    for (double& x : v) x = g.uniform(-1, 1);
    K += std::pow(100.0, double(spring) / (n - 1)) * v * v.transpose();
  }
  return K;
}

/// Two nodes whose joint frames differ by phi in a random direction.
void add_pose(Inputs& in, Generator& g, double phi) {
  const auto pair = reference::turned_pair(g, phi, !in.spec.a.H.isIdentity(0));
  in.qa.push_back({g.vector(1), pair.a});
  in.a.push_back(reference::matrix_pose(in.qa.back()));
  const Pose<double>& a = in.a.back();
  const Mat3<double> R_b = reference::matrix_pose({{}, pair.b}).R;
  in.qb.push_back({a.x + a.R * in.spec.a.o + g.vector(0.3) - R_b * in.spec.b.o, pair.b});
  in.b.push_back(reference::matrix_pose(in.qb.back()));
}

}  // namespace

Inputs inputs(Kind kind, const Parameters& parameters, bool block_diagonal, bool ends,
              double (*convex_radius)(const Eigen::MatrixXd& K)) {
  Generator g(2011);
  Inputs in;
  in.spec.kind = kind;
  static_cast<Parameters&>(in.spec) = parameters;
  Eigen::MatrixXd K = stiffness(g, strain_count(kind));
  if (block_diagonal && kind == Kind::linear_angular) {
    K.topRightCorner(3, 3).setZero();
    K.bottomLeftCorner(3, 3).setZero();
  }
  in.spec.law = reference::LinearSpec{K, false};
  if (ends) {
    in.spec.a = {g.vector(0.5), reference::third_of_turn(1)};
    in.spec.b = {g.vector(0.5), reference::third_of_turn(-1)};
  }
  const bool is_series = convex_radius && kind != Kind::linear;
  const double span = is_series ? std::min(3e3, convex_radius(K) / 1e-3) : 3e3;
  for (int i = 0; i < kPoses; ++i) add_pose(in, g, 1e-3 * std::pow(span, g.uniform(0, 1)));
  return in;
}

std::vector<ErrorAt> phi_ranges() {
  std::vector<ErrorAt> ranges;
  const auto decade = [](int n) { return std::pow(10.0, n); };
  for (int n = -12; n < 0; ++n) ranges.push_back({decade(n), decade(n + 1)});
  ranges.push_back({1, pi - decade(-1)});
  for (int n = -1; n > -12; --n) ranges.push_back({pi - decade(n), pi - decade(n - 1)});
  return ranges;
}

Inputs moved_into(Inputs in, const ErrorAt& range) {
  Generator g(1968);
  const bool near_pi = range.from > 3;
  const double low = near_pi ? pi - range.from : range.from;
  const double high = near_pi ? pi - range.to : range.to;
  in.qa.clear(), in.qb.clear(), in.a.clear(), in.b.clear();
  for (int i = 0; i < kPosesInRange; ++i) {
    const double x = low * std::pow(high / low, g.uniform(0, 1));
    add_pose(in, g, near_pi ? pi - x : x);
  }
  return in;
}

}  // namespace halfway::bench
