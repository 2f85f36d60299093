// Joints of programs as formulations of the catalog, for whoever wants them in every study: `--all`.
//
// The tangent, which those laws do not bring, is the derivative of their loads by dual numbers: so where a
// tangent is held against dual numbers, these show rounding alone.
#pragma once

#include "halfway/joint/family.hpp"
#include "halfway/programs/engines.hpp"
#include "halfway/programs/havok.hpp"
#include "reference/numbers/dual.hpp"

#include <array>

namespace halfway {

namespace reference {

/// What theory says of a law beyond its ProgramFacts.
struct LeadingOrder {
  int loop_slope = 3;  ///< work round a loop ~ amplitude^slope: 4 where the second order has a potential
  bool has_fingerprint = false;  ///< the moment's second order is of the (alpha, beta) form
  double alpha = 0.5, beta = 0;
};

/// Defects that are there, of a size that nobody has said: no rounding, and a hundred times everything.
inline constexpr Band kThere{1e-4, 100};

/// Of laws whose springs of translation are along the axes of a: alone, they do no work round a loop of body
/// b.
constexpr Facts facts_of(const programs::ProgramFacts& law, const LeadingOrder& order) {
  const auto unless = [](bool holds) { return holds ? Band{} : kThere; };
  const bool moment = law.anisotropic_conservative;
  const Band balance = unless(law.balanced), exchange = unless(law.order_free);
  return {.moment_balance = {.linear = balance, .linear_angular = balance},
          .node_order = {exchange, exchange, exchange},
          .symmetry = {unless(moment), balance, unless(moment && law.balanced)},
          .loop_work = {unless(moment), {}, unless(moment)},
          .loop_slope = double(order.loop_slope),
          .clamped_energy = moment ? Band{} : Band{1.5e-3, 1e6},  // beyond the integrator's own
          .has_fingerprint = order.has_fingerprint,
          .alpha = order.alpha,
          .beta = order.beta};
}

/// @tparam Law  one that BySprings, along the axes of a; derive, and add `facts`
template <class Law>
struct AsFormulation {
  static constexpr const char* name = Law::name;
  static constexpr const char* stands_for = Law::stands_for;
  static constexpr bool kLinearWithoutRotation = false;
  static constexpr bool kBlockDiagonalLawOnly = true;  // programs couple nothing

  static constexpr bool has_potential(Kind kind) {
    constexpr programs::ProgramFacts known = Law::facts;
    if (kind == Kind::linear) return known.balanced;
    return known.anisotropic_conservative && (known.balanced || kind == Kind::angular);
  }

  template <Kind kind, class T>
  Strain<T, kind> strain(const RelativeMotion<T>& m) const {
    const Strain<T, Kind::linear_angular> e = Law::strain(m);
    if constexpr (kind == Kind::linear_angular)
      return e;
    else if constexpr (kind == Kind::linear)
      return e.template head<3>();
    else
      return e.template tail<3>();
  }

  template <bool with_tangent, class T, halfway::Law<T, 3> L>
  AngularResponse<T> angular(const RelativeMotion<T>& motion, const L& law) const {
    RelativeMotion<T> m = motion;
    m.p = Vec3<T>::Zero();  // an angular joint leaves it alone
    AngularResponse<T> r;
    const Response<T, Kind::angular> at(m, law);
    r.m = at.loads().m_b;
    if constexpr (with_tangent) r.m_psi = at.by_turning()[2];
    return r;
  }

  template <Kind kind, bool with_tangent, class T, halfway::Law<T, strain_count(kind)> L>
  PointResponse<T> point(const RelativeMotion<T>& m, const L& law) const {
    const Response<T, kind> at(m, law);
    const programs::ProgramLoads<T> loads = at.loads();
    PointResponse<T> r;
    r.f = loads.f, r.m_a = loads.m_a, r.m_b = loads.m_b;
    if constexpr (with_tangent) {
      const auto moved = at.by_moving(), turned = at.by_turning();
      r.f_p = moved[0], r.m_a_p = moved[1], r.m_b_p = moved[2];
      r.f_psi = turned[0], r.m_a_psi = turned[1], r.m_b_psi = turned[2];
    }
    return r;
  }

 private:
  template <class T, Kind kind>
  class Response {
   public:
    template <class L>
    Response(const RelativeMotion<T>& m, const L& law)
        : m_(m), law_(law(AsFormulation{}.template strain<kind>(m))) {}

    programs::ProgramLoads<T> loads() const { return of_stress<T>(m_, law_.stress); }

    /// Derivatives of f, m_a, m_b by p.
    std::array<Mat3<T>, 3> by_moving() const {
      return columns([&](int k) {
        RelativeMotion<Dual<T>> moved = as_duals();
        moved.p[k].d = T(1);
        return moved;
      });
    }

    /// By the spin psi, delta R = [psi] R.
    std::array<Mat3<T>, 3> by_turning() const {
      return columns([&](int k) {
        const Mat3<T> turning = skew<T>(Vec3<T>::Unit(k)) * m_.R;
        Mat3<Dual<T>> R = m_.R.template cast<Dual<T>>();
        for (int i = 0; i < 9; ++i) R(i).d = turning(i);
        return relative_motion<Dual<T>>(R, m_.p.template cast<Dual<T>>());
      });
    }

   private:
    template <class S>
    static programs::ProgramLoads<S> of_stress(const RelativeMotion<S>& m, const Strain<S, kind>& stress) {
      Vec3<S> force = Vec3<S>::Zero(), moment = Vec3<S>::Zero();
      if constexpr (kind != Kind::angular) force = stress.template head<3>();
      if constexpr (kind != Kind::linear) moment = stress.template tail<3>();
      return Law::template of_stress<S>(m, force, moment);
    }

    RelativeMotion<Dual<T>> as_duals() const {
      return relative_motion<Dual<T>>(m_.R.template cast<Dual<T>>(), m_.p.template cast<Dual<T>>());
    }

    template <class Moved>
    std::array<Mat3<T>, 3> columns(const Moved& moved) const {
      std::array<Mat3<T>, 3> out;
      for (int k = 0; k < 3; ++k) {
        const programs::ProgramLoads<Dual<T>> at = derived(moved(k));
        const Vec3<Dual<T>> parts[] = {at.f, at.m_a, at.m_b};
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j) out[std::size_t(i)](j, k) = parts[i][j].d;
      }
      return out;
    }

    /// The law's own stiffness makes its stress a dual.
    programs::ProgramLoads<Dual<T>> derived(const RelativeMotion<Dual<T>>& moved) const {
      constexpr int n = strain_count(kind);
      const Strain<Dual<T>, kind> e = AsFormulation{}.template strain<kind>(moved);
      Eigen::Matrix<T, n, 1> rate;
      for (int i = 0; i < n; ++i) rate[i] = e[i].d;
      const Eigen::Matrix<T, n, 1> stress_rate = law_.stiffness * rate;
      Strain<Dual<T>, kind> stress;
      for (int i = 0; i < n; ++i) stress[i] = Dual<T>(law_.stress[i], stress_rate[i]);
      return of_stress<Dual<T>>(moved, stress);
    }

    RelativeMotion<T> m_;
    LawResponse<T, strain_count(kind)> law_;
  };
};

}  // namespace reference

// Of these the moment's second order is theirs to say: b of m = K theta + theta x K theta / 2 + (b1 t2 t3,
// ..).

struct ProgramBullet6Dof : reference::AsFormulation<programs::Bullet6Dof> {
  static constexpr Facts facts = reference::facts_of(programs::Bullet6Dof::facts,
                                                     {.loop_slope = 4, .has_fingerprint = true, .beta = 0.5});
};
struct ProgramBullet6DofAtB : reference::AsFormulation<programs::Bullet6DofAtB> {
  static constexpr Facts facts = reference::facts_of(programs::Bullet6DofAtB::facts,
                                                     {.loop_slope = 4, .has_fingerprint = true, .beta = 0.5});
};
struct ProgramPhysxSwingTwist : reference::AsFormulation<programs::PhysxSwingTwist> {
  static constexpr Facts facts = reference::facts_of(programs::PhysxSwingTwist::facts, {});
};
struct ProgramJolt6Dof : reference::AsFormulation<programs::Jolt6Dof> {
  static constexpr Facts facts =
      reference::facts_of(programs::Jolt6Dof::facts, {.has_fingerprint = true, .alpha = 1});
};
struct ProgramRapierAsin : reference::AsFormulation<programs::RapierAsin> {
  static constexpr Facts facts =
      reference::facts_of(programs::RapierAsin::facts, {.has_fingerprint = true, .alpha = 0});
};
struct ProgramHavok : reference::AsFormulation<programs::Havok> {
  static constexpr Facts facts =
      reference::facts_of(programs::Havok::facts, {.has_fingerprint = true, .alpha = 0});
};
struct ProgramNewtonD6 : reference::AsFormulation<programs::NewtonD6> {
  static constexpr Facts facts = reference::facts_of(programs::NewtonD6::facts, {});
};
struct ProgramMbsimOffdiag : reference::AsFormulation<programs::MbsimOffdiag> {
  static constexpr Facts facts = reference::facts_of(programs::MbsimOffdiag::facts, {});
};

}  // namespace halfway
