// The family: translation x rotation measure x transport, for every kind of joint [18-30].
//
// A formulation maps the relative motion of the two joint frames and a law to the loads at the two
// joint points, in the axes of P_a. It offers
//   strain<kind>(m)                 what the law sees
//   energy<kind>(m, law)            its potential, where that is not the law's energy at the strain
//   angular<with_tangent>(m, law)   AngularResponse: computes nothing linear
//   point<kind, with_tangent>(...)  PointResponse, for linear and linear/angular joints
//   kLinearWithoutRotation          does the linear joint do without the relative rotation?
// joint.hpp carries them to the nodes. Sign: loads conjugate to the motion of b (strain power).
#pragma once

#include "halfway/joint/facts.hpp"
#include "halfway/joint/frames.hpp"
#include "halfway/joint/laws.hpp"
#include "halfway/joint/measures.hpp"

namespace halfway {

/// Moment on b (that on a is its opposite), N m, and its derivative by the relative spin psi.
template <class T>
struct AngularResponse {
  Vec3<T> m;
  Mat3<T> m_psi;
};

/// Force on b (that on a is its opposite), moments on a and b about their own joint points, and
/// their derivatives by the relative position p and the relative spin psi, 3x3 each.
template <class T>
struct PointResponse {
  Vec3<T> f, m_a, m_b;
  Mat3<T> f_p, f_psi, m_a_p, m_a_psi, m_b_p, m_b_psi;
};

/// Moment on a from moment balance: m_a = -(m_b + p x f), with its derivatives.
template <class T>
void balance_moment(const RelativeMotion<T>& m, PointResponse<T>& r) {
  const Mat3<T> p = skew(m.p);
  r.m_a = -(r.m_b + m.p.cross(r.f));
  r.m_a_p = skew(r.f) - r.m_b_p - p * r.f_p;
  r.m_a_psi = -r.m_b_psi - p * r.f_psi;
}

/// What turns the stress mbar into the moment on b, X mbar, with its derivative for constant mbar;
/// and the rate E of the rotation measure.
template <class T>
struct MomentMap {
  Mat3<T> X, X_rate, E;
};

/// Rates of the strain dbar = M(theta) p: d(dbar) = J dp + N psi.
template <class T>
struct StrainRates {
  Mat3<T> J, N;
};

template <class T>
StrainRates<T> strain_rates_of(const RelativeMotion<T>& m, const Isotropic<T>& M) {
  return {M.matrix(m.theta), M.derivative(m.theta, m.p) * so3::gamma_inverse(m.theta)};
}

/// Loads of the force stress fbar on the strain M(theta) p, by virtual work [24-30].
template <bool with_tangent, class T>
PointResponse<T> force_response(const RelativeMotion<T>& m, const Isotropic<T>& M, const Vec3<T>& fbar,
                                const Mat3<T>& K) {
  const Mat3<T> rate = so3::gamma_inverse(m.theta);
  const Mat3<T> J = M.matrix(m.theta);
  const Mat3<T> M_theta = M.derivative(m.theta, m.p);
  const Mat3<T> N = M_theta * rate;
  PointResponse<T> r;
  r.f = J.transpose() * fbar;
  r.m_b = N.transpose() * fbar;
  if constexpr (with_tangent) {
    const Vec3<T> g = M_theta.transpose() * fbar;
    const Mat3<T> geometric = M.transposed().derivative(m.theta, fbar) * rate;
    const Mat3<T> KJ = K * J, KN = K * N;
    r.f_p = J.transpose() * KJ;
    r.f_psi = J.transpose() * KN + geometric;
    r.m_b_p = r.f_psi.transpose();
    r.m_b_psi = N.transpose() * KN + spin_derivative<T>(m.theta, g, M.hessian(m.theta, m.p, fbar));
    balance_moment(m, r);
  } else {
    r.m_a = -(r.m_b + m.p.cross(r.f));
  }
  return r;
}

/// The same where M is the identity (node a's own frame): no rotation, no moment at b [31].
template <bool with_tangent, class T>
PointResponse<T> fixed_force_response(const RelativeMotion<T>& m, const Vec3<T>& fbar, const Mat3<T>& K) {
  PointResponse<T> r;
  r.f = fbar;
  r.m_b = Vec3<T>::Zero();
  if constexpr (with_tangent) {
    r.f_p = K;
    r.f_psi = r.m_b_p = r.m_b_psi = Mat3<T>::Zero();
    balance_moment(m, r);
  } else {
    r.m_a = -m.p.cross(r.f);
  }
  return r;
}

/// The loads alone, where M turns p into a frame Q whose spin is A psi: the closed form [30].
template <class T>
PointResponse<T> frame_force_response(const RelativeMotion<T>& m, const Mat3<T>& Q, const Mat3<T>& A,
                                      const Vec3<T>& fbar) {
  PointResponse<T> r;
  r.f = Q * fbar;
  const Vec3<T> moment = m.p.cross(r.f);
  r.m_b = -(A.transpose() * moment);
  r.m_a = -(r.m_b + moment);
  return r;
}

/// Adds the moment stress and the coupling of a linear/angular law to the force's response.
template <bool with_tangent, class T>
void add_moment(const RelativeMotion<T>& m, const LawResponse<T, 6>& law, const MomentMap<T>& map,
                const StrainRates<T>& rates, PointResponse<T>& r) {
  const Vec3<T> mbar = law.stress.template tail<3>();
  r.m_b += map.X * mbar;
  if constexpr (with_tangent) {
    const Mat3<T> K_fm = law.stiffness.template topRightCorner<3, 3>();
    const Mat3<T> K_mf = law.stiffness.template bottomLeftCorner<3, 3>();
    const Mat3<T> K_mm = law.stiffness.template bottomRightCorner<3, 3>();
    const Mat3<T> K_fm_E = K_fm * map.E;
    const Mat3<T> mbar_psi = K_mf * rates.N + K_mm * map.E;
    r.f_psi += rates.J.transpose() * K_fm_E;
    r.m_b_p += map.X * K_mf * rates.J;
    r.m_b_psi += rates.N.transpose() * K_fm_E + map.X * mbar_psi + map.X_rate;
    balance_moment(m, r);
  } else {
    r.m_a = -(r.m_b + m.p.cross(r.f));
  }
}

/// q follows from virtual work: the moment is E^T mbar.
struct Conjugate {
  static constexpr bool kConjugate = true;
};
/// The moment is R^(xi) mbar [14, 19].
struct Projected {
  static constexpr bool kConjugate = false;
};

template <class Translation, class Measure, class Transport>
struct Family {
  [[no_unique_address]] Translation translation{};

  static constexpr bool kLinearWithoutRotation = Translation::kConstant;

  /// Derivable from the law's energy? Forces are for every xi, moments only when conjugate.
  static constexpr bool has_potential(Kind kind) { return kind == Kind::linear || Transport::kConjugate; }

  template <Kind kind, class T>
  Strain<T, kind> strain(const RelativeMotion<T>& m) const {
    if constexpr (kind == Kind::angular) {
      return Measure::strain(m);
    } else if constexpr (kind == Kind::linear && Translation::kConstant) {
      return m.p;
    } else if constexpr (kind == Kind::linear && Translation::kFrame) {
      return translation.rotation(m).transpose() * m.p;
    } else if constexpr (kind == Kind::linear) {
      return translation.motion(T(m.theta.squaredNorm())).times(m.theta, m.p);
    } else {
      Strain<T, kind> e;
      e << strain<Kind::linear>(m), strain<Kind::angular>(m);
      return e;
    }
  }

  template <bool with_tangent, class T, Law<T, 3> L>
  AngularResponse<T> angular(const RelativeMotion<T>& m, const L& law) const {
    const LawResponse<T, 3> response = law(strain<Kind::angular>(m));
    const Mat3<T> X = moment_map(m);
    AngularResponse<T> r;
    r.m = X * response.stress;
    if constexpr (with_tangent) {
      r.m_psi = X * response.stiffness * Measure::rate(m) + moment_map_rate(m, response.stress);
    }
    return r;
  }

  template <Kind kind, bool with_tangent, class T, Law<T, strain_count(kind)> L>
  PointResponse<T> point(const RelativeMotion<T>& m, const L& law) const {
    const LawResponse<T, strain_count(kind)> response = law(strain<kind>(m));
    if constexpr (kind == Kind::linear) {
      return force<with_tangent>(m, Vec3<T>(response.stress), response.stiffness);
    } else {
      MomentMap<T> map;
      map.X = moment_map(m);
      if constexpr (with_tangent) {
        map.E = Measure::rate(m);
        map.X_rate = moment_map_rate(m, Vec3<T>(response.stress.template tail<3>()));
      }
      auto r = force<with_tangent>(m, Vec3<T>(response.stress.template head<3>()),
                                   Mat3<T>(response.stiffness.template topLeftCorner<3, 3>()));
      const StrainRates<T> rates = with_tangent ? strain_rates(m) : StrainRates<T>{};
      add_moment<with_tangent>(m, response, map, rates, r);
      return r;
    }
  }

 private:
  template <bool with_tangent, class T>
  PointResponse<T> force(const RelativeMotion<T>& m, const Vec3<T>& fbar, const Mat3<T>& K) const {
    if constexpr (Translation::kConstant)
      return fixed_force_response<with_tangent>(m, fbar, K);
    else if constexpr (Translation::kFrame && !with_tangent)
      return frame_force_response(m, translation.rotation(m), translation.spin(m), fbar);
    else
      return force_response<with_tangent>(m, translation.motion(T(m.theta.squaredNorm())), fbar, K);
  }

  template <class T>
  StrainRates<T> strain_rates(const RelativeMotion<T>& m) const {
    if constexpr (Translation::kConstant)
      return {Mat3<T>::Identity(), Mat3<T>::Zero()};
    else
      return strain_rates_of(m, translation.motion(T(m.theta.squaredNorm())));
  }

  /// X with moment on b = X mbar.
  template <class T>
  Mat3<T> moment_map(const RelativeMotion<T>& m) const {
    if constexpr (Transport::kConjugate)
      return Measure::rate(m).transpose();
    else
      return translation.rotation(m);
  }

  /// d(X mbar)/d(psi) for constant mbar.
  template <class T>
  Mat3<T> moment_map_rate(const RelativeMotion<T>& m, const Vec3<T>& mbar) const {
    if constexpr (Transport::kConjugate) {
      return Measure::transport_rate(m, mbar);
    } else {
      return -skew<T>(translation.rotation(m) * mbar) * translation.spin(m);
    }
  }
};

}  // namespace halfway
