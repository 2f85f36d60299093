// What a joint that stands for a rod has to follow: to all orders, at third, and at second where the rod is
// tapered.
#include "reference/truth/closed_forms.hpp"
#include "reference/truth/rod/closed/third_order.hpp"
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/studies/rods/rod_access.hpp"

#include <fmt/format.h>

#include <cmath>

namespace halfway::verify {
namespace {

namespace rod = reference::rod;
namespace closed_joint = reference::closed;
using M3 = Mat3<double>;

M3 stiffness(const Vec3<double>& k) {
  const M3 Q = closed_joint::rotation(Vec3<double>(0.5, -0.8, 0.3));
  return Q * k.asDiagonal() * Q.transpose();
}

/// The moment in the half-way frame less its third-order law, over the third-order size |w| |theta|^2: of the
/// order of the square of the rotation. The mean of m and -m: theta follows m with terms of second order, and
/// what they change here cancels.
double misfit(const M3& K, const Vec3<double>& m) {
  double sum = 0;
  for (const double sign : {1., -1.}) {
    const Vec3<double> theta = rotation_of(rod::end_rotation(K, sign * m));
    const Vec3<double> mbar = closed_joint::rotation(Vec3<double>(-theta / 2)) * (sign * m);
    sum += (mbar - rod::closed::third_order_moment(K, theta)).norm() / (m.norm() * theta.squaredNorm());
  }
  return sum / 2;
}

std::vector<Finding> third_order() {
  Measurement worst;
  struct {
    Vec3<double> k;
    double largest_ratio;
  } const kCases[] = {{{1, 2, 3}, 3}, {{9, 1, 35}, 35}, {{1, 10, 100}, 100}};
  for (const auto& [k, largest_ratio] : kCases) {
    const M3 K = stiffness(k);
    for (const Vec3<double>& turn : {Vec3<double>(0.6, -0.3, 0.7), Vec3<double>(0.2, 0.9, -0.4)}) {
      // The series is one in the rotation times the ratio of stiffnesses.
      const double size = 0.1 / largest_ratio;
      const double ratio = misfit(K, 2 * size * (K * turn)) / misfit(K, size * (K * turn));
      worst.include(std::abs(tapped(ratio) - 4), fmt::format("stiffness {}, {}, {}", k[0], k[1], k[2]));
    }
  }
  return {
      rod_finding("law/third_order")
          .measured(worst)
          .in("of the factor 4 by which half the rotation divides the misfit")
          .at_most(0.03,
                   "the square of 0.1, the size of the series' terms, a few times: the next order; a wrong "
                   "third order has the factor 1")
          .by(Oracle::independent)};
}

/// The tapered rod's second order from its rotation under m and -m, extrapolated from two sizes.
Vec3<double> second_order_of(const rod::Rod& r, const Vec3<double>& m) {
  const auto even = [&](double size) {
    const auto turn = [&](double by) { return rotation_of(tip_under_moment(r, by * m).R); };
    return Vec3<double>((turn(size) + turn(-size)) / (2 * size * size));
  };
  constexpr double kSize = 0.005;
  return (4 * even(kSize) - even(2 * kSize)) / 3;
}

/// theta = Cb m - Cb (xi (Cb m) x m) + ... component by component.
Vec3<double> xi_by_rod(const rod::Rod& r, const Vec3<double>& m, const Vec3<double>& Cb) {
  const Vec3<double> second = second_order_of(r, m);
  const Vec3<double> product = Cb.cwiseProduct(Vec3<double>(Cb.cwiseProduct(m)).cross(m));
  return -second.cwiseQuotient(product);
}

std::vector<Finding> taper() {
  rod::Rod r;
  r.taper = [](double s) {
    const double u = 1 - s / 2, cube = 1 / (u * u * u);
    return rod::Section{{cube, 2 / u, 0.3 * cube}};
  };
  const Vec3<double> xi = rod::closed::xi_of_taper(r.taper, 1), m(0.7, -1, 0.9), Cb(3, 4 * std::log(2.), 0.9);
  Measurement digits;
  const nlohmann::json& kept = kept_rods().at("taper_xi");
  for (int i = 0; i < 3; ++i)
    digits.include(digits_apart(xi[i], kept.at(std::size_t(i))), fmt::format("component {}", i + 1));
  const Vec3<double> by_rod = tapped<Vec3<double>>(xi_by_rod(r, m, Cb));
  // One shape for all components, whatever it is, and xi is 1/2.
  const auto one_shape = [](double s) {
    const double u = 1 + s * s - s / 3;
    return rod::Section{u * Vec3<double>(1, 2.5, 0.4)};
  };
  return {digits_finding("law/taper_xi/digits", digits),
          rod_finding("law/taper_xi/by_rod")
              .measured((by_rod - xi).cwiseQuotient(xi).norm())
              .in("relative")
              .at_most(1e-7,
                       "extrapolated from rotations of some 0.01 rad: their fourth power, and rounding over "
                       "their square")
              .by(Oracle::independent),
          rod_finding("law/taper_xi/one_shape")
              .measured((tapped<Vec3<double>>(rod::closed::xi_of_taper(one_shape, 1.4)) -
                         Vec3<double>::Constant(0.5))
                            .norm())
              .at_most(1e-13, "rounding")
              .by(Oracle::closed_form)};
}

/// Seen from the other end the rod is the same rod: the clamp turned by R^T under -R^T m.
std::vector<Finding> end_rotations() {
  Measurement swapped, collocated, isotropic;
  for (const Vec3<double>& k : {Vec3<double>(1, 2, 3), Vec3<double>(9, 1, 35)}) {
    const M3 K = stiffness(k);
    for (const double size : {0.3, 2., 7.}) {
      const Vec3<double> m = size * Vec3<double>(0.6, -0.5, 0.7);
      const std::string where = fmt::format("stiffness {}, {}, {}, {} N m", k[0], k[1], k[2], size);
      const M3 R = rod::end_rotation(K, m);
      const M3 back = rod::end_rotation(K, -R.transpose() * m);
      swapped.include(reference::largest_entry<double>(tapped<M3>(back) - R.transpose()), where);
    }
  }
  const Vec3<double> k(2, 3, 1), m(1.5, -2, 0.7);
  const rod::Rod r = straight_rod(1.6, 1.6 * k);
  const M3 R = rod::end_rotation(k.asDiagonal(), m);
  collocated.include(reference::largest_entry<double>(tapped<M3>(R) - collocate(r, {.moment = m}, 24).R),
                     "by collocation");
  // Isotropic: theta = K^-1 m to all orders.
  const Vec3<double> turn(1.2, -2, 1.7);
  isotropic.include(
      (rotation_of(tapped<M3>(rod::end_rotation(2.5 * M3::Identity(), 2.5 * turn))) - turn).norm(),
      fmt::format("{:.3g} rad", turn.norm()));
  const auto limit = [](const char* name, const Measurement& w) -> Finding {
    return rod_finding(std::string("law/end_rotation/") + name)
        .measured(w)
        .in("rad")
        .at_most(1e-12, "rounding of some hundred steps, grown where the moment is near an intermediate axis")
        .by(Oracle::independent);
  };
  return {limit("from_the_other_end", swapped), limit("by_collocation", collocated),
          limit("isotropic", isotropic)};
}

}  // namespace

void rod_laws(Checks& checks) {
  checks.push_back({"rods/law/third_order", "", third_order});
  checks.push_back({"rods/law/taper_xi", "", taper});
  checks.push_back({"rods/law/end_rotation", "", end_rotations});
}

}  // namespace halfway::verify
