// The kernels of the whole family, translation x measure x transport, in global axes.
//
// Only the law is ever rotated: F K F^T. Everything else is a skew operator or a rank-one update
// about the relative quaternion's vector in global axes. A load seen in the joint's frame W has the
// derivatives x_p and x_w by the relative position and spin seen there; in space
//   x_d = x_p,   x_wb = x_w + (x_p [d] - [x]) A,   A the share of the relative spin that turns W.
#pragma once

#include "halfway/joint/family.hpp"
#include "halfway/kernels/euler.hpp"
#include "halfway/kernels/fasse.hpp"
#include "halfway/kernels/force.hpp"
#include "halfway/kernels/frames.hpp"
#include "halfway/kernels/response.hpp"
#include "halfway/kernels/screw.hpp"

namespace halfway::kernel {

template <class Translation, class Measure, class Transport>
struct FamilyKernel {
  [[no_unique_address]] Translation translation{};

  static constexpr bool kBalanced = true, kSymmetricForce = true;
  template <Kind kind>
  static constexpr bool kNeedsRelative = kind != Kind::linear || !Translation::kConstant;
  static constexpr bool kConjugate = Transport::kConjugate;
  template <Kind kind>
  static constexpr bool kConservative = kConjugate || kind == Kind::linear;
  static constexpr bool kSe3 = !Translation::kFrame;
  static constexpr bool kWeighted = requires(Translation t) { t.xi; };

  /// Moment on b and its derivatives. `Angle`: how exactly the rotation's angle is taken.
  template <class Angle, bool with_tangent, class T, class L>
  HALFWAY_INLINE MomentLoads<T> angular(const Relative<T>& r, const L& law) const {
    const auto j = jet<Angle, Kind::angular, with_tangent>(r);
    if constexpr (kEuler<Measure>)
      return euler_angular<with_tangent>(r, j, law);
    else if constexpr (kConjugate && std::is_same_v<Measure, QuaternionMeasure>)
      return FasseKernel{}.template angular<Angle, with_tangent>(r, law);  // the same potential
    else
      return vector_angular<with_tangent>(r, j, law);
  }

  /// Loads at the joint points, to be completed (loads.hpp). @param d  from joint point a to b, global axes,
  /// m.
  template <class Angle, Kind kind, bool with_tangent, class T, class L>
  HALFWAY_INLINE PointLoads<T> point(const Relative<T>& r, const V3<T>& d, const L& law) const {
    PointLoads<T> out;
    put<Fill::points, Angle, kind, with_tangent>(r, d, law, out);
    return out;
  }
  /// All loads and columns, with joint points at the nodes.
  template <class Angle, Kind kind, bool with_tangent, class T, class L, class Out>
  HALFWAY_INLINE void at_nodes(const Relative<T>& r, const V3<T>& d, const L& law, Out& out) const {
    put<Fill::nodes, Angle, kind, with_tangent>(r, d, law, out);
  }

 private:
  template <Fill what, class Angle, Kind kind, bool with_tangent, class T, class L, class Out>
  HALFWAY_INLINE void put(const Relative<T>& r, const V3<T>& d, const L& law, Out& out) const {
    const auto j = jet<Angle, kind, with_tangent>(r);
    if constexpr (kSe3)
      se3<what, kind, with_tangent>(r, j, d, law, out);
    else if constexpr (kind == Kind::linear)
      linear<what, with_tangent>(r, j, d, law, out);
    else if constexpr (kEuler<Measure>)
      euler<what, with_tangent>(r, j, d, law, out);
    else
      vector<what, with_tangent>(r, j, d, law, out);
  }

  template <Kind kind, bool with_tangent>
  static constexpr int order() {
    const bool conjugate_rate = with_tangent && kConjugate;
    const int measure =
        kind == Kind::linear ? -1 : jet_order<Measure>(with_tangent || kConjugate, conjugate_rate);
    const bool framed = kind != Kind::angular || !kConjugate;
    const int frame = !framed ? -1 : kWeighted ? 1 : kSe3 ? (with_tangent ? 3 : 2) : -1;
    return measure > frame ? measure : frame;
  }
  template <class Angle, Kind kind, bool with_tangent, class T>
  static HALFWAY_INLINE AngleJet<T> jet(const Relative<T>& r) {
    return jet_at<Angle, order<kind, with_tangent>()>(r);
  }

  template <bool with_tangent, class T>
  static HALFWAY_INLINE Measured<T> measured(const Relative<T>& r, const AngleJet<T>& j) {
    return MeasureKernel<Measure>::template measured < (with_tangent && kConjugate) ? 2
           : with_tangent || kConjugate                                             ? 1
                                                                                    : 0 > (r, j);
  }

  /// The frame of a moment parallel to the rotation vector: conjugate ones are simplest half-way.
  template <bool with_tangent, class T>
  HALFWAY_INLINE auto moment_frame(const Relative<T>& r, const AngleJet<T>& j) const {
    if constexpr (kConjugate)
      return frame<with_tangent>(FrameHalfway{}, r, j);
    else
      return frame<with_tangent>(translation, r, j);
  }

  template <bool with_tangent, class T, class L>
  HALFWAY_INLINE MomentLoads<T> vector_angular(const Relative<T>& r, const AngleJet<T>& j,
                                               const L& law) const {
    const Measured<T> e = measured<with_tangent>(r, j);
    const auto H = moment_frame<with_tangent>(r, j);
    const auto rate = H.rate(r, e);
    V3<T> m;
    S3<T> K;
    respond<with_tangent>(law, H.F, e.eta * r.v, e.eta * r.g, m, K);
    MomentLoads<T> out;
    out.m = kConjugate ? rate.transposed_times(m) : m;
    if constexpr (with_tangent) {
      M3<T> w = rate.after(full(K));
      if constexpr (kConjugate) w = rate.transposed_times(w) + rate_of_rate(r, e, m);
      out.wb = minus_turn(w, out.m, H.spin);
      out.wa = minus_skew(-out.wb, out.m);
    }
    return out;
  }

  /// In the frame of the moment: of a for virtual work, else the law's own.
  template <bool with_tangent, class T, class L>
  HALFWAY_INLINE MomentLoads<T> euler_angular(const Relative<T>& r, const AngleJet<T>& j,
                                              const L& law) const {
    const auto e = EulerKernel<Measure>::template values < with_tangent || kConjugate > (r);
    const auto F = euler_frame<with_tangent>(r, j);
    const V3<T> mbar = law.stress(e.e);
    const V3<T> y = kConjugate ? mbar * e.E : mbar;
    MomentLoads<T> out;
    out.m = F.F * y;
    if constexpr (with_tangent) {
      M3<T> w = full(law.stiffness(e.e)) * euler_rate(r, F, e.E);
      if constexpr (kConjugate) w = transposed_times(e.E, w) + EulerKernel<Measure>::transport_rate(e, y);
      out.wb = minus_turn(turned(F.F, w, F.F), out.m, F.spin);
      out.wa = minus_skew(-out.wb, out.m);
    }
    return out;
  }
  template <bool with_tangent, class T>
  HALFWAY_INLINE auto euler_frame(const Relative<T>& r, const AngleJet<T>& j) const {
    if constexpr (kConjugate)
      return frame<with_tangent>(FrameA{}, r, j);
    else
      return frame<with_tangent>(translation, r, j);
  }
  /// The rate by the spin seen in frame F; E takes it in the axes of a.
  template <class T, class Frame>
  static HALFWAY_INLINE M3<T> euler_rate(const Relative<T>& r, const Frame& F, const M3<T>& E) {
    if constexpr (requires { F.from_a(r); })
      return E * F.from_a(r);
    else
      return E;
  }

  /// Force alone: needs neither a measure nor, half-way, an angle.
  template <Fill what, bool with_tangent, class T, class L, class Out>
  HALFWAY_INLINE void linear(const Relative<T>& r, const AngleJet<T>& j, const V3<T>& d, const L& law,
                             Out& out) const {
    const auto F = frame<with_tangent>(translation, r, j);
    V3<T> f;
    S3<T> K;
    respond<with_tangent>(law, F.F, d * F.F, d, f, K);
    fill<what, with_tangent>(d, f, K, F.spin, out);
  }

  template <Fill what, bool with_tangent, class T, class L, class Out>
  HALFWAY_INLINE void vector(const Relative<T>& r, const AngleJet<T>& j, const V3<T>& d, const L& law,
                             Out& out) const {
    const Measured<T> e = measured<with_tangent>(r, j);
    const auto F = frame<with_tangent>(translation, r, j);
    const auto H = moment_frame<with_tangent>(r, j);
    const auto rate = H.rate(r, e);
    const auto s =
        respond<with_tangent>(law, F.F, H.F, Pair<T>{d * F.F, e.eta * r.v}, Pair<T>{d, e.eta * r.g});
    auto m = moment_in(H.spin, kConjugate ? rate.transposed_times(s.m) : s.m);
    if constexpr (with_tangent) {
      m.f_w = rate.after(s.K.fm);
      m.w = rate.after(full(s.K.mm));
      if constexpr (kConjugate)
        m.w = rate.transposed_times(m.w) + rate_of_rate(r, e, s.m);
      else
        m.p = transposed(s.K.fm);
    }
    fill<what, kConjugate, with_tangent>(d, s.f, s.K.ff, F.spin, m, out);
  }
  template <class T, class Spin>
  static HALFWAY_INLINE Moment<T, Spin> moment_in(const Spin& spin, const V3<T>& value) {
    return {value, {}, {}, {}, spin};
  }

  template <Fill what, bool with_tangent, class T, class L, class Out>
  HALFWAY_INLINE void euler(const Relative<T>& r, const AngleJet<T>& j, const V3<T>& d, const L& law,
                            Out& out) const {
    const auto e = EulerKernel<Measure>::template values < with_tangent || kConjugate > (r);
    const auto F = frame<with_tangent>(translation, r, j);
    const auto H = euler_frame<with_tangent>(r, j);
    const Pair<T> strain{d * F.F, e.e};
    const Pair<T> stress = law.stress(strain);
    const V3<T> y = kConjugate ? stress.m * e.E : stress.m;
    auto m = moment_in(H.spin, H.F * y);
    S3<T> f_p{};
    if constexpr (with_tangent) {
      const Stiffness6<T> K = law.stiffness(strain);
      const M3<T> E = euler_rate(r, H, e.E);
      M3<T> w = full(K.mm) * E;
      if constexpr (kConjugate)
        w = transposed_times(E, w) + EulerKernel<Measure>::transport_rate(e, y);
      else
        m.p = turned(H.F, transposed(K.fm), F.F);
      m.w = turned(H.F, w, H.F);
      m.f_w = turned(F.F, K.fm * E, H.F);
      f_p = turned(F.F, K.ff);
    }
    fill<what, kConjugate, with_tangent>(d, F.F * stress.f, f_p, F.spin, m, out);
  }

  /// On SE(3): the translation's strain is B d with the rotation vector's own rate B, half-way.
  template <Fill what, Kind kind, bool with_tangent, class T, class L, class Out>
  HALFWAY_INLINE void se3(const Relative<T>& r, const AngleJet<T>& j, const V3<T>& d, const L& law,
                          Out& out) const {
    static_assert(kConjugate && kVectorial<Measure>);
    const auto H = frame<with_tangent>(FrameHalfway{}, r, j);
    const ScrewStrain<T> strain = screw_strain(r, j, d);
    const auto& B = strain.B;
    V3<T> f;
    S3<T> K;
    auto m = moment_in(H.spin, V3<T>{});
    M3<T> stiff_w;  // d(fbar)/d(spin)
    if constexpr (kind == Kind::linear) {
      respond<with_tangent>(law, H.F, strain.l * H.F, strain.l, f, K);
      m.value = f * strain.L;
      if constexpr (with_tangent) {
        stiff_w = full(K) * strain.L;
        m.w = transposed_times(strain.L, stiff_w) + strain.second(r, j, d, f);
      }
    } else {
      const Measured<T> e = measured<with_tangent>(r, j);
      const auto rate = H.rate(r, e);
      const auto s = respond<with_tangent>(law, H.F, H.F, Pair<T>{strain.l * H.F, e.eta * r.v},
                                           Pair<T>{strain.l, e.eta * r.g});
      f = s.f;
      m.value = f * strain.L + rate.transposed_times(s.m);
      if constexpr (with_tangent) {
        K = s.K.ff;
        stiff_w = full(K) * strain.L + rate.after(s.K.fm);
        const M3<T> moment_w = transposed(s.K.fm) * strain.L + rate.after(full(s.K.mm));
        m.w = transposed_times(strain.L, stiff_w) + strain.second(r, j, d, f) +
              rate.transposed_times(moment_w) + rate_of_rate(r, e, s.m);
      }
    }
    S3<T> f_p{};
    if constexpr (with_tangent) {
      f_p = upper_triangle(B.transposed_times(B.after(full(K))));
      m.f_w = B.transposed_times(stiff_w) + rate_of_rate(r, strain.measure, f);
    }
    fill<what, true, with_tangent>(d, B.times(f), f_p, H.spin, m, out);
  }
};

}  // namespace halfway::kernel
