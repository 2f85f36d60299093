#include "reference/truth/rod/critical.hpp"

#include "reference/numbers/linear_algebra.hpp"
#include "reference/truth/rod/shooting.hpp"
#include "reference/truth/rod/zero.hpp"

#include <array>
#include <cmath>

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

Tangent tangent_about(const Rod& rod, int axis, double M, const Mat3<double>& moment_by_spin, int finer) {
  const Arrival tip = carried(rod, Vec3<double>::Zero(), M * Vec3<double>::Unit(axis), finer);
  const std::array others{(axis + 1) % 3, (axis + 2) % 3};
  const Mat3<double> flexibility = tip.changes.block<3, 3>(kSpin, kMoment);
  return {flexibility(others, others), moment_by_spin(others, others)};
}

/// @param value  (load, finer), which vanishes at the critical load
Critical first_with_error(const std::function<double(double, int)>& value, double low, double high,
                          int samples) {
  const auto zero = [&](int finer) {
    return first_zero([&](double load) { return value(load, finer); }, low, high, samples);
  };
  const double load = zero(kFiner);
  return {load, std::abs(load - zero(1))};
}

}  // namespace

Critical critical_semi_tangential(const Rod& rod, int axis, double high) {
  const auto value = [&](double M, int finer) {
    const Vec3<double> m = M * Vec3<double>::Unit(axis);
    return tangent_about(rod, axis, M, of_semi_tangential_moment(m), finer).smallest();
  };
  return first_with_error(value, 0, high, 16);
}

Critical critical_quasi_tangential(const Rod& rod, int axis, const Vec3<double>& arm, double high) {
  const Vec3<double> p = arm.cross(Vec3<double>::Unit(axis));
  const auto value = [&](double M, int finer) {
    return tangent_about(rod, axis, M, of_quasi_tangential_moment(M, p, arm), finer).smallest();
  };
  return first_with_error(value, 0, high, 16);
}

Critical critical_fork_moment(const Rod& rod, double high) {
  const auto value = [&](double M, int finer) {
    const State start{.m = Vec3<double>(0, 0, M)};
    const Arrival tip = carried(rod, Vec3<double>::Zero(), start.m, finer);
    return determinant(fork(start), tip.changes, fork(tip.end), kOutOfPlane);
  };
  return first_with_error(value, high / 16, high, 15);
}

Critical critical_tip_force(const Rod& rod, double high) {
  const auto value = [&](double F, int finer) {
    const Clamp clamp = at_clamp(rod, {.force = {0, F, 0}});
    const Changes transfer = carried(rod, clamp.n, clamp.m, finer).changes;
    return determinant(clamped(), transfer, free_end(of_fixed_moment()), kOutOfPlane);
  };
  return first_with_error(value, 0, high, 8);
}

}  // namespace halfway::reference::rod
