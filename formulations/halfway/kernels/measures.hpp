// Rotation measures parallel to the rotation vector, e = eta v, as algebra on the relative quaternion.
#pragma once

#include "halfway/joint/measures.hpp"
#include "halfway/kernels/motion.hpp"

namespace halfway::kernel {

/// In the half-way frame de = (beta + gamma v v^T) dspin, in frame a (beta (w - [v]) + delta v v^T)
/// dspin. beta_w, gamma_w: derivatives by w, for what follows from virtual work.
template <class T>
struct Measured {
  T eta{}, beta{}, gamma{}, delta{}, beta_w{}, gamma_w{};
};

/// The kernel of a measure: `kJet`, how much of the angle's jet it needs for the value, its rate and
/// the rate's derivative; `measured<order>`.
template <class Measure>
struct MeasureKernel;

template <>
struct MeasureKernel<RotationVectorMeasure> {
  static constexpr int kJet[3] = {0, 1, 2};
  template <int order, class T>
  static HALFWAY_INLINE Measured<T> measured(const Relative<T>& r, const AngleJet<T>& j) {
    Measured<T> m;
    m.eta = j.h;
    if constexpr (order >= 1) {
      m.beta = T(0.5) * j.h, m.delta = j.d;
      m.gamma = j.d - m.beta * r.iw;
    }
    if constexpr (order >= 2) m.beta_w = -j.d, m.gamma_w = j.d1 + (j.d + m.beta * r.iw) * r.iw;
    return m;
  }
};

/// Of the algebraic ones only eta, beta and gamma differ.
struct AlgebraicMeasure {
  static constexpr int kJet[3] = {-1, -1, -1};
};

template <>
struct MeasureKernel<LinearMeasure> : AlgebraicMeasure {
  template <int order, class T>
  static HALFWAY_INLINE Measured<T> measured(const Relative<T>& r, const AngleJet<T>&) {
    return {r.w + r.w, r.w, -(r.w + r.w + T(1)) * r.iw, T(-1), T(1), -r.iw * r.iw};
  }
};

template <>
struct MeasureKernel<QuaternionMeasure> : AlgebraicMeasure {
  template <int order, class T>
  static HALFWAY_INLINE Measured<T> measured(const Relative<T>& r, const AngleJet<T>&) {
    return {T(2), T(1), -r.iw, T(0), T(0), r.iw * r.iw};
  }
};

template <>
struct MeasureKernel<CayleyMeasure> : AlgebraicMeasure {
  template <int order, class T>
  static HALFWAY_INLINE Measured<T> measured(const Relative<T>& r, const AngleJet<T>&) {
    const T c = T(1) / r.w, c2 = c * c, gamma = r.iw * c2;
    return {c + c, c, gamma, c2, -c2, -gamma * (r.iw + c + c)};
  }
};

template <>
struct MeasureKernel<ConformalMeasure> : AlgebraicMeasure {
  template <int order, class T>
  static HALFWAY_INLINE Measured<T> measured(const Relative<T>& r, const AngleJet<T>&) {
    const T beta = r.iw + r.iw;
    return {beta + beta, beta, T(0), beta * r.iw, -beta * r.iw, T(0)};
  }
};

template <class M>
inline constexpr bool kVectorial = requires {
  MeasureKernel<M>::kJet;
};

}  // namespace halfway::kernel
