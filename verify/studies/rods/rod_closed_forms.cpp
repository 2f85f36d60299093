// States of rods that need no integration: elasticas and helices.
#include "reference/truth/rod/closed/elastica.hpp"
#include "reference/truth/rod/closed/helix.hpp"
#include "reference/truth/rod/flow.hpp"
#include "reference/truth/rod/load_steps.hpp"
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/studies/rods/rod_access.hpp"

#include <fmt/format.h>

#include <cmath>

namespace halfway::verify {
namespace {

namespace rod = reference::rod;
namespace closed = reference::rod::closed;

constexpr const char* kClosedReason =
    "closed forms: rounding of some hundred steps, and of elliptic integrals near 1e-15";
constexpr double kClosedLimit = 1e-12;

Finding closed_finding(const std::string& name, const Measurement& worst, const char* unit) {
  return rod_finding(name)
      .measured(worst)
      .in(unit)
      .at_most(kClosedLimit, kClosedReason)
      .by(Oracle::closed_form);
}

constexpr double kLength = 1.7, kStiffness = 2.3;

/// The rod's tip, by alpha = P L^2/EI: angle, x, y over the length.
Vec3<double> by_rod(double alpha, const closed::Elastica& e, bool is_thrust) {
  const rod::Rod r = straight_rod(kLength, {0.7, 1.9, kStiffness});
  const double P = alpha * kStiffness / (kLength * kLength);
  rod::Tip tip;
  if (is_thrust) {
    // The branch that buckles does not grow from the unloaded rod: its moment at the clamp is that of the
    // thrust.
    const rod::State start{.m = Vec3<double>(0, 0, P * kLength * e.y)};
    const Vec3<double> n(-P, 0, 0);
    const rod::State end = flow(r, start, n, rod::Changes(12, 0), 2 * enough_steps(r, start, n)).end;
    tip = {end.x, end.R};
  } else {
    tip = solve(r, {.force = {0, P, 0}});
  }
  return {std::atan2(tip.R(1, 0), tip.R(0, 0)), tip.x[0] / kLength, tip.x[1] / kLength};
}

std::vector<Finding> elastica() {
  std::vector<Finding> out;
  for (const bool is_thrust : {false, true}) {
    const std::string name = is_thrust ? "thrust" : "transverse";
    Measurement rods, digits;
    for (const nlohmann::json& row : kept_rods().at("closed").at(name)) {
      const double alpha = std::stod(row.at(0).get<std::string>());
      const closed::Elastica e =
          is_thrust ? closed::under_thrust(alpha) : closed::under_transverse_force(alpha);
      const Vec3<double> exact(e.angle, e.x, e.y);
      include_digits(digits, exact, {row.at(1), row.at(2), row.at(3)}, fmt::format("alpha = {}", alpha));
      rods.include((tapped<Vec3<double>>(by_rod(alpha, e, is_thrust)) - exact).norm(),
                   fmt::format("alpha = {}", alpha));
    }
    out.push_back(closed_finding("elastica/" + name, rods, "rad, of the length"));
    out.push_back(digits_finding("elastica/" + name + "/digits", digits));
  }
  return out;
}

std::vector<Finding> helix_about_moment() {
  Measurement worst;
  for (const Vec3<double>& m :
       {Vec3<double>(1.2, 0.7, -2), Vec3<double>(-4, 3, 5), Vec3<double>(0.1, -9, 0)}) {
    const rod::Rod r = straight_rod(1.3, {0.8, 1.1, 1.1});
    const rod::Tip exact = closed::under_moment(1.1, 0.8, r.length, m);
    worst.include(tapped(rod::apart(tip_under_moment(r, m), exact, r.length)),
                  fmt::format("{:.3g} N m", m.norm()));
  }
  return {closed_finding("helix/about_moment", worst, "of the length, rad")};
}

std::vector<Finding> helix_under_wrench() {
  const closed::Helix helix{1, 0.8, 0.3, 40 * std::numbers::pi / 180, 0.9};
  const closed::Wrench wrench = wrench_of(helix);
  Measurement digits, state;
  const nlohmann::json& kept = kept_rods().at("closed").at("wrench");
  digits.include(digits_apart(wrench.force, kept.at(0)), "force");
  digits.include(digits_apart(wrench.couple, kept.at(1)), "couple");
  for (const double length : {0.5, 1., 2.5}) {
    const rod::Rod r = straight_rod(length, {helix.C, helix.B, helix.B});
    const closed::HelixState clamp = along(helix, 0), exact = along(helix, length);
    const rod::State start{clamp.x, clamp.R, clamp.m};
    const rod::State end =
        flow(r, start, clamp.n, rod::Changes(12, 0), 2 * enough_steps(r, start, clamp.n)).end;
    const double off =
        std::hypot((end.x - exact.x).norm(), (end.R - exact.R).norm(), (end.m - exact.m).norm());
    state.include(tapped(off), fmt::format("length {}", length));
  }
  return {digits_finding("helix/under_wrench/digits", digits),
          closed_finding("helix/under_wrench", state, "of lengths, rotations, moments near 1")};
}

}  // namespace

void rod_closed_forms(Checks& checks) {
  checks.push_back({"rods/elastica", "", elastica});
  checks.push_back({"rods/helix/about_moment", "", helix_about_moment});
  checks.push_back({"rods/helix/under_wrench", "", helix_under_wrench});
}

}  // namespace halfway::verify
