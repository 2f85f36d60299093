// Isotropic tensor functions of a vector: the one algebraic object behind rotations and joints.
#pragma once

#include "halfway/rotations/scalar.hpp"
#include "halfway/rotations/stumpff.hpp"

namespace halfway {

/// M(theta) = 1 + b(s) [theta] + c(s) [theta]^2, s = |theta|^2.
/// exp, Gamma, Gamma^-1 and the map from relative position to either strain are of this form.
template <class T>
struct Isotropic {
  Jet<T> b, c;

  Isotropic transposed() const { return {{-b.f, -b.d1, -b.d2}, c}; }

  /// M itself, 3x3.
  Mat3<T> matrix(const Vec3<T>& theta) const;

  /// M v.
  Vec3<T> times(const Vec3<T>& theta, const Vec3<T>& v) const;

  /// d(M v)/d(theta) for constant v, 3x3.
  Mat3<T> derivative(const Vec3<T>& theta, const Vec3<T>& v) const;

  /// d2(f . M p)/d(theta)^2 for constant f and p, symmetric 3x3.
  Mat3<T> hessian(const Vec3<T>& theta, const Vec3<T>& p, const Vec3<T>& f) const;
};

template <class T>
Mat3<T> Isotropic<T>::matrix(const Vec3<T>& theta) const {
  const Mat3<T> x = skew(theta);
  return Mat3<T>::Identity() + b.f * x + c.f * x * x;
}

template <class T>
Vec3<T> Isotropic<T>::times(const Vec3<T>& theta, const Vec3<T>& v) const {
  const Vec3<T> t = theta.cross(v);
  return v + b.f * t + c.f * theta.cross(t);
}

template <class T>
Mat3<T> Isotropic<T>::derivative(const Vec3<T>& theta, const Vec3<T>& v) const {
  const Vec3<T> t = theta.cross(v);
  const Vec3<T> along = T(2) * (b.d1 * t + c.d1 * theta.cross(t));
  const Mat3<T> twist = skew(t) + skew(theta) * skew(v);
  return along * theta.transpose() - b.f * skew(v) - c.f * twist;
}

// f . M p = f.p + b t + c B with t = theta . k, k = p x f, B = (theta.p)(theta.f) - s (f.p).
template <class T>
Mat3<T> Isotropic<T>::hessian(const Vec3<T>& theta, const Vec3<T>& p, const Vec3<T>& f) const {
  const Vec3<T> k = p.cross(f);
  const T fp = f.dot(p), theta_f = theta.dot(f), theta_p = theta.dot(p);
  const T t = theta.dot(k);
  const T big_b = theta_p * theta_f - theta.squaredNorm() * fp;
  const Vec3<T> grad_b = p * theta_f + f * theta_p - (T(2) * fp) * theta;
  const T curvature = T(2) * (b.d2 * t + c.d2 * big_b);
  const Vec3<T> mixed = T(2) * (b.d1 * k + c.d1 * grad_b) + curvature * theta;
  const Mat3<T> half = mixed * theta.transpose() + c.f * (p * f.transpose());
  Mat3<T> h = half + half.transpose();
  h.diagonal().array() += T(2) * (b.d1 * t + c.d1 * big_b - c.f * fp);
  return h;
}

/// The identity map, for strains that need no rotation (node a's own frame).
template <class T>
Isotropic<T> constant_isotropic() {
  return {{T(0), T(0), T(0)}, {T(0), T(0), T(0)}};
}

}  // namespace halfway
