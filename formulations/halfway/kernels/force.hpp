// Force and moment at the joint points from what the joint's frames see of them.
#pragma once

#include "halfway/kernels/spin_terms.hpp"

namespace halfway::kernel {

/// The moment on b as a frame of its own sees it, whose share of the relative spin is `spin`; global axes.
/// Its derivatives by the relative position (not read where there is a potential) and spin, and the force's
/// by the spin.
template <class T, class Spin>
struct Moment {
  V3<T> value;
  M3<T> p, w, f_w;
  Spin spin;
};

/// Which parts of the loads a kernel fills: f and b, to be carried and completed (loads.hpp); or all of them,
/// with joint points at the nodes.
enum class Fill { points, nodes };

/// Loads of a force in a frame that turns with the share A of the relative spin. At a fixed strain the force
/// changes by `both` w, w the frame's spin: d(f)/dw_a and d(f)/dw_b add up to it. There is a potential: mixed
/// derivatives are each other's transposes.
/// @param f_p  derivative of the force by the relative position
/// @param out  PointLoads, or what takes its parts as soon as they are known: what is stored early is not
///             kept in registers
template <Fill what, bool with_tangent, class T, class Spin, class Out>
HALFWAY_INLINE void fill(const V3<T>& d, const V3<T>& f, const S3<T>& f_p, const Spin& A, Out& out) {
  const V3<T> arm = cross(d, f), b = minus_spun(arm, A), a = -(b + arm);  // [24, 30]
  out.f.value = f, out.b.value = b;
  if constexpr (what == Fill::nodes) out.a.value = a;
  if constexpr (with_tangent) {
    out.f.x = full(f_p);
    const M3<T> both = minus_skew(times_skew(full(f_p), d), f);
    const M3<T> f_b = spun(both, A), f_a = both - f_b;
    out.f.wb = f_b, out.b.x = transposed(f_b);
    if constexpr (what == Fill::nodes) out.f.wa = f_a, out.a.x = transposed(f_a);
    const M3<T> of_b = minus_skew(times_skew(transposed(f_b), d), b);
    const M3<T> b_b = minus_rate(spun(of_b, A), arm, A), b_a = of_b - b_b;
    out.b.wb = b_b;
    if constexpr (what == Fill::nodes) {
      out.b.wa = b_a, out.a.wb = transposed(b_a);
      out.a.wa = minus_skew(times_skew(transposed(f_a), d) - transposed(b_a), a);
    }
  }
}
/// The same in frame a.
template <Fill what, bool with_tangent, class T, class Out>
HALFWAY_INLINE void fill(const V3<T>& d, const V3<T>& f, const S3<T>& f_p, const NoSpin&, Out& out) {
  const V3<T> a = cross(f, d);
  out.f.value = f, out.b.value = zero3<T>();
  if constexpr (what == Fill::nodes) out.a.value = a;
  if constexpr (with_tangent) {
    out.f.x = full(f_p), out.f.wb = zero33<T>(), out.b.x = zero33<T>(), out.b.wb = zero33<T>();
    if constexpr (what == Fill::nodes) {
      const M3<T> f_a = minus_skew(times_skew(full(f_p), d), f);
      out.f.wa = f_a, out.a.x = transposed(f_a), out.b.wa = zero33<T>(), out.a.wb = zero33<T>();
      out.a.wa = minus_skew(times_skew(transposed(f_a), d), a);
    }
  }
}

/// The same with a moment.
/// @tparam conservative  do both follow from one potential?
template <Fill what, bool conservative, bool with_tangent, class T, class Spin, class MomentSpin, class Out>
HALFWAY_INLINE void fill(const V3<T>& d, const V3<T>& f, const S3<T>& f_p, const Spin& A,
                         const Moment<T, MomentSpin>& m, Out& out) {
  constexpr bool carried = !std::is_same_v<Spin, NoSpin>;
  const V3<T> arm = cross(d, f), of_arm = minus_spun(arm, A);
  const V3<T> b = carried ? of_arm + m.value : m.value, a = -(b + arm);
  out.f.value = f, out.b.value = b;
  if constexpr (what == Fill::nodes) out.a.value = a;
  if constexpr (with_tangent) {
    out.f.x = full(f_p);
    const M3<T> both = minus_skew(times_skew(full(f_p), d), f);
    M3<T> f_b = m.f_w, b_x = conservative ? transposed(m.f_w) : m.p;
    if constexpr (carried) {
      const M3<T> share = spun(both, A);
      f_b = share + f_b, b_x = transposed(share) + b_x;
    }
    out.f.wb = f_b, out.b.x = b_x;
    const M3<T> f_a = both - f_b, a_x = conservative ? transposed(f_a) : transposed(both) - b_x;
    if constexpr (what == Fill::nodes) out.f.wa = f_a, out.a.x = a_x;
    const M3<T> turned_b = times_skew(b_x, d);
    M3<T> b_b = minus_turn(m.w, m.value, m.spin);
    if constexpr (carried) {
      const M3<T> share = spun(minus_skew(turned_b, of_arm), A) - transposed_spun(skew_times(d, m.f_w), A);
      b_b = minus_rate(share, arm, A) + b_b;
    }
    out.b.wb = b_b;
    if constexpr (what == Fill::nodes) {
      const M3<T> b_a = minus_skew(turned_b, b) - b_b;
      const M3<T> a_b = conservative ? transposed(b_a) : -(b_b + skew_times(d, f_b));
      out.b.wa = b_a, out.a.wb = a_b;
      out.a.wa = minus_skew(times_skew(a_x, d) - a_b, a);
    }
  }
}

}  // namespace halfway::kernel
