// What one joint makes of a slender rod: held against tables of an independent computation, and against what
// symmetry says of a force at mid-length.
#include "verify/oracle/kept.hpp"
#include "verify/oracle/property.hpp"
#include "verify/studies/rods/end_force.hpp"
#include "verify/studies/rods/one_joint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace halfway::verify {
namespace {

constexpr const char* kTable =
    "of a table by 80-bit Taylor series and another Newton, computed for this project; ";

Draft of_rod(const Entry& entry, const std::string& what) {
  return finding(fmt::format("{}/rods/{}", entry.name, what)).of(std::string(entry.name)).about("rods");
}

// --- a skew moment on the slender rod that has the compliances of C3

constexpr std::array<double, 6> kMoments = {100, 200, 400, 600, 800, 1000};  // N m
struct SkewRow {
  std::string_view name;
  std::array<double, 6> error;  ///< NaN: no equilibrium
};
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr SkewRow kSkew[] = {{"attached_a", {.0055, .011, .026, .051, .094, .18}},
                             {"attached_b", {.006, .017, .33, .92, .87, .76}},
                             {"invariant", {.0001, .0005, .0029, .018, .27, .70}},
                             {"potential", {.0001, .0007, .0083, .15, .98, 1.05}},
                             {"conformal", {.0021, .0083, .032, .066, .12, .34}},
                             {"quaternion", {.0043, .018, .125, kNone, kNone, kNone}},
                             {"jointc", {.018, .085, kNone, kNone, kNone, kNone}}};

double error_at(const Followed& followed, double moment) {
  const auto& all = skew_moment().moment;
  return followed.error.at(std::size_t(std::ranges::find(all, moment) - all.begin()));
}

/// Half a unit of the last of two digits, at least of the fourth decimal.
double half_unit(double x) { return x < 1e-2 ? 5e-5 : 0.5 * std::pow(10, std::floor(std::log10(x)) - 1); }

Finding skew(const Entry& entry) {
  const Followed& followed = follows_skew_moment(entry);
  const auto range = [&](double tolerance) {
    const auto last = followed.last_within(tolerance);
    return last ? fmt::format("{:g} N m", skew_moment().moment[*last]) : "nowhere";
  };
  const std::string ranges = fmt::format("within 1 % to {}, within 5 % to {}", range(.01), range(.05));
  Draft f = of_rod(entry, "skew_moment").in("of half the last digit").by(Oracle::independent);
  const auto* row = kept_of(kSkew, entry);
  if (row == nullptr) {
    const double first = error_at(followed, kMoments.front());
    return f.measured(first, ranges).in("relative").reported("error at 100 N m; no table knows this one");
  }
  Measurement worst;
  for (std::size_t i = 0; i < kMoments.size(); ++i) {
    if (std::isnan(row->error[i])) continue;
    const double off = std::abs(error_at(followed, kMoments[i]) - row->error[i]);
    worst.include(off / half_unit(row->error[i]), fmt::format("{:g} N m; {}", kMoments[i], ranges));
  }
  return f.measured(worst).at_most(1.2,
                                   std::string(kTable) + "two digits, of which the last was cut or rounded");
}

// --- random fixed moments

struct RandomRow {
  std::string_view name;
  std::array<double, 6> median;  ///< (1, 2, 3), C3, (1, 10, 100) at 0.2, and at 1 rad
};
constexpr RandomRow kRandom[] = {{"attached_a", {.022, .010, .013, .11, .051, .056}},
                                 {"invariant", {7.8e-4, 7.2e-4, 7.3e-4, .019, .016, .018}},
                                 {"potential", {5.3e-4, 4.2e-4, 5.5e-4, .013, .011, .011}},
                                 {"conformal", {.0039, .0040, .0039, .081, .083, .081}},
                                 {"quaternion", {.0067, .0068, .0067, .43, .52, .43}},
                                 {"cayley", {.014, .014, .014, .21, .21, .21}},
                                 {"jointc", {.030, .030, .030, kNone, kNone, kNone}},
                                 {"rod4", {9e-7, 6e-6, 3e-5, 6e-4, .0072, kNone}}};

/// Of a median over as few draws as the table's.
constexpr double kSpread = 2.5;

Finding random(const Entry& entry, const RandomMoments& moments, std::size_t number) {
  const Spread& spread = error_of_random(entry, moments);
  Draft f =
      of_rod(entry, fmt::format("random_{}/{}/{:g}", to_string(moments.drawn), moments.name, moments.size))
          .measured(spread.median, fmt::format("{} of {} without an equilibrium", spread.lost, spread.of))
          .in("median of |turn between the ends| over |turn of the rod|")
          .by(Oracle::independent);
  const auto* row = kept_of(kRandom, entry);
  const bool known = row != nullptr && moments.drawn == Drawn::moment;
  if (spread.lost * 2 >= spread.of)
    return f.measured(spread.lost, "no equilibrium there").in("joints").reported("half or more are lost");
  if (!known) return f.reported("nothing to hold it against");
  const double expected = row->median.at(number);
  // Its error goes with the fourth power of what the others' goes with the square of.
  const double spread_of = entry.name == "rod4" ? kSpread * kSpread : kSpread;
  return f.within(expected / spread_of, spread_of * expected,
                  std::string(kTable) +
                      "of 80 other draws: four seeds of as many moved the median of invariant on "
                      "(1, 10, 100) from 6.4e-4 to 1.6e-3");
}

// --- a semi-tangential moment

struct CriticalRow {
  std::string_view name;
  std::array<double, 4> ratio;  ///< of joint over rod; 0: none
};
constexpr CriticalRow kCritical[] = {
    {"attached_a", {.993, 1.182, 0, 0}},      {"invariant", {1.218, 1.182, 2.92, 9.0}},
    {"potential", {1.063, 1.069, 2.54, 7.8}}, {"conformal", {1.314, 1.737, 3.05, 9.1}},
    {"quaternion", {.805, .564, 1.98, 6.4}},  {"jointc", {.521, kNone, 1.33, 4.5}},
    {"rod4", {.978, 1.011, 1.084, 1.101}}};

Finding critical(const Entry& entry, const SemiTangential& of, std::size_t number) {
  const auto& load = critical_of(entry, of);
  const double ratio = load ? *load / of.critical : 0;
  Draft f =
      of_rod(entry, fmt::format("semi_tangential/{}", of.name))
          .measured(ratio, load ? fmt::format("{:.6g} of {:.12g} N m", *load, of.critical) : "none below pi")
          .in("of the rod's critical moment")
          .by(Oracle::independent);
  const auto* row = kept_of(kCritical, entry);
  if (row == nullptr || std::isnan(row->ratio[number])) return f.reported("no table knows this one");
  const double expected = row->ratio[number];
  const double unit = number < 2 || entry.name == "rod4" ? 1e-3 : expected > 4 ? .1 : .01;
  return f.equal(expected, unit, std::string(kTable) + "a unit of its last digit, which was cut or rounded");
}

// --- a force

/// The frame half-way is that of the rod's middle to first order, which is what a force there needs.
constexpr std::string_view kRightInTheMiddle[] = {"invariant",  "conformal",        "potential",
                                                  "helicoidal", "quaternion",       "cayley",
                                                  "drake_rpy",  "exudyn_intrinsic", "rod4"};
/// Wrong by all of the turn, or much of it, at any load: the law sits at a node; or it locks.
constexpr std::string_view kWrongInTheMiddle[] = {"attached_a",  "attached_b",  "intrinsic",
                                                  "jointc",      "field_a",     "field_b",
                                                  "simbody_xyz", "chrono_body", "fasse"};

constexpr const char* kCubic =
    "the strains of a slender rod to second order: what is left begins two powers of the load after the turn";

Finding force_in_the_middle(const Entry& entry) {
  const ForceErrors& errors = force_errors(entry, Where::middle);
  const std::string at = fmt::format("error {:.2g} at a force of {:g} EI/L^2", errors.back(), kForces.back());
  Draft f = of_rod(entry, "force/middle").by(Oracle::closed_form);
  if (entry.needs_length) return f.measured(growth(errors), at).in("power of the load").at_least(1.9, kCubic);
  if (std::ranges::find(kRightInTheMiddle, entry.name) != std::end(kRightInTheMiddle))
    return f.measured(growth(errors), at)
        .in("power of the load")
        .at_least(0.98, "right to second order, in which the turn begins: what is left grows with the load");
  if (std::ranges::find(kWrongInTheMiddle, entry.name) != std::end(kWrongInTheMiddle))
    return f.measured(errors.back(), at)
        .in("relative")
        .within(0.3, 1.1,
                "a law at a node turns with the node, not with the middle; fasse locks: its axial "
                "stiffness, 1e7 times the transverse one, acts along both nodes' axes");
  return f.measured(errors.back(), at).in("relative").reported("of a law that the lists do not know");
}

Finding force_at_the_tip(const Entry& entry) {
  const ForceErrors& errors = force_errors(entry, Where::tip);
  Draft f = of_rod(entry, "force/tip")
                .measured(growth(errors), fmt::format("error {:.2g} at a force of {:g} EI/L^2", errors.back(),
                                                      kForces.back()))
                .in("power of the load")
                .by(Oracle::closed_form);
  if (entry.needs_length) return f.at_least(1.9, kCubic);
  if (kept_of(kSkew, entry) == nullptr) return f.reported("how the error grows");
  return f.within(0.9, 1.1,
                  "a rod shortens by its bending and its shear couples with twist: cubic terms of the "
                  "energy that no law of one joint has, so that a part of first order is left");
}

std::vector<Finding> of_forces(const Entry& entry) {
  return {force_in_the_middle(entry), force_at_the_tip(entry)};
}

std::vector<Finding> of_moments(const Entry& entry) {
  std::vector<Finding> out{skew(entry)};
  for (std::size_t i = 0; i < random_moments().size(); ++i)
    out.push_back(random(entry, random_moments()[i], i));
  for (std::size_t i = 0; i < semi_tangential().size(); ++i)
    out.push_back(critical(entry, semi_tangential()[i], i));
  return out;
}

}  // namespace

void joint_for_a_rod(Checks& checks) {
  for (const Entry& entry : reference::formulations()) {
    const auto add = [&](const char* what, auto of) {
      checks.push_back({fmt::format("{}/rods/{}", entry.name, what), {}, [&entry, of] { return of(entry); }});
    };
    add("moments", of_moments);
    add("forces", of_forces);
  }
}

}  // namespace halfway::verify
