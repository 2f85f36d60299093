// The geometric spring of port-Hamiltonian robotics (Fasse and Breedveld 1998): a law at each node, half of
// each.
//
//   U = W(p, e)/2 + W(R^T p, e)/2,   e = 2 sin(phi/2) n:
// the law sees the relative position from node a and from node b, and a rotation that looks the same from
// both. With K = (K_f, K_m) that is
//   F = (K_a + K_b) d/2,  m_b = -d x K_b d/2 + M,  m_a = -d x K_a d/2 - M,  K_i = P_i K_f P_i^T,
// and M the axial vector of R (tr(K_m)/2 - K_m): a polynomial in the nodes' axes, smooth on all SO(3), where
// the moment of the rotation vanishes at pi. A law that couples translation and rotation, or is no linear
// one, needs e itself, which changes sign at pi.
#pragma once

#include "halfway/joint/family.hpp"

namespace halfway {

struct Fasse {
  static constexpr const char* name = "fasse";
  static constexpr const char* stands_for = "Fasse-Breedveld geometric spring of port-Hamiltonian robotics";
  static constexpr Facts facts{};
  static constexpr bool kLinearWithoutRotation = false;
  static constexpr bool has_potential(Kind) { return true; }

  /// The mean of the two strains. No one strain has the energy of both, so energy() is below; but a linear
  /// law's mean stress is its stress at the mean strain, which like the joint favours no node.
  template <Kind kind, class T>
  Strain<T, kind> strain(const RelativeMotion<T>& m) const {
    if constexpr (kind == Kind::angular)
      return turn(m);
    else
      return (at_a<kind>(m) + at_b<kind>(m)) / T(2);
  }

  template <Kind kind, class T, ElasticLaw<T, strain_count(kind)> L>
  T energy(const RelativeMotion<T>& m, const L& law) const {
    if constexpr (kind == Kind::angular)
      return law.energy(turn(m));
    else
      return (law.energy(at_a<kind>(m)) + law.energy(at_b<kind>(m))) / T(2);
  }

  template <bool with_tangent, class T, Law<T, 3> L>
  AngularResponse<T> angular(const RelativeMotion<T>& m, const L& law) const {
    const LawResponse<T, 3> response = law(turn(m));
    const Mat3<T> E = rate(m);
    AngularResponse<T> r;
    r.m = E.transpose() * response.stress;
    if constexpr (with_tangent)
      r.m_psi = E.transpose() * response.stiffness * E + transport_rate(m, response.stress);
    return r;
  }

  template <Kind kind, bool with_tangent, class T, Law<T, strain_count(kind)> L>
  PointResponse<T> point(const RelativeMotion<T>& m, const L& law) const {
    const LawResponse<T, strain_count(kind)> of_a = law(at_a<kind>(m)), of_b = law(at_b<kind>(m));
    const Vec3<T> f_b = m.R * of_b.stress.template head<3>() / T(2);
    PointResponse<T> r;
    r.f = of_a.stress.template head<3>() / T(2) + f_b;
    r.m_b = f_b.cross(m.p);
    if constexpr (with_tangent) {
      const Mat3<T> f_b_p = m.R * of_b.stiffness.template topLeftCorner<3, 3>() * m.R.transpose() / T(2);
      const Mat3<T> p = skew(m.p), f_b_psi = f_b_p * p - skew(f_b);
      r.f_p = of_a.stiffness.template topLeftCorner<3, 3>() / T(2) + f_b_p;
      r.f_psi = f_b_psi;
      r.m_b_p = f_b_psi.transpose();
      r.m_b_psi = -p * f_b_psi;
    }
    if constexpr (kind == Kind::linear_angular) add_moment<with_tangent>(m, of_a, of_b, r);
    if constexpr (with_tangent)
      balance_moment(m, r);
    else
      r.m_a = -(r.m_b + m.p.cross(r.f));
    return r;
  }

 private:
  /// e = 2 sin(phi/2) n.
  template <class T>
  static Vec3<T> turn(const RelativeMotion<T>& m) {
    return T(2) * m.q.v;
  }
  template <Kind kind, class T>
  static Strain<T, kind> at_a(const RelativeMotion<T>& m) {
    return seen<kind>(m, m.p);
  }
  template <Kind kind, class T>
  static Strain<T, kind> at_b(const RelativeMotion<T>& m) {
    return seen<kind>(m, Vec3<T>(m.R.transpose() * m.p));
  }
  template <Kind kind, class T>
  static Strain<T, kind> seen(const RelativeMotion<T>& m, const Vec3<T>& position) {
    if constexpr (kind == Kind::linear) {
      return position;
    } else {
      Strain<T, kind> e;
      e << position, turn(m);
      return e;
    }
  }

  /// de = E psi.
  template <class T>
  static Mat3<T> rate(const RelativeMotion<T>& m) {
    return m.q.w * Mat3<T>::Identity() - skew(m.q.v);
  }
  /// d(E^T mu)/d(psi) for constant mu.
  template <class T>
  static Mat3<T> transport_rate(const RelativeMotion<T>& m, const Vec3<T>& mu) {
    return (m.q.v.dot(mu) * Mat3<T>::Identity() + skew<T>(rate(m).transpose() * mu)) / T(-2);
  }

  /// Adds the mean moment stress, and what it and the forces have of the rotation.
  template <bool with_tangent, class T>
  static void add_moment(const RelativeMotion<T>& m, const LawResponse<T, 6>& of_a,
                         const LawResponse<T, 6>& of_b, PointResponse<T>& r) {
    const Mat3<T> E = rate(m);
    const Vec3<T> mbar = (of_a.stress.template tail<3>() + of_b.stress.template tail<3>()) / T(2);
    r.m_b += E.transpose() * mbar;
    if constexpr (with_tangent) {
      const Mat3<T> p = skew(m.p), mm = (of_a.stiffness + of_b.stiffness).template bottomRightCorner<3, 3>();
      const Mat3<T> f_a_psi = of_a.stiffness.template topRightCorner<3, 3>() * E / T(2);
      const Mat3<T> f_b_psi = m.R * of_b.stiffness.template topRightCorner<3, 3>() * E / T(2);
      r.f_psi += f_a_psi + f_b_psi;
      r.m_b_p += (f_a_psi + f_b_psi).transpose();
      r.m_b_psi += f_b_psi.transpose() * p - p * f_b_psi + E.transpose() * mm * E / T(2);
      r.m_b_psi += transport_rate(m, mbar);
    }
  }
};

}  // namespace halfway
