#include "reference/truth/rod/critical.hpp"

#include "reference/numbers/linear_algebra.hpp"
#include "reference/truth/rod/shooting.hpp"
#include "reference/truth/rod/zero.hpp"

#include <array>

namespace halfway::reference::rod {
namespace {

/// Of a state that is bent or twisted about `axis` alone, against turns about the other two.
struct Tangent {
  Eigen::Matrix2d flexibility;     ///< dw/dm
  Eigen::Matrix2d moment_by_spin;  ///< of the load

  /// flexibility^-1 - moment_by_spin is symmetric where the load is conservative.
  double smallest() const {
    const Eigen::Matrix2d K = flexibility.inverse() - moment_by_spin;
    return spectrum((K + K.transpose()) / 2).smallest;
  }
};

Tangent tangent_about(const Rod& rod, int axis, double M, const Mat3<double>& moment_by_spin) {
  const Arrival tip = carried(rod, Vec3<double>::Zero(), M * Vec3<double>::Unit(axis));
  const std::array others{(axis + 1) % 3, (axis + 2) % 3};
  const Mat3<double> flexibility = tip.changes.block<3, 3>(kSpin, kMoment);
  return {flexibility(others, others), moment_by_spin(others, others)};
}

}  // namespace

double critical_semi_tangential(const Rod& rod, int axis, double high) {
  return first_zero(
      [&](double M) {
        const Vec3<double> m = M * Vec3<double>::Unit(axis);
        return tangent_about(rod, axis, M, of_semi_tangential_moment(m)).smallest();
      },
      0, high, 16);
}

double critical_quasi_tangential(const Rod& rod, int axis, const Vec3<double>& arm, double high) {
  const Vec3<double> p = arm.cross(Vec3<double>::Unit(axis));
  return first_zero(
      [&](double M) { return tangent_about(rod, axis, M, of_quasi_tangential_moment(M, p, arm)).smallest(); },
      0, high, 16);
}

double critical_fork_moment(const Rod& rod, double high) {
  const auto value = [&](double M) {
    const State start{.m = Vec3<double>(0, 0, M)};
    const Arrival tip = carried(rod, Vec3<double>::Zero(), start.m);
    return determinant(fork(start), tip.changes, fork(tip.end), kOutOfPlane);
  };
  return first_zero(value, high / 16, high, 15);
}

double critical_tip_force(const Rod& rod, double high) {
  const auto value = [&](double F) {
    const Clamp clamp = at_clamp(rod, {.force = {0, F, 0}});
    const Changes transfer = carried(rod, clamp.n, clamp.m).changes;
    return determinant(clamped(), transfer, free_end(of_fixed_moment()), kOutOfPlane);
  };
  return first_zero(value, 0, high, 8);
}

}  // namespace halfway::reference::rod
