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
using rod::TorqueEnds;

constexpr double kRigid = std::numeric_limits<double>::infinity();

rod::Rod of_length(double length, const Vec3<double>& bending) {
  rod::Rod out;
  out.length = length;
  out.section = rod::of_stiffness(bending);
  return out;
}

Finding critical_finding(const std::string& name, const Measurement& worst) {
  return rod_finding("critical/" + name)
      .measured(worst)
      .in("relative")
      .at_most(1e-12,
               "closed forms: rounding of some hundred steps over the slope of the determinant at its zero")
      .by(Oracle::closed_form);
}

// Torques -------------------------------------------------------------------------------------------

constexpr double kB = 1.3, kLong = 1.7;

rod::Rod shaft() { return of_length(kLong, {0.8, kB, kB}); }

std::vector<Finding> torques() {
  const rod::Rod r = shaft();
  Measurement hinged, clamped, digits;
  for (const TorqueEnds ends : {TorqueEnds::hinged_fixed, TorqueEnds::hinged_follower}) {
    for (const double P : {0., 2.5}) {
      const double exact = closed::greenhill_hinged(kB, kLong, P);
      hinged.include(
          relative(critical_torque(r, ends, P, 0.5 * exact, 1.3 * exact), exact),
          fmt::format("thrust {}, {}", P, ends == TorqueEnds::hinged_fixed ? "fixed" : "follower"));
    }
  }
  const double exact = closed::greenhill_clamped(kB, kLong);
  clamped.include(relative(critical_torque(r, TorqueEnds::clamped, 0, 0.6 * exact, 1.1 * exact), exact),
                  "clamped");
  digits.include(
      digits_apart(closed::greenhill_clamped(1, 1), kept_rods().at("closed").at("greenhill_clamped")),
      "greenhill");
  return {critical_finding("torque/hinged", hinged), critical_finding("torque/clamped", clamped),
          digits_finding("critical/torque/digits", digits)};
}

/// The rod's determinant is that of the closed form, whose two terms have moduli 1 + M^2/2 and sqrt(1 + M^2),
/// which differ for every M > 0.
std::vector<Finding> no_torque() {
  const rod::Rod r = of_length(1, {0.8, 1, 1});
  std::vector<Finding> out;
  struct {
    const char* name;
    TorqueEnds ends;
  } const kCases[] = {{"clamped_hinged/fixed", TorqueEnds::clamped_hinged_fixed},
                      {"clamped_hinged/follower", TorqueEnds::clamped_hinged_follower},
                      {"clamped_free/fixed", TorqueEnds::clamped_free_fixed},
                      {"clamped_free/follower", TorqueEnds::clamped_free_follower}};
  for (const auto& c : kCases) {
    Measurement apart, least;
    for (const double M : {0.7, 3., 6.5, 9., 14., 29.}) {
      const double size = tapped(std::abs(torque_determinant(r, c.ends, M, 0)));
      const double bound = (1 + M * M / 2 - std::sqrt(1 + M * M)) / (M * M * M);
      const bool is_hinged =
          c.ends == TorqueEnds::clamped_hinged_fixed || c.ends == TorqueEnds::clamped_hinged_follower;
      apart.include(std::abs(size / closed::torque_determinant(c.ends, M) - 1), fmt::format("{} N m", M));
      least.include((is_hinged ? bound : 1) / size, fmt::format("{} N m", M));
    }
    out.push_back(critical_finding(std::string("none/") + c.name, apart));
    out.push_back(rod_finding(std::string("critical/none/") + c.name + "/bound")
                      .measured(least)
                      .in("of the determinant")
                      .at_most(1 + 1e-12,
                               "the moduli of the determinant's two terms are this far apart at least: no "
                               "torque makes it vanish; rounding where both turn into line")
                      .by(Oracle::closed_form));
  }
  return out;
}

// Conservative moments ------------------------------------------------------------------------------

std::vector<Finding> conservative_moments() {
  const Vec3<double> arm(0, std::cos(0.4), std::sin(0.4));
  const rod::Rod r = shaft();
  Measurement semi, quasi;
  semi.include(relative(critical_semi_tangential(r, 0, 3), closed::semi_tangential(kB, kLong)), "torque");
  quasi.include(relative(critical_quasi_tangential(r, 0, arm, 3), closed::quasi_tangential(kB, kLong)),
                "torque");
  // A strip, rigid about axis 3, about which the moment acts; the arms of its forces along a principal axis.
  const rod::Rod strip = of_length(kLong, {0.65, kB, kRigid});
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
  const double touched = value(of_length(1, {0.65, 1, kRigid}), mean);
  const double between = value(of_length(1, {0.65, 1, 10}), mean);
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
    fork.include(relative(critical_fork_moment(of_length(kLong, bending), 1.5 * exact), exact),
                 fmt::format("EI3 = {}", bending[2]));
  }
  const double exact = closed::tip_force(kB, 0.65, kLong);
  force.include(relative(critical_tip_force(of_length(kLong, {0.65, kB, kRigid}), 1.5 * exact), exact),
                "EI3 infinite");
  digits.include(digits_apart(closed::tip_force(1, 1, 1), kept_rods().at("closed").at("tip_force")),
                 "EI3 infinite");
  const nlohmann::json& kept = kept_rods().at("tip_force");
  for (const nlohmann::json& row : kept.at("rows")) {
    const double stiff = std::stod(row.at(0).get<std::string>());
    const rod::Rod r = of_length(1, {kept.at("GJ").get<double>(), kept.at("EI2").get<double>(), stiff});
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
      follower_flutter(of_length(kLong, {0.8, 1.1, kEI}), kMass, {20 * load_unit, 11 * frequency_unit});
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
  checks.push_back({"rods/critical/torque", "", torques});
  checks.push_back({"rods/critical/none", "", no_torque});
  checks.push_back({"rods/critical/conservative", "", conservative_moments});
  checks.push_back({"rods/critical/double_zero", "", double_zero});
  checks.push_back({"rods/critical/strips", "", strips});
  checks.push_back({"rods/critical/flutter", "", flutters});
}

}  // namespace halfway::verify
