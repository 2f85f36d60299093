// What the paper's identities speak of: samples, the two nodes at a sample, and their perturbation by duals.
#pragma once

#include "halfway/rotations/so3.hpp"
#include "reference/numbers/dual.hpp"
#include "reference/numbers/precision.hpp"
#include "verify/oracle/saboteurs/tap.hpp"

#include <Eigen/LU>

#include <cmath>
#include <vector>

namespace halfway::verify::identity {

template <class T>
using Dual = reference::Dual<T>;

/// Exact in double, and so the same in both scalars.
struct Sample {
  Vec3<double> theta, d, arm_a, arm_b;
  double xi;
};

inline std::vector<Sample> samples() {
  const double angles[] = {1e-8, 1e-4, 0.02, 0.4, 1.1, 1.5707963, 2.2, 3.0, 3.1405, 3.1415920};
  const double xis[] = {0.5, 0.3, -0.435917, 0.55, 1.4};
  std::vector<Sample> out;
  for (int i = 0; i < 30; ++i) {
    const double a = std::sin(1 + 7.3 * i), b = std::sin(2 + 4.1 * i), c = std::cos(5.7 * i);
    const Vec3<double> n = Vec3<double>(a, b, c).normalized();
    out.push_back({angles[i % 10] * n, {b, -c, 0.6 * a}, {0.4 * c, a, 0.3}, {-0.7 * b, 0.2, c}, xis[i % 5]});
  }
  return out;
}

/// What the identities speak of, in scalar T: R_a is a generic rotation, joint frames as the nodes'.
template <class T>
struct At {
  explicit At(const Sample& s)
      : theta(s.theta.cast<T>()),
        d(s.d.cast<T>()),
        arm_a(s.arm_a.cast<T>()),
        arm_b(s.arm_b.cast<T>()),
        xi(s.xi) {
    P_a = so3::exp<T>(Vec3<T>(T(0.7), T(-1.3), T(0.4)));
    R = so3::exp(theta);
    P_b = P_a * R;
    tilde = so3::exp<T>(theta / T(2));
  }
  Vec3<T> theta, d, arm_a, arm_b;
  T xi;
  Mat3<T> P_a, P_b, R, tilde;
  Mat3<T> one = Mat3<T>::Identity();

  Mat3<T> frame(const T& x) const { return P_a * so3::exp<T>(x * theta); }
  Mat3<T> spin_tilde(const T& x) const {
    return x * so3::gamma<T>(x * theta) * so3::gamma_inverse(theta);
  }                                                                                           // [59]
  Mat3<T> spin(const T& x) const { return frame(x) * spin_tilde(x) * frame(x).transpose(); }  // [26]
  Vec3<T> zeta() const {  // [72], tilde theta = theta/2
    using std::tan;
    const T phi = theta.norm();
    return tan(T(phi / T(4))) / phi * theta;
  }
};

/// Vectors and matrices alike: an expression is evaluated once, not compiled once more in every function.
template <class T>
using Columns = Eigen::Matrix<T, 3, Eigen::Dynamic, 0, 3, 3>;

/// Largest entry; NaN comes through.
template <class T>
double size(const Columns<T>& m) {
  return double(largest_entry<T>(tapped(m)));
}

template <class T>
Mat3<Dual<T>> turning(const Mat3<T>& R, const Vec3<T>& spin) {
  const Mat3<T> rate = skew(spin) * R;
  Mat3<Dual<T>> out;
  for (int i = 0; i < 9; ++i) out.data()[i] = {R.data()[i], rate.data()[i]};
  return out;
}
template <class T>
Vec3<Dual<T>> moving(const Vec3<T>& v, const Vec3<T>& rate) {
  return {Dual<T>(v[0], rate[0]), Dual<T>(v[1], rate[1]), Dual<T>(v[2], rate[2])};
}
template <class T, int C>
Eigen::Matrix<T, 3, C> rate_of(const Eigen::Matrix<Dual<T>, 3, C>& m) {
  return m.unaryExpr([](const Dual<T>& x) { return x.d; });
}
template <class T, int C>
Eigen::Matrix<T, 3, C> value_of(const Eigen::Matrix<Dual<T>, 3, C>& m) {
  return m.unaryExpr([](const Dual<T>& x) { return x.v; });
}
/// Spin [3] of a rotation of dual numbers.
template <class T>
Vec3<T> spin_of(const Mat3<Dual<T>>& R) {
  return axial<T>(rate_of<T, 3>(R) * value_of<T, 3>(R).transpose());
}

template <class T>
Vec3<T> w_a() {
  return {T(0.3), T(0.8), T(-0.5)};
}
template <class T>
Vec3<T> w_b() {
  return {T(-0.6), T(0.2), T(0.9)};
}
template <class T>
Vec3<T> dx_a() {
  return {T(0.1), T(-0.4), T(0.7)};
}
template <class T>
Vec3<T> dx_b() {
  return {T(0.5), T(0.35), T(-0.2)};
}
template <class T>
Mat3<T> stiffness() {
  Mat3<T> K;
  K << T(1), T(0.25), T(-0.125), T(0.25), T(0.5), T(0.0625), T(-0.125), T(0.0625), T(2);
  return K;
}

}  // namespace halfway::verify::identity
