// Isotropic operators p + q [g] + r g g^T about the rotation's own axis, and the spins of frames.
//
// The rate of every measure parallel to the rotation vector, and the share of the relative spin that
// a frame takes, are of this form in every frame between the nodes and in global axes: nothing of
// them is ever rotated. Their products cost a cross product and a rank-one update.
#pragma once

#include "halfway/kernels/motion.hpp"

namespace halfway::kernel {

template <class T>
struct Axial {
  T p, q, r;
  V3<T> g;

  HALFWAY_INLINE V3<T> times(const V3<T>& x) const { return p * x + q * cross(g, x) + (r * dot(g, x)) * g; }
  HALFWAY_INLINE V3<T> transposed_times(const V3<T>& x) const {
    return p * x - q * cross(g, x) + (r * dot(g, x)) * g;
  }
  /// M A, A this operator.
  HALFWAY_INLINE M3<T> after(const M3<T>& M) const {
    return p * M + q * times_skew(M, g) + outer(M * (r * g), g);
  }
  /// A^T M.
  HALFWAY_INLINE M3<T> transposed_times(const M3<T>& M) const {
    return p * M - q * skew_times(g, M) + outer(r * g, g * M);
  }
};

/// Without the skew part: symmetric, as every rate is in the half-way frame.
template <class T>
struct SymmetricAxial {
  T p, r;
  V3<T> g;

  HALFWAY_INLINE V3<T> times(const V3<T>& x) const { return p * x + (r * dot(g, x)) * g; }
  HALFWAY_INLINE V3<T> transposed_times(const V3<T>& x) const { return times(x); }
  HALFWAY_INLINE M3<T> after(const M3<T>& M) const { return p * M + outer(M * (r * g), g); }
  HALFWAY_INLINE M3<T> transposed_times(const M3<T>& M) const { return p * M + outer(r * g, g * M); }
};

/// Share A of the relative spin that turns frame a: none. A^T x is what the arm of a force in that
/// frame leaves at b [24, 30]; rate(x) = d(A^T x)/d(relative spin) for constant x.
struct NoSpin {};

/// Frame b turns with all of it.
struct FullSpin {};

/// The half-way frame: A = (1 - [z])/2, z = tan(phi/4) n [32, 71].
template <class T>
struct HalfSpin {
  V3<T> z;
  T quarter;  ///< 1 / (4 (1 + w)): dz = 2 quarter dspin

  HALFWAY_INLINE V3<T> transposed_times(const V3<T>& x) const { return T(0.5) * (x + cross(z, x)); }
  HALFWAY_INLINE M3<T> transposed_times(const M3<T>& M) const { return T(0.5) * (M + skew_times(z, M)); }
  HALFWAY_INLINE M3<T> after(const M3<T>& M) const { return T(0.5) * (M - times_skew(M, z)); }
  HALFWAY_INLINE M3<T> plus_rate(const M3<T>& M, const V3<T>& x) const { return minus_skew(M, quarter * x); }
};

/// Frame xi: A = p + q [g] + r g g^T, with the derivatives of p, q, r by w and the rate of g.
template <class T>
struct WeightedSpin : Axial<T> {
  T p_w, q_w, r_w;
  Axial<T> vector_rate;  ///< d(v) of the relative quaternion by the relative spin, in frame xi
  using Axial<T>::transposed_times;

  HALFWAY_INLINE M3<T> plus_rate(const M3<T>& M, const V3<T>& x) const {
    const T along = dot(this->g, x);
    // A^T x = p x + q x cross v + r v (v . x); dw = -v . spin / 2.
    const V3<T> by_w = p_w * x + q_w * cross(x, this->g) + (r_w * along) * this->g;
    const M3<T> by_v = plus_diagonal(plus_skew(outer(this->r * this->g, x), this->q * x), this->r * along);
    return M + vector_rate.after(by_v) - outer(T(0.5) * by_w, this->g);
  }
};

}  // namespace halfway::kernel
