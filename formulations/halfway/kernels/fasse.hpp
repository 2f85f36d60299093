// The kernel of the geometric spring: products of the quaternions' entries, and neither a half-way frame nor
// an angle.
//
// Vec(b x a*) = B x with B linear in either quaternion: e = 2 v changes by B^T dspin of node b, so that the
// moment is B mbar and its derivatives have B K B^T. Mixed derivatives of the potential are each other's
// transposes; so what at_nodes() adds to point() costs less than complete() does by objectivity and balance.
#pragma once

#include "halfway/kernels/force.hpp"
#include "halfway/kernels/response.hpp"
#include "halfway/systems/fasse.hpp"

namespace halfway::kernel {

/// B of Vec(b x a*) = B x.
template <class T>
HALFWAY_INLINE M3<T> between(const Quat<T>& a, const Quat<T>& b) {
  const T w = a.w * b.w, x = a.v.x * b.v.x, y = a.v.y * b.v.y, z = a.v.z * b.v.z;
  const T yz = a.v.y * b.v.z + a.v.z * b.v.y, zx = a.v.z * b.v.x + a.v.x * b.v.z,
          xy = a.v.x * b.v.y + a.v.y * b.v.x;
  const V3<T> u = a.w * b.v + b.w * a.v;
  return {{(w + x) - (y + z), xy - u.z, zx + u.y},
          {xy + u.z, (w + y) - (z + x), yz - u.x},
          {zx - u.y, yz + u.x, (w + z) - (x + y)}};
}

struct FasseKernel {
  static constexpr bool kBalanced = true, kSymmetricForce = true;
  template <Kind>
  static constexpr bool kConservative = true;
  static constexpr bool kSparesCoupling = true;  ///< a coupling has two fifths of the flops

  template <class Angle, bool with_tangent, class T, class L>
  HALFWAY_INLINE MomentLoads<T> angular(const Relative<T>& r, const L& law) const {
    const V3<T> e = T(2) * r.v;
    S3<T> K;
    if constexpr (with_tangent) K = law.stiffness(e);
    return moment<with_tangent>(r, between(r.a, r.b), law.stress(e), K);
  }

  template <class Angle, Kind kind, bool with_tangent, class T, class L>
  HALFWAY_INLINE PointLoads<T> point(const Relative<T>& r, const V3<T>& d, const L& law) const {
    PointLoads<T> out;
    put<Fill::points, coupling<kind, L>(), with_tangent>(d, parts<kind, with_tangent>(r, d, law), out);
    return out;
  }

  /// All loads and columns, with joint points at the nodes.
  template <class Angle, Kind kind, bool with_tangent, class T, class L, class Out>
  HALFWAY_INLINE void at_nodes(const Relative<T>& r, const V3<T>& d, const L& law, Out& out) const {
    put<Fill::nodes, coupling<kind, L>(), with_tangent>(d, parts<kind, with_tangent>(r, d, law), out);
  }

 private:
  /// What there is beside the forces.
  enum class Coupling { no_turn, none, all };
  template <Kind kind, class L>
  static constexpr Coupling coupling() {
    return kind == Kind::linear ? Coupling::no_turn : kCoupled<L> ? Coupling::all : Coupling::none;
  }

  /// Half of what the law answers at one node, global axes: force, its derivative K by d, and N by e, times
  /// B^T.
  template <class T>
  struct Half {
    V3<T> f;
    S3<T> K;
    M3<T> N;
  };
  template <class T>
  struct Parts {
    Half<T> a, b;
    MomentLoads<T> turn;  ///< of e alone, the positions constant
  };

  template <bool with_tangent, class T>
  static HALFWAY_INLINE MomentLoads<T> moment(const Relative<T>& r, const M3<T>& B, const V3<T>& mbar,
                                              const S3<T>& K) {
    MomentLoads<T> out;
    out.m = B * mbar;
    if constexpr (with_tangent) {
      const M3<T> symmetric = plus_diagonal(full(turned(B, K)), T(-0.5) * dot(r.v, mbar));
      out.wb = minus_skew(symmetric, T(0.5) * out.m);
      out.wa = -transposed(out.wb);
    }
    return out;
  }

  template <class T>
  static HALFWAY_INLINE S3<T> scaled(const T& s, const S3<T>& k) {
    return {s * k.xx, s * k.xy, s * k.xz, s * k.yy, s * k.yz, s * k.zz};
  }

  template <bool with_tangent, class T, class L>
  static HALFWAY_INLINE Half<T> half(const L& law, const M3<T>& P, const V3<T>& d, const V3<T>& p) {
    Half<T> h;
    respond<with_tangent>(law, P, p, d, h.f, h.K);
    h.f = T(0.5) * h.f;
    if constexpr (with_tangent) h.K = scaled(T(0.5), h.K);
    return h;
  }
  template <bool with_tangent, class T, class L>
  static HALFWAY_INLINE Half<T> half(const L& law, const M3<T>& P, const V3<T>& d, const Pair<T>& strain,
                                     const M3<T>& B) {
    Half<T> h;
    if constexpr (with_tangent) {
      const Stiffness6<T> k = law.stiffness(strain);
      h.K = turned(P, scaled(T(0.5), k.ff));
      if constexpr (kCoupled<L>) h.N = P * times_transposed(T(0.5) * k.fm, B);
      if constexpr (L::kLinear) {
        h.f = h.K * d;
        if constexpr (kCoupled<L>) h.f = h.f + P * (T(0.5) * (k.fm * strain.m));
        return h;
      }
    }
    h.f = P * (T(0.5) * law.stress(strain).f);
    return h;
  }

  template <Kind kind, bool with_tangent, class T, class L>
  static HALFWAY_INLINE Parts<T> parts(const Relative<T>& r, const V3<T>& d, const L& law) {
    const M3<T> P_a = matrix(r.a), P_b = matrix(r.b);
    const V3<T> p_a = d * P_a, p_b = d * P_b;
    if constexpr (kind == Kind::linear) {
      return {half<with_tangent>(law, P_a, d, p_a), half<with_tangent>(law, P_b, d, p_b), {}};
    } else {
      const M3<T> B = between(r.a, r.b);
      const V3<T> e = T(2) * r.v;
      const Pair<T> at_a{p_a, e}, at_b{p_b, e};
      return {half<with_tangent>(law, P_a, d, at_a, B), half<with_tangent>(law, P_b, d, at_b, B),
              mean_moment<with_tangent>(r, B, at_a, at_b, law)};
    }
  }
  /// A linear law is asked once, at the mean strain; one without coupling does not see the positions.
  template <bool with_tangent, class T, class L>
  static HALFWAY_INLINE MomentLoads<T> mean_moment(const Relative<T>& r, const M3<T>& B, const Pair<T>& at_a,
                                                   const Pair<T>& at_b, const L& law) {
    S3<T> K;
    if constexpr (L::kLinear || !kCoupled<L>) {
      const Pair<T> mean{T(0.5) * (at_a.f + at_b.f), at_a.m};
      if constexpr (with_tangent) K = law.stiffness(mean).mm;
      return moment<with_tangent>(r, B, law.stress(mean).m, K);
    } else {
      if constexpr (with_tangent) K = scaled(T(0.5), law.stiffness(at_a).mm + law.stiffness(at_b).mm);
      return moment<with_tangent>(r, B, T(0.5) * (law.stress(at_a).m + law.stress(at_b).m), K);
    }
  }

  /// d(force at one node)/d(its own spin), without e.
  template <class T>
  static HALFWAY_INLINE M3<T> by_spin(const V3<T>& d, const Half<T>& h) {
    return minus_skew(times_skew(full(h.K), d), h.f);
  }

  template <Fill what, Coupling coupling, bool with_tangent, class T, class Out>
  static HALFWAY_INLINE void put(const V3<T>& d, const Parts<T>& part, Out& out) {
    constexpr bool turns = coupling != Coupling::no_turn;
    const V3<T> b = cross(part.b.f, d), a = cross(part.a.f, d);
    out.f.value = part.a.f + part.b.f;
    out.b.value = turns ? b + part.turn.m : b;
    if constexpr (what == Fill::nodes) out.a.value = turns ? a - part.turn.m : a;
    if constexpr (with_tangent) {
      out.f.x = full(part.a.K + part.b.K);
      M3<T> coupled;  // d(f)/d(dspin)
      if constexpr (coupling == Coupling::all) coupled = part.a.N + part.b.N;
      put_b<coupling>(d, part, coupled, out);
      if constexpr (what == Fill::nodes) put_a<coupling>(d, part, coupled, out);
    }
  }
  /// The columns of b's spin, but for the moment on a.
  template <Coupling coupling, class T, class Out>
  static HALFWAY_INLINE void put_b(const V3<T>& d, const Parts<T>& part, const M3<T>& coupled, Out& out) {
    const M3<T> own = by_spin(d, part.b), f = coupling == Coupling::all ? own + coupled : own;
    out.f.wb = f, out.b.x = transposed(f);
    M3<T> b = -skew_times(d, own);
    if constexpr (coupling != Coupling::no_turn) b = b + part.turn.wb;
    if constexpr (coupling == Coupling::all) {
      const M3<T> arm = skew_times(d, part.b.N);
      b = b - (arm + transposed(arm));
    }
    out.b.wb = b;
  }
  /// The columns of a's spin, and those of the moment on a.
  template <Coupling coupling, class T, class Out>
  static HALFWAY_INLINE void put_a(const V3<T>& d, const Parts<T>& part, const M3<T>& coupled, Out& out) {
    const M3<T> own = by_spin(d, part.a), f = coupling == Coupling::all ? own - coupled : own;
    out.f.wa = f, out.a.x = transposed(f);
    M3<T> a = -skew_times(d, own), mixed = zero33<T>();
    if constexpr (coupling != Coupling::no_turn) a = a + transposed(part.turn.wb), mixed = part.turn.wa;
    if constexpr (coupling == Coupling::all) {
      const M3<T> arm_a = skew_times(d, part.a.N), arm_b = skew_times(d, part.b.N);
      a = a + (arm_a + transposed(arm_a));
      mixed = mixed + (arm_b - transposed(arm_a));
    }
    out.a.wa = a, out.b.wa = mixed, out.a.wb = transposed(mixed);
  }
};

}  // namespace halfway::kernel
