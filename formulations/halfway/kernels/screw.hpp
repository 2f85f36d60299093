// The rate B of a measure parallel to the rotation vector, its own derivatives, and the strain B d that
// the logarithm on SE(3) makes of the relative position.
#pragma once

#include "halfway/kernels/measures.hpp"
#include "halfway/kernels/spins.hpp"

namespace halfway::kernel {

/// L(x) = d(B x)/d(spin) for constant x, B = beta + gamma v v^T the rate in the half-way frame.
template <class T>
HALFWAY_INLINE M3<T> rate_of_rate(const Relative<T>& r, const Measured<T>& m, const V3<T>& x) {
  const T along = dot(r.g, x);
  const T half_gamma = T(0.5) * m.gamma;
  const V3<T> row = half_gamma * x - ((T(0.5) * m.gamma_w + m.gamma * r.iw) * along) * r.g;
  return plus_diagonal(outer(r.g, row) - outer((T(0.5) * m.beta_w) * x, r.g), half_gamma * along);
}

/// l = B d, half-way and in global axes, with L = dl/d(spin).
template <class T>
struct ScrewStrain {
  Measured<T> measure;
  SymmetricAxial<T> B;
  V3<T> l;
  M3<T> L;

  /// d(L^T f)/d(spin) for constant d and f: the second derivative of f . B d.
  HALFWAY_INLINE M3<T> second(const Relative<T>& r, const AngleJet<T>& j, const V3<T>& d,
                              const V3<T>& f) const {
    const T gamma = measure.gamma, gamma_w = measure.gamma_w, iw2 = r.iw * r.iw, half(0.5);
    const T gamma_ww = j.d2 + (j.d1 - (T(2) * j.d + j.h * r.iw) * r.iw) * r.iw;
    const T P = dot(r.g, d), Q = dot(r.g, f), PQ = P * Q, fd = dot(f, d);
    const T mu = r.iw * gamma + half * gamma_w;
    const T k0 = mu * PQ + half * measure.beta_w * fd;
    const T k1 = (r.iw * gamma_w - iw2 * gamma + half * gamma_ww) * PQ - half * j.d1 * fd;
    const V3<T> u = P * f + Q * d;
    const auto V = [&](const V3<T>& x) { return half * (x - (r.iw * dot(r.g, x)) * r.g); };  // d(v)/d(spin)
    const M3<T> mixed = outer(half * gamma * f, V(d)) + outer(half * gamma * d, V(f));
    const V3<T> column = (T(0.25) * gamma_w) * u;
    const V3<T> row = half * (k1 + k0 * r.iw) * r.g - mu * V(u);
    return plus_diagonal(mixed - outer(column, r.g) + outer(r.g, row), -half * k0);
  }
};

template <class T>
HALFWAY_INLINE ScrewStrain<T> screw_strain(const Relative<T>& r, const AngleJet<T>& j, const V3<T>& d) {
  ScrewStrain<T> s;
  s.measure = MeasureKernel<RotationVectorMeasure>::measured<2>(r, j);
  s.B = {s.measure.beta, s.measure.gamma, r.g};
  s.l = s.B.times(d);
  s.L = rate_of_rate(r, s.measure, d);
  return s;
}

}  // namespace halfway::kernel
