// Nonlinear and user-made laws: the same joint, the same guarantees.
#include "halfway/systems/intrinsic.hpp"
#include "verify/oracle/property.hpp"
#include "verify/oracle/saboteurs/tap.hpp"

#include <fmt/format.h>

namespace halfway::verify {
namespace {

/// Hardening on every axis, strongly so at the probes' strains.
reference::PolynomialSpec hardening(Kind kind) {
  const int n = strain_count(kind);
  reference::PolynomialSpec law;
  law.k1 = Eigen::VectorXd::LinSpaced(n, 1, 40);
  law.k3 = Eigen::VectorXd::LinSpaced(n, 30, 2);
  law.k5 = Eigen::VectorXd::LinSpaced(n, 0.5, 5);
  return law;
}

std::vector<Probe> hardening_probes(const Entry& entry, Kind kind) {
  auto list = probes(entry, kind, 4, 2.0);
  for (Probe& probe : list) probe.spec.law = hardening(kind);
  return list;
}

/// A law that only its caller knows: stress_i = sinh(k_i e_i), as a plain lambda.
std::vector<Finding> callable() {
  const auto law = [](const Vec3<double>& e) {
    const Vec3<double> k(1, 2, 3);
    const Eigen::Array3d ke = k.cwiseProduct(e).array();
    return LawResponse<double, 3>{Vec3<double>(ke.sinh()),
                                  Mat3<double>((k.array() * ke.cosh()).matrix().asDiagonal())};
  };
  const Joint<Kind::angular, double, Invariant, decltype(law)> joint{{}, law};
  const Pose<double> a;
  Pose<double> b;
  b.R = so3::exp<double>({0.3, -0.5, 0.7});
  const auto at = [&](const Vec3<double>& w) {
    Pose<double> moved = b;
    moved.R = so3::exp<double>(w) * b.R;
    return loads<false>(joint, a, moved).m_b;
  };
  const Mat3<double> tangent = tapped(loads<true>(joint, a, b).m_b_wb);
  constexpr double h = 1e-4;
  Measurement worst;
  for (int i = 0; i < 3; ++i) {
    const auto e = [&](double s) -> Vec3<double> { return s * h * Vec3<double>::Unit(i); };
    const Vec3<double> column = (8 * (at(e(1)) - at(e(-1))) - (at(e(2)) - at(e(-2)))) / (12 * h);
    worst.include((column - tangent.col(i)).norm() / tangent.norm(), fmt::format("column {}", i + 1));
  }
  return {
      finding("laws/callable/tangent")
          .about("laws")
          .measured(worst)
          .in("relative")
          .at_most(1e-10,
                   "fourth-order central differences with a step of 1e-4: h^4 and eps/h are both near 1e-12")
          .by(Oracle::independent)};
}

/// The joint in another scalar: the same moment to that scalar's rounding.
template <class T>
Finding scalar(const char* name) {
  const LinearLaw<T, 3> law = orthotropic_law<T, 3>({T(1), T(10), T(100)});
  const Joint<Kind::angular, T, Invariant, LinearLaw<T, 3>> joint{{}, law};
  const LinearLaw<double, 3> law_double = orthotropic_law<double, 3>({1, 10, 100});
  const Joint<Kind::angular, double, Invariant, LinearLaw<double, 3>> joint_double{{}, law_double};
  Pose<T> b;
  b.R = so3::exp<T>({T(0.25), T(-0.5), T(0.75)});
  Pose<double> b_double;
  b_double.R = so3::exp<double>({0.25, -0.5, 0.75});
  const Vec3<double> m = tapped(loads<false>(joint, Pose<T>{}, b).m_b.template cast<double>().eval());
  const Vec3<double> expected = loads<false>(joint_double, Pose<double>{}, b_double).m_b;
  const double eps =
      larger(double(std::numeric_limits<T>::epsilon()), std::numeric_limits<double>::epsilon());
  return finding(fmt::format("laws/scalar/{}", name))
      .about("laws")
      .measured((m - expected).norm() / expected.norm())
      .in("relative")
      .at_most(10 * eps, "ten eps of the coarser scalar, as rounding allows")
      .by(Oracle::fifty_digits);
}

}  // namespace

void laws(Checks& checks) {
  const auto kinds = {Kind::angular, Kind::linear, Kind::linear_angular};
  add_property(checks, "tangent_hardening", kinds, [](const Entry& entry, Kind kind, Draft f) {
    return hold(f, tangent_by_duals(under_test(entry), hardening_probes(entry, kind)), {},
                Oracle::independent);
  });
  add_property(checks, "energy_gradient_hardening", kinds, [](const Entry& entry, Kind kind, Draft f) {
    if (!entry.has_potential(kind))
      return f.left_out("this formulation has no potential of this kind; see symmetry and loop_work");
    return hold(f, energy_gradient(under_test(entry), hardening_probes(entry, kind)), {},
                Oracle::independent);
  });
  checks.push_back({"laws/callable", "properties", callable});
  checks.push_back({"laws/scalars", "properties", [] {
                      return std::vector{scalar<float>("float"), scalar<long double>("long_double")};
                    }});
}

}  // namespace halfway::verify
