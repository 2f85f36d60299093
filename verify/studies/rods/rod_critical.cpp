// Critical loads of rods by the rod's own determinants, against closed forms and kept values.
#include "reference/truth/rod/closed/loads.hpp"
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/studies/rods/rod_access.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace halfway::verify {
namespace {

namespace rod = reference::rod;
namespace closed = reference::rod::closed;

constexpr double kRigid = std::numeric_limits<double>::infinity();

constexpr double kB = 1.3, kLong = 1.7;

// Conservative moments ------------------------------------------------------------------------------

std::vector<Finding> conservative_moments() {
  const Vec3<double> arm(0, std::cos(0.4), std::sin(0.4));
  const rod::Rod r = straight_rod(kLong, {0.8, kB, kB});
  Measurement semi, quasi;
  semi.include(relative(critical_semi_tangential(r, 0, 3), closed::semi_tangential(kB, kLong)), "torque");
  quasi.include(relative(critical_quasi_tangential(r, 0, arm, 3), closed::quasi_tangential(kB, kLong)),
                "torque");
  // A strip, rigid about axis 3, about which the moment acts; the arms of its forces along a principal axis.
  const rod::Rod strip = straight_rod(kLong, {0.65, kB, kRigid});
  const double mean = std::sqrt(0.65 * kB);
  semi.include(relative(critical_semi_tangential(strip, 2, 2), closed::semi_tangential(mean, kLong)),
               "strip");
  for (const int axis : {0, 1}) {
    quasi.include(relative(critical_quasi_tangential(strip, 2, Vec3<double>::Unit(axis), 2),
                           closed::quasi_tangential(mean, kLong)),
                  fmt::format("strip, arm along {}", axis + 1));
  }
  Measurement digits;
  for (const nlohmann::json& row : kept_rods().at("semi_tangential")) {
    rod::Rod kept;
    kept.section = row.contains("stiffness") ? rod::of_stiffness(vector_of(row.at("stiffness")))
                                             : rod::Section{vector_of(row.at("compliance"))};
    const Vec3<double> C = kept.section.bending;
    digits.include(
        digits_apart(critical_semi_tangential(kept, 0, 4 / std::sqrt(C[1] * C[2])), row.at("moment")),
        row.at("name"));
  }
  return {critical_finding("semi_tangential", semi), critical_finding("quasi_tangential", quasi),
          digits_finding("critical/semi_tangential/digits", digits)};
}

/// Of a strip that is rigid about axis 3 the determinant under a semi-tangential moment about it touches
/// zero; one that gives way there has two zeros and a negative determinant between them.
std::vector<Finding> double_zero() {
  constexpr int kOthers[] = {3, 4};
  const auto value = [&](const rod::Rod& r, double M) {
    const Vec3<double> m(0, 0, M);
    const rod::End end = rod::free_end(rod::of_semi_tangential_moment(m));
    return determinant(rod::clamped(), rod::carried(r, Vec3<double>::Zero(), m).changes, end, kOthers);
  };
  const double mean = closed::semi_tangential(std::sqrt(0.65), 1);
  const double touched = value(straight_rod(1, {0.65, 1, kRigid}), mean);
  const double between = value(straight_rod(1, {0.65, 1, 10}), mean);
  return {
      rod_finding("critical/semi_tangential/double")
          .measured(std::abs(tapped(touched)))
          .in("of the determinant without load")
          .at_most(1e-12, "a double zero: the square of what rounding moves it by")
          .by(Oracle::closed_form),
      rod_finding("critical/semi_tangential/split")
          .measured(tapped(between))
          .in("of the determinant without load")
          .at_most(-1e-4, "negative, by more than rounding: the state bent before it buckles splits the zero")
          .by(Oracle::independent)};
}

// Strips --------------------------------------------------------------------------------------------

std::vector<Finding> strips() {
  Measurement fork, force, digits;
  for (const Vec3<double>& bending : {Vec3<double>(0.65, 1, 10), Vec3<double>(1.4, 0.8, 6)}) {
    const double exact = closed::fork_strip(bending, kLong);
    fork.include(relative(critical_fork_moment(straight_rod(kLong, bending), 1.5 * exact), exact),
                 fmt::format("EI3 = {}", bending[2]));
  }
  const double exact = closed::tip_force(kB, 0.65, kLong);
  force.include(relative(critical_tip_force(straight_rod(kLong, {0.65, kB, kRigid}), 1.5 * exact), exact),
                "EI3 infinite");
  digits.include(digits_apart(closed::tip_force(1, 1, 1), kept_rods().at("closed").at("tip_force")),
                 "EI3 infinite");
  const nlohmann::json& kept = kept_rods().at("tip_force");
  for (const nlohmann::json& row : kept.at("rows")) {
    const double stiff = std::stod(row.at(0).get<std::string>());
    const rod::Rod r = straight_rod(1, {kept.at("GJ").get<double>(), kept.at("EI2").get<double>(), stiff});
    digits.include(digits_apart(critical_tip_force(r, 6), row.at(1)), fmt::format("EI3 = {}", stiff));
  }
  return {critical_finding("fork_moment", fork), critical_finding("tip_force", force),
          digits_finding("critical/tip_force/digits", digits)};
}

// Beck's column -------------------------------------------------------------------------------------

std::vector<Finding> flutters() {
  constexpr double kMass = 0.7, kEI = 2.3;
  const double load_unit = kEI / (kLong * kLong),
               frequency_unit = std::sqrt(load_unit / (kLong * kLong * kMass));
  const rod::Flutter exact = rod::flutter(closed::beck_determinant, {20, 11});
  const rod::Flutter found =
      follower_flutter(straight_rod(kLong, {0.8, 1.1, kEI}), kMass, {20 * load_unit, 11 * frequency_unit});
  Measurement worst, digits;
  worst.include(relative(found.load / load_unit, exact.load), "load");
  worst.include(relative(found.frequency / frequency_unit, exact.frequency), "frequency");
  const nlohmann::json& kept = kept_rods().at("closed");
  // The 17 digits that are kept are more than doubles have: relative.
  digits.include(relative(exact.load, std::stod(kept.at("beck_load").get<std::string>())), "load");
  digits.include(relative(exact.frequency, std::stod(kept.at("beck_frequency").get<std::string>())),
                 "frequency");
  return {critical_finding("flutter", worst),
          rod_finding("critical/flutter/digits")
              .measured(digits)
              .in("relative")
              .at_most(1e-12, "rounding of the determinant, 1e-15, over its slopes at a double zero")
              .by(Oracle::independent)};
}

}  // namespace

void rod_critical(Checks& checks) {
  checks.push_back({"rods/critical/conservative", "", conservative_moments});
  checks.push_back({"rods/critical/double_zero", "", double_zero});
  checks.push_back({"rods/critical/strips", "", strips});
  checks.push_back({"rods/critical/flutter", "", flutters});
}

}  // namespace halfway::verify
