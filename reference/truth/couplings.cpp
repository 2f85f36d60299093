#include "reference/truth/couplings.hpp"

#include "halfway/rotations/so3.hpp"

#include <Eigen/LU>

#include <cmath>
#include <stdexcept>

namespace halfway::reference {
namespace {

using T = Dual<Real50>;
using Vec6T = Eigen::Matrix<double, 6, 1>;
using Mat6T = Eigen::Matrix<double, 6, 6>;

/// d/de at e = 0 of the load's tangent by (dx_b, w_b) along the straight path (e d, exp(e theta)).
Mat6T tangent_rate(const Entry& entry, const JointSpec& spec, const Vec6T& q) {
  const T e(Real50(0), Real50(1));
  const Eigen::Matrix<T, 6, 1> path = q.cast<Real50>().cast<T>() * e;
  const Pose<T> a{Vec3<T>::Zero(), Mat3<T>::Identity()};
  const Pose<T> b{path.head<3>(), so3::exp<T>(path.tail<3>())};
  const auto [loads, tangent] = entry.in_dual50.point(spec, a, b, true);
  Mat6T rate;
  if (!loads.unaryExpr([](const T& x) { return double(x.v); }).allFinite())
    return Mat6T::Constant(std::nan(""));  // no series begins where the loads are no numbers
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) rate(i, j) = double(tangent(6 + i, 6 + j).d);
  }
  return rate;
}

}  // namespace

// With the load L(q) = K q + L_2(q, q) + ..., dL/de = T(e) q along the path, so L_2(q, q) = T'[q] q / 2 and
// the motion under l is q = C l - C L_2(C l, C l).
Couplings couplings(const Entry& entry, const JointSpec& spec) {
  if (spec.kind != Kind::linear_angular)
    throw std::invalid_argument("couplings are those of linear_angular joints");
  const auto* law = std::get_if<LinearSpec>(&spec.law);
  if (!law) throw std::invalid_argument("couplings are taken about a linear law");
  const Mat6T C = law->is_compliance ? Mat6T(law->matrix) : Mat6T(Mat6T(law->matrix).inverse());
  Couplings out;
  for (auto& Q : out) Q.setZero();
  for (int i = 0; i < 6; ++i) {
    const Mat6T bilinear = -0.5 * C * tangent_rate(entry, spec, C.col(i)) * C;  // columns j
    for (int k = 0; k < 6; ++k) {
      for (int j = 0; j < 6; ++j) {
        out[std::size_t(k)](i, j) += bilinear(k, j) / 2;
        out[std::size_t(k)](j, i) += bilinear(k, j) / 2;
      }
    }
  }
  return out;
}

}  // namespace halfway::reference
