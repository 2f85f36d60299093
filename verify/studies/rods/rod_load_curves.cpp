// A fixed end moment on a clamped rod: the load curve by one integration, and why nothing ever buckles there.
#include "reference/truth/rod/load_steps.hpp"
#include "reference/truth/rod/stability.hpp"
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/studies/rods/rod_access.hpp"

#include <fmt/format.h>

#include <cmath>

namespace halfway::verify {
namespace {

namespace rod = reference::rod;

rod::Rod of_compliance(const Vec3<double>& bending) {
  rod::Rod out;
  out.section.bending = bending;
  return out;
}

struct Curve {
  std::string name;
  rod::Rod rod;
  Vec3<double> direction;
  std::vector<double> amounts;
  std::vector<nlohmann::json> theta;
};

std::vector<Curve> kept_curves() {
  std::vector<Curve> out;
  for (const nlohmann::json& row : kept_rods().at("load_curves")) {
    Curve curve{row.at("name"),
                of_compliance(vector_of(row.at("compliance"))),
                vector_of(row.at("direction")),
                {},
                {}};
    for (const nlohmann::json& point : row.at("curve")) {
      curve.amounts.push_back(std::stod(point.at(0).get<std::string>()));
      curve.theta.push_back({point.at(1), point.at(2), point.at(3)});
    }
    out.push_back(std::move(curve));
  }
  return out;
}

std::vector<Finding> load_curves() {
  std::vector<Finding> out;
  Measurement bars, singly;
  for (const Curve& curve : kept_curves()) {
    const auto tips = tips_under_moment(curve.rod, curve.direction, curve.amounts);
    Measurement worst;
    for (std::size_t i = 0; i < tips.size(); ++i) {
      const std::string where = fmt::format("{}, {} N m", curve.name, curve.amounts[i]);
      include_digits(worst, rotation_of(tips[i].R), curve.theta[i], where);
      bars.include(tapped(tips[i].error), where);
      const rod::Tip one = tip_under_moment(curve.rod, curve.amounts[i] * curve.direction);
      singly.include(tapped(rod::apart(tips[i], one, curve.rod.length)), where);
    }
    out.push_back(digits_finding("load_curves/" + curve.name, worst));
  }
  const auto limit = [](const char* name, const Measurement& m) -> Finding {
    return rod_finding(std::string("load_curves/") + name)
        .measured(m)
        .in("of the length, rad")
        .at_most(1e-13, "rounding of some hundred steps")
        .by(Oracle::independent);
  };
  out.push_back(limit("error_bar", bars));
  out.push_back(limit("one_integration_against_one_each", singly));
  return out;
}

// No static critical moment -------------------------------------------------------------------------

struct Case {
  const char* name;
  rod::Rod rod;
  Vec3<double> moment;  ///< followed from none
};

std::vector<Case> cases() {
  const Curve c3 = kept_curves().front();
  rod::Rod strip = of_compliance({1 / 0.65, 1, 0});
  rod::Rod generic = of_compliance(Vec3<double>::Zero());
  generic.curvature0 = {0.4, -0.9, 0.6};
  generic.taper = [](double s) {
    return rod::of_stiffness({0.8 - s / 4, 1 + s, 4 - s * s}, {50., 20 + s, 30.});
  };
  return {
      {"c3", c3.rod, 1800 * c3.direction}, {"strip", strip, {0.01, 0, 9}}, {"generic", generic, {3, -2, 5}}};
}

/// Determinants of what the clamp carries by what the tip carries: d(n, m)(length)/d(n, m)(0) of a fixed
/// moment is triangular with ones on its diagonal. Of a follower it is that of R^T m, which flows by Euler's
/// equations of a top, whose divergence is zero: it keeps volumes, so this one is 1 as well (derived here).
/// No zero, no other equilibrium.
std::vector<Finding> no_critical_moment() {
  constexpr int kSteps = 12;
  std::vector<Finding> out;
  for (const Case& c : cases()) {
    Measurement fixed, follower;
    int zeros = 0;
    for (int i = 1; i <= kSteps; ++i) {
      const Vec3<double> m = double(i) / kSteps * c.moment;
      const rod::Arrival tip = rod::carried(c.rod, Vec3<double>::Zero(), m);
      const auto value = [&](const Mat3<double>& by_spin) {
        return tapped(determinant(rod::clamped(), tip.changes, rod::free_end(by_spin), rod::kAll));
      };
      const double one = value(rod::of_fixed_moment()), other = value(rod::of_follower_moment(m));
      const std::string where = fmt::format("{:.4g} N m", m.norm());
      fixed.include(std::abs(one - 1), where);
      follower.include(std::abs(other - 1), where);
      if (!(one > 0) || !(other > 0)) ++zeros;
    }
    const std::string name = fmt::format("no_static_critical_moment/{}", c.name);
    const auto limit = [&](const char* which, const Measurement& m) -> Finding {
      return rod_finding(name + which)
          .measured(m)
          .in("of the determinant, which is 1")
          .at_most(1e-10,
                   "rounding, 1e-15 in some hundred steps, of changes that grow up to 1e3 times on the way")
          .by(Oracle::closed_form);
    };
    out.push_back(limit("/fixed", fixed));
    out.push_back(limit("/follower", follower));
    out.push_back(rod_finding(name)
                      .measured(zeros, fmt::format("none up to {:.4g} N m", c.moment.norm()))
                      .in("moments of as many without a determinant above zero")
                      .equal(0, 0, "no force, so m is known from the clamp on: an initial value problem")
                      .by(Oracle::closed_form));
  }
  return out;
}

/// R at the load a m is the top at the time a: the tip turns by dw/da = L R C R^T m, between the smallest and
/// the largest compliance, along the whole curve. The variational equations know nothing of that.
std::vector<Finding> rate_of_turn() {
  const Curve c3 = kept_curves().front();
  Measurement worst;
  for (const double amount : {100., 415., 830., 1300., 1800.}) {
    const Vec3<double> m = amount * c3.direction;
    const rod::Arrival tip = rod::carried(c3.rod, Vec3<double>::Zero(), m);
    const Vec3<double> by_changes =
        tapped<Vec3<double>>(tip.changes.block<3, 3>(rod::kSpin, rod::kMoment) * m);
    const Mat3<double>& R = tip.end.R;
    const Vec3<double> by_top = R * c3.rod.section.bending.cwiseProduct(R.transpose() * m);
    worst.include((by_changes - by_top).norm() / by_top.norm(), fmt::format("{} N m", amount));
  }
  return {
      rod_finding("rate_of_turn")
          .measured(worst)
          .in("relative")
          .at_most(1e-11, "rounding of some hundred steps in changes that grow up to 1e3 times on the way")
          .by(Oracle::closed_form)};
}

}  // namespace

void rod_load_curves(Checks& checks) {
  checks.push_back({"rods/load_curves", "", load_curves});
  checks.push_back({"rods/no_static_critical_moment", "", no_critical_moment});
  checks.push_back({"rods/rate_of_turn", "", rate_of_turn});
}

}  // namespace halfway::verify
