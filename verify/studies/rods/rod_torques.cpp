// A torque on a straight rod: Greenhill's loads, and ends that let none buckle it.
#include "reference/truth/rod/closed/loads.hpp"
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/studies/rods/rod_access.hpp"

#include <fmt/format.h>

#include <cmath>

namespace halfway::verify {
namespace {

namespace rod = reference::rod;
namespace closed = reference::rod::closed;
using rod::TorqueEnds;

constexpr double kShaft = 1.3, kShaftLength = 1.7;

rod::Rod shaft() { return straight_rod(kShaftLength, {0.8, kShaft, kShaft}); }

std::vector<Finding> torques() {
  const rod::Rod r = shaft();
  CriticalLoads loads;
  for (const TorqueEnds ends : {TorqueEnds::hinged_fixed, TorqueEnds::hinged_follower}) {
    for (const double P : {0., 2.5}) {
      const double exact = closed::greenhill_hinged(kShaft, kShaftLength, P);
      loads.against(
          critical_torque(r, ends, P, 0.5 * exact, 1.3 * exact), exact,
          fmt::format("hinged, thrust {}, {}", P, ends == TorqueEnds::hinged_fixed ? "fixed" : "follower"));
    }
  }
  const double exact = closed::greenhill_clamped(kShaft, kShaftLength);
  loads.against(critical_torque(r, TorqueEnds::clamped, 0, 0.6 * exact, 1.1 * exact), exact, "clamped");
  const std::string kept = kept_rods().at("closed").at("greenhill_clamped");
  loads.digits.include(digits_apart(closed::greenhill_clamped(1, 1), kept), "clamped");
  return findings_of("torque", loads);
}

/// The rod's determinant is that of the closed form, whose two terms have moduli 1 + M^2/2 and sqrt(1 + M^2),
/// which differ for every M > 0.
std::vector<Finding> no_torque() {
  const rod::Rod r = straight_rod(1, {0.8, 1, 1});
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
    out.push_back(rod_finding(std::string("critical/none/") + c.name)
                      .measured(apart)
                      .in("relative")
                      .at_most(1e-12, "rounding of some hundred steps")
                      .by(Oracle::closed_form));
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

}  // namespace

void rod_torques(Checks& checks) {
  checks.push_back({"rods/critical/torque", "", torques});
  checks.push_back({"rods/critical/none", "", no_torque});
}

}  // namespace halfway::verify
