// The tips of loaded rods by shooting and by collocation, against kept ones.
#include "reference/truth/rod/load_steps.hpp"
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/studies/rods/rod_access.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>

namespace halfway::verify {
namespace {

namespace rod = reference::rod;

/// Loads in the axes of x become those of the clamp.
rod::Loads at_clamp_axes(const KeptTip& kept) {
  const Mat3<double> to_clamp = kept.clamp.transpose();
  return {.force = to_clamp * kept.loads.force, .moment = to_clamp * kept.loads.moment};
}

std::vector<Finding> shooting() {
  std::vector<Finding> out;
  Measurement bars;
  for (const KeptTip& kept : sampled(kept_tips(), 3)) {
    const rod::Tip tip = solve(kept.rod, at_clamp_axes(kept));
    Measurement worst;
    include_digits(worst, kept.clamp * tip.x, kept.x, "x");
    if (!kept.theta.is_null()) include_digits(worst, rotation_of(tip.R), kept.theta, "theta");
    out.push_back(digits_finding("tips/shooting/" + kept.name, worst));
    bars.include(tapped(tip.error), kept.name);
  }
  out.push_back(rod_finding("tips/shooting/error_bar")
                    .measured(bars)
                    .in("of the length, rad")
                    .at_most(1e-13,
                             "half the steps: order 8 leaves 256 times the error of the steps taken, which "
                             "is at rounding, 2e-16 in some hundred additions")
                    .by(Oracle::independent));
  return out;
}

bool is_for_collocation(const std::string& name) {
  constexpr std::string_view kNames[] = {"straight", "pre_curved", "bend_45_polar_600",
                                         "bend_45_st_venant_600"};
  return std::ranges::find(kNames, name) != std::end(kNames);
}

/// Both roads also under loads that follow the tip, of which nothing is kept.
rod::Loads followers() {
  return {.force = {0.2, -0.1, 0.4},
          .moment = {0.1, 0.3, -0.2},
          .follower_force = {-0.7, 0.5, 0.3},
          .follower_moment = {0.3, -0.4, 0.6}};
}

std::vector<Finding> collocation() {
  constexpr int kDegree = 28;
  Measurement apart, bars;
  const auto compare = [&](const std::string& name, const rod::Rod& r, const rod::Loads& loads) {
    const rod::Tip one = solve(r, loads), other = collocate(r, loads, kDegree);
    apart.include(tapped(rod::apart(one, other, r.length)), name);
    bars.include(tapped(other.error), name);
  };
  for (const KeptTip& kept : kept_tips())
    if (is_for_collocation(kept.name)) compare(kept.name, kept.rod, at_clamp_axes(kept));
  rod::Rod tapered = kept_tips().front().rod;
  tapered.curvature0 = {0.3, -0.2, 0.5};
  tapered.taper = [](double s) {
    const double u = 1 - s / 3;
    return rod::of_stiffness({0.8 * u, u * u, 4 / u}, {40 * u, 30, 20 * u});
  };
  compare("tapered, curved, shear-soft, followers", tapered, followers());
  const auto limit = [&](const char* name, const Measurement& m) -> Finding {
    return rod_finding(std::string("tips/collocation/") + name)
        .measured(m)
        .in("of the length, rad")
        .at_most(1e-13,
                 "polynomials of degree 24 and 28 are at rounding, 2e-16, which some hundred additions of "
                 "either road gather")
        .by(Oracle::independent);
  };
  return {limit("against_shooting", apart), limit("error_bar", bars)};
}

/// The print of eight straight elements for the polar torsion constant J = 1/6, GJ = EI.
std::vector<Finding> published() {
  Measurement worst;
  const nlohmann::json& printed = kept_rods().at("published");
  for (const KeptTip& kept : kept_tips()) {
    if (!printed.contains(kept.name)) continue;
    const Vec3<double> x = tapped<Vec3<double>>(kept.clamp * solve(kept.rod, at_clamp_axes(kept)).x);
    for (int i = 0; i < 3; ++i) {
      const double theirs = std::stod(printed.at(kept.name).at(std::size_t(i)).get<std::string>());
      worst.include(std::abs(theirs / x[i] - 1), fmt::format("{}, component {}", kept.name, i + 1));
    }
  }
  return {rod_finding("tips/published")
              .measured(worst)
              .in("relative")
              .at_most(0.01,
                       "eight straight elements for an arc: their own error; St-Venant's torsion constant is "
                       "off by as much again, so J = 1/6 is theirs")
              .by(Oracle::printed, 0.01)};
}

}  // namespace

void rod_tips(Checks& checks) {
  checks.push_back({"rods/tips/shooting", "", shooting});
  checks.push_back({"rods/tips/collocation", "", collocation});
  checks.push_back({"rods/tips/published", "", published});
}

}  // namespace halfway::verify
