// A path that folds ends there, for bodies in space as for the joint between them, in load steps of any
// length.
#include "reference/solve/path.hpp"
#include "verify/oracle/property.hpp"
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/oracle/scene_access.hpp"
#include "verify/studies/mechanisms/generic.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace halfway::verify {
namespace {

using reference::MechanismScene;
using reference::Scene;

/// The load factor where the way of the bodies ends, by so many points.
double end_of(const MechanismScene& scene, const Entry& entry, double to, int points) {
  const reference::mechanism::Model<double> model(scene, entry, entry.probe_xi);
  reference::mechanism::Follower<double> follower(model);
  for (int i = 1; i <= points && is_equilibrium(follower.reached().status); ++i)
    follower.advance(to * i / points);
  return follower.reached().factor;
}

std::vector<Finding> where_it_ends(const Entry& entry) {
  constexpr std::array kPointCounts{1, 7, 30, 144};
  Scene scene = verify::scene("c3_buckling");
  reference::Path<double> path(scene, entry, entry.probe_xi);
  const double end = path.advance(scene.factor_end).factor;
  const MechanismScene bodies = as_mechanism(scene, {});
  Measurement worst;
  for (const int points : kPointCounts)
    worst.include(std::abs(tapped(end_of(bodies, entry, scene.factor_end, points)) / end - 1),
                  fmt::format("{} points", points));
  return {finding(std::string(entry.name) + "/mechanism_stops")
              .of(std::string(entry.name))
              .about("mechanisms")
              .measured(worst)
              .in("of the load factor where the joint's own path ends")
              .at_most(1e-6, "load steps shrink to 1e-9 of an advance before they give up")
              .by(Oracle::independent)};
}

}  // namespace

/// `jointc` folds while another of its branches is 0.27 rad away; `potential` goes on to the end.
void mechanism_stops(Checks& checks) {
  for (const char* name : {"jointc", "potential"}) {
    const Entry* entry = reference::find_formulation(name);
    if (entry)
      checks.push_back(
          {std::string(name) + "/mechanism_stops", "mechanisms", [entry] { return where_it_ends(*entry); }});
  }
}

}  // namespace halfway::verify
