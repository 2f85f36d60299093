// Kernels of other programs' joints, defects included; their headers say which.
#pragma once

#include "halfway/kernels/family.hpp"
#include "halfway/peers/chrono_body.hpp"
#include "halfway/peers/drake_rpy.hpp"
#include "halfway/peers/exudyn_intrinsic.hpp"
#include "halfway/peers/mbdyn_joint_inv.hpp"

namespace halfway::kernel {

/// Strain and law of a peer joint as its frame sees them: stresses in global axes, and their
/// derivatives by the relative position and spin seen there.
template <class T>
struct Seen {
  Load<T> f, m;  ///< x, wb: by position and spin
};

/// From what frame A sees to derivatives by the position and the spin of b.
template <class T, class Spin>
HALFWAY_INLINE void in_space(const V3<T>& d, const Spin& A, Load<T>& l) {
  l.wb = minus_turn(l.wb, l.value, A) + spun(times_skew(l.x, d), A);
}

/// Stresses of the strain (l, e) in frame F, l in global axes, with their derivatives by l and, at
/// constant l, by the spin: de = rate dspin.
template <Kind kind, bool with_tangent, class T, class L, class Rate>
HALFWAY_INLINE Seen<T> seen(const L& law, const M3<T>& F, const V3<T>& l, const Relative<T>& r, const T& eta,
                            const Rate& rate) {
  Seen<T> s{};
  if constexpr (kind == Kind::linear) {
    S3<T> K;
    respond<with_tangent>(law, F, l * F, l, s.f.value, K);
    if constexpr (with_tangent) s.f.x = full(K), s.f.wb = zero33<T>();
  } else {
    const Response<T> g = respond<with_tangent>(law, F, F, Pair<T>{l * F, eta * r.v}, Pair<T>{l, eta * r.g});
    s.f.value = g.f, s.m.value = g.m;
    if constexpr (with_tangent) {
      s.f.x = full(g.K.ff), s.f.wb = rate.after(g.K.fm);
      s.m.x = transposed(g.K.fm), s.m.wb = rate.after(full(g.K.mm));
    }
  }
  return s;
}

/// The rotation vector's measure, where a kind of joint has one.
template <Kind kind, bool with_tangent, class T>
HALFWAY_INLINE Measured<T> rotation_vector(const Relative<T>& r, const AngleJet<T>& j) {
  if constexpr (kind == Kind::linear)
    return {};
  else
    return MeasureKernel<RotationVectorMeasure>::measured < with_tangent ? 1 : 0 > (r, j);
}

/// Chrono: the motion of a seen from b, loads of opposite sign at both points, no arm.
struct ChronoKernel {
  static constexpr bool kBalanced = false;

  /// -law(-e): b's own motion where Chrono asks for a's.
  template <class L>
  struct Reversed {
    const L& law;
    static constexpr bool kLinear = L::kLinear;
    template <class S>
    HALFWAY_INLINE auto stress(const S& e) const {
      return minus(law.stress(minus(e)));
    }
    template <class S>
    HALFWAY_INLINE auto stiffness(const S& e) const {
      return law.stiffness(minus(e));
    }
    template <class T>
    static HALFWAY_INLINE V3<T> minus(const V3<T>& v) {
      return -v;
    }
    template <class T>
    static HALFWAY_INLINE Pair<T> minus(const Pair<T>& v) {
      return {-v.f, -v.m};
    }
  };

  using AtB = FamilyKernel<FrameB, RotationVectorMeasure, Projected>;

  template <class Angle, bool with_tangent, class T, class L>
  HALFWAY_INLINE MomentLoads<T> angular(const Relative<T>& r, const L& law) const {
    return AtB{}.template angular<Angle, with_tangent>(r, Reversed<L>{law});
  }

  template <class Angle, Kind kind, bool with_tangent, class T, class L>
  HALFWAY_INLINE PointLoads<T> point(const Relative<T>& r, const V3<T>& d, const L& law) const {
    const auto j = jet_at < Angle, kind == Kind::linear ? -1 : with_tangent ? 1 : 0 > (r);
    const auto F = frame<with_tangent>(FrameB{}, r, j);
    const Measured<T> e = rotation_vector<kind, with_tangent>(r, j);
    const Seen<T> s = seen<kind, with_tangent>(Reversed<L>{law}, F.F, d, r, e.eta, F.rate(r, e));
    PointLoads<T> out;
    out.f = s.f;
    if constexpr (kind == Kind::linear) {
      out.b = {zero3<T>(), zero33<T>(), {}, zero33<T>()};
    } else {
      out.b = s.m;
      if constexpr (with_tangent) in_space(d, F.spin, out.b);
    }
    if constexpr (with_tangent) in_space(d, F.spin, out.f);
    out.a.value = -out.b.value;
    if constexpr (with_tangent) out.a.x = -out.b.x, out.a.wb = -out.b.wb;
    return out;
  }
};

/// Drake: the conjugate half-way joint on roll, pitch, yaw, but with its force at the midpoint.
struct DrakeKernel {
  static constexpr bool kBalanced = true;

  using Equivalent = FamilyKernel<FrameHalfway, Euler321, Conjugate>;

  template <class Angle, bool with_tangent, class T, class L>
  HALFWAY_INLINE MomentLoads<T> angular(const Relative<T>& r, const L& law) const {
    return Equivalent{}.template angular<Angle, with_tangent>(r, law);
  }

  template <class Angle, Kind kind, bool with_tangent, class T, class L>
  HALFWAY_INLINE PointLoads<T> point(const Relative<T>& r, const V3<T>& d, const L& law) const {
    PointLoads<T> out = Equivalent{}.template point<Angle, kind, with_tangent>(r, d, law);
    // A^T = (1 + [z])/2 becomes 1/2: what [z] adds is taken away again.
    const HalfSpin<T> A{r.iw * r.g, T(0.25) * r.iw};
    const V3<T> half = T(0.5) * A.z, moment = cross(d, out.f.value);
    out.b.value = out.b.value + cross(half, moment);
    if constexpr (with_tangent) {
      Load<T> more;
      more.x = skew_times(half, minus_skew(skew_times(d, out.f.x), out.f.value));
      // d(z/2) = quarter dspin as the half-way frame sees it; in space that frame turns z too.
      const M3<T> z_wb = minus_turn(plus_diagonal(zero33<T>(), A.quarter), half, A);
      more.wb = skew_times(half, skew_times(d, out.f.wb)) - skew_times(moment, z_wb);
      out.b.x = out.b.x + more.x;
      out.b.wb = out.b.wb + more.wb;
    }
    return out;
  }
};

/// Exudyn: strains on SE(3), stresses applied half-way, arm -v/2 with the same sign on both nodes.
struct ExudynKernel {
  static constexpr bool kBalanced = false;

  using Half = FamilyKernel<FrameHalfway, RotationVectorMeasure, Projected>;

  template <class Angle, bool with_tangent, class T, class L>
  HALFWAY_INLINE MomentLoads<T> angular(const Relative<T>& r, const L& law) const {
    return Half{}.template angular<Angle, with_tangent>(r, law);
  }

  template <class Angle, Kind kind, bool with_tangent, class T, class L>
  HALFWAY_INLINE PointLoads<T> point(const Relative<T>& r, const V3<T>& d, const L& law) const {
    const auto j = jet_at<Angle, 2>(r);
    const auto H = frame<with_tangent>(FrameHalfway{}, r, j);
    const ScrewStrain<T> strain = screw_strain(r, j, d);
    const SymmetricAxial<T>& B = strain.B;  // dl = B dp + L dspin
    Seen<T> s = seen<kind, with_tangent>(law, H.F, strain.l, r, j.h, B);
    if constexpr (with_tangent) {
      for (Load<T>* l : {&s.f, &s.m}) {
        l->wb = l->wb + l->x * strain.L;
        l->x = B.after(l->x);
      }
    }
    // Couple -l x f / 2 on both nodes.
    const V3<T> half = T(0.5) * strain.l;
    Load<T> c;
    c.value = -cross(half, s.f.value);
    if constexpr (with_tangent) {
      const V3<T> half_f = T(0.5) * s.f.value;
      c.x = B.after(plus_skew(zero33<T>(), half_f)) - skew_times(half, s.f.x);
      c.wb = skew_times(half_f, strain.L) - skew_times(half, s.f.wb);
    }
    PointLoads<T> out;
    out.f = s.f, out.a = c, out.b = c;
    if constexpr (kind == Kind::linear_angular) {
      out.a.value = c.value - s.m.value, out.b.value = c.value + s.m.value;
      if constexpr (with_tangent) {
        out.a.x = c.x - s.m.x, out.a.wb = c.wb - s.m.wb;
        out.b.x = c.x + s.m.x, out.b.wb = c.wb + s.m.wb;
      }
    }
    if constexpr (with_tangent)
      for (Load<T>* l : {&out.f, &out.a, &out.b}) in_space(d, H.spin, *l);
    return out;
  }
};

/// MBDyn's invariant deformable joint as coded: half-way strains, loads projected with frame a.
struct MbdynJointInvKernel {
  static constexpr bool kBalanced = true;

  using AtA = FamilyKernel<FrameA, RotationVectorMeasure, Projected>;

  template <class Angle, bool with_tangent, class T, class L>
  HALFWAY_INLINE MomentLoads<T> angular(const Relative<T>& r, const L& law) const {
    return AtA{}.template angular<Angle, with_tangent>(r, law);
  }

  template <class Angle, Kind kind, bool with_tangent, class T, class L>
  HALFWAY_INLINE PointLoads<T> point(const Relative<T>& r, const V3<T>& d, const L& law) const {
    const auto j = jet_at < Angle, kind == Kind::linear ? -1 : with_tangent ? 1 : 0 > (r);
    const auto H = frame<with_tangent>(FrameHalfway{}, r, j);
    const Measured<T> e = rotation_vector<kind, with_tangent>(r, j);
    Seen<T> s = seen<kind, with_tangent>(law, H.F, d, r, e.eta, SymmetricAxial<T>{e.beta, e.gamma, r.g});
    if constexpr (with_tangent) {
      // What frame a sees of the position, the half-way frame sees turned by its own share.
      for (Load<T>* l : {&s.f, &s.m}) l->wb = l->wb + H.spin.after(times_skew(l->x, d));
    }
    // From half-way axes to those of a: a turn by -phi/2.
    const Axial<T> back{r.w, T(-1), r.iw, r.g};
    const auto to_a = [&](const Load<T>& l) {
      Load<T> out;
      out.value = back.times(l.value);
      if constexpr (with_tangent) {
        out.x = back_times(back, l.x);
        out.wb = back_times(back, l.wb);
      }
      return out;
    };
    PointLoads<T> out;
    out.f = to_a(s.f);
    const V3<T> moment = cross(d, out.f.value);
    out.b.value = -H.spin.transposed_times(moment);
    if constexpr (with_tangent) {
      out.b.x = H.spin.transposed_times(plus_skew(-skew_times(d, out.f.x), out.f.value));
      const M3<T> z_rate = back.after(minus_skew(zero33<T>(), H.spin.quarter * moment));
      out.b.wb = -(H.spin.transposed_times(skew_times(d, out.f.wb)) + z_rate);
    }
    if constexpr (kind == Kind::linear_angular) {
      const Load<T> m = to_a(s.m);
      out.b.value = out.b.value + m.value;
      if constexpr (with_tangent) out.b.x = out.b.x + m.x, out.b.wb = out.b.wb + m.wb;
    }
    return out;
  }

 private:
  /// A M, A the operator.
  template <class T>
  static HALFWAY_INLINE M3<T> back_times(const Axial<T>& A, const M3<T>& M) {
    return A.p * M + A.q * skew_times(A.g, M) + outer(A.r * A.g, A.g * M);
  }
};

}  // namespace halfway::kernel
