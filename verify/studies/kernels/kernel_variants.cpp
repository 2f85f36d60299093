// The kernels behind the registry's face against the readable transcription, and the cheaper angles
// of the invariant kernel against phi / sin(phi/2) at 50 digits.
#include "reference/face/kernel_variants.hpp"
#include "halfway/kernels/core/functions.hpp"
#include "reference/scene/joint/convexity.hpp"
#include "verify/oracle/findings.hpp"
#include "verify/oracle/property.hpp"
#include "verify/oracle/replay.hpp"
#include "verify/oracle/saboteurs/tap.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace halfway::verify {
namespace {

using reference::KernelVariant;
using reference::LinearSpec;

// Angles ------------------------------------------------------------------------------------------

/// phi / sin(phi/2) as a variant takes it over its true value, less 1, at 50 digits.
template <class Angle>
double angle_error(double phi) {
  const Real50 half = Real50(phi) / 2, quarter = half / 2;
  const Real50 t = 2 * sin(quarter) * sin(quarter);
  const kernel::HalfAngle<Real50> at{t, 1 - t, 1 / (2 - t)};
  return std::abs(double(tapped(Angle::template jet<0>(at).h) * sin(half) / Real50(phi) - 1));
}

/// The worst error over phi^power for phi from 1e-3 rad to pi.
template <class Angle>
Measurement worst_angle(int power) {
  constexpr int kPoints = 200;
  Measurement worst;
  for (int i = 0; i <= kPoints; ++i) {
    const double phi =
        std::min(1e-3 * std::pow(1e3 * std::numbers::pi, double(i) / kPoints), std::numbers::pi);
    const double error = angle_error<Angle>(phi) / std::pow(phi, power);
    worst.include(error, fmt::format("phi = {:.4g} rad", phi));
  }
  return worst;
}

/// h = sum of a_k t^k, a_k = 2^(k+1) k!^2 / (2k+1)!: all positive, and a_(k+1) < a_k / 2. So the first
/// omitted term leaves at most a_n t^n / (1 - t/2) <= 2 a_n t^n of h >= 2; t <= phi^2 / 8.
/// @return  the bound over phi^(2 terms)
double small_angle_bound(int terms) {
  double a = 2;
  for (int k = 1; k <= terms; ++k) a *= 2. * k * k / (2 * k * (2 * k + 1));
  return a / std::pow(8, terms);
}

template <int terms>
Finding small_angle() {
  return at_most(fmt::format("kernel_variants/order_{}", terms), "kernel_variants",
                 worst_angle<kernel::SmallAngle<terms>>(2 * terms), small_angle_bound(terms),
                 fmt::format("1/rad^{}", 2 * terms).c_str(), Oracle::closed_form,
                 fmt::format("error / phi^{}: the first omitted term, twice for those after it", 2 * terms));
}

/// h is analytic inside the ellipse with rho = 3 + sqrt(8) = 5.83, up to t = 2 (phi = 2 pi): with a
/// smaller one, up to t_max, |h| <= h(t_max) since all a_k > 0, and interpolation at Chebyshev points
/// errs by 4 h(t_max) rho^-n / (rho - 1) at most (Trefethen, Approximation Theory, theorem 8.2).
double ellipse_bound(int degree) {
  double least = HUGE_VAL;
  for (double rho = 2; rho < 5.82; rho += 0.01) {
    const double t_max = (1 + (rho + 1 / rho) / 2) / 2;
    const double h = 2 * std::acos(1 - t_max) / std::sqrt(t_max * (2 - t_max));
    least = std::min(least, 4 * h * std::pow(rho, -degree) / (rho - 1));
  }
  return least / 2;  // relative to h >= 2
}

template <int degree>
Finding polynomial_angle() {
  return at_most(fmt::format("kernel_variants/log_{}", degree), "kernel_variants",
                 worst_angle<kernel::PolynomialAngle<degree>>(0), ellipse_bound(degree), "relative",
                 Oracle::closed_form,
                 "interpolation at Chebyshev points: 4 M rho^-n / (rho - 1), the least of all ellipses");
}

std::vector<Finding> relative_angles() {
  return {small_angle<1>(),      small_angle<2>(),       small_angle<3>(),      polynomial_angle<4>(),
          polynomial_angle<8>(), polynomial_angle<12>(), polynomial_angle<18>()};
}

// Loads -------------------------------------------------------------------------------------------

/// That of the kernels themselves (kernels.cpp), and as much again for matrices rounded twice.
constexpr double kVariantLimit = 1e-14;
constexpr double kSingleLimit =
    kVariantLimit * std::numeric_limits<float>::epsilon() / std::numeric_limits<double>::epsilon();

/// The stiffness of a probe, or every other time its compliance: the adapters invert as scenes do.
std::vector<Probe> mixed_probes(const Entry& entry, Kind kind) {
  auto out = probes(entry, kind, 8, 1);
  for (std::size_t i = 1; i < out.size(); i += 2) {
    auto& law = std::get<LinearSpec>(out[i].spec.law);
    law = {law.matrix.inverse(), true};
  }
  // Beyond, what solves refuses; the terms of a series cancel there.
  std::erase_if(out, [&](const Probe& p) { return p.phi > reference::convex_radius(entry, p.spec); });
  return out;
}

double defect(const NodeLoads<double>& value, const NodeLoads<double>& by) {
  const auto of_largest = [](const auto& x, const auto& y) {
    return largest_entry<double>((x - y).eval()) / largest_entry<double>(y);
  };
  return larger(of_largest(value.q, by.q), of_largest(value.tangent, by.tangent));
}

/// Loads and tangent of one entry against another's, each over its largest entry.
Measurement worst_loads(const Entry& entry, const Entry& by, Kind kind) {
  Measurement worst;
  for (const Probe& p : mixed_probes(by, kind)) {
    const auto value = reference::node_loads<double>(entry, p.spec, p.a, p.b, true);
    const double miss = defect(value, reference::node_loads<double>(by, p.spec, p.a, p.b, true));
    if (worst.include(miss, fmt::format("phi = {:.3g} rad", p.phi)))
      worst.set_replay(eval_request(std::string(by.name), p.spec, p.a, p.b));
  }
  return worst;
}

std::vector<Finding> by_kernel(const Entry& entry, Kind kind) {
  const auto compared = [&](const char* name, bool in_float, double limit, const char* why) {
    return property_finding(entry, kind, name)
        .measured(worst_loads(with_kernel(entry, in_float), entry, kind))
        .in("relative")
        .at_most(limit, why)
        .by(Oracle::independent);
  };
  return {compared("with_kernel", false, kVariantLimit,
                   "a dozen roundings of the kernel and of the transcription each, over the largest entry"),
          compared("with_kernel_float", true, kSingleLimit, "the same in eps of float")};
}

/// Relative error of the angle at 1 rad, the largest of the probes' angles, and rounding.
double variant_limit(const KernelVariant& v) {
  if (v.precision == "float") return kSingleLimit;
  const auto number = [&](std::string_view prefix) {
    return v.name.starts_with(prefix) ? std::stoi(std::string(v.name.substr(prefix.size()))) : 0;
  };
  if (const int terms = number("order_")) return small_angle_bound(terms) + kVariantLimit;
  if (const int degree = number("log_")) return ellipse_bound(degree) + kVariantLimit;
  return kVariantLimit;
}

/// Moments against the transcription's: a linear law scales them by the error of the angle, no more.
Measurement worst_moment(const KernelVariant& v, const Entry& invariant) {
  Measurement worst;
  const Entry entry = with_variant(invariant, v);
  for (const Probe& p : mixed_probes(invariant, Kind::angular)) {
    const Vec3<double> exact = invariant.in_double.angular(p.spec, p.a, p.b, false).m_b;
    for (const bool with_tangent : {false, true}) {
      const Vec3<double> m = entry.in_double.angular(p.spec, p.a, p.b, with_tangent).m_b;
      const double miss = (m - exact).norm() / exact.norm();
      worst.include(miss, fmt::format("phi = {:.3g} rad", p.phi));
    }
  }
  return worst;
}

/// The tangent of a variant against central differences of its own moments: a cruder angle must not
/// break Newton's method.
Measurement worst_tangent(const KernelVariant& v, const Entry& invariant) {
  constexpr double kStep = 1e-5;  // rad
  Measurement worst;
  for (const Probe& p : mixed_probes(invariant, Kind::angular)) {
    const auto moment = [&](const Vec3<double>& spin) {
      const Pose<double> b{p.b.x, so3::exp<double>(spin) * p.b.R};
      return v.from_matrices(p.spec, p.a, b, false).m_b;
    };
    Mat3<double> difference;
    for (int i = 0; i < 3; ++i) {
      const Vec3<double> spin = kStep * Vec3<double>::Unit(i);
      difference.col(i) = (moment(spin) - moment(-spin)) / (2 * kStep);
    }
    const Mat3<double> tangent = v.from_matrices(p.spec, p.a, p.b, true).m_b_wb;
    const double miss = (tangent - difference).norm() / tangent.norm();
    worst.include(miss, fmt::format("phi = {:.3g} rad", p.phi));
  }
  return worst;
}

std::vector<Finding> variants() {
  const Entry& invariant = *reference::find_formulation("invariant");
  std::vector<Finding> out;
  for (const KernelVariant& v : reference::invariant_variants()) {
    const std::string name = fmt::format("variants/{}_{}", v.name.empty() ? "plain" : v.name, v.precision);
    out.push_back(property_finding(invariant, Kind::angular, name + "/moment")
                      .measured(worst_moment(v, invariant))
                      .in("relative")
                      .at_most(variant_limit(v),
                               "the bound of the angle's relative error at 1 rad, and a dozen roundings")
                      .by(Oracle::independent));
    if (v.precision == "float")
      continue;  // differences of floats leave four digits: with_kernel_float has it
    out.push_back(
        property_finding(invariant, Kind::angular, name + "/tangent")
            .measured(worst_tangent(v, invariant))
            .in("relative")
            .at_most(1e-8, "central differences: step^2 = 1e-10 times third derivatives, eps / step = 2e-11")
            .by(Oracle::independent));
  }
  return out;
}

}  // namespace

void kernel_variants(Checks& checks) {
  checks.push_back({"kernel_variants/angles", "kernels", relative_angles});
  checks.push_back({"kernel_variants/loads", "kernels", variants});
  for (const Entry& entry : reference::formulations()) {
    if (entry.kernel.in_double.angular == nullptr) continue;
    for (const Kind kind : kKinds) {
      checks.push_back({fmt::format("{}/{}/with_kernel", entry.name, to_string(kind)), "kernels",
                        [&entry, kind] { return by_kernel(entry, kind); }});
    }
  }
}

}  // namespace halfway::verify
