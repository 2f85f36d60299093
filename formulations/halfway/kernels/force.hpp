// Force and moment at the joint points from what the joint's frames see of them.
#pragma once

#include "halfway/kernels/spin_terms.hpp"

#include <type_traits>

namespace halfway::kernel {

/// The moment on b as its frame sees it, global axes, with its derivatives by the relative position
/// and spin, and the force's derivative by the spin.
template <class T>
struct Moment {
  V3<T> value;
  M3<T> p{}, w{}, f_w{};
};

/// Force on b and its moment, as derivatives by the position and the spin of b.
template <bool with_tangent, bool with_f_w, class T, class Spin>
HALFWAY_INLINE void force_at_points(const V3<T>& d, const V3<T>& f, const M3<T>& f_p, const M3<T>& f_w,
                                    const Spin& A, PointLoads<T>& out) {
  out.f.value = f;
  if constexpr (std::is_same_v<Spin, NoSpin>) {
    out.b.value = zero3<T>();
    if constexpr (with_tangent) {
      out.f.x = f_p;
      out.f.wb = with_f_w ? f_w : zero33<T>();
      out.b.x = out.b.wb = zero33<T>();
    }
  } else {
    const Load<T> b = arm<with_tangent, with_f_w>(d, f, f_p, f_w, A);
    out.b.value = b.value;
    if constexpr (with_tangent) {
      out.f.x = f_p;
      const M3<T> seen = minus_skew(times_skew(f_p, d), f);
      out.f.wb = with_f_w ? f_w + spun(seen, A) : spun(seen, A);
      out.b.x = b.x;
      const M3<T> carried = spun(minus_skew(times_skew(b.x, d), b.value), A);
      if constexpr (with_f_w || !std::is_same_v<Spin, FullSpin>)
        out.b.wb = b.wb + carried;
      else
        out.b.wb = carried;
    }
  }
}

/// The same with a moment, seen in a frame of its own whose spin is A_m.
template <bool with_tangent, class T, class Spin, class MomentSpin>
HALFWAY_INLINE PointLoads<T> with_moment(const V3<T>& d, const V3<T>& f, const M3<T>& f_p, const Moment<T>& m,
                                         const Spin& A, const MomentSpin& A_m) {
  PointLoads<T> out;
  force_at_points<with_tangent, true>(d, f, f_p, m.f_w, A, out);
  out.b.value = out.b.value + m.value;
  if constexpr (with_tangent) {
    out.b.x = out.b.x + m.p;
    out.b.wb = out.b.wb + minus_turn(m.w, m.value, A_m);
    if constexpr (!std::is_same_v<Spin, NoSpin>) out.b.wb = out.b.wb + spun(times_skew(m.p, d), A);
  }
  return out;
}

}  // namespace halfway::kernel
