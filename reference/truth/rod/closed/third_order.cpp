#include "reference/truth/rod/closed/third_order.hpp"

#include "reference/truth/rod/chebyshev.hpp"

#include <stdexcept>

namespace halfway::reference::rod::closed {

Vec3<double> third_order_moment(const Mat3<double>& K, const Vec3<double>& theta) {
  const Vec3<double> w = K * theta, v = K.inverse() * w.cross(theta);
  return w - theta.cross(theta.cross(w)) / 24 - (K * theta.cross(v) + v.cross(w)) / 12;
}

Vec3<double> xi_of_taper(const std::function<Section(double s)>& taper, double length) {
  constexpr int kDegree = 32;  // a section that is smooth over the rod is known to rounding then
  const ChebyshevRule rule = chebyshev_rule(kDegree);
  Eigen::MatrixX3d C(kDegree + 1, 3);
  for (int i = 0; i <= kDegree; ++i) C.row(i) = length * taper(length * rule.points[i]).bending.transpose();
  const Eigen::MatrixX3d G = rule.integral * C;
  const Vec3<double> all = G.row(kDegree);
  Vec3<double> xi;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    if (all[j] == all[k]) throw std::invalid_argument("rod: two compliances are equal, no xi between them");
    const Eigen::ArrayXd mean = C.col(i).array() * (G.col(k) - G.col(j)).array();
    const Eigen::ArrayXd loop = G.col(j).array() * C.col(k).array() - G.col(k).array() * C.col(j).array();
    xi[i] = rule.integral.row(kDegree).dot((mean + loop / 2).matrix()) / (all[i] * (all[k] - all[j]));
  }
  return xi;
}

}  // namespace halfway::reference::rod::closed
