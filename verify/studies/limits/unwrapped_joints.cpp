// Joints that are wound by the unwrapped rotation vector: no moment is lost at pi, and tangents hold beyond.
#include "halfway/joint/unwrapped.hpp"
#include "halfway/systems/attached.hpp"
#include "halfway/systems/intrinsic.hpp"
#include "halfway/systems/potentials.hpp"
#include "verify/oracle/findings.hpp"
#include "verify/oracle/saboteurs/tap.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace halfway::verify {
namespace {

constexpr const char* kSubject = "unwrapped";

Mat3<double> turned(double phi) { return so3::exp<double>(phi * Vec3<double>(2, 3, 6) / 7); }

Finding expected(const std::string& name, double value, double expectation, double limit, const char* unit,
                 const std::string& reason) {
  return finding(name)
      .about(kSubject)
      .measured(value)
      .in(unit)
      .equal(expectation, limit, reason)
      .by(Oracle::closed_form);
}

/// Moment about a generic axis of a spring with unequal stiffnesses, wound by five turns and not unwrapped.
std::vector<Finding> spring() {
  const Vec3<double> k(2, 3, 7), n = Vec3<double>(2, 3, 6) / 7, Kn = k.cwiseProduct(n);
  const LinearLaw<double, 3> law{Mat3<double>(k.asDiagonal())};
  UnwrappedRotation<double> rotation;
  Measurement moment, energy;
  double work = 0, last = 0, wrapped_most = 0, jump = 0;
  Vec3<double> wrapped_before = Vec3<double>::Zero();
  constexpr int kSteps = 1000;
  for (int i = 1; i <= kSteps; ++i) {
    const double phi = 10 * std::numbers::pi * i / kSteps, h = 10 * std::numbers::pi / kSteps;
    const auto wrapped = relative_motion<double>(turned(phi), Vec3<double>::Zero());
    const auto step = rotation.tried(wrapped.q);
    rotation.commit(step);
    const Vec3<double> m = tapped(AttachedA{}.angular<false>(unwrapped_motion(wrapped, step), law).m);
    moment.include((m - phi * Kn).norm() / (phi * Kn.norm()), fmt::format("phi = {:.4g} rad", phi));
    work += h * (last + n.dot(m)) / 2;  // exact for a linear law
    last = n.dot(m);
    energy.include(std::abs(work / (phi * phi * n.dot(Kn) / 2) - 1), fmt::format("phi = {:.4g} rad", phi));
    const Vec3<double> forgetful = AttachedA{}.angular<false>(wrapped, law).m;
    keep_largest(wrapped_most, forgetful.norm() / Kn.norm());
    keep_largest(jump, (forgetful - wrapped_before).norm() / Kn.norm());
    wrapped_before = forgetful;
  }
  const double eps = std::numeric_limits<double>::epsilon();
  return {
      at_most("unwrapped/spring/moment", kSubject, moment, 16 * eps, "relative", Oracle::closed_form,
              "phi K n over five turns; the axis of R is known to eps/sin(phi/2), 16 steps a quarter turn"),
      at_most("unwrapped/spring/energy", kSubject, energy, 16 * eps, "relative", Oracle::closed_form,
              "work is phi^2 n.Kn/2; the roundings of a thousand additions even out"),
      expected("unwrapped/spring/wrapped_moment", wrapped_most, std::numbers::pi, 0.02, "rad",
               "without unwrapping no moment is beyond pi K n; the nearest step is 0 to 0.016 rad before"),
      expected("unwrapped/spring/wrapped_jump", jump, 2 * std::numbers::pi, 0.04, "rad",
               "without unwrapping the moment jumps by 2 pi K n; less the step")};
}

/// Moments that are the same in any scalar, as a function of the spin from a wound state.
template <class T, class F>
AngularResponse<T> wound_response(const F& formulation, const UnwrappedRotation<T>& rotation,
                                  const Mat3<T>& R) {
  const LinearLaw<T, 3> law{Mat3<T>(Vec3<T>(T(2), T(3), T(7)).asDiagonal())};
  const auto wrapped = relative_motion<T>(R, Vec3<T>::Zero());
  auto out = formulation.template angular<true>(unwrapped_motion(wrapped, rotation.tried(wrapped.q)), law);
  out.m = tapped(out.m), out.m_psi = tapped(out.m_psi);
  return out;
}

template <class F>
Finding tangent(const F& formulation) {
  Measurement worst;
  for (const double phi : {2.5, 3.5, 5.5, 8., 17., 29.}) {
    const Vec3<Real50> theta = Real50(phi) * Vec3<Real50>(2, 3, 6) / Real50(7);
    const Mat3<Real50> R = so3::exp(theta);
    const auto exact = wound_response<Real50>(formulation, UnwrappedRotation<Real50>(theta), R);
    const double size = double(Real50(exact.m_psi.norm()));
    for (int j = 0; j < 3; ++j) {
      const Mat3<Real50> rate = skew<Real50>(Vec3<Real50>::Unit(j)) * R;
      Mat3<Dual50> turning = R.cast<Dual50>();
      for (int i = 0; i < 9; ++i) turning(i).d = rate(i);
      const UnwrappedRotation<Dual50> rotation(theta.cast<Dual50>());
      const Vec3<Dual50> m = wound_response<Dual50>(formulation, rotation, turning).m;
      for (int i = 0; i < 3; ++i)
        worst.include(double(abs(m[i].d - exact.m_psi(i, j))) / size, fmt::format("phi = {} rad", phi));
    }
  }
  return finding(fmt::format("unwrapped/tangent/{}", F::name))
      .of(F::name, "angular")
      .about(kSubject)
      .measured(worst)
      .in("relative")
      .at_most(kRounding, kRoundingReason)
      .by(Oracle::independent);
}

std::vector<Finding> tangents() {
  return {tangent(AttachedA{}), tangent(Invariant{}), tangent(Potential{}), tangent(Conformal{})};
}

/// The half-way frame turns by half of the whole angle, not of the wrapped one: those are pi apart.
std::vector<Finding> halfway() {
  Measurement moment, rate;
  for (const double phi : {2.5, 3.5, 5.5, 8., 17., 29.}) {
    const Vec3<Real50> theta = Real50(phi) * Vec3<Real50>(2, 3, 6) / Real50(7);
    const Vec3<Real50> stress = Vec3<Real50>(2, 3, 7).cwiseProduct(theta);
    const Vec3<Real50> exact = so3::exp<Real50>(theta / Real50(2)) * stress;
    const Vec3<Real50> m =
        wound_response<Real50>(Invariant{}, UnwrappedRotation<Real50>(theta), so3::exp(theta)).m;
    moment.include(double(Real50((m - exact).norm() / stress.norm())), fmt::format("phi = {} rad", phi));
  }
  for (const int turns : {1, 2, 3}) {  // where R has no axis: the last one, along which theta goes on
    const Vec3<Real50> n = Vec3<Real50>(2, 3, 6) / Real50(7),
                       theta = Real50(2 * turns) * reference::pi50() * n;
    Mat3<Dual50> turning = Mat3<Dual50>::Identity();
    const Mat3<Real50> spin = skew(n);
    for (int i = 0; i < 9; ++i) turning(i).d = spin(i);
    const auto step = UnwrappedRotation<Dual50>(theta.cast<Dual50>()).tried(turning);
    for (int i = 0; i < 3; ++i)
      rate.include(double(abs(step.theta[i].d - n[i])), fmt::format("after {} turns", turns));
  }
  return {at_most("unwrapped/halfway/moment", kSubject, moment, kRounding, "relative", Oracle::closed_form,
                  kRoundingReason),
          at_most("unwrapped/halfway/full_turn_rate", kSubject, rate, kRounding, "rad/rad",
                  Oracle::closed_form, kRoundingReason)};
}

/// As a measure, 4 tan(phi/4) n is regular to 2 pi: with the unwrapped vector the joint is, too.
std::vector<Finding> conformal_beyond_pi() {
  Measurement worst;
  const Vec3<Real50> n = Vec3<Real50>(2, 3, 6) / Real50(7), k(2, 3, 7);
  const auto moment = [&](const Real50& phi) {
    const Vec3<Real50> theta = phi * n;
    return wound_response<Real50>(Conformal{}, UnwrappedRotation<Real50>(theta), so3::exp(theta)).m;
  };
  for (const double phi : {3., 3.3, 4.7, 6., 6.28}) {
    const Real50 quarter = Real50(phi) / Real50(4), c = cos(quarter);
    const Real50 size = Real50(4) * tan(quarter) / (c * c) * k.cwiseProduct(n).norm();
    worst.include(std::abs(double(moment(Real50(phi)).norm() / size - Real50(1))),
                  fmt::format("phi = {}", phi));
  }
  const Real50 step("1e-20"), at_pi = reference::pi50(), turn = at_pi + at_pi;
  const double jump = double(Real50((moment(at_pi + step) - moment(at_pi - step)).norm()));
  const double growth = double(Real50(moment(turn - step).norm() / moment(turn - Real50("1e-10")).norm()));
  return {at_most("unwrapped/conformal/moment", kSubject, worst, kRounding, "relative", Oracle::closed_form,
                  kRoundingReason),
          at_most("unwrapped/conformal/jump_at_pi", kSubject, {jump}, 2e-18, "N m", Oracle::closed_form,
                  "smooth: 2e-20 rad of the slope 8 |K n|, 1e-18 N m"),
          expected("unwrapped/conformal/pole_at_full_turn", std::log10(growth) / 10, 3, 1e-6, "order",
                   "tan(phi/4)/cos^2(phi/4): the third power of the distance to 2 pi")};
}

}  // namespace

void unwrapped_joints(Checks& checks) {
  checks.push_back({"unwrapped/spring", "stability", spring});
  checks.push_back({"unwrapped/halfway", "stability", halfway});
  checks.push_back({"unwrapped/tangents", "stability", tangents});
  checks.push_back({"unwrapped/conformal", "stability", conformal_beyond_pi});
}

}  // namespace halfway::verify
