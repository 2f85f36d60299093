// The formulas of halfway/rotations/so3.hpp by roads that share nothing with them: power series and defining
// equations at 50 digits, and the derivatives that dual numbers take through them.
#include "verify/oracle/findings.hpp"
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/oracle/so3_measure.hpp"

#include <Eigen/LU>

namespace halfway::verify {
namespace {

void add(Checks& checks, const std::string& name, double limit, const char* reason,
         std::function<Measurement()> measure) {
  checks.push_back({name, "identities", [=]() -> std::vector<Finding> {
                      return {at_most(name, "so3", measure(), limit, "eps", Oracle::independent, reason)};
                    }});
}

using M50 = Mat3<Real50>;
using V50 = Vec3<Real50>;

/// sum [theta]^k/(k + shift)!: exp for shift 0, Gamma for 1. No scaling; |theta| <= 2 pi loses 3 digits.
M50 power_series(const V50& theta, int shift) {
  const M50 x = skew(theta);
  M50 term = M50::Identity(), sum = M50::Identity();
  for (int k = 1; k < 120; ++k) {
    term = M50(term * x) / Real50(k + shift);
    sum += term;
  }
  return sum;
}

double in_eps50(const auto& difference, const Real50& size = Real50(1)) {
  return double(largest(tapped(difference.eval())) / size / Eigen::NumTraits<Real50>::epsilon());
}

V50 theta_of(const Rotation& r) { return r.phi * r.n; }
const M50 kOne = M50::Identity();

double cayley_defect(const V50& zeta, const M50& R) {  // (1 - [zeta]) R = 1 + [zeta], defining equation [70b]
  const Real50 size = zeta.norm() > Real50(1) ? zeta.norm() : Real50(1);
  return in_eps50(M50((kOne - skew(zeta)) * R - (kOne + skew(zeta))), size);
}

void add_formulas(Checks& checks) {
  constexpr double kLimit = 500;
  constexpr const char* kReason =
      "eps = 2^-167; the series in |theta| <= pi passes terms of size e^pi = 23, a few roundings each";
  const auto formula = [&](const std::string& function, double (*defect)(const Rotation&)) {
    add(checks, "so3/" + function + "/formula", kLimit, kReason,
        [=] { return worst_rotation(table_rotations(), defect); });
  };
  formula("exp", [](const Rotation& r) {
    return in_eps50(M50(so3::exp(theta_of(r)) - power_series(theta_of(r), 0)));
  });
  formula("gamma", [](const Rotation& r) {
    return in_eps50(M50(so3::gamma(theta_of(r)) - power_series(theta_of(r), 1)));
  });
  formula("gamma_inverse", [](const Rotation& r) {
    return in_eps50(M50(so3::gamma_inverse(theta_of(r)) * power_series(theta_of(r), 1) - kOne));
  });
  formula("log", [](const Rotation& r) {
    const M50 R = power_series(theta_of(r), 0);
    return in_eps50(M50(power_series(so3::log(R), 0) - R));
  });
  formula("half", [](const Rotation& r) {
    const M50 R = power_series(theta_of(r), 0), H = so3::half(R);
    return H.trace() < Real50(1) - Real50("1e-40") ? std::numeric_limits<double>::infinity()
                                                   : in_eps50(M50(H * H - R));
  });
  formula("quaternion", [](const Rotation& r) {
    const M50 R = power_series(theta_of(r), 0);
    const auto q = as_vector(so3::quaternion(R));
    return larger(in_eps50(q - exact_input<Input::quaternion>(r)),
                  in_eps50(M50(so3::matrix(as_quaternion<Real50>(q)) - R)));
  });
  formula("cayley", [](const Rotation& r) { return cayley_defect(theta_of(r), so3::cayley(theta_of(r))); });
  formula("cayley_inverse", [](const Rotation& r) {
    const M50 R = power_series(theta_of(r), 0);
    return cayley_defect(so3::cayley_inverse(R), R);
  });
  add(checks, "so3/exp/formula_beyond_pi", kLimit, kReason, [] {
    return worst_rotation(long_rotations(), [](const Rotation& r) {
      return in_eps50(M50(so3::exp(theta_of(r)) - power_series(theta_of(r), 0)));
    });
  });
  add(checks, "so3/gamma/formula_beyond_pi", kLimit, kReason, [] {
    return worst_rotation(long_rotations(), [](const Rotation& r) {
      return in_eps50(M50(so3::gamma(theta_of(r)) - power_series(theta_of(r), 1)));
    });
  });
}

// ---- Dual numbers: the derivative in double against Gamma at 50 digits ----

using Dual = reference::Dual<double>;

Mat3<Dual> with_rate(const Mat3<double>& value, const Mat3<double>& rate) {
  Mat3<Dual> out;
  for (int i = 0; i < 9; ++i) out.data()[i] = {value.data()[i], rate.data()[i]};
  return out;
}

double in_eps(const auto& rate_of_duals, const auto& expected, const Real50& size) {
  Real50 error(0);
  for (int i = 0; i < rate_of_duals.size(); ++i)
    keep_largest(error, Real50(abs(Real50(tapped(rate_of_duals.data()[i].d)) - expected.data()[i])));
  return double(error / size) / std::numeric_limits<double>::epsilon();
}

const Vec3<double> kDirection(0.6, -0.9, 0.4);

/// dR = [Gamma(theta) delta] R, absolute, delta of length 1.15.
double exp_rate_error(const Rotation& r) {
  const Vec3<double> theta = theta_of(r).cast<double>();
  Vec3<Dual> moving;
  for (int i = 0; i < 3; ++i) moving[i] = {theta[i], kDirection[i]};
  const V50 exact = theta.cast<Real50>(), delta = kDirection.cast<Real50>();
  return in_eps(so3::exp(moving), M50(skew<Real50>(power_series(exact, 1) * delta) * power_series(exact, 0)),
                Real50(1));
}

/// d(theta) = Gamma(theta)^-1 w for dR = [w] R; relative to the largest entry of Gamma^-1.
double log_rate_error(const Rotation& r) {
  const Mat3<double> R = exact_input<Input::matrix>(r).cast<double>();
  const Mat3<double> rate = skew(kDirection) * R;
  const V50 theta = so3::log<Real50>(R.cast<Real50>());
  const M50 inverse = power_series(theta, 1).inverse();
  return in_eps(so3::log(with_rate(R, rate)), V50(inverse * kDirection.cast<Real50>()), largest(inverse));
}

std::vector<Rotation> with_zero() {
  std::vector<Rotation> out = table_rotations();
  out.push_back({Real50(0), V50::UnitX(), "phi = 0 exactly"});
  return out;
}

void add_duals(Checks& checks) {
  constexpr double kLimit = 16;
  constexpr const char* kReason =
      "a derivative adds one product per factor to the 4 eps of the value: four factors along the longest "
      "chain";
  add(checks, "so3/exp/dual", kLimit, kReason, [] { return worst_rotation(with_zero(), exp_rate_error); });
  add(checks, "so3/log_matrix/dual", kLimit, kReason,
      [] { return worst_rotation(with_zero(), log_rate_error); });
}

}  // namespace

void so3_formulas(Checks& checks) {
  add_formulas(checks);
  add_duals(checks);
}

}  // namespace halfway::verify
