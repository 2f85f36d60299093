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
const double kMean = std::sqrt(0.65 * kB);

/// Rigid about axis 3.
rod::Rod strip() { return straight_rod(kLong, {0.65, kB, kRigid}); }

// Conservative moments ------------------------------------------------------------------------------

std::vector<Finding> semi_tangential() {
  CriticalLoads loads;
  const rod::Rod shaft = straight_rod(kLong, {0.8, kB, kB});
  loads.against(critical_semi_tangential(shaft, 0, 3), closed::semi_tangential(kB, kLong), "torque");
  loads.against(critical_semi_tangential(strip(), 2, 2), closed::semi_tangential(kMean, kLong), "strip");
  for (const nlohmann::json& row : kept_rods().at("semi_tangential")) {
    rod::Rod kept;
    kept.section = row.contains("stiffness") ? rod::of_stiffness(vector_of(row.at("stiffness")))
                                             : rod::Section{vector_of(row.at("compliance"))};
    const Vec3<double> C = kept.section.bending;
    const double high = 4 / std::sqrt(C[1] * C[2]);
    loads.against(critical_semi_tangential(kept, 0, high), row.at("moment").get<std::string>(),
                  row.at("name"));
  }
  return findings_of("semi_tangential", loads);
}

/// Any arm will do of a shaft; of a strip one along a principal axis.
std::vector<Finding> quasi_tangential() {
  CriticalLoads loads;
  const rod::Rod shaft = straight_rod(kLong, {0.8, kB, kB});
  const Vec3<double> arm(0, std::cos(0.4), std::sin(0.4));
  loads.against(critical_quasi_tangential(shaft, 0, arm, 3), closed::quasi_tangential(kB, kLong), "torque");
  for (const int axis : {0, 1})
    loads.against(critical_quasi_tangential(strip(), 2, Vec3<double>::Unit(axis), 2),
                  closed::quasi_tangential(kMean, kLong), fmt::format("strip, arm along {}", axis + 1));
  return findings_of("quasi_tangential", loads);
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

std::vector<Finding> fork_moment() {
  CriticalLoads loads;
  for (const Vec3<double>& bending : {Vec3<double>(0.65, 1, 10), Vec3<double>(1.4, 0.8, 6)}) {
    const double exact = closed::fork_strip(bending, kLong);
    loads.against(critical_fork_moment(straight_rod(kLong, bending), 1.5 * exact), exact,
                  fmt::format("EI3 = {}", bending[2]));
  }
  return findings_of("fork_moment", loads);
}

std::vector<Finding> tip_force() {
  CriticalLoads loads;
  const double exact = closed::tip_force(kB, 0.65, kLong);
  loads.against(critical_tip_force(strip(), 1.5 * exact), exact, "EI3 infinite");
  const std::string constant = kept_rods().at("closed").at("tip_force");
  loads.digits.include(digits_apart(closed::tip_force(1, 1, 1), constant), "EI3 infinite");
  const nlohmann::json& kept = kept_rods().at("tip_force");
  for (const nlohmann::json& row : kept.at("rows")) {
    const double stiff = std::stod(row.at(0).get<std::string>());
    const rod::Rod r = straight_rod(1, {kept.at("GJ").get<double>(), kept.at("EI2").get<double>(), stiff});
    loads.against(critical_tip_force(r, 6), row.at(1).get<std::string>(), fmt::format("EI3 = {}", stiff));
  }
  return findings_of("tip_force", loads);
}

// Beck's column -------------------------------------------------------------------------------------

std::vector<Finding> flutters() {
  constexpr double kMass = 0.7, kEI = 2.3;
  const double load_unit = kEI / (kLong * kLong),
               frequency_unit = std::sqrt(load_unit / (kLong * kLong * kMass));
  const rod::Flutter exact = rod::flutter(closed::beck_determinant, {20, 11});
  const rod::Flutter found =
      follower_flutter(straight_rod(kLong, {0.8, 1.1, kEI}), kMass, {20 * load_unit, 11 * frequency_unit});
  CriticalLoads loads;
  loads.against({found.load / load_unit, found.error * exact.load}, exact.load, "load");
  loads.against({found.frequency / frequency_unit, found.error * exact.frequency}, exact.frequency,
                "frequency");
  std::vector<Finding> out = findings_of("flutter", loads);
  // The 17 digits that are kept are more than doubles have: relative.
  Measurement digits;
  for (const auto& [key, value] : {std::pair{"beck_load", exact.load}, {"beck_frequency", exact.frequency}})
    digits.include(relative(value, std::stod(kept_rods().at("closed").at(key).get<std::string>())), key);
  out.push_back(rod_finding("critical/flutter/digits")
                    .measured(digits)
                    .in("relative")
                    .at_most(1e-12, "rounding of the determinant, 1e-15, over its slopes at a double zero")
                    .by(Oracle::independent));
  return out;
}

}  // namespace

void rod_critical(Checks& checks) {
  checks.push_back({"rods/critical/semi_tangential", "", semi_tangential});
  checks.push_back({"rods/critical/quasi_tangential", "", quasi_tangential});
  checks.push_back({"rods/critical/double_zero", "", double_zero});
  checks.push_back({"rods/critical/fork_moment", "", fork_moment});
  checks.push_back({"rods/critical/tip_force", "", tip_force});
  checks.push_back({"rods/critical/flutter", "", flutters});
}

}  // namespace halfway::verify
