// Up to which moment each formulation of C3's joint follows the body that it stands for: its rotation, and
// the coupling theta_2 alone.
#include "verify/oracle/kept.hpp"
#include "verify/oracle/property.hpp"
#include "verify/studies/solids/c3_body.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

namespace halfway::verify {
namespace {

using reference::fe::SolidLaw;

/// N m, from this code: a formulation that is not here is only reported.
struct KeptMoments {
  std::string_view name;
  double rotation, coupling;
};

constexpr KeptMoments kMoments[] = {
    {"attached_a", 222.2, 0},     {"attached_b", 214.6, 0},           {"invariant", 227.5, 246.5},
    {"intrinsic", 227.5, 246.5},  {"jointc", 127.7, 61.22},           {"field_a", 222.5, 0},
    {"field_b", 225.7, 0},        {"conformal", 281.6, 332.9},        {"potential", 227.5, 171.8},
    {"helicoidal", 227.5, 171.8}, {"quaternion", 181, 105.7},         {"cayley", 484.4, 118.8},
    {"fasse", 181, 105.7},        {"simbody_xyz", 215.7, 0},          {"drake_rpy", 214.6, 0},
    {"chrono_body", 214.6, 0},    {"exudyn_intrinsic", 227.5, 246.5}, {"mbdyn_joint_inv", 222.2, 0}};

std::string at_moments(const std::vector<Departure>& list) {
  std::string out;
  for (const Departure& d : list) {
    for (const double moment : {100.0, 400.0, 800.0}) {
      if (std::abs(d.moment - moment) < 1e-6 * moment)
        out += fmt::format("; at {:g} off by {:.2g} and {:.2g}", moment, d.theta, d.theta_2);
    }
  }
  return out;
}

Finding of_formulation(const Entry& entry, Draft f, double Departure::*what, double KeptMoments::*column) {
  const auto& list = departures(entry, SolidLaw::neo_hooke);
  f.measured(moment_within(list, what, 0.05),
             fmt::format("within 1 % up to {:.4g}{}", moment_within(list, what, 0.01), at_moments(list)))
      .in("N m");
  const auto* kept = kept_of(kMoments, entry);
  if (kept == nullptr) return f.reported("no kept value of this formulation");
  return f
      .equal(kept->*column, 1e-3 * kept->*column,
             "kept to four digits: up to where it is within 5 % of the neo-Hookean body, compliance the same")
      .by(Oracle::kept);
}

}  // namespace

void fe_buckling_joints(Checks& checks) {
  add_property(checks, "fe_c3_rotation", {Kind::angular}, [](const Entry& entry, Kind, Draft f) {
    return of_formulation(entry, std::move(f), &Departure::theta, &KeptMoments::rotation);
  });
  add_property(checks, "fe_c3_coupling", {Kind::angular}, [](const Entry& entry, Kind, Draft f) {
    return of_formulation(entry, std::move(f), &Departure::theta_2, &KeptMoments::coupling);
  });
}

}  // namespace halfway::verify
