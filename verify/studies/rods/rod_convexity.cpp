// The rotation up to which the energies of rod4 and rod34 are convex: searched for, and where their moment
// vanishes.
#include "reference/numbers/linear_algebra.hpp"
#include "reference/scene/joint/convexity.hpp"
#include "verify/oracle/property.hpp"

#include <fmt/format.h>

#include <cmath>

namespace halfway::verify {
namespace {

using reference::Generator;

constexpr const char* kSeries[] = {"rod4", "rod34"};

Draft of_convexity(const std::string& formulation, const std::string& what, Kind kind) {
  return finding(fmt::format("rod_convexity/{}/{}", formulation, what))
      .of(formulation, to_string(kind))
      .about("rod_joints");
}

/// A law by its principal axes and values.
struct Principal {
  Mat3<double> axes;
  Vec3<double> k;
  Mat3<double> K() const { return axes * k.asDiagonal() * axes.transpose(); }
};

/// d(energy)/d(theta), from the moment on b and the rates of rotations: spin = Gamma d(theta).
Vec3<double> gradient(const Entry& entry, const JointSpec& spec, const Vec3<double>& theta) {
  const Pose<double> b{Vec3<double>::Zero(), so3::exp<double>(theta)};
  return so3::gamma<double>(theta).transpose() * entry.in_double.angular(spec, {}, b, false).m_b;
}

/// |theta| along n at which the Hessian, by central differences of the gradient, is first singular: it
/// differs from K by a form of order two in theta.
double radius_along(const Entry& entry, const JointSpec& spec, const Principal& law, const Vec3<double>& n) {
  constexpr double kStep = 1e-4;
  const double r = 0.3;
  Mat3<double> hessian;
  for (int i = 0; i < 3; ++i) {
    const Vec3<double> step = kStep * Vec3<double>::Unit(i);
    hessian.col(i) =
        (gradient(entry, spec, r * n + step) - gradient(entry, spec, r * n - step)) / (2 * kStep);
  }
  const Mat3<double> white = law.axes * law.k.cwiseSqrt().cwiseInverse().asDiagonal();
  const Mat3<double> form = white.transpose() * (law.K() - hessian) * white / (r * r);
  const double most = -reference::spectrum(-form).smallest;
  return 1 / std::sqrt(most);
}

/// The least of all directions: random ones, then about the worst of them.
double searched_radius(const Entry& entry, const JointSpec& spec, const Principal& law, Generator& g) {
  Vec3<double> worst = g.direction();
  double least = radius_along(entry, spec, law, worst);
  const auto look = [&](const Vec3<double>& n) {
    const double r = radius_along(entry, spec, law, n);
    if (r < least) least = r, worst = n;
  };
  for (int i = 0; i < 300; ++i) look(g.direction());
  for (double near = 0.3; near > 1e-5; near *= 0.7)
    for (int i = 0; i < 6; ++i) look((worst + near * g.direction()).normalized());
  return least;
}

JointSpec spec_of(const Entry& entry, Kind kind, const Eigen::MatrixXd& K) {
  JointSpec spec;
  static_cast<Parameters&>(spec) = entry.probe;
  spec.kind = kind;
  spec.law = reference::LinearSpec{(K + K.transpose()) / 2, false};
  return spec;
}

std::vector<Finding> radius(const std::string& formulation) {
  const Entry& entry = *reference::find_formulation(formulation);
  Generator g(1226);
  Extent share;  // searched over stated
  for (int i = 0; i < by_effort(20, 6); ++i) {
    const Principal law{g.rotation(0.1, 3),
                        Vec3<double>(1, std::pow(30, g.uniform(0, 1)), std::pow(100, g.uniform(0, 1)))};
    const JointSpec spec = spec_of(entry, Kind::angular, law.K());
    share.include(searched_radius(entry, spec, law, g) / reference::convex_radius(entry, spec));
  }
  return {
      of_convexity(formulation, "radius_is_safe", Kind::angular)
          .measured(share.low())
          .in("of the stated radius")
          .at_least(1 - 1e-5, "no direction of the search is worse; differences of 1e-4 rad hold it to 1e-6")
          .by(Oracle::independent),
      of_convexity(formulation, "radius_is_sharp", Kind::angular)
          .measured(share.high())
          .in("of the stated radius")
          .at_most(1 + 1e-4, "a search that closes in on the worst direction to 1e-5")
          .by(Oracle::independent)};
}

/// The energy by the strains (d, theta) in the half-way frame.
double energy_at(const Entry& entry, const JointSpec& spec, const Eigen::Matrix<double, 6, 1>& e) {
  const Vec3<double> theta = e.tail<3>();
  const Pose<double> b{so3::exp<double>(theta / 2) * e.head<3>(), so3::exp<double>(theta)};
  return entry.in_double.energy(spec, {}, b).value_or(std::nan(""));
}

using Mat6 = Eigen::Matrix<double, 6, 6>;
using Strain6 = Eigen::Matrix<double, 6, 1>;

/// Of the energy by the strains, by central differences.
Mat6 hessian_at(const Entry& entry, const JointSpec& spec, const Strain6& at) {
  constexpr double kStep = 1e-3;
  Mat6 out;
  for (int r = 0; r < 6; ++r) {
    for (int c = 0; c < 6; ++c) {
      const auto u = [&](double s, double t) {
        Strain6 moved = at;
        moved[r] += s * kStep, moved[c] += t * kStep;
        return energy_at(entry, spec, moved);
      };
      out(r, c) = (u(1, 1) - u(1, -1) - u(-1, 1) + u(-1, -1)) / (4 * kStep * kStep);
    }
  }
  return out;
}

double least_eigenvalue(const Mat6& m) { return reference::spectrum(m).smallest; }

/// A law with coupling, just inside what is stated: the least eigenvalue of the Hessian over that of the law;
/// and the Hessian at rest, which is the law's stiffness.
std::vector<Finding> coupled(const std::string& formulation) {
  const Entry& entry = *reference::find_formulation(formulation);
  Generator g(66);
  Extent least;
  Measurement at_rest;
  for (const Probe& probe : probes(entry, Kind::linear_angular, 6, 1)) {
    JointSpec spec = probe.spec;
    spec.a = spec.b = {};
    const Mat6 K = std::get<reference::LinearSpec>(spec.law).matrix;
    at_rest.include((hessian_at(entry, spec, Strain6::Zero()) - K).norm() / K.norm(), {});
    const double radius = reference::convex_radius(entry, spec);
    for (int i = 0; i < by_effort(20, 4); ++i) {
      Strain6 at;
      at << 0, 0, 0, 0.99 * radius * g.direction();
      least.include(least_eigenvalue(hessian_at(entry, spec, at)) / least_eigenvalue(K));
    }
  }
  return {
      of_convexity(formulation, "coupled_law", Kind::linear_angular)
          .measured(least.low())
          .in("of the law's least stiffness")
          .at_least(0,
                    "within a bound from below of the rotation, the Hessian is positive definite in every "
                    "direction")
          .by(Oracle::independent),
      of_convexity(formulation, "coupled_law_at_rest", Kind::linear_angular)
          .measured(at_rest)
          .in("of the law's stiffness")
          .at_most(5e-7,
                   "differences of 1e-3: a twelfth of their square of an energy whose fourth order is as "
                   "large as the second, and its rounding over that square")
          .by(Oracle::independent)};
}

/// K = (1, 10, 100): in the plane of the two stiffer axes the moment along the rotation is K_n phi - 4 q
/// phi^3, which vanishes at phi^2 = 6 k_1 (k_2 c^2 + k_3 s^2)/((k_2 - k_3) c s)^2, least where c^2 : s^2 =
/// sqrt(k_3) : sqrt(k_2).
std::vector<Finding> vanishing_moment() {
  const Entry& entry = *reference::find_formulation("rod4");
  const Vec3<double> k(1, 10, 100), root = k.cwiseSqrt();
  const JointSpec spec = spec_of(entry, Kind::angular, Eigen::MatrixXd(k.asDiagonal()));
  const auto along = [&](const Vec3<double>& n, double phi) { return n.dot(gradient(entry, spec, phi * n)); };
  const Vec3<double> worst(0, std::sqrt(root[2] / (root[1] + root[2])),
                           std::sqrt(root[1] / (root[1] + root[2])));
  double low = 0.1, high = 1;
  for (int i = 0; i < 60; ++i) (along(worst, (low + high) / 2) > 0 ? low : high) = (low + high) / 2;
  Generator g(36);
  Extent elsewhere;
  for (int i = 0; i < 2000; ++i) elsewhere.include(along(g.direction(), 0.999 * low) / low);
  return {of_convexity("rod4", "vanishing_moment", Kind::angular)
              .measured(low, "K = (1, 10, 100) N m/rad")
              .in("rad")
              .equal(std::sqrt(6 * k[0]) / (root[2] - root[1]), 1e-12, "bisection to the last bits")
              .by(Oracle::closed_form),
          of_convexity("rod4", "moment_before_that", Kind::angular)
              .measured(elsewhere.low())
              .in("N m/rad")
              .at_least(0, "in every direction the moment still holds against the rotation")
              .by(Oracle::closed_form)};
}

}  // namespace

void rod_convexity(Checks& checks) {
  for (const std::string formulation : kSeries) {
    checks.push_back(
        {fmt::format("rod_convexity/{}/radius", formulation), "", [=] { return radius(formulation); }});
  }
  checks.push_back({"rod_convexity/rod4/coupled_law", "", [] { return coupled("rod4"); }});
  checks.push_back({"rod_convexity/rod4/vanishing_moment", "", vanishing_moment});
}

}  // namespace halfway::verify
